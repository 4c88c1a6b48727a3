#include "contact/ranges/reduced_forces.hpp"

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"
#include "contact/enclosure/sizes.hpp"

namespace slipproof {

using Eigen::Index;

ForceScales ForceScales::of_rows(const std::vector<std::size_t>& rows) const {
  ForceScales own{force, {}, {}};
  for (const std::size_t i : rows) {
    own.change.push_back(change[i]);
    if (i < unknown.size()) own.unknown.push_back(unknown[i]);
  }
  return own;
}

ForceScales force_scales(const MixedProblem& problem, std::span<const double> x, double tolerance) {
  ForceScales scales;
  const double change = tolerance * contact_sizes(problem).velocity;
  for (std::size_t i = problem.free; i < x.size(); ++i) scales.force = std::max(scales.force, std::abs(x[i]));
  const FreeSizes free = free_sizes(problem, scales.force);
  for (std::size_t i = 0; i < problem.free; ++i) {
    scales.unknown.push_back(free.unknowns[i] > 0 ? free.unknowns[i] : 1);
    scales.change.push_back(free.rows[i] > 0 ? tolerance * free.rows[i] : change);
  }
  scales.change.resize(problem.size(), change);
  return scales;
}

std::vector<double> components(std::span<const double> x, const std::vector<std::size_t>& rows) {
  std::vector<double> own;
  for (const std::size_t i : rows) own.push_back(x[i]);
  return own;
}

ReducedForces::ReducedForces(const MixedProblem& problem, const std::vector<ForceSet>& sets,
                             const ForceScales& scales) {
  for (std::size_t j = 0; j < problem.free; ++j) columns_.push_back({{j, scales.unknown[j]}});
  for (std::size_t k = 0; k < sets.size(); ++k) {
    place_.push_back(sets[k].kind == ForceSet::Kind::none ? -1 : size());
    add(sets[k], problem.normal(k), problem.dimension, scales.force);
  }
}

void ReducedForces::add(const ForceSet& set, std::size_t normal, std::size_t dimension, double force) {
  if (set.kind == ForceSet::Kind::none) return;
  const Index first = size();
  if (set.kind == ForceSet::Kind::ray) {
    auto& column = columns_.emplace_back();
    column.emplace_back(normal, force);
    for (std::size_t t = 0; t < set.slip.size(); ++t) {
      column.emplace_back(normal + 1 + t, -force * nearest_binary64(set.mu * set.slip[t]));
    }
  } else {
    for (std::size_t i = 0; i < dimension; ++i) columns_.push_back({{normal + i, force}});
  }
  cones_.push_back({first, size() - first, nearest_binary64(set.mu)});
}

Eigen::SparseMatrix<double> ReducedForces::derivative(const MixedProblem& problem, const ForceScales& scales) const {
  std::vector<std::vector<std::pair<Index, double>>> users(problem.size());  // of each component
  for (Index j = 0; j < size(); ++j) {
    for (const auto& [i, factor] : columns_[static_cast<std::size_t>(j)]) users[i].emplace_back(j, factor);
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    for (std::size_t e = problem.A.starts[i]; e < problem.A.starts[i + 1]; ++e) {
      for (const auto& [j, factor] : users[problem.A.column[e]]) {
        entries.emplace_back(static_cast<int>(i), static_cast<int>(j), problem.A.value[e] * factor / scales.change[i]);
      }
    }
  }
  Eigen::SparseMatrix<double> B(static_cast<Index>(problem.size()), size());
  B.setFromTriplets(entries.begin(), entries.end());
  return B;
}

std::vector<double> ReducedForces::x_of(const Eigen::VectorXd& y, std::size_t components) const {
  std::vector<double> x(components, 0);
  for (Index j = 0; j < size(); ++j) {
    for (const auto& [i, factor] : columns_[static_cast<std::size_t>(j)]) x[i] += factor * y[j];
  }
  return x;
}

Eigen::VectorXd ReducedForces::of(std::span<const double> x) const {
  Eigen::VectorXd y(size());
  for (Index j = 0; j < size(); ++j) {
    const auto& [i, factor] = columns_[static_cast<std::size_t>(j)].front();
    y[j] = x[i] / factor;
  }
  return y;
}

}  // namespace slipproof
