// DART: one step of its world, by Dantzig's method and where that gives up by sweeps; with many iterations by sweeps
// alone. Contacts are found by DART's own collision detector, between a sphere on one body and a box on the other that
// meet in the contact's point; pairs that belong to no contact are filtered out. Bodies hang on planar joints.
#include <dart/dart.hpp>

#include "adapter.hpp"

using namespace engines;

namespace {

using Eigen::Vector3d;

Vector3d vec(const Vector& v) {
  return {v[0], v[1], v[2]};
}

Vector three(const Vector3d& v) {
  return {v[0], v[1], v[2]};
}

/// Lets the two shapes of the same contact meet: those of the same name.
class OwnContacts : public dart::collision::CollisionFilter {
 public:
  bool ignoresCollision(const dart::collision::CollisionObject* a,
                        const dart::collision::CollisionObject* b) const override {
    return name(a).substr(1) != name(b).substr(1);
  }
  static std::string name(const dart::collision::CollisionObject* object) { return object->getShapeFrame()->getName(); }
};

class Scene {
 public:
  explicit Scene(const Question& q) : q_(q) {
    if (!q.friction.empty()) throw Refused("brakes and clutches");
    world_->setGravity(vec(q.gravity));
    world_->setTimeStep(q.step);
    for (const Body& body : q.bodies) add(body);
    for (const Contact& contact : q.contacts) add(contact);
    for (const auto& skeleton : skeletons_) world_->addSkeleton(skeleton);
    auto* solver = dynamic_cast<dart::constraint::BoxedLcpConstraintSolver*>(world_->getConstraintSolver());
    solver->setCollisionDetector(dart::collision::DARTCollisionDetector::create());
    solver->getCollisionOption().collisionFilter = std::make_shared<OwnContacts>();
    for (const Joint& joint : q.joints) add(*solver, joint);
    if (q.iterations > 0) {
      auto sweeps = std::make_shared<dart::constraint::PgsBoxedLcpSolver>();
      dart::constraint::PgsBoxedLcpSolver::Option option;
      option.mMaxIteration = q.iterations, option.mDeltaXThreshold = 0, option.mRelativeDeltaXTolerance = 0;
      // Sweeps end where all impulses are smaller, which by default are 1e-9; rows that are 0 are left out by it.
      option.mEpsilonForDivision = 1e-15;
      sweeps->setOption(option);
      solver->setBoxedLcpSolver(sweeps);
      // Sweeps that reach no tolerance of 0 count as failed, and a second solver with its 30 sweeps would take over.
      solver->setSecondaryBoxedLcpSolver(nullptr);
    }
  }

  Answer step() {
    push_and_step();
    Answer answer;
    answer.settings = {{"solver", q_.iterations > 0 ? "PGS" : "Dantzig, then PGS"}};
    if (q_.iterations > 0) answer.settings["iterations"] = q_.iterations;
    for (const auto* body : bodies_) {
      const Vector3d v = body->getCOMLinearVelocity(), w = body->getAngularVelocity();
      if (q_.in_space) {
        answer.velocity.push_back({v[0], v[1], v[2], w[0], w[1], w[2]});
      } else {
        answer.velocity.push_back({v[0], v[1], w[2]});
      }
    }
    for (const Contact& contact : q_.contacts) answer.push(contact, 0, 0);
    for (const auto& found : world_->getLastCollisionResult().getContacts()) {
      const std::string name = OwnContacts::name(found.collisionObject1);
      const Contact& contact = q_.contacts[std::stoul(name.substr(1))];
      const double sign = name[0] == 'o' ? 1 : -1;  // the force is on the first
      answer.push(contact, {sign * found.force[0], sign * found.force[1], sign * found.force[2]});
    }
    if (!q_.watch.empty()) {
      watch(
          q_, answer, [&] { push_and_step(); },
          [&](std::size_t i) {
            const dart::dynamics::BodyNode& body = *bodies_[i];
            const Eigen::Quaterniond t(body.getTransform().linear());
            return Pose{three(body.getCOM()),
                        {t.w(), t.x(), t.y(), t.z()},
                        three(body.getCOMLinearVelocity()),
                        three(body.getAngularVelocity())};
          });
    }
    return answer;
  }

 private:
  void push_and_step() {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      bodies_[i]->addExtForce(vec(q_.bodies[i].force), Vector3d::Zero(), false, true);
      bodies_[i]->addExtTorque(q_.in_space ? vec(q_.bodies[i].torques) : Vector3d(0, 0, q_.bodies[i].torque), false);
    }
    world_->step();
  }

  template <class J>
  dart::dynamics::BodyNode* create(const dart::dynamics::SkeletonPtr& skeleton, const Body& body, const J& properties) {
    using namespace dart::dynamics;
    const double i = body.turns ? body.inertia : 1;
    const Vector3d moments = q_.in_space && body.turns ? vec(body.moments) : Vector3d(i, i, i);
    BodyNode::Properties node;
    node.mInertia = Inertia(body.is_free ? body.mass : 1, Vector3d::Zero(), Eigen::Matrix3d(moments.asDiagonal()));
    return skeleton->createJointAndBodyNodePair<typename J::JointKind>(nullptr, properties.properties, node).second;
  }
  template <class T>
  struct Hung {
    using JointKind = T;
    typename T::Properties properties;
  };

  void add(const Body& body) {
    using namespace dart::dynamics;
    auto skeleton = Skeleton::create(body.name);
    skeletons_.push_back(skeleton);
    Eigen::Isometry3d at(Eigen::Translation3d(vec(body.at)));
    at.rotate(Eigen::Quaterniond(body.turn[0], body.turn[1], body.turn[2], body.turn[3]));
    const bool moves = body.acceleration != Vector{} || body.turning != 0 || body.turnings != Vector{} ||
                       (!body.is_free && body.velocity != Vector{}) ||
                       (!body.turns && (body.spin != 0 || body.spins != Vector{}));
    if (moves) throw Refused("a body that moves as prescribed");
    const auto hang = [&](auto hung) {
      hung.properties.mT_ParentBodyToJoint = at;
      bodies_.push_back(create(skeleton, body, hung));
    };
    if (body.is_prescribed()) hang(Hung<WeldJoint>());
    skeleton->setMobile(!body.is_prescribed());
    if (body.is_prescribed()) return;
    if (q_.in_space) {
      hang(Hung<FreeJoint>());
      auto* joint = static_cast<FreeJoint*>(skeleton->getJoint(0));
      joint->setLinearVelocity(vec(body.velocity));
      joint->setAngularVelocity(vec(body.spins));
      return;
    }
    if (body.is_free && body.turns) hang(Hung<PlanarJoint>());
    if (body.is_free && !body.turns) hang(Hung<TranslationalJoint2D>());
    if (!body.is_free && body.turns) hang(Hung<RevoluteJoint>());
    if (body.is_free && body.turns) skeleton->setVelocities(Vector3d(body.velocity[0], body.velocity[1], body.spin));
    if (body.is_free && !body.turns) skeleton->setVelocities(Eigen::Vector2d(body.velocity[0], body.velocity[1]));
    if (!body.is_free && body.turns) skeleton->setVelocity(0, body.spin);
  }

  void add_shape(const dart::dynamics::ShapePtr& shape, std::size_t body, const std::string& name, const Vector& at,
                 const Eigen::Quaterniond& turn, const Contact& contact) {
    using namespace dart::dynamics;
    auto* node = bodies_[body]->createShapeNodeWith<CollisionAspect, DynamicsAspect>(shape, name);
    Eigen::Isometry3d placed(Eigen::Translation3d(vec(at)));
    placed.rotate(turn);
    node->setRelativeTransform(placed);
    node->getDynamicsAspect()->setFrictionCoeff(contact.friction);
    node->getDynamicsAspect()->setRestitutionCoeff(name[0] == 'o' ? contact.restitution : 1);  // they are multiplied
  }

  void add(const Contact& contact) {
    using namespace dart::dynamics;
    const std::string number = std::to_string(&contact - q_.contacts.data());
    const double r = q_.disc(contact), half = q_.half(contact);
    const auto beyond = [&](std::size_t body, double by) {  // along the normal, in the axes of the body
      Vector at = q_.arm(body, contact.at);
      for (std::size_t k = 0; k < 3; ++k) at[k] += by * contact.normal[k];
      return in_body(q_.bodies[body], at);
    };
    const Vector n = in_body(q_.bodies[contact.on], contact.normal);
    const auto turn = q_.in_space ? Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitY(), vec(n))
                                  : Eigen::Quaterniond(Eigen::AngleAxisd(std::atan2(-n[0], n[1]), Vector3d::UnitZ()));
    add_shape(std::make_shared<SphereShape>(r + 1e-9 * q_.size), contact.of, "o" + number, beyond(contact.of, r),
              Eigen::Quaterniond::Identity(), contact);
    add_shape(std::make_shared<BoxShape>(Vector3d(2 * half, 2 * half, 2 * half)), contact.on, "b" + number,
              beyond(contact.on, -half), turn, contact);
  }

  void add(dart::constraint::ConstraintSolver& solver, const Joint& joint) {
    using namespace dart::constraint;
    auto *first = bodies_[joint.first], *second = bodies_[joint.second];
    if (q_.bodies[joint.first].is_ground()) std::swap(first, second);
    if (q_.in_space) throw Refused("joints in space");
    if (joint.kind != "pin" && joint.kind != "weld") throw Refused("DART has no " + joint.kind + " of this kind");
    if (joint.kind == "pin") solver.addConstraint(std::make_shared<BallJointConstraint>(first, second, vec(joint.at)));
    if (joint.kind == "weld") solver.addConstraint(std::make_shared<WeldJointConstraint>(first, second));
  }

  const Question& q_;
  dart::simulation::WorldPtr world_ = dart::simulation::World::create();
  std::vector<dart::dynamics::SkeletonPtr> skeletons_;
  std::vector<dart::dynamics::BodyNode*> bodies_;
};

}  // namespace

int main() {
  return run(
      {"dart", DART_VERSION,
       "box of two directions, bounded by mu times the normal force, and by Dantzig's method times the normal force "
       "that the contacts would have without friction; the first step from rest",
       [](const Question& q) { return Scene(q).step(); },
       "pyramid of two directions of the engine's own, bounded by mu times the normal force, and by Dantzig's method "
       "times "
       "the normal force that the contacts would have without friction; the first step from rest"});
}
