// ammo.js, Bullet 2.82 in binary32 as asm.js: one step, sequential impulses, 10 iterations by default. It has no call that
// hands contacts over, so it is asked only with those that it finds between the whole shapes of a body and the floor. As in
// bullet.cpp, what pushes is added to the velocities before the step, and the floor is a box that the body overlaps a
// little. Overlaps change positions alone (split impulses), as binary32 needs one that by default would throw the body up
// in a short step. ammo tells no tangential impulses.
import { engine, run, watch } from "./adapter.mjs";

const { module: load, version } = await engine("ammojs-typed");
const Ammo = await load();
/** What is made for a question, to be freed after it, the last first: the heap is small. */
const owned = [];
const make = (kind, ...given) => (owned.push(new Ammo[kind](...given)), owned.at(-1));
const vec = ([x, y, z]) => make("btVector3", x, y, z), list = (v) => [v.x(), v.y(), v.z()];
const place = (at, [w, x, y, z]) => make("btTransform", make("btQuaternion", x, y, z, w), vec(at));
const upright = [1, 0, 0, 0];
const neverSleeps = 4; // DISABLE_DEACTIVATION

function makeWorld(q) {
  const configuration = make("btDefaultCollisionConfiguration");
  const world = make("btDiscreteDynamicsWorld", make("btCollisionDispatcher", configuration), make("btDbvtBroadphase"),
                     make("btSequentialImpulseConstraintSolver"), configuration);
  world.setGravity(vec([0, 0, 0]));
  const info = world.getSolverInfo();
  if (q.iterations) info.set_m_numIterations(q.iterations);
  info.set_m_splitImpulse(true);
  info.set_m_splitImpulsePenetrationThreshold(1); // all overlaps
  return world;
}

function shapeOf({ box, sphere, hull }) {
  if (box) return make("btBoxShape", vec(box.map((side) => side / 2)));
  if (sphere) return make("btSphereShape", sphere);
  const made = make("btConvexHullShape");
  hull.forEach((point) => made.addPoint(vec(point), true));
  made.setMargin(0);
  return made;
}

/** The body, in its principal axes, or the floor. */
function addBody(world, q, body, index) {
  const parts = make("btCompoundShape");
  const whole = index === 0 ? make("btBoxShape", vec([1, 1, 1].map((side) => 10 * side * q.size))) : parts;
  for (const shape of index === 0 ? [] : q.shapes) {
    const local = place([0, 0, 0], body.turn.map((t, i) => (i ? -t : t)));
    local.op_mul(place(shape.at, shape.turn));
    parts.addChildShape(local, shapeOf(shape));
  }
  const [x, y, z] = body.at, at = [x, y, z - (index === 0 ? 10 : 1e-6) * q.size];
  const info = make(
    "btRigidBodyConstructionInfo", index === 0 ? 0 : body.mass, make("btDefaultMotionState", place(at, index === 0 ? upright : body.turn)),
    whole, vec(index === 0 ? [0, 0, 0] : body.inertia));
  const made = make("btRigidBody", info);
  made.setFriction(index === 0 ? 1 : q.contacts[0].friction); // those of both bodies are multiplied
  made.setRestitution(index === 0 ? 1 : q.contacts[0].restitution ?? 0);
  made.setActivationState(neverSleeps);
  made.setFlags(0); // no gyroscopic forces
  world.addRigidBody(made);
  if (index === 0) return made;
  made.setLinearVelocity(vec(body.velocity));
  made.setAngularVelocity(vec(body.spin));
  return made;
}

function push(made, body, q) {
  const kick = (along, about) => { made.applyCentralImpulse(vec(along)); made.applyTorqueImpulse(vec(about)); };
  kick(body.force.map((f, i) => q.step * (f + body.mass * q.gravity[i])), body.torque.map((t) => q.step * t));
}

function ask(q) {
  const world = makeWorld(q), bodies = q.bodies.map((body, i) => addBody(world, q, body, i));
  const again = () => {
    push(bodies[1], q.bodies[1], q);
    world.stepSimulation(q.step, 1, q.step);
  };
  again();
  const pose = (i) => {
    const at = bodies[i].getWorldTransform(), turned = at.getRotation();
    return { at: list(at.getOrigin()), turn: [turned.w(), ...list(turned)], velocity: list(bodies[i].getLinearVelocity()),
             spin: list(bodies[i].getAngularVelocity()) };
  };
  const velocities = bodies.map((_, i) => [...pose(i).velocity, ...pose(i).spin]);
  const watched = watch(q, again, pose);
  const settings = { iterations: world.getSolverInfo().get_m_numIterations(), splitImpulse: "all overlaps" };
  bodies.forEach((body) => world.removeRigidBody(body));
  while (owned.length) Ammo.destroy(owned.pop());
  return { velocities, contacts: null, watched, settings };
}

await run({ name: "ammo-shapes", version, ask, law: "",
            lawInSpace: "one direction of friction at each contact, that in which it slips freely, by sweeps, at the contacts of whole shapes; the first step from rest" });
