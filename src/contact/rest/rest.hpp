// Whether a scene can rest, whether it must, and up to where (contact/MATHEMATICS.md, "Rest").
#pragma once

#include <array>
#include <optional>
#include <string>

#include "contact/rest/rest_answer.hpp"

namespace slipproof {

/// Two loads whose values a map has: parameters that multiply no unknown, each perhaps within a frame.
struct RestMapQuestion {
  std::string x, y;
  RestMap::Frame x_frame, y_frame;
};

struct RestQuestions {
  std::optional<std::array<Rational, 3>> tilt;  ///< the axis about which gravity turns
  std::string parameter;                        ///< whose values to search; empty: none
  std::optional<RestMapQuestion> map;
  bool only_whether = false;     ///< whether it can, and what proves it: nothing else
  Work effort = 60'000'000'000;  ///< of each question: about a minute
};

/// Throws InputError as RestProblemMaker does, and for questions that the scene does not fit.
RestAnswer find_rest(MechanismScene scene, const RestQuestions& questions = {});

/// Whether the scene has no motion beside rest, if it can rest. `scene` has a value of its load.
MustRest must_rest(const MechanismScene& scene, const RestProblem& problem, const RestPush& push,
                   const RestDecision& decision, Effort& effort, std::size_t& programs);
/// The parameter's values at which the scene can rest. Throws InputError for an unknown name.
RestParameter rest_along(const MechanismScene& scene, const RestProblemMaker& maker, const std::string& parameter,
                         Effort& effort, std::size_t& programs);
/// How far gravity can turn. Throws InputError if forces other than weights push, or the axis is not across gravity.
RestTilt rest_under_tilt(const MechanismScene& scene, const RestProblemMaker& maker, const RestProblem& problem,
                         const std::array<Rational, 3>& axis, Effort& effort, std::size_t& programs);
/// The region of two loads. Where it is not bounded, a frame cuts it. Throws InputError for what is no load, and for
/// loads that multiply each other.
RestMap rest_map(const MechanismScene& scene, const RestMapQuestion& question, Effort& effort, std::size_t& programs);

}  // namespace slipproof
