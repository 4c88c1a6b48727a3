// A planar body on a few contacts, with walls, wedges and masses that may be 0, and all of its motions at a load by
// brute force: each mode's equations and conditions, written here once more, by elimination (Gauss, then Fourier and
// Motzkin).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/number/rational.hpp"

namespace slipproof::test {

/// Forms are over ax, ay and alpha.
struct BodyContact {
  std::array<Rational, 3> gap, slip;
  Rational static_friction, kinetic_friction;
};

/// mass[i] a[i] = force[i] + load[i] F, and the contact forces by virtual work.
struct Body {
  std::array<Rational, 3> mass, force, load;
  std::vector<BodyContact> contacts;
};

/// With contacts between walls, in wedges, at one place, on one level, and masses and inertias of 0.
class RandomBodies {
 public:
  explicit RandomBodies(std::uint64_t seed) : state_(seed) {}
  Body body(std::size_t contacts);
  int integer(int low, int high);

 private:
  BodyContact contact();
  std::uint64_t state_;
};

/// The accelerations of a motion.
using Accelerations = std::vector<Rational>;

struct BruteMotions {
  struct Motion {
    std::set<std::string> modes, boundary_modes, continua;
  };
  std::map<Accelerations, Motion> motions;  ///< of modes with one motion
  std::map<std::string, bool> continua;     ///< modes with several, and whether a motion is strict there
  std::size_t modes = 0;                    ///< all, with a solution or without

  /// Modes that have a motion, strict ones or all.
  std::set<std::string> consistent(bool strict) const;
};

BruteMotions brute_force(const Body& body, const Rational& load);

}  // namespace slipproof::test
