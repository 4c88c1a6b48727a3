// What is known of a scene at rest: data, which rest.hpp finds.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

/// The values of two loads at which a scene can rest: a convex set between two polygons.
struct RestMap {
  struct Corner {
    Rational x, y;
    std::vector<Rational> forces;  ///< that hold it there
  };
  /// It rests only where x X + y Y <= most: elsewhere the motion gains power.
  struct Border {
    Rational x, y, most;
    VirtualMotion motion;
  };
  /// Nothing is said beyond these values.
  struct Frame {
    std::optional<Rational> from, to;
  };

  std::string x, y;  ///< their symbols
  std::optional<Rational> x_here, y_here;
  Frame x_frame, y_frame;
  bool none = false;                            ///< it rests nowhere: `borders` leave nothing
  bool decided = true;                          ///< false: the effort was not enough for both polygons
  bool exact = false;                           ///< both polygons are one
  std::vector<Corner> inside;                   ///< counterclockwise; it can rest in all that is between them
  std::vector<Border> borders;                  ///< counterclockwise
  std::vector<std::array<Rational, 2>> around;  ///< the corners of what the borders and the frame leave
  double gap = 0;  ///< the largest distance of `around` from the inside, in widths and heights of `around`
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
  std::optional<RestMap> map;
  std::size_t programs = 0;  ///< linear programs that were solved
};

}  // namespace slipproof
