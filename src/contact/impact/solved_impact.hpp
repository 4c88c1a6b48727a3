// All outcomes of an impact, in the plane and in space, with the energy of each: data, which solve_impact.hpp finds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/space/solved_space.hpp"
#include "mechanics/scene/solved_mechanism.hpp"

namespace slipproof {

/// Velocities after, for which impulses exist that satisfy the law. Ranges are points where a value is known exactly.
struct ImpactOutcome {
  std::vector<std::string> modes;              ///< all with this outcome; those at whose border it lies last
  bool strict = false;                         ///< no condition of one of its modes holds with equality
  bool continuum = false;                      ///< it is one of a family, and ranges hold all of it
  bool exists = true, unique = true;           ///< as of SpaceMotion
  std::vector<Range> motion;                   ///< in the order of acceleration_names()
  std::vector<std::optional<Range>> impulses;  ///< of force_names(); nothing where one is left open
  Range energy;                                ///< after, of all bodies that move freely
  std::optional<bool> gains;                   ///< whether energy is gained; nothing where that is not known
};

struct SolvedImpact {
  struct Contact {
    bool closed = false;
    Rational opening, sliding, second;  ///< before; 0 where it has none
    /// Its gap is the velocity of opening after, and the first of these; its slips those of sliding, and the others.
    Rational restored, slip_restored, second_restored;
  };
  MechanismScene scene;
  std::vector<Rational> velocities;  ///< before, in the order of the unknown accelerations
  std::vector<Contact> contacts;
  Rational energy;      ///< before
  bool driven = false;  ///< bodies that no impulse changes move, and may put energy in
  std::vector<ImpactOutcome> outcomes;
  std::vector<std::string> undecided;    ///< in space: patterns in which others may be
  std::optional<SolvedMechanism> plane;  ///< what is drawn: one of both
  std::optional<SolvedSpace> space;

  bool complete() const { return undecided.empty(); }
  /// `Newton's law`.
  std::string law_words() const {
    switch (scene.mechanism.impact->law) {
      case ImpactLaw::newton:
        return "Newton's law";
      case ImpactLaw::moreau:
        return "Moreau's law";
      case ImpactLaw::poisson:
        break;
    }
    return "Poisson's law";
  }
};

}  // namespace slipproof
