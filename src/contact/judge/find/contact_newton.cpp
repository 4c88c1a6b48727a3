#include "contact/judge/find/contact_newton.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>

#include "base/parallel/stop.hpp"

namespace slipproof {

namespace {

using Index = Eigen::Index;

/// A contact's z = r - h u, and what that makes of it.
struct ContactTrial {
  double normal, length, bound;
  Eigen::VectorXd direction;  ///< of z_T, where it slips

  ContactTrial(const Eigen::VectorXd& r, const Eigen::VectorXd& u, Index first, Index size, double h, double mu)
      : normal(r[first] - h * u[first]), bound(mu * normal) {
    direction = r.segment(first + 1, size - 1) - h * u.segment(first + 1, size - 1);
    length = direction.norm();
    if (length > 0) direction /= length;
  }
  bool open() const { return normal <= 0; }
  bool sticks() const { return length <= bound; }
};

}  // namespace

ContactNewton::ContactNewton(const MixedProblem& problem)
    : problem_(problem),
      W_(Eigen::MatrixXd::Zero(static_cast<Index>(problem.size()), static_cast<Index>(problem.size()))),
      q_(Eigen::Map<const Eigen::VectorXd>(problem.c.data(), static_cast<Index>(problem.size()))) {
  for (std::size_t i = 0; i < problem.size(); ++i) {
    for (std::size_t e = problem.A.starts[i]; e < problem.A.starts[i + 1]; ++e) {
      W_(static_cast<Index>(i), static_cast<Index>(problem.A.column[e])) += problem.A.value[e];
    }
  }
  const auto size = static_cast<Index>(problem.dimension);
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    const double trace = W_.block(static_cast<Index>(k) * size, static_cast<Index>(k) * size, size, size).trace();
    h_.push_back(trace > 0 ? static_cast<double>(size) / trace : 1);
  }
}

double ContactNewton::error(const Eigen::VectorXd& r, Eigen::VectorXd& equations) const {
  const Eigen::VectorXd u = W_ * r + q_;
  const auto size = static_cast<Index>(problem_.dimension);
  equations = u;
  for (std::size_t k = 0; k < h_.size(); ++k) {
    const Index first = static_cast<Index>(k) * size;
    const ContactTrial z(r, u, first, size, h_[k], problem_.mu[k]);
    if (z.open()) {
      equations.segment(first, size) = r.segment(first, size) / h_[k];
    } else if (!z.sticks()) {
      equations.segment(first + 1, size - 1) = (r.segment(first + 1, size - 1) - z.bound * z.direction) / h_[k];
    }
  }
  return equations.norm();
}

Eigen::VectorXd ContactNewton::step(const Eigen::VectorXd& r, const Eigen::VectorXd& equations, double added) const {
  const Eigen::VectorXd u = W_ * r + q_;
  const auto size = static_cast<Index>(problem_.dimension);
  Eigen::MatrixXd J = W_;
  for (std::size_t k = 0; k < h_.size(); ++k) {
    const Index first = static_cast<Index>(k) * size, tangents = size - 1;
    const double mu = problem_.mu[k], h = h_[k];
    const ContactTrial z(r, u, first, size, h, mu);
    if (z.open()) {
      J.middleRows(first, size).setZero();
      J.block(first, first, size, size).diagonal().setConstant(1 / h);
    } else if (!z.sticks()) {  // z_T/|z_T| turns by across * dz_T
      Eigen::MatrixXd across = Eigen::MatrixXd::Identity(tangents, tangents) - z.direction * z.direction.transpose();
      across *= z.bound / z.length;
      J.middleRows(first + 1, tangents) =
          across * W_.middleRows(first + 1, tangents) + mu * z.direction * W_.row(first);
      J.block(first + 1, first + 1, tangents, tangents) += (Eigen::MatrixXd::Identity(tangents, tangents) - across) / h;
      J.block(first + 1, first, tangents, 1) -= mu * z.direction / h;
    }
    for (Index i = first; i < first + size; ++i) J(i, i) += added / h;
  }
  return J.partialPivLu().solve(equations);
}

bool ContactNewton::solve(Eigen::VectorXd& r, int attempt) const {
  constexpr std::array added{1e-6, 1e-10, 1e-8};
  constexpr int most_steps = 12, patience = 4;
  const double enough = 1e-14 * q_.norm();
  Eigen::VectorXd x = r, equations, trial;
  double now = error(x, equations), least = now;
  for (int i = 0, worse = 0; i < most_steps && worse < patience && least > enough; ++i) {
    stop_if_asked();
    const Eigen::VectorXd full = step(x, equations, added[static_cast<std::size_t>(attempt) % added.size()]);
    if (!full.allFinite()) break;
    double part = 1, reached = 0;
    Eigen::VectorXd next;  // the last that is tried, with its equations in `trial`
    for (int halving = 0; halving < 6; ++halving, part /= 2) {
      next = x - part * full;
      reached = error(next, trial);
      if (reached < now) break;
    }
    x.swap(next);
    equations.swap(trial);
    now = reached;
    worse = now < least ? 0 : worse + 1;
    if (now < least) least = now, r = x;
  }
  return least <= enough;
}

}  // namespace slipproof
