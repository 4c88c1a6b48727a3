// Newton's method for all contacts at once.
#pragma once

#include <Eigen/Core>

#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// Coulomb's law as equations, after Alart and Curnier 1991: with z = r - h u of each contact, h > 0,
///   z_N <= 0: r = 0;   |z_T| <= mu z_N: u = 0;   otherwise: u_N = 0, r_T = mu z_N z_T/|z_T|.
/// They hold exactly at solutions, and have a derivative but for borders between modes. Where forces are redundant the
/// derivative is singular up to rounding; something is added to its diagonal, in other sizes in other attempts. A step
/// is halved while the equations get worse. Cubic in the size.
class ContactNewton {
 public:
  /// The problem has no free unknowns, has Coulomb's law, and must outlive this.
  explicit ContactNewton(const MixedProblem& problem);

  /// Improves r if it can; true if the equations hold up to rounding.
  bool solve(Eigen::VectorXd& r, int attempt) const;

 private:
  double error(const Eigen::VectorXd& r, Eigen::VectorXd& equations) const;
  Eigen::VectorXd step(const Eigen::VectorXd& r, const Eigen::VectorXd& equations, double added) const;

  const MixedProblem& problem_;
  Eigen::MatrixXd W_;
  Eigen::VectorXd q_;
  std::vector<double> h_;
};

}  // namespace slipproof
