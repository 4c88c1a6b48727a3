// A rigid-body engine on the same scenes: the bicycle as frame and wheels, hinges, contacts; one short step from rest.
#include <ode/ode.h>

#include "scenes.hpp"

using namespace slipproof;

namespace {

constexpr double step = 1e-3;

/// x forward, y down as in the model, z into the plane: a rotation about z from x to y is clockwise and positive.
test::SolverAnswer solve(const ForcedScene<double>& s) {
  const Bicycle<double>& p = s.bicycle;
  const double m2 = 0.02 * p.M, m3 = 0.02 * p.M, frame_mass = p.M - m2 - m3;  // wheels of little mass
  const dWorldID world = dWorldCreate();
  dWorldSetGravity(world, 0, s.road.g, 0);
  dWorldSetCFM(world, 1e-12);
  dWorldSetERP(world, 0);

  // C is the origin; the axles are h below it. The frame's own centre makes C the centre of everything.
  const double x2 = -p.b2, x3 = p.b3;
  const double fx = -(m2 * x2 + m3 * x3) / frame_mass, fy = -(m2 + m3) * p.h / frame_mass;
  // J counts the wheels as points at their hinges; what is left is the frame's own.
  const double own = *p.J - m2 * (x2 * x2 + p.h * p.h) - m3 * (x3 * x3 + p.h * p.h) - frame_mass * (fx * fx + fy * fy);
  const auto body = [&](double mass, double inertia, double x, double y) {
    const dBodyID b = dBodyCreate(world);
    dMass m;
    dMassSetParameters(&m, mass, 0, 0, 0, inertia, inertia, inertia, 0, 0, 0);
    dBodySetMass(b, &m);
    dBodySetPosition(b, x, y, 0);
    return b;
  };
  const dBodyID frame = body(frame_mass, own, fx, fy), rear = body(m2, p.I2, x2, p.h), front = body(m3, p.I3, x3, p.h);
  dJointAttach(dJointCreatePlane2D(world, nullptr), frame, nullptr);  // the hinges hold the wheels in the plane too
  dJointFeedback feedback[2];
  int i = 0;
  for (const dBodyID wheel : {rear, front}) {
    const dReal* at = dBodyGetPosition(wheel);
    const dJointID hinge = dJointCreateHinge(world, nullptr);
    dJointAttach(hinge, frame, wheel);
    dJointSetHingeAnchor(hinge, at[0], at[1], 0);
    dJointSetHingeAxis(hinge, 0, 0, 1);
    dContact c{};
    c.surface.mode = dContactApprox1 | dContactFDir1 | dContactMu2;
    c.surface.mu = s.road.f;
    c.surface.mu2 = 0;
    c.fdir1[0] = 1;
    c.geom.pos[0] = at[0];
    c.geom.pos[1] = at[1] + p.R;
    c.geom.normal[1] = -1;
    const dJointID contact = dJointCreateContact(world, nullptr, &c);
    dJointAttach(contact, wheel, nullptr);
    dJointSetFeedback(contact, &feedback[i++]);
  }
  // The chain: with a massless sprocket its moment on the wheel is mu L F, and the frame carries the opposite.
  const double drive = p.r2 / p.r1 * p.L * s.F;
  dBodyAddTorque(rear, 0, 0, drive);
  dBodyAddTorque(frame, 0, 0, -drive);
  dWorldStep(world, step);
  double momentum = 0;
  for (const dBodyID b : {frame, rear, front}) {
    dMass m;
    dBodyGetMass(b, &m);
    momentum += m.mass * dBodyGetLinearVel(b)[0];
  }
  test::SolverAnswer x{
      momentum / p.M / step, feedback[0].f1[0], feedback[1].f1[0], -feedback[0].f1[1], -feedback[1].f1[1], "", 0};
  dWorldDestroy(world);
  return x;
}

}  // namespace

int main(int argc, char** argv) {
  dInitODE();
  test::record(std::string(argc > 1 ? argv[1] : ".") + "/ode.csv", solve);
  dCloseODE();
}
