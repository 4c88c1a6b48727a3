#include <algorithm>
#include <array>
#include <map>

#include "base/number/format.hpp"
#include "mechanics/bodies/bodies.hpp"
#include "mechanics/checks/check_parts.hpp"
#include "mechanics/checks/free_motion.hpp"
#include "mechanics/mechanism/algebra.hpp"

namespace slipproof::mechanism_checks {

namespace {

using Check = MechanismFinding::Check;

std::optional<MechanismFinding> reciprocity_at(const CheckPoints& points, const CheckPoint& point, const Matrix& matrix,
                                               const std::vector<Pairing>& pairings) {
  const Mechanism& mechanism = points.mechanism();
  const auto force = [&](std::size_t i) { return mechanism.unknowns[pairings[i].force].symbol; };
  const auto where = [&](std::size_t i, std::size_t k) {
    return points.where(point, [&](const CheckPoint& there) -> std::optional<Rational> {
      const auto other = delassus(mechanism, there.problem, mechanism_checks::pairings(mechanism, there.problem));
      return other ? std::optional((*other)[i][k]) : std::nullopt;
    });
  };
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (matrix[i][k] == matrix[k][i]) continue;
      return warning(Check::reciprocity, pairings[i].place,
                     "forces and accelerations are not reciprocal, as virtual work requires: " + force(k) + " gives " +
                         pairings[i].name + " " + exact_text(matrix[i][k]) + ", " + force(i) + " gives " +
                         pairings[k].name + " " + exact_text(matrix[k][i]) + ", expected the same" + where(i, k));
    }
  }
  const auto negative = negative_direction(matrix);
  if (!negative) return std::nullopt;
  return warning(Check::reciprocity, pairings[*negative].place,
                 "the force " + force(*negative) + " accelerates " + pairings[*negative].name +
                     " against itself, expected a positive semidefinite matrix of accelerations over forces" +
                     where(*negative, *negative));
}

bool rests(const MechanismContact& contact) {
  return contact.start == ElementKind::Start::rest && !contact.bilateral;
}

/// Whether the gravity of bodies points up at all points, as the y axis of their scene does, in space the z axis.
bool gravity_points_up(const CheckPoints& points) {
  const auto& bodies = points.mechanism().bodies;
  if (!bodies || !bodies->gravity) return false;
  const PlacedExpression& upward = bodies->dimension == 3 ? bodies->gravity.z : bodies->gravity.y;
  const Program up = points.maker().compiled().compile(upward.expression);
  return std::ranges::all_of(points.all(), [&](const CheckPoint& point) {
    const auto value = points.maker().at(point.values).number(up);
    return value.number && *value.number > 0;
  });
}

/// Whether bodies say that gravity need not press on the contact: it is along the surface, or springs may lift.
bool gravity_passes_by(const CheckPoints& points, const CheckPoint& point, const MechanismContact& contact) {
  const auto& bodies = points.mechanism().bodies;
  if (!bodies || !bodies->gravity || contact.direction.empty()) return false;
  if (std::ranges::any_of(bodies->joints, [](const auto& one) { return one.kind == BodyJoint::Kind::spring; }))
    return true;
  const std::array gravity{&bodies->gravity.x, &bodies->gravity.y, &bodies->gravity.z};
  Expression pressing = zero_literal();
  for (std::size_t i = 0; i < contact.direction.size(); ++i) {
    const Expression part = make(Operation::multiply, {contact.direction[i].expression, gravity[i]->expression});
    pressing = make(Operation::add, {pressing, part});
  }
  const auto value = points.maker().at(point.values).number(points.maker().compiled().compile(pressing));
  return value.number && value.number->is_zero();
}

/// Adds each contact that opens without contact forces and load, if it is not there from another point.
void add_opening(const CheckPoints& points, const CheckPoint& point, const FreeMotion& motion,
                 std::map<std::size_t, MechanismFinding>& findings) {
  const Mechanism& mechanism = points.mechanism();
  for (std::size_t i = 0; i < motion.gaps.size(); ++i) {
    const MechanismContact& contact = mechanism.contacts[i];
    if (findings.contains(i) || !rests(contact) || motion.gaps[i] <= 0 || gravity_passes_by(points, point, contact))
      continue;
    const auto gap = [&](const CheckPoint& there) -> std::optional<Rational> {
      const auto other = free_motion(mechanism, there.problem);
      return other ? std::optional(other->gaps[i]) : std::nullopt;
    };
    findings.emplace(i, warning(Check::gravity, contact.gap.place(),
                                "without contact forces and load the contact " + contact.name + " opens: " +
                                    contact.gap_name + " = " + exact_text(motion.gaps[i]) + points.where(point, gap)));
  }
}

}  // namespace

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

std::vector<MechanismFinding> check_reciprocity(const CheckPoints& points) {
  const Mechanism& mechanism = points.mechanism();
  if (!mechanism.reciprocal || mechanism.by_virtual_work) return {};
  std::size_t count = 0;
  for (const CheckPoint& point : points.all()) {
    const auto pairs = pairings(mechanism, point.problem);
    if (pairs.empty()) return {};
    const auto matrix = delassus(mechanism, point.problem, pairs);
    if (!matrix) continue;
    if (auto finding = reciprocity_at(points, point, *matrix, pairs)) return {std::move(*finding)};
    if (++count == CheckPoints::enough) break;
  }
  if (count >= CheckPoints::needed) return {};
  return {not_checkable(Check::reciprocity,
                        "reciprocity: the equations do not determine the accelerations for given contact forces")};
}

std::vector<MechanismFinding> check_gravity(const CheckPoints& points) {
  const Mechanism& mechanism = points.mechanism();
  if (gravity_points_up(points)) {
    const bool space = mechanism.dimension == 3;
    return {warning(Check::gravity, mechanism.bodies->gravity.place,
                    std::string("gravity points up: ") + (space ? "z" : "y") +
                        " counts upwards, expected a vector such as [\"0\", " + (space ? "\"0\", " : "") + "\"-g\"]")};
  }
  if (mechanism.impact || std::ranges::none_of(mechanism.contacts, rests)) return {};  // gravity has no impulse
  std::size_t count = 0;
  bool moves = false;
  std::map<std::size_t, MechanismFinding> open;
  for (const CheckPoint& sampled : points.all()) {
    const CheckPoint point = points.without_pushes(sampled);
    if (!has_gravity(mechanism) && points.is_pushed(point)) return {};  // it is no gravity that opens contacts
    const auto motion = free_motion(mechanism, point.problem);
    if (!motion) continue;
    moves = moves || motion->moves;
    add_opening(points, point, *motion, open);
    if (++count == CheckPoints::enough) break;
  }
  std::vector<MechanismFinding> findings;
  for (auto& [unused, finding] : open) findings.push_back(std::move(finding));
  if (!findings.empty()) return findings;
  if (count < CheckPoints::needed) {
    return {not_checkable(Check::gravity, "gravity: the equations do not determine a motion without contact forces")};
  }
  if (moves || !has_gravity(mechanism)) return {};
  return {warning(Check::gravity, mechanism.contacts.front().gap.place(),
                  "there is gravity, but without contact forces and load nothing moves, so that it presses on no "
                  "contact")};
}

}  // namespace slipproof::mechanism_checks
