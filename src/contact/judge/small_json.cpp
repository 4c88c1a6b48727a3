#include "contact/judge/small_json.hpp"

#include "base/number/format.hpp"

namespace slipproof {

Json modes_json(const ContactProblem& problem, const std::vector<ProblemMode>& modes) {
  Json names = Json::array();
  for (const ProblemMode& mode : modes) names.push_back(name(problem, mode));
  return names;
}

void add_solutions(const ContactProblem& problem, const SmallJudgement& found, Json& to) {
  to["found"] = Json::array();
  for (const ContactSolution& s : found.all->solutions) {
    to["found"].push_back({{"modes", modes_json(problem, s.modes)},
                           {"status", s.strict ? "strict" : "boundary"},
                           {"z", exact_texts(s.z)},
                           {"w", exact_texts(s.w)}});
  }
  for (std::size_t i = 0; i < found.members.size(); ++i) {
    const ContactContinuum& c = found.all->continua[i];
    to["continua"].push_back({{"mode", name(problem, c.mode)},
                              {"parameters", c.directions.size()},
                              {"nearest_z", exact_texts(found.members[i])}});
  }
}

void add_own_mode(const ContactProblem& problem, const ProblemAnswer& answer, const SmallJudgement& found, Json& to) {
  to[answer.mode ? "claimed" : "looks_like"] = name(problem, found.looks_like);
  to["violated"] = nullptr;
  switch (found.own->kind) {
    case ModeOutcome::Kind::violated:
      to["violated"] = name(problem, *found.own->condition);
      to["margin"] = exact_text(found.own->margin);
      break;
    case ModeOutcome::Kind::inconsistent:
      to["reason"] = "the mode has no solution";
      break;
    case ModeOutcome::Kind::solution:
    case ModeOutcome::Kind::continuum:
      to["reason"] = "the mode is right, its numbers are not";
      break;
  }
}

}  // namespace slipproof
