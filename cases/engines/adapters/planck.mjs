// planck: Box2D 2.4 in JavaScript. Contacts are found by the engine, between a disc on one body and a box on the other
// that meet in the contact's point and nothing else; default sweeps are 8 of velocities, 3 of positions.
import { Refused, engine, run, dot } from "./adapter.mjs";

const { module, version } = await engine("planck");
const { World, Circle, Polygon, RevoluteJoint, PrismaticJoint, WeldJoint, DistanceJoint, RopeJoint, FrictionJoint,
        Settings } = module;
const vec = ([x, y]) => ({ x, y });

function addBody(world, body) {
  const made = world.createBody({
    type: body.prescribed ? "kinematic" : "dynamic", position: vec(body.at), linearVelocity: vec(body.velocityAfter),
    angularVelocity: body.spinAfter, fixedRotation: !body.turns, allowSleep: false });
  return made;
}

/** Masses come last: fixtures without density would reset them. */
function load(world, bodies, body, made) {
  if (body.prescribed) return;
  made.setMassData({ mass: body.mass ?? 1, center: { x: 0, y: 0 }, I: body.inertia ?? 0 });
  made.applyForceToCenter(vec(body.force));
  made.applyTorque(body.torque);
  if (body.free) return;
  const anchor = addBody(world, { ...body, prescribed: true, turns: false, spinAfter: 0 });
  world.createJoint(new RevoluteJoint({}, anchor, made, vec(body.at)));
}

/** Box2D rounds polygons by a skin; the disc touches the skin, and overlaps it by a little to be found. */
function addContact(world, bodies, contact, index, size) {
  const filter = { friction: contact.friction, restitution: contact.restitution ?? 0, density: 0, filterGroupIndex: index + 1, filterMaskBits: 0,
                   userData: index };
  const [nx, ny] = contact.normal, { disc, half: r } = contact, skin = Settings.polygonRadius;
  const middle = contact.face.map((p, i) => p - (r + skin) * contact.normal[i]);
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) =>
    ({ x: middle[0] + r * (a * ny + b * nx), y: middle[1] + r * (b * ny - a * nx) }));
  bodies[contact.of].createFixture({ ...filter, shape: new Circle(vec(contact.centre), disc + 1e-9 * size) });
  bodies[contact.on].createFixture({ ...filter, shape: new Polygon(corners) });
}

function addJoint(world, bodies, joint, q) {
  const a = bodies[joint.first], b = bodies[joint.second], def = { collideConnected: true };
  const made = {
    pin: () => new RevoluteJoint(def, a, b, vec(joint.at)),
    slider: () => new PrismaticJoint(def, a, b, vec(joint.at), vec(joint.axis)),
    weld: () => new WeldJoint(def, a, b, vec(joint.at)),
    rod: () => new DistanceJoint(def, a, b, vec(joint.at), vec(joint.to)),
    rope: () => new RopeJoint({ ...def, bodyA: a, bodyB: b, maxLength: joint.length,
      localAnchorA: vec(q.arm(joint.first, joint.at)), localAnchorB: vec(q.arm(joint.second, joint.to)) }),
  }[joint.kind];
  if (!made) throw new Refused(`planck has no ${joint.kind} of this kind`);
  world.createJoint(made());
}

function told(world, q) {
  const pairs = q.contacts.map(() => [0, 0]);
  for (let c = world.getContactList(); c; c = c.getNext()) {
    const index = c.getFixtureA().getUserData(), points = c.getManifold().pointCount;
    if (points !== 1) throw new Error(`contact ${index} has ${points} points, expected 1`);
    const { normalImpulse, tangentImpulse } = c.getManifold().points[0], contact = q.contacts[index];
    const along = dot([contact.normal[1], -contact.normal[0]], contact.tangent);
    pairs[index] = [normalImpulse / q.step, (along * tangentImpulse) / q.step];
  }
  return pairs;
}

function ask(q) {
  const world = new World({ gravity: vec(q.gravity), allowSleep: false });
  const bodies = q.bodies.map((body) => addBody(world, body));
  q.contacts.forEach((contact, i) => addContact(world, bodies, contact, i, q.size));
  q.bodies.forEach((body, i) => load(world, bodies, body, bodies[i]));
  q.joints.forEach((joint) => addJoint(world, bodies, joint, q));
  q.friction.forEach((f) => world.createJoint(new FrictionJoint(
    { collideConnected: true, maxForce: 0, maxTorque: f.limit }, bodies[f.first], bodies[f.second], { x: 0, y: 0 })));
  const velocityIterations = q.iterations ?? 8, positionIterations = 3;
  world.step(q.step, velocityIterations, positionIterations);
  const velocities = bodies.map((b) => [b.getLinearVelocity().x, b.getLinearVelocity().y, b.getAngularVelocity()]);
  return { velocities, contacts: told(world, q), settings: { velocityIterations, positionIterations } };
}

await run({ name: "planck", version, law: "cone, by sweeps; the first step from rest", ask });
