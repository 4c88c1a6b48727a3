#include "claims/paper/paper.hpp"

namespace slipproof {

std::string_view name(Reading reading) {
  return reading == Reading::printed ? "printed" : "repaired";
}

std::string_view name(Origin origin) {
  return origin == Origin::printed ? "printed" : "ours";
}

std::string Paper::place(std::size_t line) const {
  std::string section, item;
  std::size_t begin = 0;  // the line of the last heading
  for (const auto& [at, heading] : headings) {
    if (at > line) break;
    const bool is_section = heading.starts_with("Section ");
    if (is_section) section = heading;
    item = is_section ? "" : heading;
    begin = at;
  }
  const Equation* last = nullptr;
  for (const Equation& equation : equations) {
    if (begin <= equation.line && equation.line <= line) last = &equation;
  }
  std::string result = section;
  if (!item.empty()) result += (result.empty() ? "" : ", ") + item;
  if (last == nullptr || headings.empty()) return result;
  return result + (result.empty() ? "" : ", ") + (last->line == line ? "(" : "after (") + last->number + ")";
}

std::string Paper::where(std::size_t line) const {
  const std::string named = place(line), numbered = std::to_string(line);
  return named.empty() ? "Line " + numbered : named + " (line " + numbered + ")";
}

}  // namespace slipproof
