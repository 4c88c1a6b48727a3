#include "contact/enclosure/residual.hpp"

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"
#include "base/parallel/stop.hpp"
#include "contact/enclosure/sizes.hpp"
#include "contact/linear/rounding.hpp"

namespace slipproof {

namespace {

/// What a contact violates, by the way it fits best.
void add_violations(std::vector<Violation>& to, std::size_t k, const FittedContact& c, double scale, FrictionLaw law) {
  const auto [of_motion, of_force] = conditions_of(law, c.fit, c.u.size());
  if (c.change > 0) to.push_back({k, 0, std::string(of_motion), c.change, c.change});
  if (c.moved > 0) to.push_back({k, 0, std::string(of_force), c.moved, c.moved * scale});
}

/// How fast an answer's forces would move its contacts; 1 if there are none.
double velocity_of_forces(const MixedProblem& problem, std::span<const double> x, const std::vector<double>& scales) {
  double largest = 0;
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    for (const double r : x.subspan(problem.normal(k), problem.dimension)) {
      largest = std::max(largest, std::abs(r) * scales[k]);
    }
  }
  return largest > 0 ? largest : 1;
}

}  // namespace

double velocity_error(const MixedProblem& problem, std::span<const Rational> w, std::span<const double> u) {
  double largest = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    largest = std::max(largest, upper_size(to_rational(u[i]) - w[problem.free + i]));
  }
  return largest;
}

std::vector<double> contact_scales(const MixedProblem& problem) {
  std::vector<double> diagonal(problem.free, 0);
  for (std::size_t i = 0; i < problem.free; ++i) {
    const auto columns = problem.A.columns_of(i);
    for (std::size_t e = 0; e < columns.size(); ++e) {
      if (columns[e] == i) diagonal[i] = std::abs(problem.A.values_of(i)[e]);
    }
  }
  std::vector<double> scales;
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    const std::size_t first = problem.normal(k), end = first + problem.dimension;
    double block = 0, through_free = 0;
    for (std::size_t i = first; i < end; ++i) {
      const auto columns = problem.A.columns_of(i);
      const auto values = problem.A.values_of(i);
      double row = 0, other = 0;
      for (std::size_t e = 0; e < columns.size(); ++e) {
        if (columns[e] >= first && columns[e] < end) row += std::abs(values[e]);
        if (columns[e] < problem.free && diagonal[columns[e]] > 0)
          other += values[e] * values[e] / diagonal[columns[e]];
      }
      block = std::max(block, row);
      through_free = std::max(through_free, other);
    }
    const double scale = block + through_free;
    scales.push_back(scale > 0 && std::isfinite(scale) ? scale : 1);
  }
  return scales;
}

Residual residual(const MixedProblem& problem, std::span<const double> x, std::span<const Rational> w,
                  const ContactLaw& law) {
  Residual result;
  const std::size_t d = problem.dimension;
  const std::vector<double> scales = contact_scales(problem);
  const ContactSizes sizes = contact_sizes(problem);
  const FreeSizes free = free_sizes(problem, sizes.force);
  result.scale = sizes.velocity > 0 ? sizes.velocity : velocity_of_forces(problem, x, scales);
  std::vector<double> moved(problem.size(), 0), change(problem.size(), 0);
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    stop_if_asked();
    const std::size_t first = problem.normal(k);
    const std::size_t own = bounds_of_contact(law.kind, d);
    const std::span<const double> bounds =
        law.bounds.empty() ? law.bounds : std::span(law.bounds).subspan(own * k, own);
    result.contacts.push_back(
        fit_contact(law, {problem.mu[k], scales[k], x.subspan(first, d), w.subspan(first, d), bounds}));
    const FittedContact& c = result.contacts.back();
    for (std::size_t i = 0; i < d; ++i) {
      moved[first + i] = c.moved;
      change[first + i] = c.change;
    }
    add_violations(result.worst, k, c, scales[k], law.kind);
    result.moved = std::max(result.moved, c.moved);
  }
  for (std::size_t i = 0; i < problem.free; ++i) {
    change[i] = upper_size(w[i]);
    const double effect = change[i] * (free.rows[i] > 0 ? result.scale / free.rows[i] : 1);
    if (change[i] > 0) result.worst.push_back({std::nullopt, i, "equation", change[i], effect});
  }
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const auto columns = problem.A.columns_of(i);
    const auto values = problem.A.values_of(i);
    double sum = change[i];
    for (std::size_t e = 0; e < columns.size(); ++e) sum += std::abs(values[e]) * moved[columns[e]];
    if (sum > 0) sum = rounded_up(sum, columns.size()) + underflow_of(columns.size());
    result.change = std::max(result.change, sum);
    const double size = i < problem.free ? free.rows[i] : result.scale;
    if (sum > 0) result.relative = std::max(result.relative, sum / size);
  }
  std::stable_sort(result.worst.begin(), result.worst.end(),
                   [](const Violation& a, const Violation& b) { return a.effect > b.effect; });
  if (result.worst.size() > 10) result.worst.resize(10);
  return result;
}

}  // namespace slipproof
