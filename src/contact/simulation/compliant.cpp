#include "contact/simulation/compliant.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace slipproof {

namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Of the vibrations of contacts that all stick.
struct Frequencies {
  double slowest, fastest;
};

Frequencies frequencies(const RowMatrix& W, const Eigen::VectorXd& stiffness) {
  const Eigen::VectorXd root = stiffness.cwiseSqrt();
  const Eigen::MatrixXd scaled = root.asDiagonal() * W * root.asDiagonal();
  const Eigen::VectorXd squares = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues();
  const double fastest = squares.maxCoeff();
  double slowest = fastest;
  // More contacts than bodies can move make zeros, which are rounded.
  for (const double square : squares) {
    if (square > 1e-10 * fastest) slowest = std::min(slowest, square);
  }
  if (!(fastest > 0) || fastest > 1e8 * slowest) {
    throw std::invalid_argument("found elastic vibrations that are too far apart, expected frequencies within 10^4");
  }
  return {std::sqrt(slowest), std::sqrt(fastest)};
}

/// Normal stiffness 1, tangential stiffness r.
Eigen::VectorXd stiffnesses(std::size_t n, double ratio) {
  Eigen::VectorXd stiffness(static_cast<Eigen::Index>(n));
  for (Eigen::Index i = 0; i < stiffness.size(); ++i) stiffness[i] = i % 2 == 0 ? 1 : ratio;
  return stiffness;
}

}  // namespace

CompliantMotion::CompliantMotion(const LoadedContacts& contacts, const Compliance& compliance, double step)
    : n_(contacts.problem.size()),
      rest_(rounded(contacts.rest)),
      push_(rounded(contacts.problem.q)),
      mu_(rounded(contacts.problem.mu)),
      ratio_(compliance.stiffness_ratio),
      velocity_(n_),
      acceleration_(n_),
      forces_(n_),
      mode_(mu_.size()) {
  for (const auto& row : contacts.problem.W) {
    const std::vector<double> entries = rounded(row);
    W_.insert(W_.end(), entries.begin(), entries.end());
  }
  for (std::size_t i = 0; i < n_; ++i) push_[i] -= rest_[i];
  for (std::size_t i = 0; i < n_; i += 2) {
    const auto damping = [&](std::size_t k, double stiffness) {
      const double mobility = W_[k * n_ + k];
      return mobility > 0 ? 2 * compliance.damping * std::sqrt(stiffness / mobility) : 0;
    };
    normal_damping_.push_back(damping(i, 1));
    tangent_damping_.push_back(damping(i + 1, ratio_));
  }
  const auto size = static_cast<Eigen::Index>(n_);
  const auto [slowest, fastest] =
      frequencies(Eigen::Map<const RowMatrix>(W_.data(), size, size), stiffnesses(n_, ratio_));
  dt_ = step / fastest;
  period_ = 2 * std::numbers::pi / slowest;
  rise_ = compliance.rise * period_;
  find_rest(rest_);
  find_forces();
  accelerate(0);
}

/// What bodies can reach is u = W y, and the springs carry q where W K u = q.
void CompliantMotion::find_rest(const std::vector<double>& q) {
  const auto size = static_cast<Eigen::Index>(n_);
  const Eigen::Map<const RowMatrix> W(W_.data(), size, size);
  const Eigen::Map<const Eigen::VectorXd> push(q.data(), size);
  const Eigen::VectorXd stiffness = stiffnesses(n_, ratio_);
  const Eigen::MatrixXd carried = W * stiffness.asDiagonal() * W;
  const Eigen::VectorXd u = W * carried.completeOrthogonalDecomposition().solve(push);
  const Eigen::VectorXd force = -stiffness.cwiseProduct(u);
  bool holds = (W * force + push).norm() <= 1e-6 * push.norm();
  const double small = 1e-9 * force.norm();
  for (Eigen::Index i = 0; i < size; i += 2) {
    holds = holds && force[i] >= -small &&
            std::abs(force[i + 1]) <= mu_[static_cast<std::size_t>(i / 2)] * force[i] + small;
  }
  if (!holds) {
    throw std::invalid_argument("found bodies that do not stay at rest without the load, expected a scene at rest");
  }
  displacement_.assign(u.data(), u.data() + size);
  for (std::size_t i = 1; i < n_; i += 2) bristles_.push_back(displacement_[i]);
}

/// Leapfrog: velocities are those half a step before, and the bristles go along.
void CompliantMotion::find_forces() {
  for (std::size_t i = 0; i < mu_.size(); ++i) {
    const double gap = displacement_[2 * i], slip = velocity_[2 * i + 1], c = tangent_damping_[i];
    const double N = gap < 0 ? std::max(0.0, -gap - normal_damping_[i] * velocity_[2 * i]) : 0;
    const double limit = mu_[i] * N, held = -ratio_ * bristles_[i] - (ratio_ * dt_ + c) * slip;
    const double T = std::clamp(held, -limit, limit);
    bristles_[i] -= dt_ * (T + ratio_ * bristles_[i]) / (ratio_ * dt_ + c);
    forces_[2 * i] = N, forces_[2 * i + 1] = T;
    mode_[i] = N == 0      ? ElementState::lift
               : T == held ? ElementState::stick
               : T < 0     ? ElementState::slip_forward
                           : ElementState::slip_backward;
  }
}

void CompliantMotion::accelerate(double time) {
  const double share = time >= rise_ ? 1 : time / rise_;
  for (std::size_t i = 0; i < n_; ++i) {
    double sum = rest_[i] + share * push_[i];
    for (std::size_t j = 0; j < n_; ++j) sum += W_[i * n_ + j] * forces_[j];
    acceleration_[i] = sum;
  }
}

void CompliantMotion::advance() {
  for (std::size_t i = 0; i < n_; ++i) {
    velocity_[i] += dt_ / 2 * acceleration_[i];
    displacement_[i] += dt_ * velocity_[i];
  }
  time_ += dt_;
  find_forces();
  accelerate(time_);
  for (std::size_t i = 0; i < n_; ++i) velocity_[i] += dt_ / 2 * acceleration_[i];
}

}  // namespace slipproof
