#include "contact/problem/every_load.hpp"

#include <algorithm>
#include <array>

#include "contact/problem/solutions.hpp"

namespace slipproof {

namespace {

/// The equations of a mode over z, without their constants.
RationalMatrix mode_matrix(const ContactProblem& p, const ProblemMode& mode) {
  RationalMatrix matrix = p.W;
  const auto unit = [&](std::size_t i) { matrix[i].assign(p.size(), 0), matrix[i][i] = 1; };
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const std::size_t normal = p.frictional() ? 2 * i : i;
    if (mode[i] == ElementState::lift) unit(normal);
    if (!p.frictional() || mode[i] == ElementState::stick) continue;
    unit(normal + 1);
    if (mode[i] != ElementState::lift) matrix[normal + 1][normal] = p.mu[i] * slip_direction(mode[i]);
  }
  return matrix;
}

/// The modes in their order; nothing beyond the last.
class ModeCounter {
 public:
  explicit ModeCounter(const ContactProblem& p)
      : states_(states(p.kind())), digits_(p.contacts()), mode_(p.contacts(), states_.front()) {}
  const ProblemMode& mode() const { return mode_; }
  bool next() {
    for (std::size_t i = mode_.size(); i-- > 0;) {
      digits_[i] = (digits_[i] + 1) % states_.size();
      mode_[i] = states_[digits_[i]];
      if (digits_[i] != 0) return true;
    }
    return false;
  }

 private:
  std::vector<ElementState> states_;
  std::vector<std::size_t> digits_;
  ProblemMode mode_;
};

/// Without friction nothing sticks strictly: such modes are borders of others.
bool has_inside(const ContactProblem& p, const ProblemMode& mode) {
  for (std::size_t i = 0; i < mode.size(); ++i) {
    if (mode[i] == ElementState::stick && p.mu[i].is_zero()) return false;
  }
  return true;
}

EveryLoad by_determinants(const ContactProblem& problem, const ContactSolver& solver, Effort& effort) {
  const Work each = std::max<Work>(1, solver.work_of_all() / std::max<Work>(1, solver.modes()));
  ModeCounter modes(problem);
  do {
    if (!has_inside(problem, modes.mode())) continue;
    effort.spend(each);
    Rational determinant = mode_determinant(problem, modes.mode());
    if (determinant.sign() > 0) continue;
    return {EveryLoad::Verdict::not_unique, EveryLoad::Reason::determinants, modes.mode(), std::move(determinant)};
  } while (modes.next());
  return {EveryLoad::Verdict::unique, EveryLoad::Reason::determinants};
}

}  // namespace

std::string_view name(EveryLoad::Verdict verdict) {
  constexpr std::array<std::string_view, 4> names{"unique", "at most one", "not unique", "undecided"};
  return names[static_cast<std::size_t>(verdict)];
}

std::string_view name(EveryLoad::Reason reason) {
  constexpr std::array<std::string_view, 6> names{"mode determinants", "bound on mu",
                                                  "positive definite", "matrix not positive definite",
                                                  "too many modes",    "pairs of modes"};
  return names[static_cast<std::size_t>(reason)];
}

Rational mode_determinant(const ContactProblem& problem, const ProblemMode& mode) {
  return determinant(mode_matrix(problem, mode));
}

bool is_unique_by_bound(const ContactProblem& problem) {
  if (!problem.frictional()) return false;
  RationalMatrix lowered = problem.W;
  for (std::size_t i = 0; i < problem.mu.size(); ++i) {
    const std::size_t normal = 2 * i, tangent = normal + 1;
    const Rational half_mu = problem.mu[i] / 2;
    for (std::size_t j = 0; j < problem.size(); ++j) {
      const Rational &a = problem.W[j][tangent], &b = problem.W[tangent][j];
      const Rational skew = half_mu * abs(Rational(a - b));
      lowered[j][j] -= skew;
      lowered[normal][normal] -= skew;
      if (j % 2 == 1) lowered[normal][normal] -= problem.mu[i] * half_mu * abs(Rational(a + b));
    }
  }
  return positive_definite(lowered);
}

EveryLoad for_every_load(const ContactProblem& problem, Effort& effort) {
  const ContactSolver solver(problem);
  const bool few_enough = effort.allows(solver.work_of_all());
  if (!problem.frictional()) {
    if (few_enough) return by_determinants(problem, solver, effort);
    if (positive_definite(problem.W)) return {EveryLoad::Verdict::unique, EveryLoad::Reason::definite};
    return {};
  }
  if (!positive_definite(problem.W)) {
    return {EveryLoad::Verdict::undecided, EveryLoad::Reason::no_theorem};
  }
  if (few_enough) return by_determinants(problem, solver, effort);
  if (is_unique_by_bound(problem)) return {EveryLoad::Verdict::unique, EveryLoad::Reason::bound};
  return {};
}

EveryLoad for_every_load(const ContactProblem& problem) {
  Effort effort(ContactSolver::default_effort);
  return for_every_load(problem, effort);
}

}  // namespace slipproof
