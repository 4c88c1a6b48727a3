// Simbody in space: one step of its time stepper for rigid contacts, by its default solver (PLUS, a kind of Newton's
// method) or, with the argument `pgs`, by sweeps, 100 by default. Contacts are handed over as points of one body on
// planes of the other; restitution is by the stepper's default model (Poisson's), and only of impacts. Simbody's
// contacts of shapes are compliant: at gap 0 they push nothing, so that no first step says anything about them. It
// tells no forces here.
#include <Simbody.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

#include "adapter.hpp"

using namespace engines;

namespace {

SimTK::Vec3 vec(const Vector& v) {
  return {v[0], v[1], v[2]};
}

Vector three(const SimTK::Vec3& v) {
  return {v[0], v[1], v[2]};
}
SimTK::Rotation turn_of(const Body& body) {
  const Quaternion& t = body.turn;
  return SimTK::Rotation(SimTK::Quaternion(t[0], t[1], t[2], t[3]));
}

/// While it lives, nothing is printed: Debian's Simbody writes what its time stepper does, megabytes, where answers go.
class Silence {
 public:
  Silence() : out_(dup(1)) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, 1), close(nowhere);
  }
  ~Silence() {
    std::cout.flush(), std::fflush(stdout);
    dup2(out_, 1), close(out_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int out_;
};

class Scene {
 public:
  explicit Scene(const Question& q) : q_(q) {
    if (!q.joints.empty()) throw Refused("the adapter has no joints");
    SimTK::Force::UniformGravity(forces_, matter_, vec(q.gravity));
    for (const Body& body : q.bodies) add(body);
    for (const Contact& contact : q.contacts) add(contact);
  }

  Answer step(bool sweeps) {
    const Silence silence;
    SimTK::State state = system_.realizeTopology();
    for (std::size_t i = 1; i < q_.bodies.size(); ++i) {
      if (q_.bodies[i].is_prescribed()) continue;
      bodies_[i].setQToFitTransform(state, SimTK::Transform(vec(q_.bodies[i].at)));
      bodies_[i].setUToFitVelocity(state, {vec(q_.bodies[i].spins), vec(q_.bodies[i].velocity)});
    }
    SimTK::SemiExplicitEulerTimeStepper stepper(system_);
    if (!q_.impact) stepper.setRestitutionModel(SimTK::SemiExplicitEulerTimeStepper::NoRestitution);
    Answer answer;
    answer.tells_forces = false;
    if (q_.impact) answer.settings["restitution"] = stepper.getRestitutionModelName(stepper.getRestitutionModel());
    answer.settings["solver"] = sweeps ? "PGS" : "PLUS";
    if (sweeps) {
      auto* solver = new SimTK::PGSImpulseSolver(stepper.getDefaultFrictionTransitionVelocityInUse());
      if (q_.iterations > 0) solver->setMaxIterations(q_.iterations), solver->setConvergenceTol(1e-15);
      answer.settings["iterations"] = solver->getMaxIterations();
      stepper.setImpulseSolver(solver);  // which owns it
    }
    stepper.initialize(state);
    int made = 0;
    const auto make = [&] { stepper.stepTo(++made * q_.step); };
    make();
    for (std::size_t i = 0; i < q_.bodies.size(); ++i) {
      system_.realize(stepper.getState(), SimTK::Stage::Velocity);
      const SimTK::Vec3 v = bodies_[i].getBodyOriginVelocity(stepper.getState()),
                        w = bodies_[i].getBodyAngularVelocity(stepper.getState());
      answer.velocity.push_back({v[0], v[1], v[2], w[0], w[1], w[2]});
    }
    if (!q_.watch.empty()) {
      watch(q_, answer, make, [&](std::size_t i) {
        const SimTK::State& now = stepper.getState();
        const SimTK::MobilizedBody& body = bodies_[i];
        system_.realize(now, SimTK::Stage::Velocity);
        // Its own axes are those of the scene at the start.
        const SimTK::Quaternion t = (body.getBodyRotation(now) * turn_of(q_.bodies[i])).convertRotationToQuaternion();
        return Pose{three(body.getBodyOriginLocation(now)),
                    {t[0], t[1], t[2], t[3]},
                    three(body.getBodyOriginVelocity(now)),
                    three(body.getBodyAngularVelocity(now))};
      });
    }
    return answer;
  }

 private:
  /// In the axes of the scene, with moments that `turn` brings there.
  void add(const Body& body) {
    if (body.is_prescribed()) {
      if (body.velocity_after(q_.step) != Vector{} || body.spins != Vector{} || body.turnings != Vector{})
        throw Refused("a body that moves as prescribed");
      bodies_.push_back(body.is_ground() ? SimTK::MobilizedBody(matter_.Ground())
                                         : SimTK::MobilizedBody::Weld(matter_.Ground(), vec(body.at),
                                                                      SimTK::Body::Massless(), SimTK::Transform()));
      return;
    }
    const SimTK::Inertia inertia = SimTK::Inertia(vec(body.moments)).reexpress(~turn_of(body));
    const SimTK::Body::Rigid rigid(SimTK::MassProperties(body.mass, SimTK::Vec3(0), inertia));
    SimTK::MobilizedBody::Free made(matter_.Ground(), SimTK::Transform(), rigid, SimTK::Transform());
    SimTK::Force::ConstantForce(forces_, made, SimTK::Vec3(0), vec(body.force));
    SimTK::Force::ConstantTorque(forces_, made, vec(body.torques));
    bodies_.push_back(made);
  }

  void add(const Contact& c) {
    const Vector on = q_.arm(c.on, c.at);
    matter_.adoptUnilateralContact(
        new SimTK::PointPlaneContact(bodies_[c.on], SimTK::UnitVec3(vec(c.normal)), dot(on, c.normal), bodies_[c.of],
                                     vec(q_.arm(c.of, c.at)), c.restitution, c.friction, c.friction, 0));
  }

  const Question& q_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  std::vector<SimTK::MobilizedBody> bodies_;
};

}  // namespace

int main(int argc, char**) {
  const bool sweeps = argc > 1;
  const std::string law =
      std::string("cone, by ") + (sweeps ? "sweeps" : "Newton's method") + "; the first step from rest";
  return run({sweeps ? "simbody-pgs" : "simbody", ENGINE_VERSION, "",
              [=](const Question& q) {
                if (!q.in_space) throw Refused("a scene in the plane");
                return Scene(q).step(sweeps);
              },
              law});
}
