// cannon-es: one step, 10 iterations by default. Contacts are handed over as contact equations in place of the engine's
// own search, friction as the engine makes it from them. Contacts are soft (stiffness 1e7, relaxation 3); with many
// iterations they are made stiff (1e12) and the tolerance of the iteration 0.
import { Refused, dot, engine, run, watch } from "./adapter.mjs";

const { module: cannon, version } = await engine("cannon-es");
const vec = ([x, y, z = 0]) => new cannon.Vec3(x, y, z);
const spinOf = (spin) => (Array.isArray(spin) ? vec(spin) : vec([0, 0, spin]));
const list = ({ x, y, z }) => [x, y, z];

function addBody(world, body) {
  const made = new cannon.Body({
    mass: body.prescribed ? 0 : body.mass ?? 1, position: vec(body.at), velocity: vec(body.velocityAfter),
    type: body.prescribed ? cannon.Body.KINEMATIC : cannon.Body.DYNAMIC, linearDamping: 0, angularDamping: 0,
    angularVelocity: spinOf(body.spinAfter), allowSleep: false });
  made.addShape(new cannon.Sphere(1));
  if (body.turn) {
    const [w, x, y, z] = body.turn;
    made.quaternion.set(x, y, z, w);
  }
  if (!body.prescribed && body.turn) {
    made.inertia.copy(vec(body.inertia));
    made.invInertia.copy(vec(body.inertia.map((i) => 1 / i)));
    made.updateSolveMassProperties();
    made.updateInertiaWorld(true);
    made.applyForce(vec(body.force));
    made.torque.vadd(vec(body.torque), made.torque);
  } else if (!body.prescribed) {
    const inertia = body.inertia ?? 1;
    made.inertia.set(inertia, inertia, inertia);
    made.invInertia.set(0, 0, body.turns ? 1 / inertia : 0);
    made.linearFactor = body.free ? new cannon.Vec3(1, 1, 0) : new cannon.Vec3(0, 0, 0);
    made.angularFactor = new cannon.Vec3(0, 0, body.turns ? 1 : 0);
    made.updateSolveMassProperties();
    made.updateInertiaWorld(true);
    if (!body.free && body.acceleration.some((a) => a !== 0)) throw new Refused("an axle that accelerates as prescribed");
    made.applyForce(vec(body.force));
    made.torque.z += body.torque;
  }
  world.addBody(made);
  return made;
}

function addJoint(world, bodies, joint, q) {
  const a = bodies[joint.first], b = bodies[joint.second];
  const at = vec(q.arm(joint.first, joint.at)), same = vec(q.arm(joint.second, joint.at));
  const local = (body, v) => body.quaternion.inverse().vmult(vec(v));
  const made = {
    hinge: () => new cannon.HingeConstraint(a, b, {
      pivotA: local(a, q.arm(joint.first, joint.at)), pivotB: local(b, q.arm(joint.second, joint.at)),
      axisA: local(a, joint.axis), axisB: local(b, joint.axis), maxForce: 1e12 }),
    pin: () => new cannon.PointToPointConstraint(a, at, b, same, 1e12),
    weld: () => new cannon.LockConstraint(a, b, { maxForce: 1e12 }),
  }[joint.kind];
  if (!made) throw new Refused(`cannon-es has no ${joint.kind} of this kind`);
  world.addConstraint(made());
}

/** In place of the engine's search: the contacts of the scene, and friction as the engine makes it from them. */
function give(world, bodies, q, kept) {
  const phase = world.narrowphase;
  phase.getContacts = (_a, _b, _world, result, _old, friction) => {
    q.contacts.forEach((contact, i) => {
      const a = bodies[contact.of], b = bodies[contact.on];
      const material = new cannon.ContactMaterial(new cannon.Material(), new cannon.Material(), {
        friction: contact.friction, restitution: contact.restitution ?? 0, ...stiff(q) });
      phase.currentContactMaterial = material;
      const equation = phase.createContactEquation(a, b, a.shapes[0], b.shapes[0], null, null);
      equation.ni.copy(vec(contact.normal.map((n) => -n))); // from the first body to the second
      equation.ri.copy(vec(q.arm(contact.of, contact.at)));
      equation.rj.copy(vec(q.arm(contact.on, contact.at)));
      result.push(equation);
      const before = friction.length;
      phase.createFrictionEquationsFromContact(equation, friction);
      kept[i] = { equation, friction: friction.slice(before) };
    });
  };
}

const stiff = (q) => (q.iterations ? { contactEquationStiffness: 1e12, frictionEquationStiffness: 1e12 } : {});

function told(q, kept) {
  return q.contacts.map((contact, i) => {
    if (!kept[i]) return [0, 0];
    const tangential = (tangent) => kept[i].friction.reduce((sum, e) => sum - e.multiplier * dot(tangent, list(e.t)), 0);
    return [kept[i].equation.multiplier, ...[contact.tangent, contact.second].filter(Boolean).map(tangential)];
  });
}

function ask(q) {
  if (q.friction.length > 0) throw new Refused("brakes and clutches");
  const world = new cannon.World({ gravity: vec(q.gravity) }), kept = [];
  world.broadphase.collisionPairs = (_world, a, b) => { a.push(world.bodies[0]); b.push(world.bodies[1]); };
  const bodies = q.bodies.map((body) => addBody(world, body));
  q.joints.forEach((joint) => addJoint(world, bodies, joint, q));
  give(world, bodies, q, kept);
  world.solver.iterations = q.iterations ?? 10;
  if (q.iterations) world.solver.tolerance = 0;
  world.step(q.step);
  const velocities = bodies.map((b) => (q.inSpace ? [...list(b.velocity), ...list(b.angularVelocity)]
    : [b.velocity.x, b.velocity.y, b.angularVelocity.z]));
  const contacts = told(q, kept);
  const again = () => {
    bodies.forEach((body, i) => {
      if (q.bodies[i].prescribed) return;
      body.applyForce(vec(q.bodies[i].force));
      body.torque.vadd(spinOf(q.bodies[i].torque), body.torque);
    });
    world.step(q.step);
  };
  const pose = (i) => ({ at: list(bodies[i].position), turn: [bodies[i].quaternion.w, ...list(bodies[i].quaternion)],
                         velocity: list(bodies[i].velocity), spin: list(bodies[i].angularVelocity) });
  return { velocities, contacts, watched: watch(q, again, pose), settings: { iterations: world.solver.iterations, tolerance: world.solver.tolerance } };
}

await run({ name: "cannon-es", version, ask,
            law: "impulses of friction, not forces, bounded by mu times gravity times the reduced mass; soft contacts (SPOOK); the first step from rest",
            lawInSpace: "pyramid of two directions of the engine's own; impulses of friction, not forces, bounded by mu times gravity times the reduced mass; soft contacts (SPOOK); the first step from rest" });
