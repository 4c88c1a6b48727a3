/* Records what Bullet solves: cubes that fall on a plane, by sweeps with two directions of friction, with the bias of
 * each contact.
 *
 *   steps_of_bullet FILE.jsonl [STEPS [ITERATIONS [WORST]]]     then: slipproof certify FILE.jsonl */
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "boxes.h"

namespace {

constexpr double h = 1.0 / 60;

class World {
 public:
  explicit World(int iterations) {
    world_.setGravity({0, 0, -gravity});
    world_.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    if (iterations > 0) {
      world_.getSolverInfo().m_numIterations = iterations;
      world_.getSolverInfo().m_leastSquaresResidualThreshold = 0;
    }
    add(0, floor_, btTransform::getIdentity());
    for (int i = 0; i < boxes; ++i) {
      double at[3];
      const double angle = start(i, at);
      add(box_mass, box_, btTransform(btQuaternion({1, 1, 0}, angle), {at[0], at[1], at[2]}));
      bodies_.back()->setUserIndex(i);
    }
  }
  ~World() {
    for (auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// One step, and the seconds that Bullet took.
  double step(boxes_step& made) {
    for (const auto& body : bodies_) {
      const int i = body->getUserIndex();
      if (i == floor_plane) continue;
      set_before(&made, i, body->getLinearVelocity(), body->getAngularVelocity(), h);
      center_[i] = body->getCenterOfMassPosition();
    }
    const double begin = now();
    world_.stepSimulation(h, 0);
    const double end = now();
    for (const auto& body : bodies_) {
      const int i = body->getUserIndex();
      if (i != floor_plane) set_after(&made, i, body->getLinearVelocity(), body->getAngularVelocity());
    }
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i)
      add_contacts(made, *dispatcher_.getManifoldByIndexInternal(i));
    return end - begin;
  }

 private:
  void add(double mass, btCollisionShape& shape, const btTransform& at) {
    const double i = mass > 0 ? inertia : 0;
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, {i, i, i});
    info.m_startWorldTransform = at;
    info.m_friction = sqrt(0.5);  // Bullet multiplies those of both bodies
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
    bodies_.back()->setUserIndex(floor_plane);
    world_.addRigidBody(bodies_.back().get());
  }

  /// With the bias that Bullet gives a contact: it may close its gap, and overcomes a part of its overlap unless that
  /// is deep enough to be left to a second pass.
  void add_contacts(boxes_step& made, const btPersistentManifold& manifold) {
    const btContactSolverInfo& info = world_.getSolverInfo();
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
      const btManifoldPoint& p = manifold.getContactPoint(i);
      const double distance = p.getDistance();
      const double part = distance > 0 ? 1 : distance > info.m_splitImpulsePenetrationThreshold ? info.m_erp2 : 0;
      btVector3 axes[3] = {p.m_normalWorldOnB, p.m_lateralFrictionDir1, p.m_lateralFrictionDir2};
      double rows[3][3];
      for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j) rows[k][j] = axes[k][j];
      add_side(&made, manifold.getBody0()->getUserIndex(), 1, arm(manifold.getBody0(), p.m_positionWorldOnA), rows);
      add_side(&made, manifold.getBody1()->getUserIndex(), -1, arm(manifold.getBody1(), p.m_positionWorldOnB), rows);
      const double r[3] = {p.m_appliedImpulse, p.m_appliedImpulseLateral1, p.m_appliedImpulseLateral2};
      add_contact(&made, p.m_combinedFriction, r, 0, part * distance / h);
    }
  }
  /// From the centre that the body had when contacts were found.
  btVector3 arm(const btCollisionObject* body, const btVector3& at) const {
    const int i = body->getUserIndex();
    return i == floor_plane ? at : at - center_[i];
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase pairs_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &pairs_, &solver_, &configuration_};
  btStaticPlaneShape floor_{{0, 0, 1}, 0};
  btBoxShape box_{{side / 2, side / 2, side / 2}};
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  btVector3 center_[boxes];
};

}  // namespace

int main(int argc, char** argv) {
  arguments given;
  slipproof_recorder recorder;
  if (read_arguments(argc, argv, &given)) return 2;
  World world(given.iterations);
  if (slipproof_record_open(&recorder, given.file, static_cast<std::size_t>(given.worst))) return perror(given.file), 1;
  const auto made = std::make_unique<boxes_step>();
  double engine = 0, recording = 0;
  for (int i = 0; i < given.steps; ++i) {
    *made = {};
    engine += world.step(*made);
    const double begin = now();
    if (record_boxes(&recorder, made.get(), SLIPPROOF_LAW_COULOMB)) return 1;
    recording += now() - begin;
  }
  return finish(&recorder, &given, engine, recording);
}
