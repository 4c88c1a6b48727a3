#include "claims/uniqueness/along.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "claims/lines/critical.hpp"
#include "claims/lines/line_mechanism.hpp"
#include "claims/uniqueness/scene_setting.hpp"
#include "contact/problem/every_push.hpp"
#include "mechanics/kernel/motions_over_loads.hpp"

namespace slipproof {

namespace {

bool alike(const LoadsApart& x, const LoadsApart& y) {
  return x.motions == y.motions && x.continuum == y.continuum;
}

/// Joins neighbours that are alike to one interval.
std::vector<LoadsApart> apart_of(const std::vector<LoadCell>& cells) {
  std::vector<LoadsApart> result;
  bool joins = false;  // whether the last cell is the last entry's
  for (const LoadCell& cell : cells) {
    LoadsApart here{cell.loads, cell.motions.size(), !cell.continua.empty()};
    const bool apart = here.motions != 1 || here.continuum;
    if (apart && joins && alike(result.back(), here)) {
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

/// The same for a problem without a load, where all loads are alike.
std::vector<LoadsApart> apart_without_load(const FrictionProblem& problem) {
  const MotionsAtLoad found = motions_of(problem, std::nullopt);
  if (found.motions.size() == 1 && found.continua.empty()) return {};
  return {{ForceInterval(), found.motions.size(), !found.continua.empty()}};
}

/// A scene with one parameter free.
class SceneLine {
 public:
  SceneLine(const MechanismScene& scene, const std::string& parameter)
      : scene_(scene), setting_(setting_along(scene, parameter)), compiled_(setting_), maker_(scene.mechanism) {
    if (mode_count(setting_.kinds()) > static_cast<double>(max_critical_modes)) {
      throw std::invalid_argument(
          "found more than " + std::to_string(max_critical_modes) +
          " contact modes, expected fewer: where the motions of two of them meet takes too long");
    }
    modes_ = modes_of(setting_.kinds());
    const auto& all = scene.mechanism.parameters;
    index_ = static_cast<std::size_t>(
        std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.symbol == parameter; }) - all.begin());
  }

  const Rational& own() const { return scene_.values.parameters[index_]; }

  /// Throws NoValue. What is known of every push, where contacts are redundant, is for one value only: ranges of the
  /// parameter end where mode determinants vanish, not where pairs of modes begin to differ.
  MotionsAtParameter motions(const Rational& x, bool of_every_push = false) const {
    const FrictionProblem problem = without_equations(maker_.problem(values(x)));
    MotionsAtParameter result;
    result.apart = problem.has_load ? apart_of(motions_over_loads(problem)->cells()) : apart_without_load(problem);
    if (const auto contacts = contact_problem(problem)) {
      result.for_every_q = of_every_push ? for_every_push(*contacts) : for_every_load(*contacts);
    }
    return result;
  }

  std::vector<ParameterCell> cells() const {
    const std::set<IntegerPolynomial> vanishing = determinants(modes_);
    const LinePoints points = critical_points(vanishing);
    const std::vector<RealRoot>& roots = points.roots;
    const std::vector<Rational> inside = cell_points(roots, points.part);
    const auto end = [](const std::optional<Rational>& x) {
      return x ? std::optional(RealRoot{*x, *x}) : std::nullopt;
    };
    std::vector<ParameterCell> result;
    const auto add = [&](std::optional<RealRoot> lower, std::optional<RealRoot> upper, std::optional<Rational> sample) {
      result.push_back({std::move(lower), std::move(upper), sample, sample ? at(*sample) : std::nullopt});
    };
    const auto add_end = [&](const std::optional<Rational>& x) {
      if (x && at(*x)) add(end(x), end(x), x);
    };
    add_end(points.part.lower);
    for (std::size_t i = 0; i < inside.size(); ++i) {
      const auto lower = i == 0 ? end(points.part.lower) : std::optional(roots[i - 1]);
      add(lower, i == roots.size() ? end(points.part.upper) : std::optional(roots[i]), inside[i]);
      if (i == roots.size()) break;
      add(roots[i], roots[i], roots[i].is_rational() ? std::optional(roots[i].lower) : std::nullopt);
    }
    add_end(points.part.upper);
    conclude(result, real_roots(vanishing, points.part));
    return result;
  }

 private:
  MechanismValues values(const Rational& x) const {
    MechanismValues changed = scene_.values;
    changed.parameters[index_] = x;
    return changed;
  }

  std::optional<MotionsAtParameter> at(const Rational& x) const {
    if (!maker_.broken(values(x)).empty()) return std::nullopt;
    try {
      return motions(x);
    } catch (const NoValue&) {
      return std::nullopt;
    }
  }

  LinePoints critical_points(const std::set<IntegerPolynomial>& beside) const {
    ClaimParts parts;
    parts.modes = modes_;
    parts.modes_meet = true;
    return points_on({{Rational(0)}, {Rational(1)}, own()}, compiled_, parts, beside);
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
  std::set<IntegerPolynomial> determinants(const std::vector<MechanismMode>& modes) const {
    CriticalSet found;
    LineEvaluator along(compiled_.scope(), {.found = &found, .here = own()});
    along.set(CompiledSetting::parameter_slot(0), LineFunction::linear(0, 1));
    along.set(CompiledSetting::force_slot(), LineFunction::force());
    const LineMechanism mechanism(compiled_, along);
    std::set<IntegerPolynomial> result;
    if (!mechanism.has_value()) return result;
    for (const MechanismMode& mode : modes) {
      const std::vector<PolynomialRow> equations = mechanism.equations(mode);
      result.insert(equations.size() == compiled_.unknowns() ? determinant(equations) : 0);
    }
    return result;
  }

  const MechanismScene& scene_;
  const Setting setting_;
  const CompiledSetting compiled_;
  const ProblemMaker maker_;
  std::vector<MechanismMode> modes_;
  std::size_t index_ = 0;
};

}  // namespace

std::optional<RealRoot> UniquenessAlong::first_apart() const {
  const auto apart = [](const ParameterCell& cell) { return cell.motions && !cell.motions->apart.empty(); };
  const auto found = std::find_if(cells.begin(), cells.end(), apart);
  return found == cells.end() ? std::nullopt : found->lower;
}

std::optional<RealRoot> UniquenessAlong::first_apart_for_some_q() const {
  const auto apart = [](const ParameterCell& cell) {
    return cell.motions && cell.motions->for_every_q &&
           cell.motions->for_every_q->verdict == EveryLoad::Verdict::not_unique;
  };
  const auto found = std::find_if(cells.begin(), cells.end(), apart);
  return found == cells.end() ? std::nullopt : found->lower;
}

UniquenessAlong uniqueness_along(const MechanismScene& scene, const std::string& parameter) {
  const SceneLine line(scene, parameter);
  return {parameter, line.own(), line.motions(line.own(), true), line.cells()};
}

}  // namespace slipproof
