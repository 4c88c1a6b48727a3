// One solver of Siconos on one contact problem from a file, at one of three tolerances.
#include <fmt/format.h>
#include <siconos/numerics/FrictionContactProblem.h>
#include <siconos/numerics/Friction_cst.h>
#include <siconos/numerics/GlobalFrictionContactProblem.h>
#include <siconos/numerics/LinearComplementarityProblem.h>
#include <siconos/numerics/NonSmoothDrivers.h>
#include <siconos/numerics/NumericsMatrix.h>
#include <siconos/numerics/SolverOptions.h>
#include <siconos/numerics/lcp_cst.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "contact_recorder.hpp"

using namespace slipproof;

namespace {

struct Solver {
  const char* name;
  int id;
  ProblemForm form;
  std::size_t dimension;
  bool sweeps;  ///< each of its iterations is one pass over all contacts, and it may need many
};

constexpr Solver solvers[] = {
    {"lcp-lemke", SICONOS_LCP_LEMKE, ProblemForm::complementarity, 1, false},
    {"lcp-pivot", SICONOS_LCP_PIVOT, ProblemForm::complementarity, 1, false},
    {"lcp-enum", SICONOS_LCP_ENUM, ProblemForm::complementarity, 1, false},
    {"lcp-pgs", SICONOS_LCP_PGS, ProblemForm::complementarity, 1, true},
    {"lcp-newton-fb", SICONOS_LCP_NEWTON_FB_FBLSA, ProblemForm::complementarity, 1, false},
    {"lcp-newton-min", SICONOS_LCP_NEWTONMIN, ProblemForm::complementarity, 1, false},
    {"fc2d-nsgs", SICONOS_FRICTION_2D_NSGS, ProblemForm::local, 2, true},
    {"fc2d-cpg", SICONOS_FRICTION_2D_CPG, ProblemForm::local, 2, true},
    {"fc2d-lemke", SICONOS_FRICTION_2D_LEMKE, ProblemForm::local, 2, false},
    {"fc2d-enum", SICONOS_FRICTION_2D_ENUM, ProblemForm::local, 2, false},
    {"fc3d-nsgs", SICONOS_FRICTION_3D_NSGS, ProblemForm::local, 3, true},
    {"fc3d-nsn-ac", SICONOS_FRICTION_3D_NSN_AC, ProblemForm::local, 3, false},
    {"fc3d-nsn-fb", SICONOS_FRICTION_3D_NSN_FB, ProblemForm::local, 3, false},
    {"fc3d-tfp", SICONOS_FRICTION_3D_TFP, ProblemForm::local, 3, false},
    {"fc3d-aclmfp", SICONOS_FRICTION_3D_ACLMFP, ProblemForm::local, 3, false},
    {"fc3d-eg", SICONOS_FRICTION_3D_EG, ProblemForm::local, 3, true},
    {"gfc3d-nsgs-wr", SICONOS_GLOBAL_FRICTION_3D_NSGS_WR, ProblemForm::global, 3, true},
    {"gfc3d-nsn-ac", SICONOS_GLOBAL_FRICTION_3D_NSN_AC, ProblemForm::global, 3, false},
    {"gfc3d-nsn-ac-wr", SICONOS_GLOBAL_FRICTION_3D_NSN_AC_WR, ProblemForm::global, 3, false},
    {"gfc3d-admm", SICONOS_GLOBAL_FRICTION_3D_ADMM, ProblemForm::global, 3, true},
};

/// Siconos aborts on problems without contacts, and has no driver for planar ones in the global form. Bilateral rows
/// are not handed to it here.
bool suits(const Solver& solver, const ProblemFile& problem) {
  return solver.dimension == problem.dimension && solver.form == problem.form && problem.contacts() > 0 &&
         problem.V.entries() == 0 && problem.G.entries() == 0;
}

using Matrix = NumericsMatrix*;

Matrix dense(const SparseMatrix& matrix) {
  Matrix result = NM_create(NM_DENSE, static_cast<int>(matrix.rows), static_cast<int>(matrix.columns));
  std::fill_n(result->matrix0, matrix.rows * matrix.columns, 0.0);
  for (std::size_t i = 0; i < matrix.rows; ++i) {
    for (std::size_t e = matrix.starts[i]; e < matrix.starts[i + 1]; ++e) {
      result->matrix0[matrix.column[e] * matrix.rows + i] = matrix.value[e];
    }
  }
  return result;
}

Matrix sparse(const SparseMatrix& matrix) {
  Matrix result = NM_create(NM_SPARSE, static_cast<int>(matrix.rows), static_cast<int>(matrix.columns));
  NM_triplet_alloc(result, static_cast<CS_INT>(matrix.entries()));
  for (std::size_t i = 0; i < matrix.rows; ++i) {
    for (std::size_t e = matrix.starts[i]; e < matrix.starts[i + 1]; ++e) {
      NM_entry(result, static_cast<int>(i), static_cast<int>(matrix.column[e]), matrix.value[e]);
    }
  }
  return result;
}

/// Enough for any of them to converge, and not more than a few seconds of sweeps.
int most_sweeps(const ProblemFile& problem) {
  const auto n = static_cast<double>(problem.components());
  return static_cast<int>(std::clamp(3e9 / (n * n + 300 * n), 100.0, 200'000.0));
}

/// From zero forces; gives Siconos' own word on its success, 0.
int solve(ProblemFile& problem, SolverOptions* options, SolverAnswer& answer) {
  const std::size_t n = problem.components();
  answer.r.assign(n, 0);
  answer.u.assign(n, 0);
  if (problem.form == ProblemForm::complementarity) {
    LinearComplementarityProblem lcp{static_cast<int>(n), dense(problem.W), problem.q.data()};
    return linearComplementarity_driver(&lcp, answer.r.data(), answer.u.data(), options);
  }
  const int dimension = static_cast<int>(problem.dimension), contacts = static_cast<int>(problem.contacts());
  if (problem.form == ProblemForm::local) {
    FrictionContactProblem local{dimension, contacts, dense(problem.W), problem.q.data(), problem.mu.data()};
    const auto driver = dimension == 2 ? fc2d_driver : fc3d_driver;
    return driver(&local, answer.r.data(), answer.u.data(), options);
  }
  answer.v.assign(problem.M.rows, 0);
  GlobalFrictionContactProblem* global = globalFrictionContactProblem_new();
  global->dimension = dimension;
  global->numberOfContacts = contacts;
  global->M = sparse(problem.M);
  global->H = sparse(problem.H);
  global->q = problem.f.data();
  global->b = problem.w.data();
  global->mu = problem.mu.data();
  return gfc3d_driver(global, answer.r.data(), answer.u.data(), answer.v.data(), options);
}

test::ContactOutcome run(ProblemFile& problem, const Solver& solver, double tolerance) {
  test::ContactOutcome outcome;
  SolverOptions* options = solver_options_create(solver.id);
  options->dparam[SICONOS_DPARAM_TOL] = tolerance;
  if (solver.sweeps) options->iparam[SICONOS_IPARAM_MAX_ITER] = most_sweeps(problem);
  outcome.code = solve(problem, options, outcome.answer);
  outcome.error = options->dparam[SICONOS_DPARAM_RESIDU];
  return outcome;
}

std::vector<test::ContactRun> runs_for(ProblemFile& problem) {
  std::vector<test::ContactRun> runs;
  for (const Solver& solver : solvers) {
    if (!suits(solver, problem)) continue;
    for (const char* tolerance : {"1e-4", "1e-8", "1e-14"}) {
      runs.push_back({solver.name, tolerance, [&solver, &problem, tolerance] {
                        return run(problem, solver, std::strtod(tolerance, nullptr));
                      }});
    }
  }
  return runs;
}

}  // namespace

int main(int argc, char** argv) {
  return test::record_contact(argc, argv, runs_for);
}
