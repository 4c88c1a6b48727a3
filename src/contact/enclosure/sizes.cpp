#include "contact/enclosure/sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/number/binary64.hpp"
#include "contact/enclosure/answer.hpp"

namespace slipproof {

namespace {

double least(const Around& x) {
  return std::max(0.0, enclose(abs(x.center)).lower - x.radius);
}

double distance(const Around& x, double from) {
  const Rational apart = abs(to_rational(from) - x.center);
  return apart.is_zero() && x.radius == 0 ? 0 : (enclose(apart).upper + x.radius) * (1 + 0x1p-50);
}

double over(double distance, double size) {
  if (distance == 0) return 0;
  return size > 0 ? distance / size * (1 + 0x1p-50) : std::numeric_limits<double>::infinity();
}

template <class Component, class Velocity>
double error(const MixedProblem& problem, std::span<const double> x, std::span<const double> u,
             const Component& component, const Velocity& velocity) {
  const ContactSizes sizes = contact_sizes(problem);
  double force = 0, moved = 0, speed = sizes.velocity, differs = 0;
  for (std::size_t i = problem.free; i < problem.size(); ++i) {
    const Around r = component(i);
    force = std::max(force, least(r));
    moved = std::max(moved, distance(r, x[i]));
  }
  if (force == 0) force = sizes.force;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const Around w = velocity(problem.free + i);
    speed = std::max(speed, least(w));
    differs = std::max(differs, distance(w, u[i]));
  }
  double result = std::max(over(moved, force), over(differs, speed));
  const FreeSizes free = free_sizes(problem, force);
  for (std::size_t i = 0; i < problem.free; ++i) {
    result = std::max(result, over(distance(component(i), x[i]), free.unknowns[i]));
  }
  return result;
}

/// Calls visit(column, |entry|) for a row's entries that are not 0.
template <class Visit>
void each_size(const MixedProblem& problem, std::size_t row, const Visit& visit) {
  const auto columns = problem.A.columns_of(row);
  const auto values = problem.A.values_of(row);
  for (std::size_t e = 0; e < columns.size(); ++e) {
    if (values[e] != 0) visit(columns[e], std::abs(values[e]));
  }
}

std::vector<double> diagonal_of(const MixedProblem& problem) {
  std::vector<double> diagonal(problem.size(), 0);
  for (std::size_t i = 0; i < problem.size(); ++i) {
    each_size(problem, i, [&](std::size_t j, double a) { diagonal[i] += j == i ? a : 0; });
  }
  return diagonal;
}

}  // namespace

ContactSizes contact_sizes(const MixedProblem& problem) {
  std::vector<double> x(problem.size(), 0), diagonal = diagonal_of(problem);
  complete_free_unknowns(problem, x);
  ContactSizes result;
  for (std::size_t i = problem.free; i < problem.size(); ++i) {
    double W = diagonal[i];  // as the diagonal of the free rows would give it
    each_size(problem, i, [&](std::size_t j, double a) {
      if (j < problem.free && diagonal[j] > 0) W += a * (a / diagonal[j]);
    });
    const double q = std::abs(row_sum(problem, i, x).nearest());
    result.velocity = std::max(result.velocity, q);
    if (W > 0) result.force = std::max(result.force, q / W);
  }
  return result;
}

FreeSizes free_sizes(const MixedProblem& problem, double force) {
  const std::vector<double> diagonal = diagonal_of(problem);
  FreeSizes sizes{std::vector<double>(problem.free, 0), std::vector<double>(problem.free, 0)};
  const auto update_rows = [&] {
    for (std::size_t i = 0; i < problem.free; ++i) {
      double size = std::abs(problem.c[i]);
      each_size(problem, i,
                [&](std::size_t j, double a) { size += a * (j < problem.free ? sizes.unknowns[j] : force); });
      sizes.rows[i] = size;
    }
  };
  // Velocities by their own rows, then the multipliers of constraints by the rows that they are in, and again: a body
  // may be moved by a constraint alone.
  for (int sweep = 0; sweep < 3 && problem.free > 0; ++sweep) {
    update_rows();
    for (std::size_t i = 0; i < problem.free; ++i) {
      if (diagonal[i] > 0) {
        if (sizes.unknowns[i] == 0) sizes.unknowns[i] = sizes.rows[i] / diagonal[i];
        continue;
      }
      each_size(problem, i, [&](std::size_t j, double a) {
        if (j < problem.free) sizes.unknowns[i] = std::max(sizes.unknowns[i], sizes.rows[j] / a);
      });
    }
  }
  update_rows();
  for (auto* list : {&sizes.unknowns, &sizes.rows}) {  // nothing moves it: no unit is known
    const double largest = list->empty() ? 0 : *std::max_element(list->begin(), list->end());
    for (double& size : *list) size = size > 0 ? size : largest;
  }
  return sizes;
}

double error_of(const MixedProblem& problem, std::span<const double> x, std::span<const double> u,
                const Enclosure& solution) {
  const std::vector<double> center = center_of(solution);
  return error(
      problem, x, u,
      [&](std::size_t i) {
        const std::size_t j = solution.system.unknown(i);
        return Around{to_rational(center[i]), j == ModeSystem::none ? 0 : solution.radius[j]};
      },
      [&](std::size_t i) {
        return Around{exact_row(problem, i, center), row_radius(problem, solution, i)};
      });
}

double error_of(const MixedProblem& problem, std::span<const double> x, std::span<const double> u,
                const std::vector<Rational>& solution) {
  return error(
      problem, x, u,
      [&](std::size_t i) {
        return Around{solution[i], 0};
      },
      [&](std::size_t i) {
        return Around{exact_row(problem, i, solution), 0};
      });
}

double error_of(const MixedProblem& problem, std::span<const double> x, std::span<const double> u,
                std::span<const Around> components, std::span<const Around> velocities) {
  return error(
      problem, x, u, [&](std::size_t i) { return components[i]; }, [&](std::size_t i) { return velocities[i]; });
}

}  // namespace slipproof
