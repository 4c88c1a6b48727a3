#include "report/values/every_load.hpp"

#include "contact/problem/every_load_json.hpp"
#include "mechanics/kernel/mode_solver.hpp"

namespace slipproof {

std::string in_words(const EveryLoad& every) {
  switch (every.verdict) {
    case EveryLoad::Verdict::unique:
      return "one motion whatever else pushes it, by the " +
             std::string(every.reason == EveryLoad::Reason::definite ? "positive definite matrix" : name(every.reason));
    case EveryLoad::Verdict::not_unique:
      return "not one under all other forces: the determinant of " + name(*every.mode) +
             (every.determinant.is_zero() ? " is 0" : " is negative");
    case EveryLoad::Verdict::undecided:
      break;
  }
  return every.reason == EveryLoad::Reason::no_theorem
             ? "other forces: not told, the Delassus matrix is not positive definite"
             : "other forces: undecided, there are too many modes";
}

std::string every_load_line(const std::optional<EveryLoad>& every) {
  if (!every) return {};
  std::string text = in_words(*every);
  text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

Json every_load_json(const std::optional<EveryLoad>& every) {
  return every ? to_json(*every, every->mode ? name(*every->mode) : "") : Json(nullptr);
}

}  // namespace slipproof
