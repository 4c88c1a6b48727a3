// Open Dynamics Engine: one step, by dWorldStep (Dantzig's method) or, with the argument `quick`, by dWorldQuickStep
// (sweeps). Contacts are handed over as contact joints; dContactApprox1 bounds friction by mu times the normal force,
// in two directions, in space those of the scene's tangents. In the plane the one out of it has none here: nothing
// pushes bodies out of their plane, and constraints that say so again would make the matrix singular. Plane2D joints
// hold what may not turn or not move. Contacts are a little deep, as they are in programs. At depth 0 Dantzig's method
// meets exact ties, such as the contact of two boxes that fall alike, gives up ("LCP internal error, s <= 0") and
// leaves all forces 0. Sweeps take the constraints in random orders; each scene begins with one seed, so that answers
// do not depend on the scenes before. With the argument `shapes` contacts are those that ODE finds between the whole
// shapes of a body and the floor.
#include <ode/ode.h>

#include <deque>

#include "adapter.hpp"

using namespace engines;

namespace {

class Scene {
 public:
  explicit Scene(const Question& q) : q_(q) {
    dWorldSetGravity(world_, q.gravity[0], q.gravity[1], q.gravity[2]);
    dWorldSetERP(world_, 1);
    for (const Body& body : q.bodies) add(body);
    for (const Joint& joint : q.joints) add(joint);
    for (const Friction& brake : q.friction) add(brake);
    if (!q.shapes.empty()) {
      add_shapes();
    } else {
      for (const Contact& contact : q.contacts) add(contact);
    }
  }
  ~Scene() {
    dJointGroupDestroy(found_);
    dJointGroupDestroy(joints_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  Answer step(bool quick) {
    Answer answer;
    if (quick && q_.iterations > 0) dWorldSetQuickStepNumIterations(world_, q_.iterations);
    dRandSetSeed(0);
    const auto make = [&] {
      find_contacts();
      quick ? dWorldQuickStep(world_, q_.step) : dWorldStep(world_, q_.step);
    };
    make();
    if (quick) answer.settings["iterations"] = dWorldGetQuickStepNumIterations(world_);
    answer.settings["CFM"] = dWorldGetCFM(world_);
    for (dBodyID body : bodies_) {
      const dReal zero[3] = {0, 0, 0};
      const dReal *v = body ? dBodyGetLinearVel(body) : zero, *w = body ? dBodyGetAngularVel(body) : zero;
      if (q_.in_space) {
        answer.velocity.push_back({v[0], v[1], v[2], w[0], w[1], w[2]});
      } else {
        answer.velocity.push_back({v[0], v[1], w[2]});
      }
    }
    answer.tells_forces = q_.shapes.empty();
    for (std::size_t i = 0; i < feedback_.size(); ++i) {
      const Vector f{feedback_[i].f1[0], feedback_[i].f1[1], feedback_[i].f1[2]};
      answer.push(q_.contacts[i], f);
    }
    if (!q_.watch.empty() && q_.in_space) {
      watch(
          q_, answer, [&] { push_all(), make(); },
          [&](std::size_t i) {
            const dBodyID b = bodies_[i];
            const dReal *at = dBodyGetPosition(b), *t = dBodyGetQuaternion(b), *v = dBodyGetLinearVel(b),
                        *w = dBodyGetAngularVel(b);
            return Pose{{at[0], at[1], at[2]}, {t[0], t[1], t[2], t[3]}, {v[0], v[1], v[2]}, {w[0], w[1], w[2]}};
          });
    }
    return answer;
  }

 private:
  void add(const Body& body) {
    if (body.is_ground()) {
      bodies_.push_back(nullptr);
      return;
    }
    dBodyID b = dBodyCreate(world_);
    bodies_.push_back(b);
    if (q_.in_space) return add_in_space(body, b);
    dBodySetPosition(b, body.at[0], body.at[1], 0);
    const Vector v = body.is_free ? body.velocity : body.velocity_after(q_.step);
    dBodySetLinearVel(b, v[0], v[1], 0);
    dBodySetAngularVel(b, 0, 0, body.turns ? body.spin : body.spin_after(q_.step));
    if (body.is_prescribed()) return dBodySetKinematic(b);
    const double i = body.turns ? body.inertia : 1;
    dMass mass;
    dMassSetParameters(&mass, body.is_free ? body.mass : 1, 0, 0, 0, i, i, i, 0, 0, 0);
    dBodySetMass(b, &mass);
    dBodySetGyroscopicMode(b, 0);
    dBodyAddForce(b, body.force[0], body.force[1], 0);
    dBodyAddTorque(b, 0, 0, body.torque);
    if (body.is_free && body.turns) return;
    dJointID plane = dJointCreatePlane2D(world_, joints_);
    dJointAttach(plane, b, nullptr);
    if (!body.turns) {
      dJointSetPlane2DAngleParam(plane, dParamVel, body.spin_after(q_.step));
      dJointSetPlane2DAngleParam(plane, dParamFMax, dInfinity);
    }
    if (!body.is_free) {
      dJointSetPlane2DXParam(plane, dParamVel, v[0]), dJointSetPlane2DXParam(plane, dParamFMax, dInfinity);
      dJointSetPlane2DYParam(plane, dParamVel, v[1]), dJointSetPlane2DYParam(plane, dParamFMax, dInfinity);
    }
  }

  void add_in_space(const Body& body, dBodyID b) {
    const Vector v = body.velocity_after(q_.step), &w = body.spins, &i = body.moments;
    dBodySetPosition(b, body.at[0], body.at[1], body.at[2]);
    const dQuaternion turn{body.turn[0], body.turn[1], body.turn[2], body.turn[3]};
    dBodySetQuaternion(b, turn);
    dBodySetLinearVel(b, v[0], v[1], v[2]);
    dBodySetAngularVel(b, w[0], w[1], w[2]);
    if (body.is_prescribed()) {
      if (body.turnings != Vector{}) throw Refused("a body that turns as prescribed");
      return dBodySetKinematic(b);
    }
    dMass mass;
    dMassSetParameters(&mass, body.mass, 0, 0, 0, i[0], i[1], i[2], 0, 0, 0);
    dBodySetMass(b, &mass);
    dBodySetGyroscopicMode(b, 0);
    push(body, b);
  }

  static void push(const Body& body, dBodyID b) {
    dBodyAddForce(b, body.force[0], body.force[1], body.force[2]);
    dBodyAddTorque(b, body.torques[0], body.torques[1], body.torques[2]);
  }
  void push_all() {
    for (std::size_t i = 1; i < bodies_.size(); ++i) {
      if (!q_.bodies[i].is_prescribed()) push(q_.bodies[i], bodies_[i]);
    }
  }

  void add(const Joint& joint) {
    dBodyID first = bodies_[joint.first], second = bodies_[joint.second];
    if (joint.kind == "pin" || joint.kind == "hinge") {
      const Vector axis = q_.in_space ? joint.axis : Vector{0, 0, 1};
      dJointID j = dJointCreateHinge(world_, joints_);
      dJointAttach(j, first, second);
      dJointSetHingeAnchor(j, joint.at[0], joint.at[1], joint.at[2]);
      dJointSetHingeAxis(j, axis[0], axis[1], axis[2]);
    } else if (joint.kind == "slider") {
      dJointID j = dJointCreateSlider(world_, joints_);
      dJointAttach(j, first, second);
      dJointSetSliderAxis(j, joint.axis[0], joint.axis[1], joint.axis[2]);
    } else if (joint.kind == "weld") {
      dJointID j = dJointCreateFixed(world_, joints_);
      dJointAttach(j, first, second);
      dJointSetFixed(j);
    } else if (joint.kind == "rod") {
      dJointID j = dJointCreateDBall(world_, joints_);
      dJointAttach(j, first, second);
      dJointSetDBallAnchor1(j, joint.at[0], joint.at[1], joint.at[2]);
      dJointSetDBallAnchor2(j, joint.to[0], joint.to[1], joint.to[2]);
    } else {
      throw Refused("ODE has no " + joint.kind);
    }
  }

  void add(const Friction& brake) {
    dJointID motor = dJointCreateAMotor(world_, joints_);
    dJointAttach(motor, bodies_[brake.first], bodies_[brake.second]);
    dJointSetAMotorNumAxes(motor, 1);
    dJointSetAMotorAxis(motor, 0, 0, 0, 0, 1);
    dJointSetAMotorParam(motor, dParamVel, 0);
    dJointSetAMotorParam(motor, dParamFMax, brake.limit);
  }

  /// The largest acceleration that gravity, forces and couples give to bodies that nothing holds; of an impact that of
  /// the fastest body, stopped in the step.
  double natural() const {
    double largest = std::sqrt(dot(q_.gravity, q_.gravity));
    for (const Body& body : q_.bodies) {
      if (q_.impact) largest = std::max(largest, std::sqrt(dot(body.velocity, body.velocity)) / q_.step);
      if (body.is_free) largest = std::max(largest, std::sqrt(dot(body.force, body.force)) / body.mass);
      if (body.turns && !q_.in_space) largest = std::max(largest, std::abs(body.torque) / body.inertia * q_.size);
    }
    return largest;
  }

  dContact rubbing(const Contact& contact) const {
    dContact given{};
    given.surface.mode = dContactApprox1 | dContactMu2;
    given.surface.mu = contact.friction;
    if (contact.restitution > 0) given.surface.mode |= dContactBounce, given.surface.bounce = contact.restitution;
    if (q_.in_space) given.surface.mu2 = contact.friction;
    given.geom.depth = 1e-9 * q_.step * q_.step * natural();
    return given;
  }

  /// The body overlaps the floor by a little, so that contacts are found.
  void add_shapes() {
    const dBodyID body = bodies_[1];
    const dReal* at = dBodyGetPosition(body);
    dBodySetPosition(body, at[0], at[1], at[2] - 1e-9 * q_.size);
    for (const Shape& shape : q_.shapes) {
      const bool ball = shape.radius > 0;
      dGeomID made =
          ball ? dCreateSphere(space_, shape.radius) : dCreateBox(space_, shape.box[0], shape.box[1], shape.box[2]);
      dGeomSetBody(made, body);
      dGeomSetOffsetWorldPosition(made, at[0] + shape.at[0], at[1] + shape.at[1], at[2] + shape.at[2]);
      const dQuaternion turn{shape.turn[0], shape.turn[1], shape.turn[2], shape.turn[3]};
      dGeomSetOffsetWorldQuaternion(made, turn);
      shapes_.push_back(made);
    }
  }

  void find_contacts() {
    dJointGroupEmpty(found_);
    for (dGeomID shape : shapes_) {
      dContactGeom points[8];
      const int count = dCollide(shape, floor_, 8, points, sizeof *points);
      for (int i = 0; i < count; ++i) {
        dContact given = rubbing(q_.contacts[0]);
        const dReal depth = given.geom.depth;
        given.geom = points[i], given.geom.depth = std::min(depth, points[i].depth);
        dJointAttach(dJointCreateContact(world_, found_, &given), bodies_[1], nullptr);
      }
    }
  }

  void add(const Contact& contact) {
    dContact given = rubbing(contact);
    given.surface.mode |= dContactFDir1;
    for (int i = 0; i < 3; ++i) {
      given.geom.pos[i] = contact.at[i], given.geom.normal[i] = contact.normal[i], given.fdir1[i] = contact.tangent[i];
    }
    dJointID joint = dJointCreateContact(world_, joints_, &given);
    dJointAttach(joint, bodies_[contact.of], bodies_[contact.on]);
    feedback_.emplace_back();
    dJointSetFeedback(joint, &feedback_.back());
  }

  const Question& q_;
  dWorldID world_ = dWorldCreate();
  dJointGroupID joints_ = dJointGroupCreate(0), found_ = dJointGroupCreate(0);
  dSpaceID space_ = dSimpleSpaceCreate(nullptr);
  dGeomID floor_ = dCreatePlane(space_, 0, 0, 1, 0);
  std::vector<dGeomID> shapes_;
  std::vector<dBodyID> bodies_;
  std::deque<dJointFeedback> feedback_;
};

}  // namespace

int main(int argc, char** argv) {
  const std::string how = argc > 1 ? argv[1] : "";
  const bool quick = how == "quick", whole = how == "shapes";
  const std::string pyramid = std::string("pyramid of two directions ") +
                              (whole ? "of the engine, at the contacts of whole shapes" : "along the scene's tangents"),
                    bounds =
                        ", each bounded by mu times the normal force that the contacts would have without friction",
                    step = "; the first step from rest";
  dInitODE();
  return run(
      {how.empty() ? "ode" : "ode-" + how, ENGINE_VERSION,
       quick ? "cone, by sweeps" + step
             : "friction bounded by mu times the normal force that the contacts would have without friction" + step,
       [&](const Question& q) { return Scene(q).step(quick); }, pyramid + (quick ? ", by sweeps" : bounds) + step});
}
