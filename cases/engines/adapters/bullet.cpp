// Bullet in binary64: one step of btDiscreteDynamicsWorld, sequential impulses, 10 iterations by default. Contacts are
// handed over as points of manifolds, so that they are those of the scene. In the plane, bodies move in it only. What
// pushes is added to the velocities before the step: Bullet's friction does not see a couple that is applied in the
// same step. With the argument `applied` it is applied as force and couple, as programs do. With `taken-back` the
// friction of contacts whose normal impulse fell to 0 is taken back after each sweep, which Bullet does not do: a test
// of whose mistake it is. With `two` contacts have two directions of friction, not one as by default. With
// `shapes` contacts are those that Bullet finds between the whole shapes of a body and the floor.
#include <btBulletDynamicsCommon.h>

#include <memory>

#include "adapter.hpp"

using namespace engines;

namespace {

btVector3 vec(const Vector& v) {
  return {v[0], v[1], v[2]};
}
Vector vector_of(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

/// A world whose contacts are given, unless it has whole shapes.
class GivenContacts : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;
  void performDiscreteCollisionDetection() override {
    if (finds) btDiscreteDynamicsWorld::performDiscreteCollisionDetection();
  }
  bool finds = false;
};

/// Sweeps after which no contact has friction without a normal impulse.
class TakingBack : public btSequentialImpulseConstraintSolver {
  btScalar solveSingleIteration(int iteration, btCollisionObject** bodies, int body_count,
                                btPersistentManifold** manifolds, int manifold_count, btTypedConstraint** constraints,
                                int constraint_count, const btContactSolverInfo& info, btIDebugDraw* drawn) override {
    const btScalar left = btSequentialImpulseConstraintSolver::solveSingleIteration(
        iteration, bodies, body_count, manifolds, manifold_count, constraints, constraint_count, info, drawn);
    for (int i = 0; i < m_tmpSolverContactFrictionConstraintPool.size(); ++i) {
      btSolverConstraint& row = m_tmpSolverContactFrictionConstraintPool[i];
      if (m_tmpSolverContactConstraintPool[row.m_frictionIndex].m_appliedImpulse > 0) continue;
      push(row.m_solverBodyIdA, row.m_contactNormal1, row.m_angularComponentA, -row.m_appliedImpulse);
      push(row.m_solverBodyIdB, row.m_contactNormal2, row.m_angularComponentB, -row.m_appliedImpulse);
      row.m_appliedImpulse = 0;
    }
    return left;
  }
  void push(int number, const btVector3& along, const btVector3& turning, btScalar impulse) {
    btSolverBody& body = m_tmpSolverBodyPool[number];
    body.internalApplyImpulse(along * body.internalGetInvMass(), turning, impulse);
  }
};

class Scene {
 public:
  Scene(const Question& q, bool applied, bool taken_back, bool two_directions)
      : q_(q),
        applied_(applied),
        two_directions_(two_directions),
        solver_(taken_back ? std::make_unique<TakingBack>() : std::make_unique<btSequentialImpulseConstraintSolver>()) {
    world_.finds = !q.shapes.empty();
    world_.setGravity(applied ? vec(q.gravity) : btVector3(0, 0, 0));
    for (const Body& body : q.bodies) add(body);
    for (const Joint& joint : q.joints) add(joint);
    for (const Friction& brake : q.friction) add(brake);
    for (const Contact& contact : q.contacts) {
      if (!world_.finds) add(contact);
    }
  }
  ~Scene() {
    for (auto& joint : joints_) world_.removeConstraint(joint.get());
    for (auto& body : bodies_) world_.removeRigidBody(body.get());
    for (btPersistentManifold* manifold : manifolds_) dispatcher_.releaseManifold(manifold);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  Answer step() {
    btContactSolverInfo& info = world_.getSolverInfo();
    if (two_directions_) info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    if (q_.iterations > 0) info.m_numIterations = q_.iterations, info.m_leastSquaresResidualThreshold = 0;
    Answer answer;
    answer.settings["iterations"] = info.m_numIterations;
    world_.stepSimulation(q_.step, 1, q_.step);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const btVector3 v = bodies_[i]->getLinearVelocity(), w = bodies_[i]->getAngularVelocity();
      if (q_.in_space) {
        answer.velocity.push_back({v.x(), v.y(), v.z(), w.x(), w.y(), w.z()});
      } else {
        answer.velocity.push_back({v.x(), v.y(), w.z()});
      }
    }
    answer.tells_forces = !world_.finds;
    for (std::size_t i = 0; i < manifolds_.size(); ++i) {
      const btManifoldPoint& point = manifolds_[i]->getContactPoint(0);
      const btVector3 friction = point.m_appliedImpulseLateral1 * point.m_lateralFrictionDir1 +
                                 point.m_appliedImpulseLateral2 * point.m_lateralFrictionDir2;
      answer.push(q_.contacts[i],
                  vector_of((point.m_appliedImpulse * vec(q_.contacts[i].normal) + friction) / q_.step));
    }
    if (!q_.watch.empty() && q_.in_space) {
      watch(
          q_, answer, [&] { step_again(); },
          [&](std::size_t i) {
            const btRigidBody& body = *bodies_[i];
            const btQuaternion t = body.getOrientation();
            return Pose{vector_of(body.getCenterOfMassPosition()),
                        {t.w(), t.x(), t.y(), t.z()},
                        vector_of(body.getLinearVelocity()),
                        vector_of(body.getAngularVelocity())};
          });
    }
    return answer;
  }

 private:
  /// A sphere that touches nothing; or the floor, or the whole shapes of the body on it. The floor is a box, which
  /// it overlaps by a little: of a box on a plane Bullet finds one corner in each step.
  btCollisionShape* shape_of(const Body& body) {
    if (!world_.finds) return &shape_;
    if (body.is_ground()) return &floor_;
    const Quaternion& t = body.turn;
    const btTransform back = btTransform(btQuaternion(t[1], t[2], t[3], t[0])).inverse();
    for (const Shape& shape : q_.shapes) {
      const Quaternion& own = shape.turn;
      if (shape.radius > 0) {
        wholes_.push_back(std::make_unique<btSphereShape>(shape.radius));
      } else {
        wholes_.push_back(std::make_unique<btBoxShape>(vec(shape.box) / 2));
      }
      const btTransform place(btQuaternion(own[1], own[2], own[3], own[0]), vec(shape.at));
      body_.addChildShape(back * place, wholes_.back().get());
    }
    return &body_;
  }

  void add_in_space(const Body& body) {
    const double mass = body.is_prescribed() ? 0 : body.mass;
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape_of(body), vec(body.moments));
    if (world_.finds && !body.is_ground()) {  // both are multiplied
      info.m_friction = q_.contacts[0].friction, info.m_restitution = q_.contacts[0].restitution;
    } else {
      info.m_friction = info.m_restitution = 1;
    }
    const Quaternion& turn = body.turn;
    info.m_startWorldTransform = btTransform(btQuaternion(turn[1], turn[2], turn[3], turn[0]), vec(body.at));
    if (world_.finds)
      info.m_startWorldTransform.getOrigin() += btVector3(0, 0, body.is_ground() ? -10 : -1e-12) * q_.size;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& made = *bodies_.back();
    made.setActivationState(DISABLE_DEACTIVATION);
    made.setFlags(0);  // no gyroscopic forces
    if (body.is_prescribed() && !body.is_ground()) {
      if (body.turnings != Vector{} || body.spins != Vector{}) throw Refused("a body that turns as prescribed");
      made.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    }
    if (world_.finds) {
      world_.addRigidBody(&made);
    } else {
      world_.addRigidBody(&made, 0, 0);
    }
    made.setLinearVelocity(vec(body.velocity_after(q_.step)));
    made.setAngularVelocity(vec(body.spins));
    if (body.is_prescribed()) {  // Bullet takes the velocity of such a body from where it was one step before
      btTransform before = made.getWorldTransform();
      before.setOrigin(before.getOrigin() - q_.step * made.getLinearVelocity());
      made.setInterpolationWorldTransform(before);
    } else {
      push(body, made);
    }
  }

  void push(const Body& body, btRigidBody& made) const {
    if (applied_) {
      made.applyCentralForce(vec(body.force));
      made.applyTorque(vec(body.torques));
    } else {
      made.setLinearVelocity(made.getLinearVelocity() + q_.step * (vec(q_.gravity) + vec(body.force) / body.mass));
      made.setAngularVelocity(made.getAngularVelocity() +
                              q_.step * (made.getInvInertiaTensorWorld() * vec(body.torques)));
    }
  }
  /// One more step in space.
  void step_again() {
    for (std::size_t i = 1; i < bodies_.size(); ++i) {
      if (!q_.bodies[i].is_prescribed()) push(q_.bodies[i], *bodies_[i]);
    }
    world_.stepSimulation(q_.step, 1, q_.step);
  }

  void add(const Body& body) {
    if (q_.in_space) return add_in_space(body);
    const double mass = body.is_prescribed() ? 0
                        : body.is_free       ? body.mass
                                             : 1,
                 inertia = body.turns ? body.inertia : 1;
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape_, btVector3(inertia, inertia, inertia));
    info.m_startWorldTransform.setIdentity();
    info.m_startWorldTransform.setOrigin(vec(body.at));
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& made = *bodies_.back();
    made.setActivationState(DISABLE_DEACTIVATION);
    made.setLinearFactor(body.is_free ? btVector3(1, 1, 0) : btVector3(0, 0, 0));
    made.setAngularFactor(body.turns ? btVector3(0, 0, 1) : btVector3(0, 0, 0));
    if (body.is_prescribed() && !body.is_ground()) made.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    if (!body.is_free && !body.is_prescribed() && (body.acceleration[0] != 0 || body.acceleration[1] != 0))
      throw Refused("an axle that accelerates as prescribed");
    world_.addRigidBody(&made, 0, 0);
    made.setLinearVelocity(vec(body.is_free ? body.velocity : body.velocity_after(q_.step)));
    made.setAngularVelocity({0, 0, body.turns ? body.spin : body.spin_after(q_.step)});
    if (body.is_prescribed() && !body.is_ground()) {
      // Bullet takes the velocity of such a body from where it was one step before.
      const btVector3 v = made.getLinearVelocity();
      btTransform before = made.getWorldTransform();
      before.setOrigin(before.getOrigin() - q_.step * v);
      made.setInterpolationWorldTransform(before);
      if (body.spin_after(q_.step) != 0) throw Refused("a body that turns as prescribed");
    }
    if (applied_) {
      made.applyCentralForce(vec(body.force));
      made.applyTorque({0, 0, body.torque});
    } else {
      if (body.is_free)
        made.setLinearVelocity(made.getLinearVelocity() + q_.step * (vec(q_.gravity) + vec(body.force) / mass));
      if (body.turns) made.setAngularVelocity({0, 0, body.spin + q_.step * body.torque / inertia});
    }
  }

  /// In the axes of a body.
  btVector3 local(std::size_t body, const Vector& v) const { return vec(in_body(q_.bodies[body], v)); }
  btVector3 arm(std::size_t body, const Vector& point) const { return local(body, q_.arm(body, point)); }

  template <class J, class... Arguments>
  J& create(const Joint& joint, Arguments&&... arguments) {
    joints_.push_back(std::make_unique<J>(*bodies_[joint.first], *bodies_[joint.second], arguments...));
    world_.addConstraint(joints_.back().get(), true);
    return static_cast<J&>(*joints_.back());
  }

  void add(const Joint& joint) {
    const btVector3 a = arm(joint.first, joint.at), b = arm(joint.second, joint.at);
    const btTransform at_a(btQuaternion::getIdentity(), a), at_b(btQuaternion::getIdentity(), b);
    if (joint.kind == "pin") {
      create<btPoint2PointConstraint>(joint, a, b);
    } else if (joint.kind == "weld") {
      create<btFixedConstraint>(joint, at_a, at_b);
    } else if (joint.kind == "hinge") {
      create<btHingeConstraint>(joint, a, b, local(joint.first, joint.axis), local(joint.second, joint.axis));
    } else if (joint.kind == "slider" && q_.in_space) {
      const btTransform at(shortestArcQuat({1, 0, 0}, vec(joint.axis)), vec(joint.at));
      auto& made = create<btSliderConstraint>(joint, bodies_[joint.first]->getWorldTransform().inverse() * at,
                                              bodies_[joint.second]->getWorldTransform().inverse() * at, true);
      made.setLowerLinLimit(1), made.setUpperLinLimit(-1);
      made.setLowerAngLimit(0), made.setUpperAngLimit(0);
    } else if (joint.kind == "slider") {
      const btQuaternion turned({0, 0, 1}, std::atan2(joint.axis[1], joint.axis[0]));
      auto& made = create<btSliderConstraint>(joint, btTransform(turned, a), btTransform(turned, b), true);
      made.setLowerLinLimit(1), made.setUpperLinLimit(-1);
      made.setLowerAngLimit(0), made.setUpperAngLimit(0);
    } else {
      throw Refused("Bullet has no " + joint.kind);
    }
  }

  void add(const Friction& brake) {
    Joint joint;
    joint.first = brake.first, joint.second = brake.second;
    auto& made =
        create<btHingeConstraint>(joint, btVector3(0, 0, 0), vec(q_.arm(brake.second, q_.bodies[brake.first].at)),
                                  btVector3(0, 0, 1), btVector3(0, 0, 1));
    made.setAngularOnly(true);
    made.enableAngularMotor(true, 0, brake.limit * q_.step);
  }

  void add(const Contact& contact) {
    btManifoldPoint point(arm(contact.of, contact.at), arm(contact.on, contact.at), vec(contact.normal), 0);
    point.m_positionWorldOnA = point.m_positionWorldOnB = vec(contact.at);
    point.m_combinedFriction = contact.friction;
    point.m_combinedRestitution = contact.restitution;
    btPersistentManifold* manifold = dispatcher_.getNewManifold(bodies_[contact.of].get(), bodies_[contact.on].get());
    manifold->addManifoldPoint(point);
    manifolds_.push_back(manifold);
  }

  const Question& q_;
  const bool applied_, two_directions_;
  btSphereShape shape_{1};
  btBoxShape floor_{btVector3(1, 1, 1) * 10 * q_.size};
  btCompoundShape body_;
  std::vector<std::unique_ptr<btCollisionShape>> wholes_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  std::unique_ptr<btSequentialImpulseConstraintSolver> solver_;
  GivenContacts world_{&dispatcher_, &broadphase_, solver_.get(), &configuration_};
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
  std::vector<btPersistentManifold*> manifolds_;
};

std::string law_in_space(bool applied, bool two, bool whole) {
  if (two) {
    return "two directions of friction at each contact, that in which it slips freely and the one across, cut to the "
           "cone, by sweeps; the first step from rest";
  }
  return std::string("one direction of friction at each contact, ") +
         (applied ? "by sweeps, where friction does not see couples" : "that in which it slips freely, by sweeps") +
         (whole ? ", at the contacts of whole shapes" : "") + "; the first step from rest";
}

}  // namespace

int main(int argc, char** argv) {
  const std::string how = argc > 1 ? argv[1] : "";
  const bool applied = how == "applied", taken_back = how == "taken-back", two = how == "two", whole = how == "shapes";
  const int version = btGetVersion();
  return run({how.empty() ? "bullet" : "bullet-" + how,
              std::to_string(version / 100) + "." + std::to_string(version % 100),
              applied ? "cone in the plane, by sweeps, where friction does not see couples; the first step from rest"
                      : "cone in the plane, by sweeps; the first step from rest",
              [=](const Question& q) { return Scene(q, applied, taken_back, two).step(); },
              law_in_space(applied, two, whole)});
}
