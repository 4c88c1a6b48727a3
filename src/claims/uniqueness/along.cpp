#include "claims/uniqueness/along.hpp"

#include <algorithm>
#include <set>

#include "contact/problem/every_push.hpp"
#include "mechanics/kernel/motions_over_loads.hpp"
#include "mechanics/lines/line_mechanism.hpp"
#include "mechanics/lines/scene_line.hpp"

namespace slipproof {

namespace {

/// Joins neighbours that are alike to one interval.
std::vector<LoadsApart> apart_of(const std::vector<LoadCell>& cells) {
  std::vector<LoadsApart> result;
  bool joins = false;  // whether the last cell is the last entry's
  for (const LoadCell& cell : cells) {
    LoadsApart here{cell.loads, cell.motions.size(), !cell.continua.empty()};
    const bool apart = here.motions != 1 || here.continuum;
    if (apart && joins && here.is_like(result.back())) {
      ForceInterval& loads = result.back().loads;
      loads =
          ForceInterval::between(loads.lower(), loads.lower_closed(), here.loads.upper(), here.loads.upper_closed());
    } else if (apart) {
      result.push_back(std::move(here));
    }
    joins = apart;
  }
  return result;
}

/// Without a load all loads are alike.
std::vector<LoadCell> all_cells(const FrictionProblem& problem) {
  if (problem.has_load) return motions_over_loads(problem)->cells();
  return {cell_of(motions_of(problem, std::nullopt))};
}

/// A scene with one parameter free, at every load.
class MotionsAlong {
 public:
  MotionsAlong(const MechanismScene& scene, const std::string& parameter)
      : line_(scene, parameter, SceneLine::Load::every, max_critical_modes, "where the motions of two of them meet") {}

  const Rational& own() const { return line_.own(); }

  /// Throws NoValue. What is known of every push, where contacts are redundant, is for one value only: ranges of the
  /// parameter end where mode determinants vanish, not where pairs of modes begin to differ.
  MotionsAtParameter at_own() const {
    return motions(line_.family().maker().problem(line_.scene().values(own())), true);
  }

  std::vector<ParameterCell> cells() const {
    const std::set<IntegerPolynomial> vanishing = determinants();
    const LinePoints points = line_.points(own(), vanishing);
    std::vector<ParameterCell> result;
    for (LineCell& cell : line_cells(points.roots, points.part)) {
      auto motions = cell.sample ? at(*cell.sample) : std::nullopt;
      const bool end =
          cell.sample && cell.is_point() && (cell.sample == points.part.lower || cell.sample == points.part.upper);
      if (motions || !end) result.push_back({std::move(cell), std::move(motions)});
    }
    conclude(result, real_roots(vanishing, points.part));
    return result;
  }

 private:
  static MotionsAtParameter motions(const FrictionProblem& with_equations, bool of_every_push) {
    const FrictionProblem problem = without_equations(with_equations);
    MotionsAtParameter result;
    result.apart = apart_of(all_cells(problem));
    if (const auto contacts = contact_problem(problem)) {
      result.for_every_q = of_every_push ? for_every_push(*contacts) : for_every_load(*contacts);
    }
    return result;
  }

  std::optional<MotionsAtParameter> at(const Rational& x) const {
    const auto problem = line_.scene().problem(x);
    return problem ? std::optional(motions(*problem, false)) : std::nullopt;
  }

  /// Concludes about irrational values between neighbours that have one motion for every q.
  static void conclude(std::vector<ParameterCell>& cells, const std::vector<RealRoot>& vanishing) {
    const auto unique = [](const ParameterCell& cell) {
      return cell.motions && cell.motions->for_every_q && cell.motions->apart.empty() &&
             cell.motions->for_every_q->verdict == EveryLoad::Verdict::unique;
    };
    for (std::size_t i = 1; i + 1 < cells.size(); ++i) {
      if (cells[i].sample || !unique(cells[i - 1]) || !unique(cells[i + 1])) continue;
      const RealRoot& here = *cells[i].lower;
      const auto may_be_here = [&](const RealRoot& r) { return r.lower <= here.upper && here.lower <= r.upper; };
      if (std::none_of(vanishing.begin(), vanishing.end(), may_be_here)) cells[i].motions = cells[i - 1].motions;
    }
  }

  /// The mode determinants, each times factors that are critical anyway.
  std::set<IntegerPolynomial> determinants() const {
    const CompiledFamily& family = line_.family();
    CriticalSet found;
    LineEvaluator along = evaluator_along(line_.line(own()), family, {.found = &found, .here = own()});
    const LineMechanism mechanism(family, along);
    std::set<IntegerPolynomial> result;
    if (!mechanism.has_value()) return result;
    for (const MechanismMode& mode : line_.modes()) {
      const std::vector<PolynomialRow> equations = mechanism.equations(mode);
      result.insert(equations.size() == family.unknowns() ? determinant(equations) : 0);
    }
    return result;
  }

  const SceneLine line_;
};

}  // namespace

std::optional<RealRoot> UniquenessAlong::first_where(bool (*holds)(const MotionsAtParameter&)) const {
  const auto found =
      std::ranges::find_if(cells, [&](const ParameterCell& cell) { return cell.motions && holds(*cell.motions); });
  return found == cells.end() ? std::nullopt : found->lower;
}

std::optional<RealRoot> UniquenessAlong::first_apart() const {
  return first_where([](const MotionsAtParameter& motions) { return !motions.apart.empty(); });
}

std::optional<RealRoot> UniquenessAlong::first_apart_for_some_q() const {
  return first_where([](const MotionsAtParameter& motions) {
    return motions.for_every_q && motions.for_every_q->verdict == EveryLoad::Verdict::not_unique;
  });
}

UniquenessAlong uniqueness_along(const MechanismScene& scene, const std::string& parameter) {
  const MotionsAlong line(scene, parameter);
  return {parameter, line.own(), line.at_own(), line.cells()};
}

}  // namespace slipproof
