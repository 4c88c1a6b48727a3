// Jolt in binary32: one step, 10 velocity steps by default. In the plane, nothing pushes bodies out of it, and they are not
// locked to it: joints that hold an angle would have no inertia to act on. Contacts are found by the engine, between a
// sphere on one body and a box on the other that meet in the contact's point; pairs that belong to no contact are refused
// by a listener. With the argument `shapes` they are those of the whole shapes of a body on the floor. Jolt tells no forces.
import { Refused, cross, engine, run, turnAfter, turnBetween, watch } from "./adapter.mjs";

const { module, version } = await engine("jolt-physics");
const Jolt = await module();
const vec = ([x, y, z = 0]) => new Jolt.Vec3(x, y, z), at = ([x, y, z = 0]) => new Jolt.RVec3(x, y, z);
const upright = new Jolt.Quat(0, 0, 0, 1), spinOf = (spin) => (Array.isArray(spin) ? vec(spin) : vec([0, 0, spin]));
const list = (v) => [v.GetX(), v.GetY(), v.GetZ()];
const none = 1e6;

function makeWorld(q) {
  const settings = new Jolt.JoltSettings();
  const pairs = new Jolt.ObjectLayerPairFilterTable(1);
  pairs.EnableCollision(0, 0);
  const layers = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
  layers.MapObjectToBroadPhaseLayer(0, new Jolt.BroadPhaseLayer(0));
  settings.mObjectLayerPairFilter = pairs;
  settings.mBroadPhaseLayerInterface = layers;
  settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 1, pairs, 1);
  settings.mMaxWorkerThreads = 0;
  const world = new Jolt.JoltInterface(settings), system = world.GetPhysicsSystem();
  Jolt.destroy(settings);
  system.SetGravity(vec(q.gravity));
  const physics = system.GetPhysicsSettings();
  if (q.iterations) physics.mNumVelocitySteps = q.iterations;
  system.SetPhysicsSettings(physics);
  return { world, system, steps: physics.mNumVelocitySteps };
}

/** The whole shapes of the body on the floor, and the floor. */
function wholeShape(q, index) {
  const parts = new Jolt.StaticCompoundShapeSettings();
  const add = (settings, where, [w, x, y, z]) => parts.AddShape(vec(where), new Jolt.Quat(x, y, z, w), settings, 0);
  const still = [1, 0, 0, 0], far = 100 * q.size;
  const box = (sizes) => new Jolt.BoxShapeSettings(vec(sizes.map((size) => size / 2)), 0);
  if (index === 0) add(box([far, far, q.size]), [0, 0, -q.size / 2], still);
  for (const shape of index === 0 ? [] : q.shapes) {
    if (shape.box) add(box(shape.box), shape.at, shape.turn);
    if (shape.sphere) add(new Jolt.SphereShapeSettings(shape.sphere), shape.at, shape.turn);
    if (shape.hull) {
      const hull = new Jolt.ConvexHullShapeSettings();
      shape.hull.forEach((point) => hull.mPoints.push_back(vec(point)));
      hull.mMaxConvexRadius = 0;
      add(hull, shape.at, shape.turn);
    }
  }
  return aboutOrigin(parts);
}

/** With its centre of mass where the shapes are placed from. */
function aboutOrigin(parts) {
  const com = parts.Create().Get().GetCenterOfMass();
  return new Jolt.OffsetCenterOfMassShapeSettings(new Jolt.Vec3(-com.GetX(), -com.GetY(), -com.GetZ()), parts).Create().Get();
}

/** Spheres and boxes of all contacts of a body, each with the number of its contact, around the centre of mass. */
function shapeOf(q, index) {
  const parts = new Jolt.StaticCompoundShapeSettings(), zero = new Jolt.Vec3(0, 0, 0);
  const add = (settings, where, turned, number) => {
    settings.mUserData = number;
    parts.AddShape(where, turned, settings, 0);
  };
  add(new Jolt.SphereShapeSettings(0.05 * q.size), zero, upright, none);
  q.contacts.forEach((contact, i) => {
    const r = contact.half, [nx, ny] = contact.normal, half = Math.atan2(-nx, ny) / 2;
    const turn = q.inSpace ? turnBetween([0, 1, 0], contact.normal) : [0, 0, Math.sin(half), Math.cos(half)];
    if (contact.of === index) add(new Jolt.SphereShapeSettings(contact.disc + contact.overlap), vec(contact.centre), upright, i);
    if (contact.on === index) {
      add(new Jolt.BoxShapeSettings(new Jolt.Vec3(r, r, r), 0), vec(contact.face.map((p, k) => p - r * contact.normal[k])),
          new Jolt.Quat(...turn), i);
    }
  });
  return aboutOrigin(parts);
}

function addBody(system, q, body, index) {
  const kind = body.prescribed ? Jolt.EMotionType_Kinematic : Jolt.EMotionType_Dynamic;
  const settings = new Jolt.BodyCreationSettings(q.shapes ? wholeShape(q, index) : shapeOf(q, index), at(body.at), upright, kind, 0);
  settings.mAllowSleeping = settings.mUseManifoldReduction = false;
  settings.mFriction = q.shapes ? q.contacts[0].friction : 0;
  settings.mRestitution = 0;
  settings.mLinearDamping = settings.mAngularDamping = 0;
  settings.mMaxLinearVelocity = settings.mMaxAngularVelocity = 1e9;
  const made = system.GetBodyInterface().CreateBody(settings);
  system.GetBodyInterface().AddBody(made.GetID(), Jolt.EActivation_Activate);
  made.SetLinearVelocity(vec(body.velocityAfter));
  made.SetAngularVelocity(spinOf(body.spinAfter));
  if (body.prescribed) return made;
  if (!body.free && body.acceleration.some((a) => a !== 0)) throw new Refused("an axle that accelerates as prescribed");
  made.GetMotionProperties().SetInverseMass(body.free ? 1 / body.mass : 0);
  const inverse = body.turns ? 1 / body.inertia : 0, [w, x, y, z] = body.turn ?? [1, 0, 0, 0];
  made.GetMotionProperties().SetInverseInertia(vec(body.turn ? body.inertia.map((i) => 1 / i) : [inverse, inverse, inverse]),
                                               new Jolt.Quat(x, y, z, w));
  made.AddForce(vec(body.force));
  made.AddTorque(spinOf(body.torque));
  return made;
}

/** A direction of length 1 across another; in the plane out of it. */
function across(axis) {
  if (axis.length === 2) return [0, 0, 1];
  const made = cross(axis, Math.abs(axis[2]) < 0.5 ? [0, 0, 1] : [1, 0, 0]), length = Math.hypot(...made);
  return made.map((x) => x / length);
}

function addJoint(system, bodies, joint) {
  const settings = {
    pin: () => new Jolt.PointConstraintSettings(),
    weld: () => Object.assign(new Jolt.FixedConstraintSettings(), { mAutoDetectPoint: false }),
    hinge: () => {
      const made = new Jolt.HingeConstraintSettings();
      made.mHingeAxis1 = made.mHingeAxis2 = vec(joint.axis);
      made.mNormalAxis1 = made.mNormalAxis2 = vec(across(joint.axis));
      return made;
    },
    slider: () => {
      const made = new Jolt.SliderConstraintSettings();
      made.mSliderAxis1 = made.mSliderAxis2 = vec(joint.axis);
      made.mNormalAxis1 = made.mNormalAxis2 = vec(across(joint.axis));
      return made;
    },
    rod: () => Object.assign(new Jolt.DistanceConstraintSettings(), { mMinDistance: joint.length, mMaxDistance: joint.length }),
    rope: () => Object.assign(new Jolt.DistanceConstraintSettings(), { mMinDistance: 0, mMaxDistance: joint.length }),
  }[joint.kind]?.();
  if (!settings) throw new Refused(`Jolt has no ${joint.kind} of this kind`);
  settings.mPoint1 = at(joint.at);
  settings.mPoint2 = at(joint.to);
  system.AddConstraint(settings.Create(bodies[joint.first], bodies[joint.second]));
}

function listen(system, q, touching) {
  const listener = new Jolt.ContactListenerJS();
  const number = (body, shape) => body.GetShape().GetSubShapeUserData(shape);
  listener.OnContactValidate = (body1, body2, _offset, result) => {
    const [a, b] = [body1, body2].map((p) => Jolt.wrapPointer(p, Jolt.Body));
    const found = Jolt.wrapPointer(result, Jolt.CollideShapeResult);
    const i = number(a, found.mSubShapeID1), same = i !== none && i === number(b, found.mSubShapeID2);
    return same ? Jolt.ValidateResult_AcceptContact : Jolt.ValidateResult_RejectContact;
  };
  listener.OnContactAdded = (body1, _body2, manifold, settings) => {
    const given = Jolt.wrapPointer(settings, Jolt.ContactSettings);
    const i = number(Jolt.wrapPointer(body1, Jolt.Body), Jolt.wrapPointer(manifold, Jolt.ContactManifold).mSubShapeID1);
    given.mCombinedFriction = q.contacts[i].friction;
    given.mCombinedRestitution = q.contacts[i].restitution ?? 0;
    touching.add(i);
  };
  listener.OnContactPersisted = listener.OnContactAdded;
  listener.OnContactRemoved = () => {};
  system.SetContactListener(listener);
}

function ask(q) {
  if (q.friction.length > 0) throw new Refused("brakes and clutches");
  const { world, system, steps } = makeWorld(q), touching = new Set();
  if (!q.shapes) listen(system, q, touching);
  const bodies = q.bodies.map((body, i) => addBody(system, q, body, i));
  q.joints.forEach((joint) => addJoint(system, bodies, joint));
  world.Step(q.step, 1);
  if (!q.shapes && touching.size !== q.contacts.length) throw new Error(`${touching.size} contacts, expected ${q.contacts.length}`);
  const velocities = bodies.map((b) => (q.inSpace ? [...list(b.GetLinearVelocity()), ...list(b.GetAngularVelocity())]
    : [b.GetLinearVelocity().GetX(), b.GetLinearVelocity().GetY(), b.GetAngularVelocity().GetZ()]));
  const again = () => {
    bodies.forEach((body, i) => {
      if (q.bodies[i].prescribed) return;
      body.AddForce(vec(q.bodies[i].force));
      body.AddTorque(spinOf(q.bodies[i].torque));
    });
    world.Step(q.step, 1);
  };
  const turnOf = (rotation) => [rotation.GetW(), rotation.GetX(), rotation.GetY(), rotation.GetZ()];
  const watched = watch(q, again, (i) => ({ at: list(bodies[i].GetCenterOfMassPosition()),
                                            turn: turnAfter(turnOf(bodies[i].GetRotation()), q.bodies[i].turn),
                                            velocity: list(bodies[i].GetLinearVelocity()), spin: list(bodies[i].GetAngularVelocity()) }));
  Jolt.destroy(world);
  return { velocities, contacts: null, watched, settings: { mNumVelocitySteps: steps } };
}

const name = process.argv[2] === "shapes" ? "jolt-shapes" : "jolt-physics";
await run({ name, version, ask, law: "cone, by sweeps; the first step from rest",
            lawInSpace: `cone, by sweeps${name === "jolt-shapes" ? ", at the contacts of whole shapes" : ""}; the first step from rest` });
