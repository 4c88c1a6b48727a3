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

/// The colour of a verdict in the bars.
ReportSpan key(std::size_t verdict) {
  return drawn("", [verdict](const Element& head) {
    const Element svg = head.add("svg", "key").set("viewBox", "0 0 10 10").set("aria-hidden", "true");
    svg.add("rect", classes[verdict]).set("width", 10).set("height", 10);
  });
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
  ReportTable table{{"solver", {"records", true}, "share"}};
  table.label = "Verdicts by solver";
  table.css_class = "solvers";
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (occurs(input, i)) table.columns.push_back({{key(i), " " + std::string(verdicts[i])}, true});
  }
  table.columns.emplace_back("of these two, called a success", true);
  for (const SolverVerdicts& solver : input.solvers) {
    std::vector<ReportCell> cells{solver.name, std::to_string(solver.records),
                                  drawn("", [&](const Element& cell) { add_bar(cell, parts_of(solver), 200, 14); })};
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
      if (occurs(input, i)) cells.push_back(ReportCell::count(solver.verdicts[i]));
    }
    cells.push_back(ReportCell::count(solver.unfounded.value_or(0), true));
    if (!solver.unfounded) cells.back() = "–";
    table.row(std::move(cells));
  }
  add_table(section, table);
}

}  // namespace slipproof
