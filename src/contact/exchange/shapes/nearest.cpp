#include "contact/exchange/shapes/nearest.hpp"

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"

namespace slipproof::imported {

namespace {

struct Difference {
  Near at{}, on_a{}, on_b{};
};

Near weighted(const std::vector<Difference>& simplex, const std::vector<double>& weights, Near Difference::*part) {
  Near sum{};
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += weights[i] * (simplex[i].*part)[k];
  }
  return sum;
}

/// The weights of the point nearest to 0 in the plane through some points, of which the last is taken for the origin of
/// the others: a linear system of at most three equations. Empty if the points do not span it.
std::vector<double> weights_of_nearest(const std::vector<Difference>& points) {
  const std::size_t n = points.size() - 1;
  std::vector<std::vector<double>> rows(n, std::vector<double>(n + 1));
  const Near& origin = points.back().at;
  for (std::size_t i = 0; i < n; ++i) {
    const Near side = minus(points[i].at, origin);
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = dot(side, minus(points[j].at, origin));
    rows[i][n] = -dot(side, origin);
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i) {
      if (std::abs(rows[i][k]) > std::abs(rows[pivot][k])) pivot = i;
    }
    std::swap(rows[k], rows[pivot]);
    if (std::abs(rows[k][k]) < 1e-30) return {};
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::vector<double> weights(n + 1, 1);
  for (std::size_t i = 0; i < n; ++i) {
    weights[i] = rows[i][n] / rows[i][i];
    weights[n] -= weights[i];
  }
  return weights;
}

/// Leaves of a simplex the part that has the point nearest to 0, with its weights.
std::vector<double> shrink(std::vector<Difference>& simplex) {
  std::vector<Difference> best;
  std::vector<double> best_weights;
  double least = INFINITY;
  for (unsigned part = 1; part < 1U << simplex.size(); ++part) {
    std::vector<Difference> some;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      if ((part >> i & 1U) != 0) some.push_back(simplex[i]);
    }
    const std::vector<double> weights = weights_of_nearest(some);
    if (weights.empty() || std::ranges::any_of(weights, [](double w) { return w < 0; })) continue;
    const Near at = weighted(some, weights, &Difference::at);
    if (dot(at, at) < least) least = dot(at, at), best = some, best_weights = weights;
  }
  simplex = best;
  return best_weights;
}

}  // namespace

Near Core::farthest(const Near& direction) const {
  Near best = points.front();
  for (const Near& p : points) {
    if (dot(p, direction) > dot(best, direction)) best = p;
  }
  if (radius == 0) return best;
  const double along = dot(direction, axis);
  Near across{};
  for (std::size_t k = 0; k < 3; ++k) across[k] = direction[k] - along * axis[k];
  const double length = std::sqrt(dot(across, across));
  for (std::size_t k = 0; k < 3; ++k) {
    best[k] += (along > 0 ? half_length : -half_length) * axis[k] + (length > 0 ? radius * across[k] / length : 0);
  }
  return best;
}

Core core_of(const Shape& shape, const Polytope& faces) {
  Core core;
  if (shape.kind == Shape::Kind::box || shape.kind == Shape::Kind::hull) {
    for (const Vector& p : faces.corners) core.points.push_back(near(p));
    return core;
  }
  core.points = {near(shape.pose.at)};
  core.axis = near(shape.pose.turn.axes[2]);
  if (shape.kind == Shape::Kind::cylinder) {
    core.radius = nearest_binary64(shape.radius);
    core.half_length = nearest_binary64(shape.half_length);
  }
  if (shape.kind == Shape::Kind::capsule) {
    core.points.clear();
    for (const int side : {1, -1}) {
      core.points.push_back(near(shape.pose.at + Rational(side) * shape.half_length * shape.pose.turn.axes[2]));
    }
  }
  return core;
}

Nearest nearest_points(const Core& a, const Core& b) {
  std::vector<Difference> simplex;
  const auto extreme = [&](const Near& direction) {
    Difference d;
    d.on_a = a.farthest(direction);
    d.on_b = b.farthest({-direction[0], -direction[1], -direction[2]});
    d.at = minus(d.on_a, d.on_b);
    return d;
  };
  simplex.push_back(extreme({1, 0, 0}));
  std::vector<double> weights{1};
  constexpr int most_steps = 200;
  for (int step = 0; step < most_steps; ++step) {
    const Near v = weighted(simplex, weights, &Difference::at);
    const double square = dot(v, v);
    if (square < 1e-20)
      return {0, weighted(simplex, weights, &Difference::on_a), weighted(simplex, weights, &Difference::on_b)};
    const Difference next = extreme({-v[0], -v[1], -v[2]});
    if (square - dot(v, next.at) <= 1e-13 * square) break;
    if (simplex.size() == 4)
      return {0, weighted(simplex, weights, &Difference::on_a), weighted(simplex, weights, &Difference::on_b)};
    simplex.push_back(next);
    const std::vector<double> found = shrink(simplex);
    if (found.empty()) break;
    weights = found;
  }
  const Near v = weighted(simplex, weights, &Difference::at);
  return {std::sqrt(dot(v, v)), weighted(simplex, weights, &Difference::on_a),
          weighted(simplex, weights, &Difference::on_b)};
}

}  // namespace slipproof::imported
