#include "contact/ranges/cone_program.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace slipproof {

namespace {

constexpr int most_steps = 20'000, between_looks = 20;
constexpr double good = 1e-10, useful = 1e-3, far = 1e4;

/// Onto |x_T| <= mu x_N.
void project_on_cone(Eigen::Ref<Eigen::VectorXd> x, double mu) {
  auto tangential = x.tail(x.size() - 1);
  const double length = tangential.norm();
  if (length <= mu * x[0]) return;
  const double normal = std::max((x[0] + mu * length) / (1 + mu * mu), 0.0);
  x[0] = normal;
  tangential *= length > 0 ? mu * normal / length : 0;
}

}  // namespace

ConeProgram::ConeProgram(Eigen::MatrixXd N, Eigen::VectorXd start, std::vector<ForceCone> cones)
    : N_(std::move(N)), start_(std::move(start)), cones_(std::move(cones)) {}

void project_on_cones(const std::vector<ForceCone>& cones, Eigen::VectorXd& x, double margin) {
  for (const ForceCone& cone : cones) {
    x[cone.first] -= margin;
    if (cone.size == 1) {
      x[cone.first] = std::max(x[cone.first], 0.0);
    } else {
      project_on_cone(x.segment(cone.first, cone.size), cone.mu);
    }
    x[cone.first] += margin;
  }
}

std::optional<Eigen::VectorXd> ConeProgram::multipliers(const Eigen::VectorXd& g, Effort& effort) const {
  const Eigen::VectorXd along = N_.transpose() * g;
  const double size = 1 + start_.lpNorm<1>();
  double rho = 1, best = std::numeric_limits<double>::infinity();
  Eigen::VectorXd x = start_, s = start_, before = start_, lambda = Eigen::VectorXd::Zero(start_.size());
  std::optional<Eigen::VectorXd> found;
  project_on_cones(cones_, s);
  for (int i = 1; i <= most_steps; ++i) {
    effort.spend(step());
    x = start_ + N_ * (N_.transpose() * (s - lambda - start_) + along / rho);
    before = s;
    s = x + lambda;
    project_on_cones(cones_, s);
    lambda += x - s;
    if (i % between_looks != 0) continue;
    if (x.lpNorm<1>() > far * size) break;
    // lambda is in the polar cone: z = -rho lambda is in the dual one, whatever else is true.
    const double off = (along - rho * (N_.transpose() * lambda)).lpNorm<Eigen::Infinity>();
    const double bound = off * size - rho * lambda.dot(start_);
    if (off <= useful && bound < best) {
      best = bound;
      found = -rho * lambda;
    }
    const double primal = (x - s).norm(), dual = rho * (s - before).norm();
    if (off <= good && std::max(primal, dual) <= good) break;
    if (i % (5 * between_looks) != 0) continue;
    const double factor = primal > 10 * dual ? 2 : dual > 10 * primal ? 0.5 : 1;
    rho *= factor;
    lambda /= factor;
  }
  return found;
}

}  // namespace slipproof
