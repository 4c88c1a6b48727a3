// Box2D 3 in binary32: one step of 4 substeps by default. Contacts are found by the engine, between a disc on one body
// and a box on the other that meet in the contact's point and nothing else.
import { Refused, engine, run, dot } from "./adapter.mjs";

const { module, version } = await engine("box2d3-wasm", "build/dist/es/compat/Box2D.compat.mjs");
const b2 = await module();
const vec = ([x, y]) => new b2.b2Vec2(x, y);

/** Members that are objects come as copies. */
function set(object, name, change) {
  const member = object[name];
  change(member);
  object[name] = member;
}

function addBody(world, body) {
  const def = b2.b2DefaultBodyDef();
  def.type = body.prescribed ? b2.b2BodyType.b2_kinematicBody : b2.b2BodyType.b2_dynamicBody;
  def.position = vec(body.at);
  def.linearVelocity = vec(body.velocityAfter);
  def.angularVelocity = body.spinAfter;
  def.enableSleep = false;
  def.allowFastRotation = true;
  set(def, "motionLocks", (locks) => { locks.angularZ = !body.turns; });
  return b2.b2CreateBody(world, def);
}

/** Masses come last: shapes without density would reset them. */
function load(world, body, made) {
  if (body.prescribed) return;
  const mass = new b2.b2MassData();
  mass.mass = body.mass ?? 1;
  mass.center = vec([0, 0]);
  mass.rotationalInertia = body.turns ? body.inertia : 0;
  b2.b2Body_SetMassData(made, mass);
  b2.b2Body_ApplyForceToCenter(made, vec(body.force), true);
  b2.b2Body_ApplyTorque(made, body.torque, true);
  if (!body.free) joint(world, "Revolute", addBody(world, { ...body, prescribed: true, turns: true, spinAfter: 0 }), made, [[0, 0], [0, 0]]);
}

function addContact(bodies, contact, index) {
  const def = b2.b2DefaultShapeDef(), r = contact.half, [nx, ny] = contact.normal;
  def.density = 0;
  set(def, "material", (material) => { material.friction = contact.friction; material.restitution = contact.restitution ?? 0; });
  set(def, "filter", (filter) => { filter.groupIndex = index + 1; filter.setMaskBits64("0"); });
  const disc = new b2.b2Circle();
  disc.center = vec(contact.centre);
  disc.radius = contact.disc + contact.overlap;
  const middle = contact.face.map((p, i) => p - r * contact.normal[i]);
  const box = b2.b2MakeOffsetBox(r, r, vec(middle), b2.b2MakeRot(Math.atan2(-nx, ny)));
  b2.b2CreatePolygonShape(bodies[contact.on], def, box);
  return b2.b2CreateCircleShape(bodies[contact.of], def, disc);
}

/** A joint with frames at the same place of both bodies, or at both ends; turned by an angle. */
function joint(world, kind, first, second, places, angle = 0, change = () => {}) {
  const def = b2[`b2Default${kind}JointDef`]();
  set(def, "base", (base) => {
    base.bodyIdA = first;
    base.bodyIdB = second;
    base.collideConnected = true;
    ["localFrameA", "localFrameB"].forEach((name, i) => set(base, name, (frame) => {
      frame.p = vec(places[i]);
      frame.q = b2.b2MakeRot(angle);
    }));
  });
  change(def);
  return b2[`b2Create${kind}Joint`](world, def);
}

function addJoint(world, bodies, given, q) {
  const ends = [bodies[given.first], bodies[given.second]];
  const same = [q.arm(given.first, given.at), q.arm(given.second, given.at)];
  const apart = [same[0], q.arm(given.second, given.to)];
  const made = {
    pin: () => joint(world, "Revolute", ...ends, same),
    weld: () => joint(world, "Weld", ...ends, same),
    slider: () => joint(world, "Prismatic", ...ends, same, Math.atan2(given.axis[1], given.axis[0])),
    rod: () => joint(world, "Distance", ...ends, apart, 0, (def) => { def.length = given.length; }),
    rope: () => joint(world, "Distance", ...ends, apart, 0, (def) => {
      Object.assign(def, { length: given.length, minLength: 0, maxLength: given.length, enableLimit: true,
                           enableSpring: true, hertz: 0 });
    }),
  }[given.kind];
  if (!made) throw new Refused(`Box2D 3 has no ${given.kind} of this kind`);
  made();
}

/** Box2D tells the friction of the last substep only: what it tells is used to see that the contacts are the scene's. */
function check(q, discs) {
  q.contacts.forEach((contact, i) => {
    const [data, more] = b2.b2Shape_GetContactData(discs[i], 4);
    if (!data) return; // it opened
    const { normal, pointCount } = data.manifold;
    const same = Math.abs(Math.abs(dot([normal.x, normal.y], contact.normal)) - 1) < 1e-3;
    if (more || pointCount > 1 || !same) throw new Error(`contact ${i} is not that of the scene`);
  });
}

function ask(q) {
  if (q.friction.length > 0) throw new Refused("brakes and clutches");
  const def = b2.b2DefaultWorldDef();
  def.gravity = vec(q.gravity);
  def.enableSleep = false;
  const world = b2.b2CreateWorld(def), bodies = q.bodies.map((body) => addBody(world, body));
  const discs = q.contacts.map((contact, i) => addContact(bodies, contact, i));
  q.bodies.forEach((body, i) => load(world, body, bodies[i]));
  q.joints.forEach((given) => addJoint(world, bodies, given, q));
  const substeps = q.iterations ?? 4;
  b2.b2World_Step(world, q.step, substeps);
  const velocities = bodies.map((id) => {
    const v = b2.b2Body_GetLinearVelocity(id);
    return [v.x, v.y, b2.b2Body_GetAngularVelocity(id)];
  });
  check(q, discs);
  b2.b2DestroyWorld(world);
  return { velocities, contacts: null, settings: { substeps } };
}

await run({ name: "box2d3", version, ask, law: "cone, by substeps with soft contacts; the first step from rest" });
