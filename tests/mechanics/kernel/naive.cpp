#include "mechanics/kernel/naive.hpp"

#include <algorithm>
#include <utility>

namespace slipproof::test {

namespace {

AffineForm sum(const AffineForm& x, int factor, const AffineForm& y) {
  AffineForm result{x.constant + factor * y.constant, {}};
  for (std::size_t i = 0; i < x.coefficients.size(); ++i) {
    result.coefficients.push_back(x.coefficients[i] + factor * y.coefficients[i]);
  }
  return result;
}

AffineForm times(int factor, const AffineForm& form) {
  return sum(form, factor - 1, form);
}

/// Stick, slip+ and slip- of something that slips with the friction limits given.
std::vector<NaiveMode> naive_slips(const ProblemElement& e, const AffineForm& limit_s, const AffineForm& limit_k) {
  std::vector<NaiveMode> result;
  if (!e.kind.slides()) {
    result.push_back({"stick", {e.slip}, {sum(limit_s, -1, e.tangent), sum(limit_s, 1, e.tangent)}});
  }
  for (const int direction : {1, -1}) {
    if (e.kind.start == ElementKind::Start::slides_forward && direction < 0) continue;
    if (e.kind.start == ElementKind::Start::slides_backward && direction > 0) continue;
    NaiveMode slip{direction > 0 ? "slip+" : "slip-", {sum(e.tangent, direction, limit_k)}, {}};
    if (!e.kind.slides()) slip.conditions.push_back(times(direction, e.slip));
    result.push_back(std::move(slip));
  }
  return result;
}

/// A contact with friction that pushes (sign = 1) or pulls.
std::vector<NaiveMode> naive_touching(const ProblemElement& e, int sign) {
  auto result = naive_slips(e, times(sign, e.static_limit), times(sign, e.kinetic_limit));
  for (NaiveMode& state : result) {
    state.equations.push_back(e.gap);
    state.conditions.push_back(times(sign, e.normal));
    if (sign < 0) state.name += '~';
  }
  return result;
}

std::vector<NaiveMode> naive_states(const ProblemElement& e) {
  using Law = ElementKind::Law;
  const bool open = e.kind.start == ElementKind::Start::open;
  std::vector<NaiveMode> result;
  if (e.kind.law == Law::limited) {
    result = naive_slips(e, e.static_limit, e.kinetic_limit);
    for (NaiveMode& state : result) {
      state.conditions.push_back(e.static_limit);
      state.conditions.push_back(e.kinetic_limit);
    }
    return result;
  }
  if (!open && e.kind.law == Law::frictionless) {
    result.push_back({"touch", {e.gap}, {}});
    if (!e.kind.bilateral) result[0].conditions.push_back(e.normal);
  } else if (!open) {
    result = naive_touching(e, 1);
    if (e.kind.bilateral) {
      for (NaiveMode& state : naive_touching(e, -1)) result.push_back(std::move(state));
    }
  }
  if (open || (!e.kind.bilateral && e.kind.lifts)) {
    NaiveMode lift{"lift", {e.normal}, {}};
    if (e.kind.law == Law::coulomb) lift.equations.push_back(e.tangent);
    if (!open) lift.conditions.push_back(e.gap);
    result.push_back(std::move(lift));
  }
  return result;
}

void add_loads(RawSystem& system, const FrictionProblem& problem, const std::optional<Rational>& load) {
  AffineForm value{0, std::vector<Rational>(problem.unknowns + 1)};
  value.coefficients.back() = 1;
  if (load || !problem.has_load) {
    value.constant = problem.has_load ? -*load : Rational(0);
    system.equations.push_back(value);
    return;
  }
  const ForceInterval& domain = problem.load_domain;
  if (domain.empty()) system.inequalities.push_back({{-1, std::vector<Rational>(problem.unknowns + 1)}, false});
  if (domain.lower()) {
    value.constant = -*domain.lower();
    system.inequalities.push_back({value, !domain.lower_closed()});
  }
  if (domain.upper()) {
    value = times(-1, value);
    value.constant = *domain.upper();
    system.inequalities.push_back({value, !domain.upper_closed()});
  }
}

RawSystem system_of(const NaiveMode& mode, const FrictionProblem& problem, const std::optional<Rational>& load,
                    bool strict) {
  RawSystem system = mode.equations_only(problem, load);
  for (const AffineForm& condition : mode.conditions) system.inequalities.push_back({condition, strict});
  return system;
}

std::vector<ForceInterval> shadows(const RawSystem& system, const std::vector<AffineForm>& forms) {
  std::vector<ForceInterval> result;
  for (const AffineForm& form : forms) result.push_back(shadow(system, form));
  return result;
}

ForceInterval hull(const ForceInterval& x, const ForceInterval& y) {
  std::optional<Rational> lower, upper;
  if (x.lower() && y.lower()) lower = std::min(*x.lower(), *y.lower());
  if (x.upper() && y.upper()) upper = std::max(*x.upper(), *y.upper());
  return ForceInterval::between(lower, true, upper, true);
}

void add_mode(NaiveMotions& result, const FrictionProblem& problem, const NaiveMode& mode,
              const std::optional<Rational>& load) {
  const RawSystem system = mode.closed(problem, load);
  if (!is_solvable(system)) return;
  result.consistent.insert(mode.name);
  const bool strict = is_solvable(mode.strict(problem, load));
  std::vector<ForceInterval> accelerations = shadows(system, problem.accelerations);
  const std::vector<ForceInterval> forces = shadows(system, problem.forces);
  if (!std::all_of(accelerations.begin(), accelerations.end(), [](const auto& range) { return range.is_point(); })) {
    accelerations.insert(accelerations.end(), forces.begin(), forces.end());
    result.continua[mode.name] = {std::move(accelerations), strict};
    return;
  }
  std::vector<Rational> key;
  for (const ForceInterval& range : accelerations) key.push_back(*range.lower());
  NaiveMotion& motion = result.motions[key];
  (strict ? motion.modes : motion.boundary_modes).insert(mode.name);
  if (motion.forces.empty()) motion.forces = forces;
  for (std::size_t i = 0; i < forces.size(); ++i) motion.forces[i] = hull(motion.forces[i], forces[i]);
}

bool naively_contains(const FrictionProblem& problem, const NaiveMode& continuum, const std::vector<Rational>& motion,
                      const std::optional<Rational>& load) {
  RawSystem system = continuum.closed(problem, load);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    system.equations.push_back(problem.accelerations[i]);
    system.equations.back().constant -= motion[i];
  }
  return is_solvable(system);
}

NaiveMotions naively_gathered(const FrictionProblem& problem, const std::vector<NaiveMode>& modes,
                              const std::optional<Rational>& load) {
  NaiveMotions result;
  for (const NaiveMode& mode : modes) add_mode(result, problem, mode, load);
  for (auto& [accelerations, motion] : result.motions) {
    for (const NaiveMode& mode : modes) {
      if (result.continua.count(mode.name) > 0 && naively_contains(problem, mode, accelerations, load))
        motion.continua.insert(mode.name);
    }
  }
  return result;
}

}  // namespace

RawSystem NaiveMode::equations_only(const FrictionProblem& problem, const std::optional<Rational>& load) const {
  RawSystem system{problem.equations, {}};
  system.equations.insert(system.equations.end(), equations.begin(), equations.end());
  add_loads(system, problem, load);
  return system;
}

RawSystem NaiveMode::closed(const FrictionProblem& problem, const std::optional<Rational>& load) const {
  return system_of(*this, problem, load, false);
}

RawSystem NaiveMode::strict(const FrictionProblem& problem, const std::optional<Rational>& load) const {
  return system_of(*this, problem, load, true);
}

std::vector<NaiveMode> naive_modes(const FrictionProblem& problem) {
  std::vector<NaiveMode> modes{{}};
  for (const ProblemElement& element : problem.elements) {
    std::vector<NaiveMode> longer;
    for (const NaiveMode& begun : modes) {
      for (const NaiveMode& state : naive_states(element)) {
        NaiveMode mode = begun;
        mode.name += (mode.name.empty() ? "" : "/") + state.name;
        mode.equations.insert(mode.equations.end(), state.equations.begin(), state.equations.end());
        mode.conditions.insert(mode.conditions.end(), state.conditions.begin(), state.conditions.end());
        longer.push_back(std::move(mode));
      }
    }
    modes = std::move(longer);
  }
  return modes;
}

NaiveMotions naive_motions(const FrictionProblem& problem, const std::vector<NaiveMode>& modes,
                           const std::optional<Rational>& load) {
  NaiveMotions result = naively_gathered(problem, modes, load);
  FrictionProblem lowered = problem;
  bool differs = false;
  for (ProblemElement& e : lowered.elements) {
    differs = differs || e.static_limit.constant != e.kinetic_limit.constant ||
              e.static_limit.coefficients != e.kinetic_limit.coefficients;
    e.static_limit = e.kinetic_limit;
  }
  if (!differs || result.motions.size() < 2 || !result.continua.empty()) return result;
  const NaiveMotions left = naively_gathered(lowered, naive_modes(lowered), load);
  if (left.motions.size() != 1 || !left.continua.empty()) return result;
  std::set_difference(result.consistent.begin(), result.consistent.end(), left.consistent.begin(),
                      left.consistent.end(), std::inserter(result.hysteresis, result.hysteresis.end()));
  return result;
}

}  // namespace slipproof::test
