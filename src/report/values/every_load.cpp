#include "report/values/every_load.hpp"

#include "contact/problem/every_load_json.hpp"
#include "mechanics/elements/element.hpp"

namespace slipproof {

namespace {

std::string directions(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " direction" : " directions");
}

}  // namespace

std::string in_words(const EveryLoad& every) {
  switch (every.verdict) {
    case EveryLoad::Verdict::unique:
      return "one motion whatever else pushes it, by the " +
             std::string(every.reason == EveryLoad::Reason::definite ? "positive definite matrix" : name(every.reason));
    case EveryLoad::Verdict::at_most_one:
      return "never two motions whatever else pushes, forces undetermined along " + directions(every.undetermined);
    case EveryLoad::Verdict::not_unique:
      if (every.other) {
        return "not one under all other forces: some allow both " + name(*every.mode) + " and " + name(*every.other);
      }
      return "not one under all other forces: the determinant of " + name(*every.mode) +
             (every.determinant.is_zero() ? " is 0" : " is negative");
    case EveryLoad::Verdict::undecided:
      break;
  }
  if (every.reason == EveryLoad::Reason::no_theorem) {
    return "other forces: not told, the Delassus matrix is not positive definite";
  }
  return "other forces: undecided, there are too many " + std::string(every.undetermined != 0 ? "pairs of " : "") +
         "modes" + (every.undetermined != 0 ? "; forces undetermined along " + directions(every.undetermined) : "");
}

std::string every_load_line(const std::optional<EveryLoad>& every) {
  if (!every) return {};
  std::string text = in_words(*every);
  text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

Json every_load_json(const std::optional<EveryLoad>& every) {
  return every ? to_json(*every, every->mode ? name(*every->mode) : "", every->other ? name(*every->other) : "")
               : Json(nullptr);
}

}  // namespace slipproof
