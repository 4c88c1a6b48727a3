// One solver of DART on one contact problem from a file.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <dart/constraint/DantzigBoxedLcpSolver.hpp>
#include <dart/constraint/PgsBoxedLcpSolver.hpp>
#include <string>
#include <vector>

#include "contact_bounds.hpp"
#include "contact_recorder.hpp"

using namespace slipproof;

namespace {

using Solver = dart::constraint::BoxedLcpSolver;
using Sweeps = dart::constraint::PgsBoxedLcpSolver;

/// What DART is given. Solvers write into all of it.
struct DartProblem {
  int n;
  std::vector<double> A, b, lo, hi, x;
  std::vector<int> depends;

  explicit DartProblem(const test::BoundedProblem& problem)
      : n(static_cast<int>(problem.b.size())),
        b(problem.b),
        lo(problem.lo),
        hi(problem.hi),
        x(b.size(), 0),
        depends(problem.depends) {
    const std::size_t row = n > 1 ? (b.size() + 3) / 4 * 4 : b.size();  // as long as DART's own rows are
    A.resize(b.size() * row);
    problem.each_entry([&](int i, int j, double value) {
      A[static_cast<std::size_t>(i) * row + static_cast<std::size_t>(j)] = value;
    });
  }

  bool solve(Solver& solver, bool stop_early) {
    return solver.solve(n, A.data(), x.data(), b.data(), 0, lo.data(), hi.data(), depends.data(), stop_early);
  }
};

test::ContactOutcome solve(const ProblemFile& problem, Solver& solver, bool stop_early = false) {
  const test::BoundedProblem bounded(problem);
  DartProblem p(bounded);
  test::ContactOutcome outcome;
  outcome.code = p.solve(solver, stop_early) ? 0 : 1;
  outcome.answer.r = bounded.forces(p.x);
  return outcome;
}

test::ContactOutcome dantzig(const ProblemFile& problem, bool stop_early) {
  dart::constraint::DantzigBoxedLcpSolver solver;
  return solve(problem, solver, stop_early);
}

test::ContactOutcome sweep(const ProblemFile& problem, const Sweeps::Option& option) {
  Sweeps solver;
  solver.setOption(option);
  return solve(problem, solver);
}

/// As a simulation does, unless it is told otherwise: where Dantzig's method gives up, 30 sweeps from zero forces.
test::ContactOutcome engine(const ProblemFile& problem) {
  test::ContactOutcome first = dantzig(problem, true);
  const auto& r = first.answer.r;
  const bool usable = std::none_of(r.begin(), r.end(), [](double x) { return std::isnan(x); });
  return first.code == 0 && usable ? first : sweep(problem, {});
}

std::vector<test::ContactRun> runs_for(const ProblemFile& problem) {
  if (!test::suits_engines(problem)) return {};
  std::vector<test::ContactRun> runs{{"dantzig", "default", [&] { return dantzig(problem, false); }},
                                     {"engine", "default", [&] { return engine(problem); }},
                                     {"pgs-30", "default", [&] { return sweep(problem, {}); }}};
  const int sweeps = test::most_sweeps(problem.components() * problem.components(), problem.components());
  for (const char* tolerance : {"1e-4", "1e-8", "1e-14"}) {
    runs.push_back({"pgs", tolerance, [&problem, sweeps, tolerance] {
                      const double most = std::strtod(tolerance, nullptr);
                      return sweep(problem, Sweeps::Option(sweeps, most, most));
                    }});
  }
  return runs;
}

}  // namespace

int main(int argc, char** argv) {
  return test::record_contact(argc, argv, runs_for);
}
