// Forces and free unknowns in the numbers in which everything is about 1.
#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <utility>
#include <vector>

#include "contact/problem/mixed_problem.hpp"
#include "contact/ranges/cone_program.hpp"
#include "contact/ranges/force_set.hpp"

namespace slipproof {

/// What components of x and of A x + c are compared with.
struct ForceScales {
  double force = 0;             ///< the largest of the answer
  std::vector<double> unknown;  ///< of free unknowns
  std::vector<double> change;   ///< that rows of A x + c may have

  /// Of a part, whose free rows come first, as in the whole.
  ForceScales of_rows(const std::vector<std::size_t>& rows) const;
};

/// Velocities and sums of free rows may change by `tolerance` times the size of their kind.
ForceScales force_scales(const MixedProblem& problem, std::span<const double> x, double tolerance);

/// These components of x.
std::vector<double> components(std::span<const double> x, const std::vector<std::size_t>& rows);

/// x = unknown y: free unknowns, rays of forces as one number, cones. Forces of contacts that open are no unknowns.
class ReducedForces {
 public:
  ReducedForces(const MixedProblem& problem, const std::vector<ForceSet>& sets, const ForceScales& scales);

  Eigen::Index size() const { return static_cast<Eigen::Index>(columns_.size()); }
  const std::vector<ForceCone>& cones() const { return cones_; }
  /// Of a contact's normal force; negative if it is open.
  Eigen::Index normal(std::size_t contact) const { return place_[contact]; }

  /// What rows change with y, over what they may.
  Eigen::SparseMatrix<double> derivative(const MixedProblem& problem, const ForceScales& scales) const;

  /// x of y: components that are no unknown are 0.
  std::vector<double> x_of(const Eigen::VectorXd& y, std::size_t components) const;
  Eigen::VectorXd of(std::span<const double> x) const;

 private:
  void add(const ForceSet& set, std::size_t normal, std::size_t dimension, double force);

  std::vector<std::vector<std::pair<std::size_t, double>>> columns_;
  std::vector<Eigen::Index> place_;
  std::vector<ForceCone> cones_;
};

}  // namespace slipproof
