#include "contact/path/solve.hpp"

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"
#include "contact/enclosure/sizes.hpp"
#include "contact/path/follow.hpp"
#include "contact/path/long_box.hpp"
#include "contact/problem/parts.hpp"
#include "contact/problem/tolerance.hpp"

namespace slipproof {

namespace {

PathEnd end_at(const MixedProblem& part, const Enclosure& box) {
  const auto center = [&](std::size_t unknown) {
    if (unknown == ModeSystem::none) return Rational(0);
    return box.proof ? box.proof->center[unknown] : to_rational(box.center[unknown]);
  };
  PathEnd end{box.system.mode(), {}, {}};
  for (std::size_t i = 0; i < part.size(); ++i) end.x.push_back(center(box.system.unknown(i)));
  for (std::size_t k = 0; k < part.contacts(); ++k) end.slip.push_back(center(box.system.slip(k)));
  return end;
}

/// Whether contacts have the same velocities, as two answers' forces give them.
bool have_same_velocities(const MixedProblem& problem, std::span<const double> x, std::span<const double> y) {
  const double near = contact_tolerance * contact_sizes(problem).velocity;
  for (std::size_t i = problem.free; i < problem.size(); ++i) {
    double moved = 0;
    for (std::size_t e = problem.A.starts[i]; e < problem.A.starts[i + 1]; ++e) {
      moved += problem.A.value[e] * (y[problem.A.column[e]] - x[problem.A.column[e]]);
    }
    if (!(std::abs(moved) <= near)) return false;
  }
  return true;
}

/// By an enclosure in binary64.
std::optional<PathEnd> enclose_part(const MixedProblem& part, std::span<const double> x) {
  const auto found = enclose_solution(part, x);
  const auto* box = std::get_if<Enclosure>(&found);
  return box != nullptr ? std::optional(end_at(part, *box)) : std::nullopt;
}

/// Along a path.
std::optional<PathEnd> follow_part(const MixedProblem& part, std::span<const double> x, Effort& effort,
                                   const OtherAnswers& elsewhere) {
  if (part.size() > largest_on_path) return std::nullopt;
  auto end = follow_path(part, x, effort);
  if (!elsewhere) return end;
  for (int i = 0;; ++i) {
    const auto box = end ? enclose_in_long_numbers(part, *std::move(end), effort) : std::nullopt;
    if (box) return end_at(part, *box);
    const std::vector<double> other = elsewhere(part, i);
    if (other.empty()) return std::nullopt;
    end.reset();
    if (have_same_velocities(part, x, other)) end = follow_path(part, other, effort);
  }
}

}  // namespace

std::optional<Enclosure> solve_along_path(const MixedProblem& problem, std::span<const double> x, Effort& effort,
                                          const OtherAnswers& elsewhere) {
  PathEnd whole{ConeMode(problem.contacts()), std::vector<Rational>(problem.size()),
                std::vector<Rational>(problem.contacts())};
  const std::vector<ContactPart> parts = parts_of(problem);
  for (const ContactPart& part : parts) {
    const std::vector<std::size_t> rows = rows_of(problem, part);
    const MixedProblem small = part_of(problem, part, rows);
    std::vector<double> start;
    for (const std::size_t i : rows) start.push_back(x[i]);
    auto end = parts.size() > 1 ? enclose_part(small, start) : std::nullopt;
    if (!end) end = follow_part(small, start, effort, elsewhere);
    if (!end) return std::nullopt;
    for (std::size_t i = 0; i < rows.size(); ++i) whole.x[rows[i]] = std::move(end->x[i]);
    for (std::size_t k = 0; k < part.contacts.size(); ++k) {
      whole.mode[part.contacts[k]] = end->mode[k];
      whole.slip[part.contacts[k]] = std::move(end->slip[k]);
    }
  }
  return enclose_in_long_numbers(problem, whole, effort);
}

double velocity_distance(const MixedProblem& problem, const Enclosure& box, std::span<const double> x) {
  std::vector<Rational> moved;  // each component, from x
  std::vector<Rational> radius;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t j = box.system.unknown(i);
    const bool open = j == ModeSystem::none;
    const Rational center = open ? Rational(0) : box.proof ? box.proof->center[j] : to_rational(box.center[j]);
    moved.push_back(center - to_rational(x[i]));
    const bool fixed = open || std::find(box.pinned.begin(), box.pinned.end(), j) != box.pinned.end();
    radius.push_back(fixed ? Rational(0) : to_rational(box.proof ? box.proof->radius[j] : box.radius[j]));
  }
  Rational largest = 0;
  for (std::size_t i = problem.free; i < problem.size(); ++i) {
    Rational center = 0, around = 0;
    const auto columns = problem.A.columns_of(i);
    for (std::size_t e = 0; e < columns.size(); ++e) {
      const Rational a = to_rational(problem.A.values_of(i)[e]);
      center += a * moved[columns[e]];
      around += abs(a) * radius[columns[e]];
    }
    largest = std::max(largest, Rational(abs(center) + around));
  }
  return enclose(largest).upper;
}

std::vector<double> force_distances(const MixedProblem& problem, const Enclosure& box, std::span<const double> x) {
  const std::vector<double> r = center_of(box);
  std::vector<double> distances(problem.contacts(), 0);
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    for (std::size_t i = problem.normal(k); i < problem.normal(k) + problem.dimension; ++i) {
      distances[k] = std::max(distances[k], std::abs(r[i] - x[i]));
    }
  }
  return distances;
}

}  // namespace slipproof
