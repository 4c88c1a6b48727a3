// What is known of a scene at rest: data, which rest.hpp finds.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "contact/rest/can_rest.hpp"
#include "contact/space/solved_space.hpp"
#include "mechanics/scene/solved_mechanism.hpp"

namespace slipproof {

/// Gravity turned about an axis by the right hand, from where it is.
struct RestTilt {
  bool none = false;  ///< not even without a tilt
  bool decided = true;
  std::optional<ProvedEnd> tangent;  ///< of the greatest angle; nothing: at 90 degrees or beyond
  ProvedEnd degrees{90, 90};         ///< without a tangent: at least these
};

/// The values of a parameter, from that of the scene outwards. An end that is no number is beyond all values that were
/// tried, or, if `monotone`, is not there.
struct RestParameter {
  std::string name;
  Rational value;         ///< in the scene
  bool monotone = false;  ///< the parameter is a coefficient of friction and nothing else: more of it never makes fall
  bool none = false;      ///< no value was found at which it can rest
  std::optional<ProvedEnd> from, to;
};

/// Whether there is no motion beside rest.
struct MustRest {
  std::optional<bool> must;
  std::string because;                     ///< a sentence's part: why, or why it is open
  std::shared_ptr<SolvedMechanism> plane;  ///< all motions, where they were found
  std::shared_ptr<SolvedSpace> space;
};

struct RestAnswer {
  MechanismScene scene;
  RestProblem problem;
  std::optional<RestPush> push;  ///< at the scene's load; nothing where that has no value
  RestDecision decision;         ///< at the load; without one, whether it can rest at some load
  MustRest must;
  std::optional<RestLoads> loads;  ///< of a scene with a load
  std::optional<RestTilt> tilt;
  std::optional<RestParameter> parameter;
  std::size_t programs = 0;  ///< linear programs that were solved
};

}  // namespace slipproof
