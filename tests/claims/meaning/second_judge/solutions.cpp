#include <algorithm>

#include "claims/meaning/second_judge/world.hpp"

namespace slipproof::meaning {

namespace {

bool contains(const std::vector<Mode>& modes, const Mode& mode) {
  return std::find(modes.begin(), modes.end(), mode) != modes.end();
}

}  // namespace

Polynomial Plane::polynomial(const std::string& X, const std::string& T) const {
  return Polynomial(constant) + Polynomial(x) * Polynomial::variable(X) + Polynomial(t) * Polynomial::variable(T);
}

bool Solutions::meets(const Rational& X, const Rational& t, bool strict) const {
  if (only_at && *only_at != X) return false;
  return std::all_of(conditions.begin(), conditions.end(), [&](const Plane& condition) {
    const Rational value = condition.at(X, t);
    return strict ? value > 0 : value >= 0;
  });
}

Motion Solutions::at(const Rational& x, const Rational& t) const {
  Motion result;
  for (const auto& [name, plane] : motion) result[name] = plane.at(x, t);
  return result;
}

std::vector<Rational> Solutions::parameters(const Rational& x, const std::vector<Plane>& more) const {
  if (!free) return {Rational(0)};
  std::set<Rational> points = {Rational(0)};
  std::vector<Plane> planes = conditions;
  planes.insert(planes.end(), more.begin(), more.end());
  for (const Plane& plane : planes) {
    if (plane.t != 0) points.insert(-(plane.constant + plane.x * x) / plane.t);
  }
  const std::vector<Rational> once = everywhere(points);
  return everywhere({once.begin(), once.end()});  // two motions at least between each two
}

std::set<Rational> Solutions::ends() const {
  std::set<Rational> result;
  if (only_at) result.insert(*only_at);
  for (const Plane& p : conditions) {
    if (p.t == 0 && p.x != 0) result.insert(-p.constant / p.x);
    for (const Plane& q : conditions) {  // where they meet
      const Rational x = p.x * q.t - q.x * p.t;
      if (x != 0) result.insert((q.constant * p.t - p.constant * q.t) / x);
    }
  }
  return result;
}

std::size_t Motions::in(const Mode& mode) const {
  if (contains(continua, mode)) return 2;
  return static_cast<std::size_t>(
      std::count_if(single.begin(), single.end(), [&](const One& one) { return contains(one.modes, mode); }));
}

bool Motions::all_in(const std::vector<Mode>& modes) const {
  return continua.empty() && std::all_of(single.begin(), single.end(), [&](const One& one) {
           return std::any_of(modes.begin(), modes.end(), [&](const Mode& mode) { return contains(one.modes, mode); });
         });
}

}  // namespace slipproof::meaning
