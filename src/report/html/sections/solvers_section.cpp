#include <algorithm>
#include <array>
#include <string>

#include "report/html/sections.hpp"
#include "report/html/verdict_bar.hpp"

namespace slipproof {

namespace {

constexpr std::array<const char*, 6> classes{"fill-proved",  "fill-holds",     "fill-inaccurate",
                                             "fill-refuted", "fill-undecided", "fill-inaccurate"};
constexpr std::array<std::string_view, 6> verdicts{"certified", "ambiguous", "inaccurate",
                                                   "wrong",     "invalid",   "undecided"};

std::vector<BarPart> parts_of(const SolverVerdicts& solver) {
  std::vector<BarPart> parts;
  for (std::size_t i = 0; i < classes.size(); ++i) parts.push_back({classes[i], solver.verdicts[i]});
  return parts;
}

/// Whether any solver has the verdict: a column of zeros is left out.
bool occurs(const PageInput& input, std::size_t verdict) {
  return std::any_of(input.solvers.begin(), input.solvers.end(),
                     [&](const SolverVerdicts& solver) { return solver.verdicts[verdict] > 0; });
}

}  // namespace

void add_solvers_section(const Element& main, const PageInput& input) {
  if (input.solvers.empty()) return;
  const Element section = add_section(main, "solvers", "Certified solvers");
  section.add("p", "lead")
      .text(
          "What floating-point solvers answered, judged record by record by slipproof certify with its "
          "default tolerance. Certified: the one motion. Ambiguous: right, but one of several. Inaccurate: "
          "the right motion, with an error above the tolerance. Wrong: no motion is near.");
  const Element scroll = section.add("div", "scroll").set("tabindex", 0).set("role", "region");
  scroll.set("aria-label", "Verdicts by solver");
  const Element table = scroll.add("table", "solvers");
  const Element head = table.add("thead").add("tr");
  head.add("th").set("scope", "col").text("solver");
  head.add("th").set("scope", "col").text("records");
  head.add("th").set("scope", "col").text("share");
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (!occurs(input, i)) continue;
    const Element th = head.add("th").set("scope", "col");
    th.add("svg", "key")
        .set("viewBox", "0 0 10 10")
        .set("aria-hidden", "true")
        .add("rect", classes[i])
        .set("width", 10)
        .set("height", 10);
    th.text(" " + std::string(verdicts[i]));
  }
  head.add("th").set("scope", "col").text("of these two, called a success");
  const Element body = table.add("tbody");
  for (const SolverVerdicts& solver : input.solvers) {
    const Element row = body.add("tr");
    row.add("th").set("scope", "row").text(solver.name);
    row.add("td", "number").text(std::to_string(solver.records));
    add_bar(row.add("td"), parts_of(solver), 200, 14);
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
      if (!occurs(input, i)) continue;
      const auto count = solver.verdicts[i];
      row.add("td", count == 0 ? "number none" : "number").text(std::to_string(count));
    }
    const bool none = !solver.unfounded || *solver.unfounded == 0;
    row.add("td", none ? "number none" : "number alarm")
        .text(solver.unfounded ? std::to_string(*solver.unfounded) : "–");
  }
}

}  // namespace slipproof
