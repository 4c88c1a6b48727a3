// One solver of Bullet on one contact problem from a file. Built twice, in single and in double precision.
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btLemkeSolver.h>
#include <BulletDynamics/MLCPSolvers/btSolveProjectedGaussSeidel.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "contact_bounds.hpp"
#include "contact_recorder.hpp"

using namespace slipproof;

namespace {

/// What Bullet is given. As in the engine, no normal force is above 1e10.
struct BulletProblem {
  btMatrixXu A;
  btVectorXu b, lo, hi;
  btAlignedObjectArray<int> depends;

  explicit BulletProblem(const test::BoundedProblem& problem) {
    const int n = static_cast<int>(problem.b.size());
    A.resize(n, n);
    A.setZero();
    problem.each_entry([&](int i, int j, double value) { A.setElem(i, j, static_cast<btScalar>(value)); });
    for (btVectorXu* vector : {&b, &lo, &hi}) vector->resize(n);
    depends.resize(n);
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      b[i] = static_cast<btScalar>(problem.b[k]);
      lo[i] = static_cast<btScalar>(problem.lo[k]);
      hi[i] = static_cast<btScalar>(std::min(problem.hi[k], 1e10));
      depends[i] = problem.depends[k];
    }
  }
};

struct Result {
  bool success = false;
  std::optional<double> error;  ///< what the solver tells of it, if it does
  btVectorXu x;
};

Result solve(const BulletProblem& p, btMLCPSolverInterface& solver, int sweeps) {
  Result result;
  result.x.resize(p.b.rows());
  result.x.setZero();
  result.success = solver.solveMLCP(p.A, p.b, result.x, p.lo, p.hi, p.depends, sweeps);
  return result;
}

Result sweep(const BulletProblem& p, int sweeps) {
  btSolveProjectedGaussSeidel solver;
  Result result = solve(p, solver, sweeps);
  result.error = static_cast<double>(solver.m_leastSquaresResidual);
  return result;
}

/// Lemke's method knows no bounds that depend on forces: those of friction are mu itself.
Result lemke(const BulletProblem& p, bool bounds) {
  btLemkeSolver solver;
  solver.m_useLoHighBounds = bounds;
  return solve(p, solver, 0);
}

/// Dantzig's method fixes the bounds when it comes to the first tangential force. Again and again, each time with the
/// bounds of the last normal forces, until these stay as they are.
Result repeated_dantzig(const BulletProblem& problem) {
  BulletProblem p = problem;
  std::fill_n(&p.depends[0], p.depends.size(), -1);
  btVectorXu x(p.b.rows());
  x.setZero();
  Result result;
  for (int round = 0; round < 1000; ++round) {
    for (int i = 0; i < x.rows(); ++i) {
      if (problem.depends[i] < 0) continue;
      p.hi[i] = problem.hi[i] * std::max(x[problem.depends[i]], btScalar(0));
      p.lo[i] = -p.hi[i];
    }
    btDantzigSolver solver;
    result = solve(p, solver, 0);
    if (!result.success) return result;
    btScalar largest = 0, change = 0;
    for (int i = 0; i < x.rows(); ++i) {
      largest = std::max(largest, btFabs(result.x[i]));
      change = std::max(change, btFabs(result.x[i] - x[i]));
    }
    x = result.x;
    result.error = static_cast<double>(largest > 0 ? change / largest : 0);
    result.success = *result.error <= 100 * static_cast<double>(SIMD_EPSILON);
    if (result.success) return result;
  }
  return result;
}

Result run(const BulletProblem& p, const std::string& solver, const ProblemFile& problem) {
  if (solver == "dantzig") {
    btDantzigSolver dantzig;
    return solve(p, dantzig, 0);
  }
  if (solver == "dantzig-repeated") return repeated_dantzig(p);
  if (solver == "lemke") return lemke(p, problem.dimension > 1);
  return sweep(p, solver == "pgs-10" ? 10 : test::most_sweeps(problem.W.entries(), problem.components()));
}

test::ContactOutcome record(const ProblemFile& problem, const std::string& solver) {
  const test::BoundedProblem bounded(problem);
  const Result result = run(BulletProblem(bounded), solver, problem);
  SolverAnswer answer;
  answer.r = bounded.forces(result.x);
  return {result.success ? 0 : 1, result.error, std::move(answer)};
}

std::vector<test::ContactRun> runs_for(const ProblemFile& problem) {
  std::vector<test::ContactRun> runs;
  if (!test::suits_engines(problem)) return runs;
  const char* precision = sizeof(btScalar) == sizeof(float) ? "single" : "double";
  for (const std::string solver : {"dantzig", "dantzig-repeated", "pgs", "pgs-10", "lemke"}) {
    if (problem.dimension == 1 && solver == "dantzig-repeated") continue;
    runs.push_back({solver, precision, [&problem, solver] { return record(problem, solver); }});
  }
  return runs;
}

}  // namespace

int main(int argc, char** argv) {
  return test::record_contact(argc, argv, runs_for);
}
