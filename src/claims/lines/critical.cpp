#include "claims/lines/critical.hpp"

#include <algorithm>
#include <utility>

#include "claims/lines/line_mechanism.hpp"
#include "claims/sampling/sampler.hpp"

namespace slipproof {

namespace {

/// For so many min, max or abs that depend on the force, both choices of the operand are tried.
constexpr std::size_t max_branches = 6;

LineEvaluator evaluator_along(const Line& line, const CompiledSetting& compiled, LineField field,
                              std::optional<std::size_t> grows) {
  LineEvaluator evaluator(compiled.scope(), std::move(field));
  for (std::size_t k = 0; k < line.origin.size(); ++k) {
    evaluator.set(CompiledSetting::parameter_slot(k),
                  grows == k ? LineFunction::force() : LineFunction::linear(line.origin[k], line.direction[k]));
  }
  if (!grows) evaluator.set(CompiledSetting::force_slot(), LineFunction::force());
  return evaluator;
}

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

/// Everything that decides a claim along a line, seen from one place on it: each min, max and abs stands for the
/// operand that it has at this place. If that depends on the force, `branches` chooses the operand.
class View {
 public:
  View(const Line& line, const CompiledSetting& compiled, const ClaimParts& parts, const Rational& here,
       unsigned branches, CriticalSet& found)
      : compiled_(compiled),
        parts_(parts),
        found_(found),
        evaluator_(
            evaluator_along(line, compiled, {.found = &found, .here = here, .branches = branches}, std::nullopt)),
        growing_(evaluator_along(
            line, compiled, {.found = &found, .here = here, .branches = branches, .at_infinity = true}, parts.grows)) {}

  void collect() {
    found_.begin_group(0);
    for (const Program& domain : compiled_.domains()) add_comparisons(domain, evaluator_);
    add_comparisons(compiled_.is_scene(), evaluator_);
    add_scene();
    add_comparisons(compiled_.force_domain(), evaluator_);
    for (const Program* program : parts_.conditions) {
      add_comparisons(*program, parts_.grows ? growing_ : evaluator_);
    }
    if (parts_.modes.empty()) return;
    LineMechanism mechanism(compiled_, evaluator_);
    if (mechanism.has_value()) add_modes(mechanism);
  }

 private:
  /// Adds the zeros of the scene's expressions: a zero may be an end of the mechanism's domain, and there is no sample
  /// where the load does not depend on the force.
  void add_scene() {
    for (const Program* program : compiled_.scene().programs()) {
      if (const auto value = evaluator_.number(*program).number) found_.add_coefficients(*value);
    }
  }

  void add_modes(LineMechanism& on_line) {
    std::vector<std::size_t> wanted = slots_behind(compiled_.scope(), parts_.of_motions);
    std::erase_if(wanted, [&](std::size_t slot) { return !compiled_.is_quantity(slot); });
    for (std::size_t i = 0; i < parts_.modes.size(); ++i) {
      found_.begin_group(parts_.modes_meet ? 1 : i + 1);
      if (!on_line.add_mode(parts_.modes[i], wanted)) continue;
      for (const Program* program : parts_.of_motions) add_comparisons(*program, evaluator_);
    }
  }

  const CompiledSetting& compiled_;
  const ClaimParts& parts_;
  CriticalSet& found_;
  LineEvaluator evaluator_;
  LineEvaluator growing_;
};

/// The part of the line from the first to the last point of the domain, which may stand alone; nothing beyond it
/// matters. An irrational end counts as in the domain.
LinePart domain_part(const Line& line, const CompiledSetting& compiled) {
  CriticalSet found;
  LineEvaluator evaluator = evaluator_along(line, compiled, {.found = &found, .here = line.inside}, std::nullopt);
  for (const Program& domain : compiled.domains()) add_comparisons(domain, evaluator);
  if (!found.orders().empty() || found.branches() > 0) return {};
  const std::vector<RealRoot> roots = real_roots(found.polynomials());
  const std::vector<Rational> points = cell_points(roots);
  // Cells at even places, and the roots between them at odd ones.
  const std::size_t places = points.size() + roots.size();
  std::size_t first = places, last = 0;
  for (std::size_t i = 0; i < places; ++i) {
    const bool irrational = i % 2 == 1 && !roots[i / 2].is_rational();
    if (!irrational && !in_domain(compiled, line.at(i % 2 == 0 ? points[i / 2] : roots[i / 2].lower))) continue;
    first = std::min(first, i);
    last = i;
  }
  if (first == places || (first == last && first % 2 == 1)) return {};
  LinePart part;
  if (first > 0) part.lower = roots[(first - 1) / 2].lower;
  if (last + 1 < places) part.upper = roots[last / 2].upper;
  return part;
}

/// The rational critical values and one point of each cell, ascending; and two more near each end of the line, since in
/// a cell that reaches an end, errors that are not examined would show there first.
std::vector<Rational> values_of(const std::vector<RealRoot>& roots, const LinePart& part) {
  std::vector<Rational> values = cell_points(roots, part);
  const Rational near(1, 1 << 30), first = values.front(), last = values.back();
  const auto size = [](const Rational& x) { return Rational(1 + abs(x)); };
  values.push_back(part.lower ? Rational(*part.lower + (first - *part.lower) * near)
                              : Rational(first - size(first) / near));
  values.push_back(part.upper ? Rational(*part.upper - (*part.upper - last) * near)
                              : Rational(last + size(last) / near));
  for (const RealRoot& root : roots) {
    if (root.is_rational()) values.push_back(root.lower);
  }
  for (const auto& end : {part.lower, part.upper}) {
    if (end) values.push_back(*end);
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}  // namespace

std::size_t LinePoints::irrational() const {
  return static_cast<std::size_t>(
      std::count_if(roots.begin(), roots.end(), [](const RealRoot& root) { return !root.is_rational(); }));
}

LinePoints points_on(const Line& line, const CompiledSetting& compiled, const ClaimParts& parts,
                     const std::set<IntegerPolynomial>& beside) {
  const LinePart part = domain_part(line, compiled);
  CriticalSet found;
  for (const IntegerPolynomial& p : beside) found.add(p);
  const auto look_from = [&](const Rational& here) {
    for (unsigned branches = 0; branches < 1U << std::min(found.branches(), max_branches); ++branches) {
      View(line, compiled, parts, here, branches, found).collect();
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

std::optional<std::vector<std::unique_ptr<SolvedSample>>> last_points(const CompiledSetting& compiled,
                                                                      const std::vector<const Program*>& conditions,
                                                                      const std::vector<Rational>& values,
                                                                      std::size_t parameter) {
  Line line = along_parameter(values, parameter);
  ClaimParts parts;
  parts.conditions = conditions;
  parts.conditions.push_back(&compiled.is_point());
  const LinePoints points = points_on(line, compiled, parts);
  std::vector<std::unique_ptr<SolvedSample>> found;
  for (auto t = points.values.rbegin(); t != points.values.rend(); ++t) {
    const auto at_root = [&](const RealRoot& root) { return root.lower <= *t && *t <= root.upper; };
    const bool critical = std::any_of(points.roots.begin(), points.roots.end(), at_root) || points.part.lower == *t ||
                          points.part.upper == *t;
    std::vector<Rational> there = line.at(*t);
    auto sample = in_domain(compiled, there) ? SolvedSample::make(compiled, std::move(there)) : nullptr;
    if (sample) found.push_back(std::move(sample));
    if (critical || found.empty()) continue;
    const auto irrational_end = [&](const RealRoot& root) { return !root.is_rational() && root.lower >= *t; };
    if (std::any_of(points.roots.begin(), points.roots.end(), irrational_end)) return std::nullopt;
    break;
  }
  return found;
}

}  // namespace slipproof
