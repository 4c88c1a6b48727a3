#include "contact/solutions.hpp"

#include <algorithm>

#include "contact/mode_system.hpp"

namespace slipproof {

namespace {

/// Goes on to the next mode; false after the last one, with the first.
bool advance(ProblemMode& mode, const std::vector<ContactState>& states) {
  for (ContactState& state : mode) {
    const auto next = std::find(states.begin(), states.end(), state) + 1;
    state = next == states.end() ? states.front() : *next;
    if (next != states.end()) return true;
  }
  return false;
}

}  // namespace

ContactSolver::ContactSolver(const ContactProblem& problem)
    : problem_(problem), scaled_(std::make_unique<const ScaledProblem>(problem)) {}

ContactSolver::~ContactSolver() = default;

Work ContactSolver::modes() const {
  return problem_.size() < 63 ? Work{1} << problem_.size() : endless;  // 4 for two components with friction, 2 for one
}

/// Of a mode that leaves so many components of z open: elimination, in which the numbers grow, then the conditions.
Work ContactSolver::work_of(std::size_t unknowns) const {
  Work work = times(problem_.size() * unknowns, product_work(scaled_->bits * (unknowns + 1)));
  for (std::size_t step = 1; step <= unknowns; ++step) {
    work = plus(work, times(3 * unknowns * (unknowns + 1), product_work(scaled_->bits * step)));
  }
  return work;
}

Work ContactSolver::work_of_all() const {
  const std::size_t n = problem_.size();
  if (modes() == endless) return endless;
  Work work = 0, chosen = 1;  // k of n components: so many modes leave k open, with friction as without
  for (std::size_t k = 0; k <= n; ++k) {
    work = plus(work, times(chosen, work_of(k)));
    if (chosen > endless / 64) return endless;
    chosen = chosen * (n - k) / (k + 1);
  }
  return work;
}

ModeOutcome ContactSolver::solve(const ProblemMode& mode, Effort& effort) const {
  effort.spend(work_of(unknown_count(problem_, mode)));
  const ModeSystem system(*scaled_, mode);
  if (!system.solvable()) return {};
  return system.unique() ? solution_of(system, mode) : narrowed(continuum_of(system, mode, effort), effort);
}

/// The one solution of a mode's equations, if it keeps the conditions.
ModeOutcome ContactSolver::solution_of(const ModeSystem& system, const ProblemMode& mode) const {
  ModeOutcome outcome;
  outcome.kind = ModeOutcome::Kind::solution;
  outcome.strict = true;
  const std::vector<Integer> z = system.scaled_solution();
  for (const ProblemCondition& condition : conditions(problem_, mode)) {
    const RawFraction value = scaled_->condition_value(condition, z, system.pivot());
    if (value.sign() < 0) {
      outcome.kind = ModeOutcome::Kind::violated;
      outcome.condition = condition;
      outcome.margin = Rational(value.numerator, value.denominator);
      return outcome;
    }
    outcome.strict = outcome.strict && value.sign() > 0;
  }
  outcome.z = system.solution();
  return outcome;
}

ContactContinuum ContactSolver::continuum_of(const ModeSystem& system, const ProblemMode& mode, Effort& effort) const {
  // A component of w for each direction; a sum of fractions takes some products.
  constexpr Work products_of_a_sum = 3;
  effort.spend(times(products_of_a_sum * problem_.size() * problem_.size() * (system.free_count() + 1),
                     product_work(scaled_->bits * (system.rank() + 1))));
  ContactContinuum continuum{mode, system.solution(), system.directions(), {}};
  std::vector<std::vector<Rational>> changes;  // of w, by each direction
  for (const auto& direction : continuum.directions) {
    auto change = accelerations(problem_, direction);
    for (std::size_t i = 0; i < change.size(); ++i) change[i] -= problem_.q[i];
    changes.push_back(std::move(change));
  }
  const auto w = accelerations(problem_, continuum.base);
  for (const ProblemCondition& condition : conditions(problem_, mode)) {
    AffineForm form{condition_value(problem_, condition, continuum.base, w), {}};
    for (std::size_t k = 0; k < changes.size(); ++k) {
      form.coefficients.push_back(condition_value(problem_, condition, continuum.directions[k], changes[k]));
    }
    continuum.conditions.push_back(std::move(form));
  }
  return continuum;
}

/// What the conditions leave of the solutions: none, a point, or more.
ModeOutcome ContactSolver::narrowed(ContactContinuum continuum, Effort& effort) const {
  ModeOutcome outcome;
  AffineForm parameter{0, std::vector<Rational>(continuum.directions.size())};
  bool point = true;
  LinearOptimum lowest;
  for (std::size_t k = 0; k < continuum.directions.size() && point; ++k) {
    parameter.coefficients[k] = 1;
    lowest = minimize(parameter, continuum.conditions, effort);
    if (lowest.kind == LinearOptimum::Kind::infeasible) return outcome;
    parameter.coefficients[k] = -1;
    const LinearOptimum highest = minimize(parameter, continuum.conditions, effort);
    parameter.coefficients[k] = 0;
    point = lowest.kind == LinearOptimum::Kind::attained && highest.kind == LinearOptimum::Kind::attained &&
            lowest.value == -highest.value;
  }
  if (point) {
    outcome.kind = ModeOutcome::Kind::solution;
    outcome.z = continuum.at(lowest.x);
  } else {
    outcome.kind = ModeOutcome::Kind::continuum;
    outcome.continuum = std::move(continuum);
  }
  return outcome;
}

std::optional<ContactSolutions> ContactSolver::all(Effort& effort) const {
  if (!effort.allows(work_of_all())) return std::nullopt;
  try {
    return try_all(effort);
  } catch (const TooMuchWork&) {
    return std::nullopt;
  }
}

std::optional<ContactSolutions> ContactSolver::all() const {
  Effort effort(usual_effort);
  return all(effort);
}

ContactSolutions ContactSolver::try_all(Effort& effort) const {
  ContactSolutions found;
  const auto all_states = states(problem_.kind());
  ProblemMode mode(problem_.contacts(), all_states.front());
  bool more = true;
  for (; more; more = advance(mode, all_states)) {
    ModeOutcome outcome = solve(mode, effort);
    if (outcome.kind == ModeOutcome::Kind::continuum) found.continua.push_back(std::move(*outcome.continuum));
    if (outcome.kind != ModeOutcome::Kind::solution) continue;
    const auto same = std::find_if(found.solutions.begin(), found.solutions.end(),
                                   [&](const ContactSolution& s) { return s.z == outcome.z; });
    if (same == found.solutions.end()) {
      auto w = accelerations(problem_, outcome.z);
      found.solutions.push_back({{mode}, outcome.strict, std::move(outcome.z), std::move(w)});
    } else {
      same->modes.push_back(mode);
      same->strict = same->strict || outcome.strict;
    }
  }
  std::erase_if(found.solutions, [&](const ContactSolution& s) {
    return std::any_of(found.continua.begin(), found.continua.end(),
                       [&](const ContactContinuum& c) { return solves(problem_, c.mode, s.z); });
  });
  return found;
}

std::optional<ContactSolution> ContactSolver::only(ProblemMode mode, Effort& effort) const {
  // As integers with one denominator the entries may be longer than those of a row.
  const Work definite = times(work_of(problem_.size()), 4);
  if (problem_.frictional() || !effort.allows(definite) || !positive_definite(problem_.W)) return std::nullopt;
  try {
    while (true) {
      ModeOutcome outcome = solve(mode, effort);
      if (outcome.kind == ModeOutcome::Kind::solution) {
        auto w = accelerations(problem_, outcome.z);
        return ContactSolution{{mode}, outcome.strict, std::move(outcome.z), std::move(w)};
      }
      ContactState& state = mode[outcome.condition->contact];
      state = state == ContactState::lift ? ContactState::touch : ContactState::lift;
    }
  } catch (const TooMuchWork&) {
    return std::nullopt;
  }
}

std::optional<ContactSolution> ContactSolver::only(ProblemMode start) const {
  Effort effort(usual_effort);
  return only(std::move(start), effort);
}

bool positive_definite(const RationalMatrix& W) {
  std::vector<Rational> flat;
  for (const auto& row : W) flat.insert(flat.end(), row.begin(), row.end());
  const Integer common = common_denominator(flat);
  const std::size_t n = W.size();
  IntegerMatrix m(n, std::vector<Integer>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = integer_times(W[i][j] + W[j][i], common);
  }
  // Bareiss without a choice of pivots: they are the leading principal minors.
  Integer previous = 1;
  for (std::size_t k = 0; k < n; ++k) {
    if (m[k][k].sign() <= 0) return false;
    for (std::size_t i = k + 1; i < n; ++i) {
      for (std::size_t j = k + 1; j < n; ++j) m[i][j] = (m[k][k] * m[i][j] - m[i][k] * m[k][j]) / previous;
    }
    previous = m[k][k];
  }
  return true;
}

std::vector<Rational> ContactContinuum::at(const std::vector<Rational>& t) const {
  std::vector<Rational> z = base;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    for (std::size_t i = 0; i < z.size(); ++i) z[i] += t[k] * directions[k][i];
  }
  return z;
}

}  // namespace slipproof
