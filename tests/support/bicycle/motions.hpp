// The motions of a scene: at one force, and over the whole line of forces.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "support/bicycle/forced_scene.hpp"
#include "support/bicycle/mode_table.hpp"

namespace slipproof {

/// One motion with every mode that gives it; V is Rational at one force, Affine<Rational> over a cell.
template <class V>
struct FoundMotion {
  std::vector<ContactMode> modes;
  bool strict = false;  ///< every condition of one of its modes holds strictly; otherwise it is a boundary motion
  Motion<V> values;
};

/// A mode with more than one consistent motion at a force.
struct FoundContinuum {
  std::shared_ptr<const Continuum> continuum;
  std::vector<ForceInterval> parameters;  ///< the range of each free parameter
  bool strict = false;
};

struct MotionsAtForce {
  std::vector<FoundMotion<Rational>> motions;
  std::vector<FoundContinuum> continua;
};

/// Every motion at a force. A motion found through several modes is one motion.
MotionsAtForce motions_at(const ModeTable& table, const Rational& force);

/// Every motion of a scene in the domain (bicycle.hpp). A double is taken exactly; throws NumberError for a NaN or an
/// infinity.
MotionsAtForce motions_at(const ForcedScene<Rational>& scene);
MotionsAtForce motions_at(const ForcedScene<double>& scene);

/// A force, or an open interval of forces, with the same motions throughout.
struct Cell {
  ForceInterval forces;
  std::vector<FoundMotion<Affine<Rational>>> motions;
  std::vector<ContactMode> continua;
};

/// The whole line of forces, from -oo to +oo, cut into points and open intervals.
std::vector<Cell> partition(const ModeTable& table);

}  // namespace slipproof
