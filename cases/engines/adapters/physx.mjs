// PhysX in binary32, in space: one step of its own sweeps (PGS), 4 position iterations by default. Contacts are found by the
// engine, between a sphere on one body and a box on the other that meet in the contact's point; bits of the shapes' filters
// let only the two of a contact meet. With the argument `shapes` they are those of the whole shapes of a body on the floor.
// The package is made for browsers: it is loaded as if this were one. PhysX tells no forces here.
import { readFileSync } from "node:fs";
import { Refused, engine, run, turnAfter, turnBetween, watch } from "./adapter.mjs";

const { module: load, version } = await engine("physx-js-webidl");
const wasmBinary = readFileSync("node_modules/physx-js-webidl/physx-js-webidl.wasm"), node = globalThis.process;
[globalThis.process, globalThis.window] = [undefined, globalThis];
const PhysX = await load({ wasmBinary, locateFile: (name) => name });
globalThis.process = node;

const top = PhysX.PxTopLevelFunctions.prototype;
const foundation = top.CreateFoundation(top.PHYSICS_VERSION, new PhysX.PxDefaultAllocator(), new PhysX.PxDefaultErrorCallback());
const vec = ([x, y, z]) => new PhysX.PxVec3(x, y, z), list = ({ x, y, z }) => [x, y, z];
const place = (at, [x, y, z, w] = [0, 0, 0, 1]) => new PhysX.PxTransform(vec(at), new PhysX.PxQuat(x, y, z, w));
const last = ([w, x, y, z]) => [x, y, z, w];

function makeScene(q) {
  const scale = new PhysX.PxTolerancesScale();
  scale.length = q.size;
  const physics = top.CreatePhysics(top.PHYSICS_VERSION, foundation, scale);
  const described = new PhysX.PxSceneDesc(scale);
  described.gravity = vec(q.gravity);
  described.cpuDispatcher = top.DefaultCpuDispatcherCreate(0);
  described.filterShader = top.DefaultFilterShader();
  return { physics, scene: physics.createScene(described) };
}

/** A shape around the centre of mass, and the bit of its contact. */
function add({ physics }, q, body, geometry, pose, friction, bit) {
  const flags = new PhysX.PxShapeFlags(PhysX.PxShapeFlagEnum.eSIMULATION_SHAPE);
  const shape = physics.createShape(geometry, physics.createMaterial(friction, friction, 0), true, flags);
  shape.setContactOffset(0.02 * q.size);
  shape.setRestOffset(0);
  shape.setLocalPose(pose);
  shape.setSimulationFilterData(new PhysX.PxFilterData(bit, bit, 0, 0));
  body.attachShape(shape);
}

/** The whole shapes of the body on the floor, or the floor. */
function addWhole(world, q, made, index) {
  const far = 100 * q.size, friction = q.contacts[0].friction;
  const box = (sizes) => new PhysX.PxBoxGeometry(...sizes.map((size) => size / 2));
  if (index === 0) add(world, q, made, box([far, far, q.size]), place([0, 0, -q.size / 2]), friction, 1);
  for (const shape of index === 0 ? [] : q.shapes) {
    if (shape.hull) throw new Refused("the adapter has no hulls");
    add(world, q, made, shape.box ? box(shape.box) : new PhysX.PxSphereGeometry(shape.sphere), place(shape.at, last(shape.turn)),
        friction, 1);
  }
}

/** Spheres and boxes of all contacts of a body. */
function addContacts(world, q, made, index) {
  q.contacts.forEach((c, i) => {
    const bit = 2 ** i, r = c.half;
    if (c.of === index) add(world, q, made, new PhysX.PxSphereGeometry(c.disc + c.overlap), place(c.centre), c.friction, bit);
    if (c.on !== index) return;
    const middle = c.face.map((p, k) => p - r * c.normal[k]);
    add(world, q, made, new PhysX.PxBoxGeometry(r, r, r), place(middle, turnBetween([0, 0, 1], c.normal)), c.friction, bit);
  });
}

function addBody(world, q, body, index) {
  const made = world.physics.createRigidDynamic(place(body.at));
  (q.shapes ? addWhole : addContacts)(world, q, made, index);
  made.setRigidBodyFlag(PhysX.PxRigidBodyFlagEnum.eKINEMATIC, body.prescribed);
  world.scene.addActor(made);
  if (body.prescribed) {
    made.setKinematicTarget(place(body.at.map((p, k) => p + q.step * body.velocityAfter[k])));
    return made;
  }
  const [w, x, y, z] = body.turn;
  made.setMass(body.mass);
  made.setMassSpaceInertiaTensor(vec(body.inertia));
  made.setCMassLocalPose(place([0, 0, 0], [x, y, z, w]));
  made.setAngularDamping(0);
  made.setMaxLinearVelocity(1e9);
  made.setMaxAngularVelocity(1e9);
  made.setSleepThreshold(0);
  made.setStabilizationThreshold(0);
  if (q.iterations) made.setSolverIterationCounts(q.iterations, q.iterations);
  made.setLinearVelocity(vec(body.velocityAfter));
  made.setAngularVelocity(vec(body.spinAfter));
  push(made, body);
  return made;
}

function push(made, body) {
  made.addForce(vec(body.force));
  made.addTorque(vec(body.torque));
}

function ask(q) {
  if (q.joints.length > 0) throw new Refused("the adapter has no joints");
  if (q.contacts.length > 31) throw new Refused("more contacts than a filter has bits");
  if (q.bodies.some((body) => body.prescribed && Math.hypot(...body.spinAfter))) throw new Refused("a body that turns as prescribed");
  const world = makeScene(q), bodies = q.bodies.map((body, i) => addBody(world, q, body, i));
  const step = () => {
    world.scene.simulate(q.step);
    world.scene.fetchResults(true);
  };
  step();
  const velocities = bodies.map((b) => [...list(b.getLinearVelocity()), ...list(b.getAngularVelocity())]);
  const again = () => {
    bodies.forEach((made, i) => q.bodies[i].prescribed || push(made, q.bodies[i]));
    step();
  };
  const watched = watch(q, again, (i) => {
    const { p, q: turned } = bodies[i].getGlobalPose();
    return { at: list(p), turn: turnAfter([turned.w, ...list(turned)], q.bodies[i].turn),
             velocity: list(bodies[i].getLinearVelocity()), spin: list(bodies[i].getAngularVelocity()) };
  });
  world.scene.release();
  world.physics.release();
  return { velocities, contacts: null, watched, settings: { positionIterations: q.iterations ?? 4, velocityIterations: q.iterations ?? 1 } };
}

const name = process.argv[2] === "shapes" ? "physx-shapes" : "physx";
await run({ name, version: `5.6.1 (${version})`, ask, law: "",
            lawInSpace: `patches of friction, by sweeps${name === "physx" ? "" : ", at the contacts of whole shapes"}; the first step from rest` });
