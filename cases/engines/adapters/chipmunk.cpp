// Chipmunk in binary64: one step, 10 iterations by default. Contacts are found by the engine, between a disc on one
// body and a segment on the other that meet in the contact's point and nothing else.
#include <chipmunk/chipmunk.h>
#include <unistd.h>

#include <cstdio>

#include "adapter.hpp"

using namespace engines;

namespace {

cpVect vec(const Vector& v) {
  return cpv(v[0], v[1]);
}

cpDataPointer number(std::size_t contact) {
  return reinterpret_cast<cpDataPointer>(contact + 1);
}

/// Only the two shapes of the same contact meet.
cpBool begin(cpArbiter* arbiter, cpSpace*, cpDataPointer) {
  CP_ARBITER_GET_SHAPES(arbiter, a, b)
  return cpShapeGetUserData(a) == cpShapeGetUserData(b);
}

class Scene {
 public:
  explicit Scene(const Question& q) : q_(q) {
    cpSpaceSetGravity(space_, vec(q.gravity));
    cpSpaceAddDefaultCollisionHandler(space_)->beginFunc = begin;
    for (const Body& body : q.bodies) add(body);
    for (const Contact& contact : q.contacts) add(contact);
    for (const Joint& joint : q.joints) add(joint);
    if (!q.friction.empty()) throw Refused("brakes and clutches");
  }
  ~Scene() {  // what is still in a space must not be freed before it; scenes are small, and a process is short
    cpSpaceFree(space_);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  Answer step() {
    if (q_.iterations > 0) cpSpaceSetIterations(space_, q_.iterations);
    Answer answer;
    answer.settings["iterations"] = cpSpaceGetIterations(space_);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (q_.bodies[i].is_prescribed()) continue;
      cpBodySetForce(bodies_[i], vec(q_.bodies[i].force)), cpBodySetTorque(bodies_[i], q_.bodies[i].torque);
    }
    cpSpaceStep(space_, q_.step);
    for (const Contact& contact : q_.contacts) answer.push(contact, 0, 0);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const cpVect v = cpBodyGetVelocity(bodies_[i]);
      answer.velocity.push_back({v.x, v.y, cpBodyGetAngularVelocity(bodies_[i])});
      told_ = &answer;
      cpBodyEachArbiter(
          bodies_[i],
          [](cpBody* body, cpArbiter* arbiter, void* scene) { static_cast<Scene*>(scene)->tell(body, arbiter); }, this);
    }
    return answer;
  }

 private:
  /// Chipmunk moves bodies before it looks for contacts. Before an impact bodies begin one step back, so that they are
  /// where the scene has them when they touch.
  void add(const Body& body) {
    cpBody* made = body.is_prescribed() ? cpBodyNewKinematic()
                                        : cpBodyNew(body.is_free ? body.mass : 1, body.turns ? body.inertia : INFINITY);
    bodies_.push_back(cpSpaceAddBody(space_, made));
    const cpVect velocity = vec(body.is_free ? body.velocity : body.velocity_after(q_.step));
    const double spin = body.turns ? body.spin : body.spin_after(q_.step), back = q_.impact ? q_.step : 0;
    const cpVect start = cpvsub(vec(body.at), cpvmult(velocity, back));
    cpBodySetPosition(made, start);
    cpBodySetAngle(made, -back * spin);
    cpBodySetVelocity(made, velocity);
    cpBodySetAngularVelocity(made, spin);
    if (body.is_free || body.is_prescribed()) return;
    cpBody* anchor = cpSpaceAddBody(space_, cpBodyNewKinematic());
    cpBodySetPosition(anchor, start);
    cpBodySetVelocity(anchor, velocity);
    cpSpaceAddConstraint(space_, cpPivotJointNew2(anchor, made, cpvzero, cpvzero));
  }

  /// The disc stays in touch by a small overlap.
  void add(const Contact& contact) {
    const std::size_t index = static_cast<std::size_t>(&contact - q_.contacts.data());
    const double r = q_.disc(contact), half = q_.half(contact);
    const Vector up = q_.arm(contact.of, contact.at), face = q_.arm(contact.on, contact.at), n = contact.normal;
    cpShape* disc =
        cpCircleShapeNew(bodies_[contact.of], r + 1e-9 * q_.size, vec({up[0] + r * n[0], up[1] + r * n[1]}));
    cpShape* line = cpSegmentShapeNew(bodies_[contact.on], vec({face[0] - half * n[1], face[1] + half * n[0]}),
                                      vec({face[0] + half * n[1], face[1] - half * n[0]}), 0);
    for (cpShape* shape : {disc, line}) {
      cpShapeSetFriction(shape, shape == disc ? contact.friction : 1);  // they are multiplied
      cpShapeSetElasticity(shape, shape == disc ? contact.restitution : 1);
      cpShapeSetUserData(shape, number(index));
      cpSpaceAddShape(space_, shape);
    }
  }

  void add(const Joint& joint) {
    cpBody *a = bodies_[joint.first], *b = bodies_[joint.second];
    const cpVect at = vec(q_.arm(joint.first, joint.at)), same = vec(q_.arm(joint.second, joint.at)),
                 to = vec(q_.arm(joint.second, joint.to)), along = vec(joint.axis);
    if (joint.kind == "pin" || joint.kind == "weld") {
      cpSpaceAddConstraint(space_, cpPivotJointNew2(a, b, at, same));
    } else if (joint.kind == "slider") {
      const cpVect far = cpvmult(along, 10 * q_.size);
      cpSpaceAddConstraint(space_, cpGrooveJointNew(a, b, cpvsub(at, far), cpvadd(at, far), same));
    } else if (joint.kind == "rod") {
      cpSpaceAddConstraint(space_, cpPinJointNew(a, b, at, to));
    } else if (joint.kind == "rope") {
      cpSpaceAddConstraint(space_, cpSlideJointNew(a, b, at, to, 0, joint.length));
    } else if (joint.kind == "gear" && q_.bodies[joint.carrier].is_ground() && !joint.one_sided) {
      cpSpaceAddConstraint(space_, cpGearJointNew(a, b, 0, joint.ratio));
    } else {
      throw Refused("Chipmunk has no " + joint.kind + " of this kind");
    }
    const bool turns = q_.bodies[joint.first].turns || q_.bodies[joint.second].turns;
    if (turns && (joint.kind == "weld" || joint.kind == "slider"))
      cpSpaceAddConstraint(space_, cpGearJointNew(a, b, 0, 1));
  }

  void tell(cpBody* body, cpArbiter* arbiter) {
    CP_ARBITER_GET_SHAPES(arbiter, shape, other)
    const std::size_t index = reinterpret_cast<std::size_t>(cpShapeGetUserData(shape)) - 1;
    const Contact& contact = q_.contacts[index];
    if (cpShapeGetUserData(shape) != cpShapeGetUserData(other) || body != bodies_[contact.of]) return;
    const cpVect impulse = cpvmult(cpArbiterTotalImpulse(arbiter), 1 / q_.step);  // on `body`
    const Vector force{impulse.x, impulse.y};
    told_->push(contact, dot(force, contact.normal), dot(force, contact.tangent));
  }

  const Question& q_;
  cpSpace* space_ = cpSpaceNew();
  std::vector<cpBody*> bodies_;
  Answer* told_ = nullptr;
};

/// Chipmunk greets on standard output, where answers go.
void let_greet() {
  const int out = dup(1);
  dup2(2, 1);
  cpSpaceFree(cpSpaceNew());
  std::fflush(stdout);
  dup2(out, 1);
}

}  // namespace

int main() {
  let_greet();
  return run({"chipmunk", cpVersionString, "cone, by sweeps; the first step from rest",
              [](const Question& q) { return Scene(q).step(); }});
}
