#include "contact/problem/global_problem.hpp"

#include <fmt/format.h>

#include "base/number/format.hpp"
#include "base/output/json.hpp"
#include "base/output/listed.hpp"

namespace slipproof {

namespace {

/// A whole number bare, a fraction as a text.
std::string number(const Rational& x) {
  const bool bare = denominator(x) == 1 && abs(x) <= Rational(1'000'000'000);
  return bare ? exact_text(x) : "\"" + exact_text(x) + "\"";
}
std::string list(const std::vector<Rational>& row) {
  return "[" + listed(row, number) + "]";
}
std::string rows(const RationalMatrix& matrix) {
  return "[\n    " + listed(matrix, list, ",\n    ") + "]";
}

}  // namespace

std::string to_json(const GlobalProblem& p) {
  std::string text = fmt::format("{{\n  \"title\": {},\n  \"dimension\": {},\n", Json(p.title).dump(), p.dimension);
  text += fmt::format("  \"contacts\": {},\n", Json(p.contacts).dump());
  if (!p.q.empty()) {
    return text + fmt::format("  \"W\": {},\n  \"q\": {},\n  \"mu\": {}\n}}\n", rows(p.W), list(p.q), list(p.mu));
  }
  text += fmt::format("  \"M\": {},\n  \"H\": {},\n  \"f\": {},\n  \"w\": {},\n  \"mu\": {}", rows(p.M), rows(p.H),
                      list(p.f), list(p.w), list(p.mu));
  if (!p.b.empty()) text += fmt::format(",\n  \"G\": {},\n  \"b\": {}", rows(p.G), list(p.b));
  return text + "\n}\n";
}

}  // namespace slipproof
