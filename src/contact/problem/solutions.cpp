#include "contact/problem/solutions.hpp"

#include <algorithm>
#include <stdexcept>

#include "mechanics/kernel/motions.hpp"

namespace slipproof {

namespace {

ContactSolution solution_of(const ContactProblem& problem, std::vector<Rational> z) {
  auto w = accelerations(problem, z);
  return {{}, false, std::move(z), std::move(w)};
}

}  // namespace

ContactSolver::ContactSolver(const ContactProblem& problem)
    : problem_(problem), kernel_problem_(friction_problem(problem)), kernel_(kernel_problem_, std::nullopt) {}

Work ContactSolver::modes() const {
  return problem_.size() < 63 ? Work{1} << problem_.size()
                              : unlimited;  // 4 for two components with friction, 2 for one
}

Work ContactSolver::work_of_all() const {
  const std::size_t n = problem_.size();
  if (modes() == unlimited) return unlimited;
  Work work = 0, chosen = 1;  // k of n components: so many modes leave k open, with friction as without
  for (std::size_t k = 0; k <= n; ++k) {
    work = plus(work, times(chosen, kernel_.work_of(k)));
    if (chosen > unlimited / 64) return unlimited;
    chosen = chosen * (n - k) / (k + 1);
  }
  return work;
}

ModeOutcome ContactSolver::solve(const ProblemMode& mode, Effort& effort) const {
  const ModesOf found = kernel_.one(mode, &effort);
  ModeOutcome outcome;
  if (found.consistent.empty()) {
    const RejectedMode& rejected = found.rejected.front();
    if (!rejected.margin) return outcome;
    outcome.kind = ModeOutcome::Kind::violated;
    outcome.condition = rejected.because.front();
    outcome.margin = *rejected.margin;
    return outcome;
  }
  const ConsistentMode& consistent = found.consistent.front();
  if (consistent.determined) {
    outcome.kind = ModeOutcome::Kind::solution;
    outcome.strict = consistent.solutions.strict;
    outcome.z = at_origin(consistent.solutions.space, kernel_problem_.accelerations);
  } else {
    outcome.kind = ModeOutcome::Kind::continuum;
    outcome.continuum = continuum_of(consistent);
  }
  return outcome;
}

ContactContinuum ContactSolver::continuum_of(const ConsistentMode& found) const {
  const AffineSpace& space = found.solutions.space;
  ContactContinuum continuum{found.mode, at_origin(space, kernel_problem_.accelerations), {}, {}};
  const std::vector<std::size_t> free = space.free_unknowns();
  for (const std::size_t i : free) {
    std::vector<Rational>& direction = continuum.directions.emplace_back();
    for (const AffineForm& z : kernel_problem_.accelerations) direction.push_back(space.on(z).coefficients[i]);
  }
  for (const AffineForm& side : found.solutions.sides) {
    AffineForm& form = continuum.conditions.emplace_back(AffineForm{side.constant, {}});
    for (const std::size_t i : free) form.coefficients.push_back(side.coefficients[i]);
  }
  return continuum;
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
  Effort effort(default_effort);
  return all(effort);
}

ContactSolutions ContactSolver::try_all(Effort& effort) const {
  const std::vector<ConsistentMode> consistent = kernel_.consistent(&effort);
  MergedModes merged = merge(kernel_problem_, consistent, &effort);
  ContactSolutions found;
  for (MergedModes::Motion& motion : merged.motions) {
    if (!motion.within.empty()) continue;
    ContactSolution& solution = found.solutions.emplace_back(solution_of(problem_, std::move(motion.accelerations)));
    for (const std::size_t i : motion.modes) {
      solution.modes.push_back(consistent[i].mode);
      solution.strict = solution.strict || consistent[i].solutions.strict;
    }
  }
  for (const std::size_t i : merged.continua) found.continua.push_back(continuum_of(consistent[i]));
  return found;
}

std::optional<ContactSolution> ContactSolver::unique_solution(ProblemMode mode, Effort& effort) const {
  // As integers with one denominator the entries may be longer than those of a row.
  const Work definite = times(kernel_.work_of(problem_.size()), 4);
  if (problem_.frictional() || !effort.allows(definite) || !positive_definite(problem_.W)) return std::nullopt;
  try {
    while (true) {
      ModeOutcome outcome = solve(mode, effort);
      if (outcome.kind == ModeOutcome::Kind::solution) {
        ContactSolution solution = solution_of(problem_, std::move(outcome.z));
        solution.modes = {mode};
        solution.strict = outcome.strict;
        return solution;
      }
      ElementState& state = mode[outcome.condition->element];
      state = state == ElementState::lift ? ElementState::touch : ElementState::lift;
    }
  } catch (const TooMuchWork&) {
    return std::nullopt;
  }
}

std::optional<ContactSolution> ContactSolver::unique_solution(ProblemMode start) const {
  Effort effort(default_effort);
  return unique_solution(std::move(start), effort);
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
  // The pivots on the diagonal are the leading principal minors.
  for (Integer previous = 1; !m.empty();) {
    if (m[0][0].sign() <= 0) return false;
    IntegerMatrix left = eliminated_once(m, 0, previous);
    previous = std::move(m[0][0]);
    m = std::move(left);
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

std::array<std::vector<Rational>, 2> ContactContinuum::two(Effort& effort) const {
  const std::size_t m = directions.size();
  const AffineForm nothing{0, std::vector<Rational>(m)};
  const std::vector<Rational> first = minimize(nothing, conditions, effort).x;
  for (std::size_t i = 0; i < m; ++i) {
    for (const int side : {1, -1}) {  // up to 1 away in one parameter
      AffineForm back = nothing, near = nothing;
      back.coefficients[i] = -side;
      near.constant = 1 + side * first[i];
      near.coefficients[i] = -side;
      std::vector<AffineForm> within = conditions;
      within.push_back(near);
      const std::vector<Rational> second = minimize(back, within, effort).x;
      if (second[i] != first[i]) return {at(first), at(second)};
    }
  }
  throw std::logic_error("a continuum of one solution");
}

}  // namespace slipproof
