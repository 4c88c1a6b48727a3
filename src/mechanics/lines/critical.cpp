#include "mechanics/lines/critical.hpp"

#include <algorithm>
#include <utility>

#include "mechanics/lines/line_mechanism.hpp"

namespace slipproof {

namespace {

/// For so many min, max or abs that depend on the force, both choices of the operand are tried.
constexpr std::size_t max_branches = 6;

void add_comparisons(const Program& program, LineEvaluator& evaluator) {
  const LineField& field = evaluator.field();
  for (const Program::Instruction& instruction : program.code()) {
    if (instruction.operation != Operation::compare) continue;
    const auto x = evaluator.number(program, instruction.first), y = evaluator.number(program, instruction.second);
    if (!x.number || !y.number) continue;
    const LineFunction difference = *x.number - *y.number;
    field.at_infinity ? field.found->add_coefficients(difference) : field.found->add(difference);
  }
}

/// Everything that decides a question along a line, seen from one place on it: each min, max and abs stands for the
/// operand that it has at this place. If that depends on the force, `branches` chooses the operand.
class View {
 public:
  View(const Line& line, const CompiledFamily& family, const Question& question, const Rational& here,
       unsigned branches, CriticalSet& found)
      : family_(family),
        question_(question),
        found_(found),
        evaluator_(evaluator_along(line, family, {.found = &found, .here = here, .branches = branches})),
        growing_(evaluator_along(
            line, family, {.found = &found, .here = here, .branches = branches, .at_infinity = true}, question.grows)) {
  }

  void collect() {
    found_.begin_group(0);
    for (const Program& domain : family_.domains()) add_comparisons(domain, evaluator_);
    add_comparisons(family_.is_scene(), evaluator_);
    add_scene();
    add_comparisons(family_.force_domain(), evaluator_);
    for (const Program* program : question_.conditions) {
      add_comparisons(*program, question_.grows ? growing_ : evaluator_);
    }
    if (question_.modes.empty()) return;
    LineMechanism mechanism(family_, evaluator_);
    if (mechanism.has_value()) add_modes(mechanism);
  }

 private:
  /// Adds the zeros of the scene's expressions: a zero may be an end of the mechanism's domain, and there is no sample
  /// where the load does not depend on the force.
  void add_scene() {
    for (const Program* program : family_.scene().programs()) {
      if (const auto value = evaluator_.number(*program).number) found_.add_coefficients(*value);
    }
  }

  void add_modes(LineMechanism& on_line) {
    std::vector<std::size_t> wanted = slots_behind(family_.scope(), question_.of_motions);
    std::erase_if(wanted, [&](std::size_t slot) { return !family_.is_quantity(slot); });
    for (std::size_t i = 0; i < question_.modes.size(); ++i) {
      found_.begin_group(question_.modes_meet ? 1 : i + 1);
      if (!on_line.add_mode(question_.modes[i], wanted)) continue;
      for (const Program* program : question_.of_motions) add_comparisons(*program, evaluator_);
    }
  }

  const CompiledFamily& family_;
  const Question& question_;
  CriticalSet& found_;
  LineEvaluator evaluator_;
  LineEvaluator growing_;
};

/// The part of the line from the first to the last point of the domain, which may stand alone; nothing beyond it
/// matters. An irrational end counts as in the domain.
LinePart domain_part(const Line& line, const CompiledFamily& family) {
  CriticalSet found;
  LineEvaluator evaluator = evaluator_along(line, family, {.found = &found, .here = line.inside});
  for (const Program& domain : family.domains()) add_comparisons(domain, evaluator);
  if (!found.orders().empty() || found.branches() > 0) return {};
  const std::vector<LineCell> cells = line_cells(real_roots(found.polynomials()));
  const auto may_be_inside = [&](const LineCell& cell) {
    return !cell.sample || in_domain(family, line.at(*cell.sample));
  };
  const auto first = std::ranges::find_if(cells, may_be_inside);
  if (first == cells.end()) return {};
  const auto last = std::find_if(cells.rbegin(), cells.rend(), may_be_inside);
  if (&*first == &*last && first->is_point()) return {};
  LinePart part;
  if (first->lower) part.lower = first->lower->lower;
  if (last->upper) part.upper = last->upper->upper;
  return part;
}

/// The rational critical values and one point of each cell, ascending; and two more near each end of the line, since in
/// a cell that reaches an end, errors that are not examined would show there first.
std::vector<Rational> values_of(const std::vector<RealRoot>& roots, const LinePart& part) {
  const std::vector<LineCell> cells = line_cells(roots, part);
  std::vector<Rational> values;
  for (const LineCell& cell : cells) {
    if (cell.sample) values.push_back(*cell.sample);
  }
  const Rational near(1, 1 << 30);
  const Rational &first = *cells[part.lower ? 1 : 0].sample, &last = *cells.rbegin()[part.upper ? 1 : 0].sample;
  const auto size = [](const Rational& x) { return Rational(1 + abs(x)); };
  values.push_back(part.lower ? Rational(*part.lower + (first - *part.lower) * near)
                              : Rational(first - size(first) / near));
  values.push_back(part.upper ? Rational(*part.upper - (*part.upper - last) * near)
                              : Rational(last + size(last) / near));
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}  // namespace

std::size_t LinePoints::irrational() const {
  return static_cast<std::size_t>(
      std::count_if(roots.begin(), roots.end(), [](const RealRoot& root) { return !root.is_rational(); }));
}

LinePoints points_on(const Line& line, const CompiledFamily& family, const Question& question,
                     const std::set<IntegerPolynomial>& beside) {
  const LinePart part = domain_part(line, family);
  CriticalSet found;
  for (const IntegerPolynomial& p : beside) found.add(p);
  const auto look_from = [&](const Rational& here) {
    for (unsigned branches = 0; branches < 1U << std::min(found.branches(), max_branches); ++branches) {
      View(line, family, question, here, branches, found).collect();
    }
  };
  // The operand of a min or max can change along the line only where an order changes. Therefore one view from each
  // cell between these places shows all operands. A view may add new orders.
  std::set<Rational> places;
  std::vector<Rational> open{line.inside};
  while (!open.empty()) {
    for (const Rational& here : open) {
      if (places.insert(here).second) look_from(here);
    }
    open.clear();
    if (found.orders().empty()) break;
    for (Rational& place : cell_points(real_roots(found.orders(), part), part)) {
      if (!places.contains(place)) open.push_back(std::move(place));
    }
  }
  std::vector<RealRoot> roots = real_roots(found.polynomials(), part);
  std::vector<Rational> values = values_of(roots, part);
  return {std::move(values), std::move(roots), part};
}

std::optional<std::vector<std::unique_ptr<SolvedSample>>> last_points(const CompiledFamily& family,
                                                                      const std::vector<const Program*>& conditions,
                                                                      const std::vector<Rational>& values,
                                                                      std::size_t parameter) {
  Line line = along_parameter(values, parameter);
  Question question;
  question.conditions = conditions;
  question.conditions.push_back(&family.is_point());
  const LinePoints points = points_on(line, family, question);
  std::vector<std::unique_ptr<SolvedSample>> found;
  for (auto t = points.values.rbegin(); t != points.values.rend(); ++t) {
    const auto at_root = [&](const RealRoot& root) { return root.lower <= *t && *t <= root.upper; };
    const bool critical = std::any_of(points.roots.begin(), points.roots.end(), at_root) || points.part.lower == *t ||
                          points.part.upper == *t;
    auto sample = SolvedSample::in_domain(family, line.at(*t));
    if (sample) found.push_back(std::move(sample));
    if (critical || found.empty()) continue;
    const auto irrational_end = [&](const RealRoot& root) { return !root.is_rational() && root.lower >= *t; };
    if (std::any_of(points.roots.begin(), points.roots.end(), irrational_end)) return std::nullopt;
    break;
  }
  return found;
}

}  // namespace slipproof
