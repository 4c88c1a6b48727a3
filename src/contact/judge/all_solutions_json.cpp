#include "contact/judge/all_solutions_json.hpp"

#include "base/number/format.hpp"

namespace slipproof {

namespace {

/// `"3/4"`, or `["1/2", "1"]` of a range that is no point; null for an end that is infinite.
Json ranges_json(const std::vector<Range>& ranges) {
  const auto end = [](const std::optional<Rational>& x) { return x ? Json(exact_text(*x)) : Json(); };
  Json list = Json::array();
  for (const Range& range : ranges) {
    list.push_back(range.is_point() ? end(range.lower) : Json::array({end(range.lower), end(range.upper)}));
  }
  return list;
}

}  // namespace

void add_solutions(const AllSolutions& all, Json& to) {
  to["found"] = Json::array();
  for (const FoundSolution& s : all.solutions) {
    if (s.is_family()) continue;
    Json entry{{"modes", s.modes},
               {"status", s.strict ? "strict" : "boundary"},
               {"z", ranges_json(s.r)},
               {"w", ranges_json(s.u)}};
    if (!s.around.empty()) entry["all_w"] = ranges_json(s.around);
    to["found"].push_back(std::move(entry));
  }
  for (const FoundSolution& s : all.solutions) {
    if (!s.is_family()) continue;
    Json entry{{"mode", s.modes.front()}, {"parameters", s.open_directions}, {"nearest_z", ranges_json(s.r)}};
    if (all.dimension == 3) entry["w"] = ranges_json(s.u);  // one motion, by other forces, if there are no others
    if (!s.around.empty()) entry["all_w"] = ranges_json(s.around);
    for (const auto& other : s.others) entry["others"].push_back(ranges_json(other.u));
    to["continua"].push_back(std::move(entry));
  }
}

void add_own_mode(const OwnMode& own, Json& to) {
  to[own.claimed ? "claimed" : "looks_like"] = own.mode;
  to["violated"] = own.violated ? Json(*own.violated) : Json();
  if (own.violated) {
    to["margin"] = exact_text(own.margin);
  } else {
    to["reason"] = own.reason;
  }
}

}  // namespace slipproof
