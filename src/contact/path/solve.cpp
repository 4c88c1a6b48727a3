#include "contact/path/solve.hpp"

#include <algorithm>
#include <cmath>

#include "base/algebra/union_find.hpp"
#include "base/number/binary64.hpp"
#include "contact/path/follow.hpp"
#include "contact/path/long_box.hpp"

namespace slipproof {

namespace {

/// Free unknowns and contacts that share rows with each other only.
struct Part {
  std::vector<std::size_t> free, contacts;
};

std::vector<Part> parts_of(const MixedProblem& problem) {
  const auto item = [&](std::size_t i) {  // free unknowns, then contacts
    return i < problem.free ? i : problem.free + (i - problem.free) / problem.dimension;
  };
  UnionFind joined(problem.free + problem.contacts());
  for (std::size_t i = 0; i < problem.size(); ++i) {
    for (const std::uint32_t j : problem.A.columns_of(i)) joined.join(item(i), item(j));
  }
  std::vector<Part> by_root(problem.free + problem.contacts());
  for (std::size_t i = 0; i < problem.free; ++i) by_root[joined.find(i)].free.push_back(i);
  for (std::size_t k = 0; k < problem.contacts(); ++k) by_root[joined.find(problem.free + k)].contacts.push_back(k);
  std::erase_if(by_root, [](const Part& p) { return p.free.empty() && p.contacts.empty(); });
  return by_root;
}

/// The rows of a part in the whole problem, in order.
std::vector<std::size_t> rows_of(const MixedProblem& problem, const Part& part) {
  std::vector<std::size_t> rows = part.free;
  for (const std::size_t k : part.contacts) {
    for (std::size_t i = 0; i < problem.dimension; ++i) rows.push_back(problem.normal(k) + i);
  }
  return rows;
}

MixedProblem problem_of(const MixedProblem& problem, const Part& part, const std::vector<std::size_t>& rows) {
  std::vector<std::uint32_t> place(problem.size());
  for (std::size_t i = 0; i < rows.size(); ++i) place[rows[i]] = static_cast<std::uint32_t>(i);
  MixedProblem result;
  result.free = part.free.size();
  result.dimension = problem.dimension;
  result.law.kind = problem.law.kind;
  result.A.rows = result.A.columns = rows.size();
  for (const std::size_t i : rows) {
    for (std::size_t e = problem.A.starts[i]; e < problem.A.starts[i + 1]; ++e) {
      result.A.column.push_back(place[problem.A.column[e]]);
      result.A.value.push_back(problem.A.value[e]);
    }
    result.A.starts.push_back(result.A.value.size());
    result.c.push_back(problem.c[i]);
  }
  for (const std::size_t k : part.contacts) result.mu.push_back(problem.mu[k]);
  return result;
}

PathEnd end_at(const MixedProblem& part, const Enclosure& box) {
  PathEnd end{box.system.mode(), to_rationals(center_of(box)), std::vector<Rational>(part.contacts())};
  for (std::size_t k = 0; k < part.contacts(); ++k) {
    const std::size_t s = box.system.slip(k);
    if (s != ModeSystem::none) end.slip[k] = to_rational(box.center[s]);
  }
  return end;
}

/// By an enclosure in binary64, or along a path.
std::optional<PathEnd> solve_part(const MixedProblem& part, std::span<const double> x, Effort& effort) {
  const auto found = enclose_solution(part, x);
  if (const auto* box = std::get_if<Enclosure>(&found)) return end_at(part, *box);
  if (part.size() > largest_on_path) return std::nullopt;
  return follow_path(part, x, effort);
}

}  // namespace

std::optional<Enclosure> solve_along_path(const MixedProblem& problem, std::span<const double> x, Effort& effort) {
  PathEnd whole{ConeMode(problem.contacts()), std::vector<Rational>(problem.size()),
                std::vector<Rational>(problem.contacts())};
  for (const Part& part : parts_of(problem)) {
    const std::vector<std::size_t> rows = rows_of(problem, part);
    const MixedProblem small = problem_of(problem, part, rows);
    std::vector<double> start;
    for (const std::size_t i : rows) start.push_back(x[i]);
    auto end = solve_part(small, start, effort);
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
    moved.push_back((open ? Rational(0) : box.proof->center[j]) - to_rational(x[i]));
    const bool fixed = open || std::find(box.pinned.begin(), box.pinned.end(), j) != box.pinned.end();
    radius.push_back(fixed ? Rational(0) : to_rational(box.proof->radius[j]));
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
