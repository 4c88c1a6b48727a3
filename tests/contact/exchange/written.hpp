// One scene in the three formats, for tests: written from what is there, without the importer.
#pragma once

#include <string>
#include <vector>

#include "base/number/rational.hpp"

namespace slipproof::test {

struct WrittenBody {
  std::string name, kind;      ///< `box`, `sphere`, `cylinder` (along y), `bar` (a cylinder along x)
  std::vector<Rational> size;  ///< x y z; the radius; radius and length
  Rational x = 0, z = 0, mass = 1, inertia = 1;
  bool fixed = false;  ///< it belongs to the ground
};

struct WrittenJoint {
  std::string name, kind, first, second;  ///< `hinge` about y; `slide` along z; the first may be empty: the ground
  Rational x = 0, z = 0;
};

struct WrittenScene {
  std::vector<WrittenBody> bodies;
  std::vector<WrittenJoint> joints;
  Rational mu = 0;
  std::string hand;  ///< the mechanism, by hand

  std::string urdf() const;  ///< without ground, gravity and friction
  std::string sdf() const;
  std::string mjcf() const;
};

/// As a decimal, which the number must be.
std::string decimal(const Rational& x);

}  // namespace slipproof::test
