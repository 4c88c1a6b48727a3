// The body on two feet of proofs/rest-on-slope, in binary64, written down from its geometry a second time: neither the
// claims nor the library's mechanics are used.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "base/number/dice.hpp"

namespace slipproof::test::rest_on_slope {

/// Numbers for the coordinates x, z1 and z2: how far the feet are along the slope, down positive, and how far each is
/// above it. Or the forces S, N1 and N2 along these.
using Triple = std::array<double, 3>;
inline constexpr std::array<std::size_t, 2> feet{1, 2};

struct State {
  Triple at{}, velocity{};

  /// A foot that has left the ground with a velocity is in the air.
  bool on_ground(std::size_t foot) const { return !(at[foot] > 0) && !(velocity[foot] > 0); }
  bool comes_down(std::size_t foot) const { return on_ground(foot) && velocity[foot] < 0; }
  bool hits() const { return comes_down(1) || comes_down(2); }
  bool at_rest() const;
};
std::string text(const State& state);

/// Its mass, half the distance of its feet and the weight across the slope are 1.
struct Body {
  double u = 0, h = 0, J = 0, mu = 0;
  double t = 0;  ///< tangent of the slope

  double b1() const { return 1 + u; }  ///< how far foot one is up the slope of the centre of mass
  double b2() const { return 1 - u; }
  /// Row i: what the forces (S, N1, N2) do to the acceleration of coordinate i.
  std::array<Triple, 3> delassus() const;
  /// Accelerations without forces of the feet.
  Triple load() const { return {t, -1, -1}; }
};
std::string text(const Body& body);

/// The body while its feet slide down (1) or up (-1), or stick (0). Then S is known if N1 and N2 are, and the
/// accelerations are linear in these. During an impact the load is 0, and impulses are in the place of forces.
class Contact {
 public:
  Contact(const Body& body, const Triple& load, int slip);

  Triple acceleration(const Triple& forces) const;
  /// The same N1 and N2, with the S that belongs to them.
  Triple with_friction(Triple forces) const;
  /// Coulomb's law for forces that with_friction() has returned.
  bool lawful(double velocity_along, const Triple& forces) const;
  /// (S, N1, N2) with which the velocities of the feet in `pushing` do not change; `forces` has that of the other foot.
  Triple keeping(const std::array<bool, 3>& pushing, Triple forces) const;

 private:
  std::array<Triple, 3> delassus_;
  Triple load_;
  double mu_;
  int slip_;
  Triple friction_;  ///< S is the first number, plus the others times N1 and N2
};

/// A number between two others.
double between(Dice& dice, double low, double high);

}  // namespace slipproof::test::rest_on_slope
