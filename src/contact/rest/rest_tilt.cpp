#include <cmath>
#include <map>
#include <numbers>

#include "base/input/diagnostic.hpp"
#include "base/number/binary64.hpp"
#include "contact/rest/rest.hpp"
#include "mechanics/bodies/bodies.hpp"

namespace slipproof {

namespace {

using Vector3 = std::array<Rational, 3>;

Vector3 cross3(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational dot3(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The square root of a number, outwards; the same twice where it is rational.
ProvedEnd root_of(const Rational& square) {
  Integer n = numerator(square), d = denominator(square);
  Rational near = to_rational(std::sqrt(nearest_binary64(square)));
  const Rational low = near * Rational(Integer(999'999'999'999'999), Integer(1'000'000'000'000'000));
  const Rational high = near * Rational(Integer(1'000'000'000'000'001), Integer(1'000'000'000'000'000));
  const Rational root(to_rational(std::round(std::sqrt(nearest_binary64(Rational(n))))));
  const Rational under(to_rational(std::round(std::sqrt(nearest_binary64(Rational(d))))));
  if (root * root == Rational(n) && under * under == Rational(d)) return {root / under, root / under};
  return {low, high};
}

/// arctan in degrees, outwards: of binary64, which is right to 1e-13 degrees.
ProvedEnd degrees_of(const ProvedEnd& tangent) {
  constexpr double step = 1e9, slack = 1e-11;
  const auto degrees = [](const Rational& x) { return std::atan(nearest_binary64(x)) * 180 / std::numbers::pi; };
  const auto whole = [](double value) { return Rational(Integer(static_cast<long>(value)), Integer(1'000'000'000)); };
  return {whole(std::floor((degrees(tangent.lower) - slack) * step)),
          whole(std::ceil((degrees(tangent.upper) + slack) * step))};
}

class Weights {
 public:
  Weights(const MechanismScene& scene, const RestProblemMaker& maker)
      : m_(scene.mechanism), maker_(maker), at_(maker.points().at(scene.values)) {}

  Vector3 gravity() {
    const PlacedVector& g = m_.bodies->gravity;
    return {number(g.x), number(g.y), number(g.z)};
  }
  Place place() const { return m_.bodies->gravity.place; }

  /// What weights push along each row, under this gravity.
  std::vector<Rational> push(const RestProblem& problem, const Vector3& gravity) {
    std::map<std::string, std::size_t> rows;
    for (std::size_t i = 0; i < problem.rows.size(); ++i) rows[problem.rows[i]] = i;
    std::vector<Rational> push(problem.rows.size());
    for (const Body& body : m_.bodies->bodies) {
      if (body.is_prescribed()) continue;
      const Rational mass = number(body.mass);
      for (std::size_t k = 0; k < 3; ++k) {
        const Body::Unknown& one = body.unknowns[k];
        if (one.symbol.empty()) continue;
        push[rows.at(one.symbol)] += (one.negated ? -mass : mass) * gravity[k];
      }
    }
    return push;
  }

 private:
  Rational number(const PlacedExpression& placed) {
    if (!placed) return 0;
    auto value = at_.number(maker_.points().compiled().compile(placed.expression));
    if (value.number) return std::move(*value.number);
    throw InputError({{m_.file, placed.place().line, placed.place().column, "found a division by zero"}});
  }

  const Mechanism& m_;
  const RestProblemMaker& maker_;
  Evaluator<Rational> at_;
};

}  // namespace

RestTilt rest_under_tilt(const MechanismScene& scene, const RestProblemMaker& maker, const RestProblem& problem,
                         const Vector3& axis, Effort& effort, std::size_t& programs) {
  const Mechanism& m = scene.mechanism;
  const auto refuse = [&](Place place, const std::string& message) {
    throw InputError({{m.file, place.line, place.column, message}});
  };
  if (!m.bodies) refuse({}, m.name + ": found a mechanism given by its equations, expected bodies, whose weights tilt");
  if (m.dimension == 2 && (!axis[0].is_zero() || !axis[1].is_zero())) {
    refuse({}, m.name + ": found an axis of tilt in the plane of the scene, expected 0,0,1 or 0,0,-1 across it");
  }
  Weights weights(scene, maker);
  const Vector3 gravity = weights.gravity();
  if (!dot3(gravity, axis).is_zero() || dot3(axis, axis).is_zero() || dot3(gravity, gravity).is_zero()) {
    refuse(weights.place(), "found an axis of tilt that is not across gravity, expected one at a right angle to it");
  }
  RestPush push = push_at(problem, scene.load ? *scene.load : Rational(0));
  bool only_weights = push.f == weights.push(problem, gravity);
  for (const Rational& limit : push.limits) only_weights = only_weights && limit.is_zero();
  if (!only_weights)
    refuse({}, m.name +
                   ": found forces other than weights, or limits that do not tilt with them, "
                   "expected weights alone for a tilt");
  const RestPush turned{weights.push(problem, cross3(axis, gravity)), push.limits};
  RestSolver solver(problem, effort);
  RestTilt result;
  const std::optional<bool> level = solver.decide(push).can;
  result.none = level == false;
  result.decided = level.has_value();
  RestLoads range;
  if (level == true) range = solver.loads(push, turned, true);
  programs += solver.programs();
  result.decided = result.decided && range.decided;
  if (!range.to) return result;
  const ProvedEnd length = root_of(dot3(axis, axis));
  result.tangent = ProvedEnd{range.to->lower * length.lower, range.to->upper * length.upper};
  result.degrees = degrees_of(*result.tangent);
  return result;
}

}  // namespace slipproof
