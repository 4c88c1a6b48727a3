#include "mechanism/checks.hpp"

#include <algorithm>
#include <iterator>

#include "mechanism/free_motion.hpp"
#include "mechanism/sampling.hpp"
#include "number/format.hpp"

namespace slipproof {

namespace {

using namespace mechanism_checks;
using Check = MechanismFinding::Check;

constexpr std::size_t points_wanted = 8, points_needed = 4, points_tried = 48;
constexpr std::uint64_t sampling_seed = 1;

MechanismFinding not_checkable(Check check, std::string why) {
  return {check, false, {}, std::move(why)};
}

MechanismFinding too_few_points(Check check, const std::string& name) {
  return not_checkable(check, name + ": too few points of the domain were found");
}

/// Points of the domain at which everything has a value.
struct Point {
  MechanismValues values;
  FrictionProblem problem;
};
std::vector<Point> points_of(const Mechanism& mechanism) {
  const ProblemMaker maker(mechanism);
  std::vector<Point> points;
  for (MechanismValues& values : sample_values(mechanism, maker, points_tried, sampling_seed)) {
    try {
      FrictionProblem problem = maker.problem(values);
      points.push_back({std::move(values), std::move(problem)});
    } catch (const NoValue&) {
      continue;
    }
  }
  return points;
}

/// Whether a symmetric matrix is positive semidefinite: elimination meets no negative pivot, and a zero one has a zero
/// row. At the first that does not, its index.
std::optional<std::size_t> negative_direction(Matrix matrix) {
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    const Rational pivot = matrix[k][k];
    const bool row_is_zero = std::all_of(matrix[k].begin() + static_cast<std::ptrdiff_t>(k), matrix[k].end(),
                                         [](const Rational& x) { return x.is_zero(); });
    if (pivot < 0 || (pivot.is_zero() && !row_is_zero)) return k;
    if (pivot.is_zero()) continue;
    for (std::size_t i = k + 1; i < matrix.size(); ++i) {
      const Rational factor = matrix[i][k] / pivot;
      for (std::size_t j = k; j < matrix.size(); ++j) matrix[i][j] -= factor * matrix[k][j];
    }
  }
  return std::nullopt;
}

std::optional<MechanismFinding> reciprocity_at(const Mechanism& mechanism, const Point& point, const Matrix& matrix,
                                               const std::vector<Pairing>& pairings) {
  const auto force = [&](std::size_t i) { return mechanism.unknowns[pairings[i].force].symbol; };
  const std::string where = "at " + values_text(mechanism, point.values);
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (matrix[i][k] == matrix[k][i]) continue;
      return MechanismFinding{Check::reciprocity, true, pairings[i].place,
                              "forces and accelerations are not reciprocal, as virtual work has them: " + force(k) +
                                  " gives " + pairings[i].name + " " + exact_text(matrix[i][k]) + ", " + force(i) +
                                  " gives " + pairings[k].name + " " + exact_text(matrix[k][i]) +
                                  ", expected the same, " + where};
    }
  }
  const auto negative = negative_direction(matrix);
  if (!negative) return std::nullopt;
  return MechanismFinding{
      Check::reciprocity, true, pairings[*negative].place,
      "the force " + force(*negative) + " accelerates " + pairings[*negative].name +
          " against itself, expected a positive semidefinite matrix of accelerations over forces, " + where};
}

bool has_gravity(const Mechanism& mechanism) {
  return std::any_of(mechanism.parameters.begin(), mechanism.parameters.end(), [](const MechanismParameter& p) {
    return p.symbol == "g" || p.unit == "m/s^2" || p.unit == "m s^-2";
  });
}

bool rests(const MechanismContact& contact) {
  return contact.start == ElementKind::Start::rest && !contact.bilateral;
}

}  // namespace

std::string to_string(const Mechanism& mechanism, const MechanismFinding& finding) {
  const std::string kind = finding.checkable ? "warning: " : "not checkable: ";
  return to_string(Diagnostic{mechanism.file, finding.place.line, finding.place.column, kind + finding.message});
}

std::vector<MechanismFinding> check_reciprocity(const Mechanism& mechanism) {
  if (!mechanism.reciprocal) return {};
  std::size_t points = 0;
  const auto sampled = points_of(mechanism);
  for (const Point& point : sampled) {
    const auto pairs = pairings(mechanism, point.problem);
    if (pairs.empty()) return {};
    const auto matrix = delassus(mechanism, point.problem, pairs);
    if (!matrix) continue;
    if (auto finding = reciprocity_at(mechanism, point, *matrix, pairs)) return {std::move(*finding)};
    if (++points == points_wanted) break;
  }
  if (points >= points_needed) return {};
  if (sampled.size() < points_needed) return {too_few_points(Check::reciprocity, "reciprocity")};
  return {not_checkable(Check::reciprocity,
                        "reciprocity: the equations do not determine the accelerations for given contact forces")};
}

std::vector<MechanismFinding> check_gravity(const Mechanism& mechanism) {
  const auto at_rest = std::count_if(mechanism.contacts.begin(), mechanism.contacts.end(), rests);
  if (at_rest == 0) return {};
  std::size_t points = 0;
  bool moves = false;
  const auto sampled = points_of(mechanism);
  for (const Point& point : sampled) {
    const auto motion = free_motion(mechanism, point.problem);
    if (!motion) continue;
    moves = moves || motion->moves;
    for (std::size_t i = 0; i < motion->gaps.size(); ++i) {
      const MechanismContact& contact = mechanism.contacts[i];
      const Rational& gap = motion->gaps[i];
      if (!rests(contact) || gap <= 0) continue;
      return {{Check::gravity, true, contact.gap.place(),
               "without contact forces and load the contact " + contact.name + " opens: " + contact.gap_name + " = " +
                   exact_text(gap) + " at " + values_text(mechanism, point.values)}};
    }
    if (++points == points_wanted) break;
  }
  if (sampled.size() < points_needed) return {too_few_points(Check::gravity, "gravity")};
  if (points < points_needed) {
    return {not_checkable(Check::gravity, "gravity: the equations do not determine a motion without contact forces")};
  }
  if (moves || !has_gravity(mechanism)) return {};
  return {{Check::gravity, true, mechanism.contacts.front().gap.place(),
           "there is gravity, but without contact forces and load nothing moves, so that it presses on no contact"}};
}

std::vector<MechanismFinding> check_mechanism(const Mechanism& mechanism) {
  std::vector<MechanismFinding> findings = check_reciprocity(mechanism);
  for (auto* check : {check_gravity, check_units}) std::ranges::move(check(mechanism), std::back_inserter(findings));
  return findings;
}

}  // namespace slipproof
