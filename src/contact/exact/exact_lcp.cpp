#include "contact/exact/exact_lcp.hpp"

#include "contact/exact/active_sets.hpp"
#include "contact/exact/unique_class.hpp"

namespace slipproof {

namespace {

/// A x + c = 0 in the active rows, for the active components.
struct ActiveSystem {
  ActiveSystem(const MixedProblem& problem, const std::vector<bool>& active) {
    std::vector<std::uint32_t> place(problem.size());
    for (std::size_t i = 0; i < problem.size(); ++i) {
      if (!active[i]) continue;
      place[i] = static_cast<std::uint32_t>(rows.size());
      rows.push_back(i);
      c.push_back(problem.c[i]);
    }
    A.rows = A.columns = rows.size();
    for (const std::size_t i : rows) {
      for (std::size_t k = problem.A.starts[i]; k < problem.A.starts[i + 1]; ++k) {
        if (!active[problem.A.column[k]]) continue;
        A.column.push_back(place[problem.A.column[k]]);
        A.value.push_back(problem.A.value[k]);
      }
      A.starts.push_back(A.value.size());
    }
  }

  std::vector<std::size_t> rows;
  SparseMatrix A;
  std::vector<double> c;
};

/// What a set of active components gives, and the components with a wrong sign.
struct Trial {
  ExactLcpSolution solution;
  std::vector<std::size_t> wrong;
};

/// Nothing where the system is singular.
std::optional<Trial> trial(const MixedProblem& problem, const std::vector<bool>& active, Effort& effort) {
  const ActiveSystem system(problem, active);
  auto in = exact_solution(system.A, system.c, effort);
  if (!in) return std::nullopt;
  Trial result;
  ExactLcpSolution& s = result.solution;
  s.active = active;
  s.x.numerators.resize(problem.size());
  s.x.denominator = std::move(in->denominator);
  for (std::size_t k = 0; k < in->size(); ++k) s.x.numerators[system.rows[k]] = std::move(in->numerators[k]);
  s.w = exact_rows(problem.A, s.x, problem.c);
  for (std::size_t i = 0; i < problem.size(); ++i) {
    if (active[i] && s.w.sign(i) != 0) return std::nullopt;  // no solution of the system
    if (s.x.sign(i) < 0 || s.w.sign(i) < 0) result.wrong.push_back(i);
  }
  return result;
}

/// Principal pivots by exact signs, all at once and then one at a time.
std::optional<ExactLcpSolution> mended(const MixedProblem& problem, std::vector<bool> active, Effort& effort) {
  constexpr int rounds = 12, rounds_at_once = 4;
  for (int round = 0; round < rounds; ++round) {
    auto result = trial(problem, active, effort);
    if (!result) return std::nullopt;
    if (result->wrong.empty()) return std::move(result->solution);
    if (round >= rounds_at_once) result->wrong = {result->wrong.back()};
    for (const std::size_t i : result->wrong) active[i].flip();
  }
  return std::nullopt;
}

}  // namespace

std::optional<ExactLcpSolution> solve_active(const MixedProblem& problem, const std::vector<bool>& active,
                                             Effort& effort) {
  auto result = trial(problem, active, effort);
  if (!result || !result->wrong.empty()) return std::nullopt;
  return std::move(result->solution);
}

std::optional<ExactLcpSolution> solve_lcp(const MixedProblem& problem, std::vector<bool> active, Effort& effort) {
  if (!is_complementarity(problem) || active.size() != problem.size()) return std::nullopt;
  try {
    const auto by_pivots = active_by_pivots(problem, active, effort);
    if (auto solution = mended(problem, by_pivots.value_or(active), effort)) return solution;
    const auto by_lemke = active_by_lemke(problem, effort);
    if (by_lemke) return mended(problem, *by_lemke, effort);
  } catch (const TooMuchWork&) {
  }
  return std::nullopt;
}

}  // namespace slipproof
