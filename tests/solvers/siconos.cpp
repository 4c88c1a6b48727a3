// Several solvers of Siconos on the same scenes: the LCP with a two-faced friction cone, and its planar frictional
// contact solvers.
#include <siconos/numerics/FrictionContactProblem.h>
#include <siconos/numerics/Friction_cst.h>
#include <siconos/numerics/LinearComplementarityProblem.h>
#include <siconos/numerics/NonSmoothDrivers.h>
#include <siconos/numerics/NumericsMatrix.h>
#include <siconos/numerics/SolverOptions.h>
#include <siconos/numerics/lcp_cst.h>

#include "scenes.hpp"

using namespace slipproof;

namespace {

struct Problem {
  double W[4][4];
  double q[4];  ///< contact accelerations without contact forces
};

Problem problem(const ForcedScene<double>& s) {
  const auto exact = to_rational(s);
  const auto form = delassus(exact.bicycle, exact.road, exact.force_kind);
  Problem p{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) p.W[i][j] = nearest_binary64(form->W[i][j]);
    p.q[i] = nearest_binary64(Rational(form->free[i] + form->per_force[i] * exact.F));
  }
  return p;
}

test::SolverAnswer answer(const ForcedScene<double>& s, const double (&lambda)[4], int info) {
  const double external = s.force_kind == ForceKind::external ? s.F : 0;
  return {(lambda[1] + lambda[3] - external) / s.bicycle.M, lambda[1], lambda[3], lambda[0], lambda[2], "", info};
}

/// z = (N, S+, S-, gamma) of each contact; w = (gap, slip + gamma, -slip + gamma, f N - S+ - S-).
test::SolverAnswer solve_lcp(const ForcedScene<double>& s, int solver) {
  const Problem p = problem(s);
  // Contact forces of z: rows N, S of contact j pick columns 4 j, 4 j + 1, 4 j + 2.
  double M[64] = {}, q[8] = {}, z[8] = {}, w[8] = {};
  const auto at = [&](int r, int c) -> double& { return M[c * 8 + r]; };
  for (int j = 0; j < 2; ++j) {
    for (int k = 0; k < 2; ++k) {
      const double NN = p.W[2 * j][2 * k], NS = p.W[2 * j][2 * k + 1], SN = p.W[2 * j + 1][2 * k],
                   SS = p.W[2 * j + 1][2 * k + 1];
      at(4 * j, 4 * k) = NN;
      at(4 * j, 4 * k + 1) = NS;
      at(4 * j, 4 * k + 2) = -NS;
      at(4 * j + 1, 4 * k) = SN;
      at(4 * j + 1, 4 * k + 1) = SS;
      at(4 * j + 1, 4 * k + 2) = -SS;
      at(4 * j + 2, 4 * k) = -SN;
      at(4 * j + 2, 4 * k + 1) = -SS;
      at(4 * j + 2, 4 * k + 2) = SS;
    }
    at(4 * j + 1, 4 * j + 3) = at(4 * j + 2, 4 * j + 3) = 1;
    at(4 * j + 3, 4 * j) = s.road.f;
    at(4 * j + 3, 4 * j + 1) = at(4 * j + 3, 4 * j + 2) = -1;
    q[4 * j] = p.q[2 * j];
    q[4 * j + 1] = p.q[2 * j + 1];
    q[4 * j + 2] = -p.q[2 * j + 1];
  }
  LinearComplementarityProblem lcp;
  lcp.size = 8;
  lcp.M = NM_create_from_data(NM_DENSE, 8, 8, M);
  lcp.q = q;
  SolverOptions* options = solver_options_create(solver);
  const int info = linearComplementarity_driver(&lcp, z, w, options);
  solver_options_delete(options);
  std::free(lcp.M);
  return answer(s, {z[0], z[1] - z[2], z[4], z[5] - z[6]}, info);
}

test::SolverAnswer solve_friction(const ForcedScene<double>& s, int solver) {
  const Problem p = problem(s);
  double W[16], q[4], mu[2] = {s.road.f, s.road.f}, reaction[4] = {}, velocity[4] = {};
  for (int r = 0; r < 4; ++r) {
    q[r] = p.q[r];
    for (int c = 0; c < 4; ++c) W[c * 4 + r] = p.W[r][c];
  }
  FrictionContactProblem contact;
  contact.dimension = 2;
  contact.numberOfContacts = 2;
  contact.M = NM_create_from_data(NM_DENSE, 4, 4, W);
  contact.q = q;
  contact.mu = mu;
  SolverOptions* options = solver_options_create(solver);
  const int info = fc2d_driver(&contact, reaction, velocity, options);
  solver_options_delete(options);
  std::free(contact.M);
  return answer(s, reaction, info);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? argv[1] : ".";
  const std::pair<const char*, int> lcp[] = {{"lcp-enum", SICONOS_LCP_ENUM},
                                             {"lcp-lemke", SICONOS_LCP_LEMKE},
                                             {"lcp-newton-min", SICONOS_LCP_NEWTONMIN},
                                             {"lcp-bard", SICONOS_LCP_BARD},
                                             {"lcp-murty", SICONOS_LCP_MURTY},
                                             {"lcp-pivot", SICONOS_LCP_PIVOT},
                                             {"lcp-newton-fb", SICONOS_LCP_NEWTON_FB_FBLSA}};
  for (const auto& [name, id] : lcp) {
    test::record(folder + "/siconos-" + name + ".csv", [id = id](const auto& s) { return solve_lcp(s, id); });
  }
  const std::pair<const char*, int> friction[] = {{"fc2d-nsgs", SICONOS_FRICTION_2D_NSGS},
                                                  {"fc2d-lemke", SICONOS_FRICTION_2D_LEMKE},
                                                  {"fc2d-enum", SICONOS_FRICTION_2D_ENUM}};
  for (const auto& [name, id] : friction) {
    test::record(folder + "/siconos-" + name + ".csv", [id = id](const auto& s) { return solve_friction(s, id); });
  }
}
