// Compliant contacts, from rest: a simulation in binary64, which proves nothing.
//
// Each contact is a spring and a damper along its normal, N = max(0, -k gap - c gap') where gap < 0, and a bristle
// along its tangent: T = -r k z - c_T z'. z follows the slip as long as |T| <= mu N, and otherwise stays behind so that
// |T| = mu N. Displacements from rest stay small, so that (gap, slip)'' = W (N, T) + q with one W throughout.
//
// This has no length scale of its own: with k s^2 for k everything happens s times as fast and s^2 times as small, and
// accelerations and forces are the same. So k is 1, and time counts in periods of the slowest elastic vibration. The
// state after 100 times as many periods is the state of contacts 10^4 times as stiff at the same time.
#pragma once

#include <vector>

#include "contact/simulation/loaded_contacts.hpp"

namespace slipproof {

struct Compliance {
  double stiffness_ratio = 1;  ///< r > 0, of the tangential to the normal stiffness
  double damping = 0.1;        ///< fraction of critical damping of each contact by itself, >= 0
  double rise = 0;             ///< number of periods over which the load rises, >= 0; 0: immediately
};

/// A simulation, step by step. Starts in the equilibrium of the springs without the load.
class CompliantMotion {
 public:
  /// The number of time steps in one radian of the fastest vibration.
  static constexpr double usual_step = 0.1;

  /// Throws std::invalid_argument, with a message for people, where the bodies do not stay at rest without the load,
  /// and where vibrations differ so much that a run would take hours.
  CompliantMotion(const LoadedContacts& contacts, const Compliance& compliance, double step = usual_step);

  void advance();
  double periods() const { return time_ / period_; }
  double time() const { return time_; }

  /// Displacements (gap, slip) or forces (N, T) of each contact, in the order of the problem. Displacements are in
  /// units of force, since k = 1.
  const std::vector<double>& displacement() const { return displacement_; }
  const std::vector<double>& velocity() const { return velocity_; }
  const std::vector<double>& forces() const { return forces_; }
  const std::vector<double>& bristles() const { return bristles_; }  ///< z, of each contact
  const ProblemMode& mode() const { return mode_; }

 private:
  void find_rest(const std::vector<double>& q);
  void find_forces();
  void accelerate(double time);

  std::size_t n_;
  std::vector<double> W_, rest_, push_, mu_, normal_damping_, tangent_damping_;
  double ratio_, dt_, period_, rise_, time_ = 0;
  std::vector<double> displacement_, velocity_, acceleration_, forces_, bristles_;
  ProblemMode mode_;
};

}  // namespace slipproof
