// One solver of Bullet on one contact problem from a file, each tangential force in a range of its own,
// |r_t| <= mu r_n: a pyramid instead of the cone. Built twice, in single and in double precision.
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btLemkeSolver.h>
#include <BulletDynamics/MLCPSolvers/btSolveProjectedGaussSeidel.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include "contact_answer.hpp"
#include "formats/read_files.hpp"

using namespace slipproof;

namespace {

/// What Bullet is given: A x = b + w, lo <= x <= hi, where the bounds of row i count times x[depends[i]]. As in the
/// engine, all normal forces come first, and none is above 1e10.
struct BoundedProblem {
  btMatrixXu A;
  btVectorXu b, lo, hi;
  btAlignedObjectArray<int> depends;
  std::vector<int> place;  ///< of the problem's components in x

  explicit BoundedProblem(const ProblemFile& problem) {
    const int n = static_cast<int>(problem.components()), dimension = static_cast<int>(problem.dimension);
    const int contacts = static_cast<int>(problem.contacts());
    for (int i = 0; i < n; ++i) {
      const int contact = i / dimension, part = i % dimension;
      place.push_back(part == 0 ? contact : contacts + contact * (dimension - 1) + part - 1);
    }
    A.resize(n, n);
    A.setZero();
    for (btVectorXu* vector : {&b, &lo, &hi}) vector->resize(n);
    depends.resize(n, -1);
    for (std::size_t row = 0; row < place.size(); ++row) {
      const int i = place[row];
      for (std::size_t e = problem.W.starts[row]; e < problem.W.starts[row + 1]; ++e) {
        A.setElem(i, place[problem.W.column[e]], static_cast<btScalar>(problem.W.value[e]));
      }
      const bool normal = i < contacts;
      const std::size_t contact = row / problem.dimension;
      b[i] = static_cast<btScalar>(-problem.q[row]);
      hi[i] = normal ? btScalar(1e10) : static_cast<btScalar>(problem.mu[contact]);
      lo[i] = normal ? 0 : -hi[i];
      if (!normal) depends[i] = static_cast<int>(contact);
    }
  }
};

struct Result {
  bool success = false;
  double error = std::numeric_limits<double>::quiet_NaN();  ///< what the solver tells of it, if it does
  btVectorXu x;
};

Result solve(const BoundedProblem& p, btMLCPSolverInterface& solver, int sweeps) {
  Result result;
  result.x.resize(p.b.rows());
  result.x.setZero();
  result.success = solver.solveMLCP(p.A, p.b, result.x, p.lo, p.hi, p.depends, sweeps);
  return result;
}

/// Enough to converge, and not more than a few seconds of sweeps.
int most_sweeps(const ProblemFile& problem) {
  const auto entries = static_cast<double>(problem.W.entries() + 10 * problem.components());
  return static_cast<int>(std::clamp(2e9 / entries, 100.0, 200'000.0));
}

Result sweep(const BoundedProblem& p, int sweeps) {
  btSolveProjectedGaussSeidel solver;
  Result result = solve(p, solver, sweeps);
  result.error = static_cast<double>(solver.m_leastSquaresResidual);
  return result;
}

/// Lemke's method knows no bounds that depend on forces: those of friction are mu itself.
Result lemke(const BoundedProblem& p, bool bounds) {
  btLemkeSolver solver;
  solver.m_useLoHighBounds = bounds;
  return solve(p, solver, 0);
}

/// Dantzig's method fixes the bounds when it comes to the first tangential force. Again and again, each time with the
/// bounds of the last normal forces, until these stay as they are.
Result repeated_dantzig(const BoundedProblem& problem) {
  BoundedProblem p = problem;
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
    result.success = result.error <= 100 * static_cast<double>(SIMD_EPSILON);
    if (result.success) return result;
  }
  return result;
}

int run(const ProblemFile& problem, const std::string& solver, const char* answer_path) {
  const test::OneLine output;
  const BoundedProblem p(problem);
  Result result;
  const auto start = std::chrono::steady_clock::now();
  if (solver == "dantzig") {
    btDantzigSolver dantzig;
    result = solve(p, dantzig, 0);
  } else if (solver == "dantzig-repeated") {
    result = repeated_dantzig(p);
  } else if (solver == "lemke") {
    result = lemke(p, problem.dimension > 1);
  } else {
    result = sweep(p, solver == "pgs-10" ? 10 : most_sweeps(problem));
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  SolverAnswer answer;
  for (const int i : p.place) answer.r.push_back(static_cast<double>(result.x[i]));
  test::write_answer(answer_path, answer);
  const std::string error = std::isnan(result.error) ? "" : fmt::format("{:.3g}", result.error);
  return output.print(fmt::format("{},{},{:.3f}\n", result.success ? 0 : 1, error, time.count()));
}

}  // namespace

/// With a problem's FILE alone, the solvers for it. With SOLVER ANSWER, runs one, writes its answer into the file
/// ANSWER, and prints `code,error,seconds`.
int main(int argc, char** argv) try {
  if (argc != 2 && argc != 4) {
    fmt::print(stderr, "usage: {} FILE [SOLVER ANSWER]\n", argv[0]);
    return 2;
  }
  const ProblemFile problem = read_problem_file(argv[1]).problem;
  const bool local = problem.form == ProblemForm::local && problem.dimension == 3;
  const bool suits = (local || problem.form == ProblemForm::complementarity) && problem.V.entries() == 0;
  for (const char* solver : {"dantzig", "dantzig-repeated", "pgs", "pgs-10", "lemke"}) {
    if (!suits || (!local && solver == std::string("dantzig-repeated"))) continue;
    if (argc == 2) fmt::print("{}\n", solver);
    if (argc == 4 && argv[2] == std::string(solver)) return run(problem, solver, argv[3]);
  }
  if (argc == 2) return 0;
  fmt::print(stderr, "{}: no solver for {}\n", argv[2], argv[1]);
  return 2;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 2;
}
