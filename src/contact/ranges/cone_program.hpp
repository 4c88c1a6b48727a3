// Linear programs over cones in floating point: what nothing but the cones bounds.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "base/number/effort.hpp"

namespace slipproof {

/// Components of a product of cones: a half line, or |x_T| <= mu x_N. The others have any sign.
struct ForceCone {
  Eigen::Index first = 0, size = 1;  ///< components of x
  double mu = 0;                     ///< coefficient for more than one component
};

/// Onto the cones with their apex at x_N = margin.
void project_on_cones(const std::vector<ForceCone>& cones, Eigen::VectorXd& x, double margin = 0);

/// The greatest g . x over x = start + N t, t free, with x in a product of cones: half lines, second-order cones
/// |x_T| <= mu x_N, and components of any sign.
class ConeProgram {
 public:
  /// The columns of N are orthonormal.
  ConeProgram(Eigen::MatrixXd N, Eigen::VectorXd start, std::vector<ForceCone> cones);

  /// Multipliers z in the dual cone, so that N^T (g + z) is about 0: then g . x <= g . x0 + z . x0 for every x and x0
  /// of the program. Nothing if there are none that are good enough to be of use, as where it is unbounded. By the
  /// alternating direction method of multipliers; nothing is proved. Throws TooMuchWork.
  std::optional<Eigen::VectorXd> multipliers(const Eigen::VectorXd& g, Effort& effort) const;

 private:
  Work step() const { return 4 * static_cast<Work>(N_.size()) + 30 * static_cast<Work>(start_.size()); }

  Eigen::MatrixXd N_;
  Eigen::VectorXd start_;
  std::vector<ForceCone> cones_;
};

}  // namespace slipproof
