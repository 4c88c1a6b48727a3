// All motions of a scene in space: data, which solve_space.hpp finds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/output/listed.hpp"
#include "mechanics/kernel/polyhedron.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// Accelerations for which forces exist that satisfy the law. Ranges hold them; a range is a point where it is known
/// exactly.
struct SpaceMotion {
  std::vector<std::string> modes;            ///< `stick`, `slip`, `lift` or, without friction, `touch`, of each contact
  std::vector<std::optional<Range>> slips;   ///< of each contact that slips: the angle from T1 towards T2, in degrees
  std::vector<Range> accelerations;          ///< in the order of acceleration_names()
  std::vector<std::optional<Range>> forces;  ///< of force_names(); nothing: left open by links that say the same
  bool exists = true;                        ///< it is proved that there is one in these ranges
  bool unique = true;                        ///< and only one
  /// Others count as this one: there no gap or slip differs from its own by more. Nothing if it is unique, or if others
  /// of its family are known to move differently.
  std::optional<Rational> others_within;
  /// Of a family that moves in different ways: others of it, with accelerations that differ for sure, and where the
  /// accelerations of all of it are; a range without an end where that is not bounded.
  std::vector<SpaceMotion> others;
  std::vector<Range> all_accelerations;
  /// Along how many its forces are open: those above are some of them. Nothing where it is not known whether they are,
  /// as the directions of slips are no rational numbers.
  std::optional<std::size_t> open_directions = 0;

  bool may_be_open() const { return open_directions != 0U; }
  bool strict = false;  ///< no condition of its mode holds with equality

  /// Whether it is one of a family that moves in different ways.
  bool is_continuum() const { return !unique && !others_within; }
};

/// `slip/stick/lift`; `free` without contacts.
inline std::string mode_of(const SpaceMotion& motion) {
  return motion.modes.empty() ? "free" : listed(motion.modes, "/");
}

struct SolvedSpace {
  MechanismScene scene;
  std::vector<SpaceMotion> motions;
  std::vector<std::string> undecided;  ///< patterns in which other motions may be
  std::optional<double> open_speed;    ///< there no gap or slip acceleration is larger
  std::size_t programs = 0;            ///< linear programs that were solved

  bool complete() const { return undecided.empty(); }
};

}  // namespace slipproof
