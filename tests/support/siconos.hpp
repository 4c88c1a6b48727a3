// The contacts of a scene as problems for Siconos: the LCP with a two-faced friction cone, and the planar frictional
// contact problem.
#pragma once

#include <siconos/numerics/FrictionContactProblem.h>
#include <siconos/numerics/Friction_cst.h>
#include <siconos/numerics/LinearComplementarityProblem.h>
#include <siconos/numerics/NonSmoothDrivers.h>
#include <siconos/numerics/NumericsMatrix.h>
#include <siconos/numerics/SolverOptions.h>
#include <siconos/numerics/lcp_cst.h>

#include <array>
#include <cstdlib>
#include <memory>

#include "base/number/binary64.hpp"
#include "support/bicycle/forced_scene.hpp"
#include "support/scenes/bicycle_scenes.hpp"

namespace slipproof::test {

/// In the default options of a solver.
using SiconosOptions = std::unique_ptr<SolverOptions, decltype(&solver_options_delete)>;
inline SiconosOptions siconos_options(int solver) {
  return {solver_options_create(solver), solver_options_delete};
}

/// Contact accelerations W lambda + q with lambda = (N2, S2, N3, S3), in binary64. The scene has J.
struct ContactProblem {
  explicit ContactProblem(const ForcedScene<double>& s) : f(s.road.f) {
    const auto exact = to_rational(s);
    const auto contacts = contacts_of(exact.bicycle, exact.road, exact.force_kind, exact.F);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) W[i][j] = nearest_binary64(contacts.W[i][j]);
      q[i] = nearest_binary64(contacts.q[i]);
    }
  }
  double W[4][4], q[4], f;
};

/// What a solver gave.
struct SiconosAnswer {
  std::array<double, 4> lambda;
  int info;  ///< the solver's own word on its success: 0
};

/// z = (N, S+, S-, gamma) of each contact; w = (gap, slip + gamma, -slip + gamma, f N - S+ - S-).
class ContactLcp {
 public:
  explicit ContactLcp(const ContactProblem& p) {
    // Contact forces of z: rows N, S of contact j pick columns 4 j, 4 j + 1, 4 j + 2.
    const auto at = [&](int r, int c) -> double& { return M_[c * 8 + r]; };
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
      at(4 * j + 3, 4 * j) = p.f;
      at(4 * j + 3, 4 * j + 1) = at(4 * j + 3, 4 * j + 2) = -1;
      q_[4 * j] = p.q[2 * j];
      q_[4 * j + 1] = p.q[2 * j + 1];
      q_[4 * j + 2] = -p.q[2 * j + 1];
    }
  }

  SiconosAnswer solve(SolverOptions* options) {
    double z[8] = {}, w[8] = {};
    LinearComplementarityProblem lcp;
    lcp.size = 8;
    lcp.M = NM_create_from_data(NM_DENSE, 8, 8, M_);
    lcp.q = q_;
    const int info = linearComplementarity_driver(&lcp, z, w, options);
    std::free(lcp.M);
    return {{z[0], z[1] - z[2], z[4], z[5] - z[6]}, info};
  }

 private:
  double M_[64] = {}, q_[8] = {};
};

class PlanarFriction {
 public:
  explicit PlanarFriction(const ContactProblem& p) : mu_{p.f, p.f} {
    for (int r = 0; r < 4; ++r) {
      q_[r] = p.q[r];
      for (int c = 0; c < 4; ++c) W_[c * 4 + r] = p.W[r][c];
    }
  }

  SiconosAnswer solve(SolverOptions* options) {
    SiconosAnswer answer{};
    double velocity[4] = {};
    FrictionContactProblem contact;
    contact.dimension = 2;
    contact.numberOfContacts = 2;
    contact.M = NM_create_from_data(NM_DENSE, 4, 4, W_);
    contact.q = q_;
    contact.mu = mu_;
    answer.info = fc2d_driver(&contact, answer.lambda.data(), velocity, options);
    std::free(contact.M);
    return answer;
  }

 private:
  double W_[16], q_[4], mu_[2];
};

}  // namespace slipproof::test
