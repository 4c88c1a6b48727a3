// Rapier in binary32, in the plane or, with the argument 3d, in space. There nothing pushes bodies of the plane out of it,
// and they are not locked to it: friction out of the plane would have no mass to act on. Contacts are found by the engine, between a ball on one body and a box on the other that meet in the contact's point and nothing
// else; with the argument `shapes` they are those of the whole shapes of a body on the floor. The default is 4 solver iterations, which are substeps.
import { Refused, dot, engine, run, turnAfter, turnBetween, watch } from "./adapter.mjs";

const whole = process.argv[2] === "shapes", space = whole || process.argv[2] === "3d";
const { module: rapier, version } = await engine(`@dimforge/rapier${space ? 3 : 2}d-compat`);
const { log } = console;
console.log = console.warn = () => {}; // a notice while it loads
await rapier.init();
console.log = log;

const vec = ([x, y, z = 0]) => (space ? { x, y, z } : { x, y });
const three = ([x, y, z = 0]) => (space ? [x, y, z] : [x, y]), list = ({ x, y, z }) => [x, y, z];
const spinOf = (spin) => (Array.isArray(spin) ? vec(spin) : space ? { x: 0, y: 0, z: spin } : spin);
const upright = space ? { x: 0, y: 0, z: 0, w: 1 } : 0;

function addBody(world, body, step) {
  const desc = body.prescribed ? rapier.RigidBodyDesc.kinematicVelocityBased() : rapier.RigidBodyDesc.dynamic();
  desc.setTranslation(...three(body.at)).setLinvel(...three(body.velocityAfter)).setCanSleep(false);
  desc.setAngvel(spinOf(body.spinAfter));
  const made = world.createRigidBody(desc);
  if (body.prescribed) return made;
  if (!body.free && body.acceleration.some((a) => a !== 0)) throw new Refused("an axle that accelerates as prescribed");
  if (!body.free) made.lockTranslations(true, true);
  if (!body.turns) made.lockRotations(true, true);
  const mass = body.mass ?? 1, inertia = body.inertia ?? 1;
  const [w, x, y, z] = body.turn ?? [1, 0, 0, 0], moments = body.turn ? body.inertia : [inertia, inertia, inertia];
  if (space) made.setAdditionalMassProperties(mass, vec([0, 0]), vec(moments), { x, y, z, w }, true);
  else made.setAdditionalMassProperties(mass, vec([0, 0]), inertia, true);
  made.addForce(vec(body.force), true);
  made.addTorque(spinOf(body.torque), true);
  return made;
}

/** Pairs of colliders are let through by hooks, which know of which contact each is. */
function addContact(world, bodies, contact) {
  const r = contact.half, [nx, ny] = contact.normal, angle = Math.atan2(-nx, ny);
  const [x, y, z, w] = contact.second ? turnBetween([0, 1, 0], contact.normal) : [0, 0, Math.sin(angle / 2), Math.cos(angle / 2)];
  const turned = space ? { x, y, z, w } : angle;
  const add = (desc, at, body) => world.createCollider(
    desc.setTranslation(...three(at)).setDensity(0).setFriction(contact.friction).setRestitution(contact.restitution ?? 0)
      .setActiveHooks(rapier.ActiveHooks.FILTER_CONTACT_PAIRS)
      .setActiveCollisionTypes(rapier.ActiveCollisionTypes.ALL), bodies[body]).handle;
  const box = rapier.ColliderDesc.cuboid(r, r, r).setRotation(turned);
  // Substeps find the distance again, in binary32: it takes ten times the overlap to keep rounding from opening gaps.
  return [add(rapier.ColliderDesc.ball(contact.disc + 10 * contact.overlap), contact.centre, contact.of),
          add(box, contact.face.map((p, i) => p - r * contact.normal[i]), contact.on)];
}

/** The whole shapes of the body on the floor, and the floor. */
function addShapes(world, bodies, q) {
  const far = 100 * q.size, add = (desc, body) => world.createCollider(desc.setDensity(0).setFriction(q.contacts[0].friction), bodies[body]);
  add(rapier.ColliderDesc.cuboid(far, far, q.size).setTranslation(0, 0, -q.size), 0);
  for (const { box, sphere, hull, at, turn: [w, x, y, z] } of q.shapes) {
    const desc = box ? rapier.ColliderDesc.cuboid(...box.map((size) => size / 2)) : sphere ? rapier.ColliderDesc.ball(sphere)
      : rapier.ColliderDesc.convexHull(new Float32Array(hull.flat()));
    add(desc.setTranslation(...at).setRotation({ x, y, z, w }), 1);
  }
}

function addJoint(world, bodies, joint, q) {
  const at = vec(q.arm(joint.first, joint.at)), to = vec(q.arm(joint.second, joint.to));
  const same = vec(q.arm(joint.second, joint.at)), { JointData } = rapier;
  const data = {
    hinge: () => JointData.revolute(at, same, vec(joint.axis)), // bodies are not turned at the start
    pin: () => (space ? JointData.revolute(at, same, { x: 0, y: 0, z: 1 }) : JointData.revolute(at, same)),
    slider: () => JointData.prismatic(at, same, vec(joint.axis)),
    weld: () => JointData.fixed(at, upright, same, upright),
    rope: () => JointData.rope(joint.length, at, to),
  }[joint.kind];
  if (!data) throw new Refused(`Rapier has no ${joint.kind} of this kind`);
  world.createImpulseJoint(data(), bodies[joint.first], bodies[joint.second], true);
}

/** [normal, tangential] force of each contact. In space Rapier does not tell along which directions friction counts. */
function told(world, q, colliders) {
  return q.contacts.map((contact, i) => {
    let pair = [0, 0];
    world.contactPair(...colliders[i].map((handle) => world.getCollider(handle)), (manifold, flipped) => {
      if (manifold.numContacts() !== 1) throw new Error(`contact ${i} has ${manifold.numContacts()} points, expected 1`);
      const { x, y } = manifold.normal();
      const along = dot([y, -x], contact.tangent);
      pair = [manifold.contactImpulse(0) / q.step, (along * manifold.contactTangentImpulse(0)) / q.step];
    });
    return pair;
  });
}

function ask(q) {
  if (q.friction.length > 0) throw new Refused("brakes and clutches");
  const world = new rapier.World(vec(q.gravity));
  const bodies = q.bodies.map((body) => addBody(world, body));
  if (q.shapes) addShapes(world, bodies, q);
  const colliders = q.shapes ? [] : q.contacts.map((contact) => addContact(world, bodies, contact));
  q.joints.forEach((joint) => addJoint(world, bodies, joint, q));
  world.timestep = q.step;
  if (q.iterations) world.integrationParameters.numSolverIterations = q.iterations;
  const of = new Map(colliders.flatMap((pair, i) => pair.map((handle) => [handle, i])));
  const filterContactPair = (a, b) => (of.get(a) === of.get(b) ? rapier.SolverFlags.COMPUTE_IMPULSE : null);
  const make = () => q.shapes ? world.step() : world.step(new rapier.EventQueue(true), { filterContactPair, filterIntersectionPair: () => false });
  make();
  const velocities = bodies.map((b) => (q.inSpace ? [...list(b.linvel()), ...list(b.angvel())]
    : [b.linvel().x, b.linvel().y, space ? b.angvel().z : b.angvel()]));
  const { numSolverIterations, numInternalPgsIterations } = world.integrationParameters;
  const settings = { numSolverIterations, numInternalPgsIterations };
  const contacts = space ? null : told(world, q, colliders);
  // Forces stay until they are reset.
  const pose = (i) => ({ at: list(bodies[i].translation()), velocity: list(bodies[i].linvel()), spin: list(bodies[i].angvel()),
                         turn: turnAfter([bodies[i].rotation().w, ...list(bodies[i].rotation())], q.bodies[i].turn) });
  const watched = space ? watch(q, make, pose) : null;
  world.free();
  return { velocities, contacts, watched, settings };
}

await run({ name: whole ? "rapier3d-shapes" : space ? "rapier3d" : "rapier2d", version, ask,
            law: `cone, by substeps with soft contacts${space ? "; in space" : ""}; the first step from rest`,
            lawInSpace: space && `cone, by substeps with soft contacts${whole ? ", at the contacts of whole shapes" : ""}; the first step from rest` });
