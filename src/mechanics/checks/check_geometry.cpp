#include <algorithm>
#include <map>
#include <set>

#include "base/algebra/union_find.hpp"
#include "mechanics/checks/check_parts.hpp"
#include "mechanics/checks/rigid_contacts.hpp"
#include "mechanics/mechanism/units.hpp"

namespace slipproof::mechanism_checks {

namespace {

using Check = MechanismFinding::Check;

/// The accelerations of one body.
struct Body {
  std::vector<std::size_t> translations;
  std::optional<std::size_t> rotation;
};

class GeometryCheck {
 public:
  explicit GeometryCheck(const CheckPoints& points) : points_(points), m_(points.mechanism()) {
    const CompiledMechanism& compiled = points.maker().compiled();
    for (const MechanismContact& contact : m_.contacts) {
      programs_.emplace_back();
      for (const auto* pair : {&contact.at, &contact.direction, &contact.slip_direction}) {
        for (const PlacedExpression& one : *pair) programs_.back().push_back(compiled.compile(one.expression));
      }
    }
  }

  std::vector<MechanismFinding> check() {
    std::vector<MechanismFinding> findings;
    std::string skipped;
    for (const std::vector<std::size_t>& group : groups()) {
      const auto bodies = bodies_of(accelerations_of(group));
      if (bodies.empty()) {
        for (const std::size_t i : group) skipped += (skipped.empty() ? "" : ", ") + m_.contacts[i].name;
        continue;
      }
      if (auto finding = check(group, bodies)) findings.push_back(std::move(*finding));
    }
    if (!skipped.empty()) {
      findings.push_back(
          not_checkable(Check::geometry,
                        "geometry of the contacts " + skipped +
                            ": their gaps and slips do not use the accelerations of one body, two translations and a "
                            "rotation"));
    }
    return findings;
  }

 private:
  std::vector<std::size_t> accelerations_of(const std::vector<std::size_t>& group) const {
    std::set<std::size_t> result;
    for (const std::size_t i : group) {
      for (const SymbolicForm* form : {&m_.contacts[i].gap_form, &m_.contacts[i].slip_form}) {
        for (const auto& [unknown, coefficient] : form->terms) {
          if (unknown < m_.accelerations) result.insert(unknown);
        }
      }
    }
    return {result.begin(), result.end()};
  }

  /// Contacts with a place, a direction and friction, those that share an acceleration together.
  std::vector<std::vector<std::size_t>> groups() const {
    UnionFind together(m_.accelerations + m_.contacts.size());
    std::vector<std::size_t> drawn;
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) {
      const MechanismContact& contact = m_.contacts[i];
      if (contact.at.empty() || contact.direction.empty() || !contact.tangent) continue;
      drawn.push_back(i);
      for (const std::size_t q : accelerations_of({i})) together.join(q, m_.accelerations + i);
    }
    std::map<std::size_t, std::vector<std::size_t>> members;
    for (const std::size_t i : drawn) members[together.find(m_.accelerations + i)].push_back(i);
    std::vector<std::vector<std::size_t>> result;
    for (auto& [root, group] : members) result.push_back(std::move(group));
    std::ranges::sort(result, {}, [](const std::vector<std::size_t>& group) { return group.back(); });
    return result;
  }

  /// The bodies that may have these accelerations: if there are units, the one that they determine; otherwise those
  /// with the same inertia in both translations.
  std::vector<Body> bodies_of(const std::vector<std::size_t>& accelerations) const {
    if (accelerations.size() > 3) return {};
    const bool units = std::ranges::all_of(accelerations, [&](std::size_t q) { return !m_.unknowns[q].unit.empty(); });
    std::vector<Body> result;
    for (std::size_t k = 0; k <= accelerations.size(); ++k) {
      Body body;
      for (std::size_t i = 0; i < accelerations.size(); ++i) {
        if (i != k) body.translations.push_back(accelerations[i]);
      }
      if (k < accelerations.size()) body.rotation = accelerations[k];
      if (body.translations.empty() || body.translations.size() > 2) continue;
      if (units ? by_units(body) : by_inertia(body)) result.push_back(std::move(body));
    }
    return result;
  }

  bool by_units(const Body& body) const {
    const auto has = [&](std::size_t q, const char* unit) {
      const auto own = parse_unit(m_.unknowns[q].unit), expected = parse_unit(unit);
      return own && expected && own->same_dimension(*expected);
    };
    return std::ranges::all_of(body.translations, [&](std::size_t q) { return has(q, "m/s^2"); }) &&
           (!body.rotation || has(*body.rotation, "s^-2"));
  }

  bool by_inertia(const Body& body) const {
    if (!m_.by_virtual_work || body.translations.size() < 2) return false;
    const std::size_t x = body.translations[0], y = body.translations[1];
    return std::ranges::all_of(points_.all(), [&](const CheckPoint& point) {
      const auto& equations = point.problem.equations;
      const auto inertia = [&](std::size_t i, std::size_t k) { return equations[i].coefficients[k]; };
      return inertia(x, x) == inertia(y, y) && inertia(x, y).is_zero() && !inertia(x, x).is_zero();
    });
  }

  /// The first misfit, if every body that there may be has one.
  std::optional<MechanismFinding> check(const std::vector<std::size_t>& group, const std::vector<Body>& bodies) const {
    std::optional<MechanismFinding> first;
    for (const Body& body : bodies) {
      const auto found = misfit(group, body);
      if (!found) return std::nullopt;
      if (!first) first = found;
    }
    return first;
  }

  std::optional<MechanismFinding> misfit(const std::vector<std::size_t>& group, const Body& body) const {
    std::size_t count = 0;
    for (const CheckPoint& point : points_.all()) {
      const auto placed = placed_at(point, group, body);
      if (!placed) continue;
      const auto found = rigid_misfit(*placed);
      if (found) return finding(point, *found, group, body);
      if (++count == CheckPoints::enough) break;
    }
    return std::nullopt;
  }

  std::optional<std::vector<PlacedContact>> placed_at(const CheckPoint& point, const std::vector<std::size_t>& group,
                                                      const Body& body) const {
    Evaluator<Rational> at = points_.maker().at(point.values);
    std::vector<PlacedContact> result;
    for (const std::size_t i : group) {
      std::vector<Rational> numbers;
      for (const Program& program : programs_[i]) {
        auto value = at.number(program);
        if (!value.number) return std::nullopt;
        numbers.push_back(std::move(*value.number));
      }
      PlacedContact placed{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}, {}, {}, {}};
      if (vanishes(placed.normal)) return std::nullopt;
      const Vector given = numbers.size() > 4 ? Vector{numbers[4], numbers[5]} : Vector{Rational(0), Rational(0)};
      placed.along = along(placed.normal, given);
      const ProblemElement& element = point.problem.elements[i];
      for (const std::size_t q : body.translations) placed.translations.push_back(velocity(placed, element, q));
      if (body.rotation) placed.rotation = velocity(placed, element, *body.rotation);
      result.push_back(std::move(placed));
    }
    return result;
  }

  /// Across the normal, towards the direction that is given, to the right, or up.
  static Vector along(const Vector& normal, const Vector& given) {
    const Vector left = turned(normal), right{Rational(-left[0]), Rational(-left[1])};
    const Rational toward = dot(right, given);
    const int side = !toward.is_zero() ? sign(toward) : !right[0].is_zero() ? sign(right[0]) : sign(right[1]);
    return side > 0 ? right : left;
  }

  static Vector velocity(const PlacedContact& placed, const ProblemElement& element, std::size_t q) {
    const Rational &gap = element.gap.coefficients[q], &slip = element.slip.coefficients[q];
    const Rational square = dot(placed.normal, placed.normal);
    return {Rational((gap * placed.normal[0] + slip * placed.along[0]) / square),
            Rational((gap * placed.normal[1] + slip * placed.along[1]) / square)};
  }

  std::string words(const RigidMisfit& misfit, const std::vector<std::size_t>& group, const Body& body) const {
    const std::string against = " move it as at the contact " + m_.contacts[group[misfit.reference]].name;
    switch (misfit.why) {
      case RigidMisfit::Why::lengths: {
        const std::string& first = m_.unknowns[body.translations.front()].symbol;
        if (body.translations.size() == 1) return first + " does not move the contact";
        return first + " and " + m_.unknowns[body.translations.back()].symbol +
               " do not move the contact by the same length in perpendicular directions";
      }
      case RigidMisfit::Why::translations:
        return "the translations do not" + against;
      case RigidMisfit::Why::rotation:
        return "the rotation does not" + against + ", by where both are";
      case RigidMisfit::Why::mirrored:
        break;
    }
    return "with the opposite sign of the rotation it would match";
  }

  MechanismFinding finding(const CheckPoint& point, const RigidMisfit& misfit, const std::vector<std::size_t>& group,
                           const Body& body) const {
    const std::size_t index = group[misfit.contact];
    const MechanismContact& contact = m_.contacts[index];
    const bool rotates = misfit.why == RigidMisfit::Why::rotation || misfit.why == RigidMisfit::Why::mirrored;
    const std::size_t q = rotates && body.rotation ? *body.rotation : body.translations.front();
    const auto coefficient = [&](const CheckPoint& there) -> std::optional<Rational> {
      const ProblemElement& element = there.problem.elements[index];
      return (misfit.in_gap ? element.gap : element.slip).coefficients[q];
    };
    const PlacedExpression& placed = misfit.in_gap ? contact.gap : contact.slip;
    return warning(Check::geometry, placed.place(),
                   (misfit.in_gap ? contact.gap_name : contact.slip_name) + " = " + to_string(placed.expression) +
                       " is not what `at` and `direction` of the contact " + contact.name +
                       " give: " + words(misfit, group, body) + points_.where(point, coefficient));
  }

  const CheckPoints& points_;
  const Mechanism& m_;
  std::vector<std::vector<Program>> programs_;  ///< for each contact: at, direction, slip_direction
};

}  // namespace

std::vector<MechanismFinding> check_geometry(const CheckPoints& points) {
  if (points.mechanism().bodies) return {};  // gaps and slips follow from the places
  return GeometryCheck(points).check();
}

}  // namespace slipproof::mechanism_checks
