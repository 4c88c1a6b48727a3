#include "mechanics/bodies/settle.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/number/format.hpp"
#include "mechanics/bodies/identity.hpp"
#include "mechanics/bodies/sure_sign.hpp"
#include "mechanics/bodies/vectors.hpp"
#include "mechanics/mechanism/algebra.hpp"
#include "mechanics/points/sampling.hpp"

namespace slipproof {

namespace {

using Start = ElementKind::Start;

class Settlement {
 public:
  Settlement(Mechanism& mechanism, Mistakes& mistakes)
      : mechanism_(mechanism), mistakes_(mistakes), original_(mechanism), maker_(original_) {
    constexpr std::size_t enough = 12;
    constexpr std::uint64_t seed = 1;
    points_ = sample_values(original_, maker_, enough, seed);
  }

  void hold(const GeometryFact& fact) {
    const Relation relation = relation_of(fact.kind);
    const auto holds = [&](const Rational& value) { return slipproof::holds(relation, sign(value)); };
    if (relation == Relation::equal && bodies_in_motion::vanishes_identically(original_, fact.value)) return;
    const Values values = at_points(fact.value);
    const bool enough =
        fact.somewhere && std::ranges::any_of(values, [&](const auto& one) { return holds(one.first); });
    for (const auto& [value, point] : values) {
      if (enough || holds(value)) continue;
      return refuse(fact.place, fact.what, fact.value, value, *point);
    }
    assume(fact.name, fact.value, relation, fact.place);
  }

  void settle(const ElementVelocity& velocity) {
    const std::size_t contacts = mechanism_.contacts.size();
    if (velocity.element >= contacts) {
      MechanismFriction& friction = mechanism_.friction[velocity.element - contacts];
      return settle_sliding(velocity, friction.name, friction.start);
    }
    MechanismContact& contact = mechanism_.contacts[velocity.element];
    if (velocity.state_given && contact.start == Start::open) return hold_open(velocity, contact.name);
    hold_closed(velocity, contact);
    if (contact.start == Start::open || !velocity.sliding) return;
    if (velocity.second) return settle_direction(velocity, contact);
    settle_sliding(velocity, contact.name, contact.start);
  }

  /// Nothing of a friction element.
  std::optional<int> settle_before_impact(const ElementVelocity& velocity, bool by_sign) {
    if (velocity.element >= mechanism_.contacts.size()) return std::nullopt;
    const MechanismContact& contact = mechanism_.contacts[velocity.element];
    if (velocity.state_given && contact.start == Start::open) {
      hold_open(velocity, contact.name);
      return std::nullopt;
    }
    hold_touching(velocity, contact.name);
    if (contact.bilateral) {
      hold({GeometryFact::Kind::zero, velocity.opening, contact.name + "-stays-closed",
            "contact " + contact.name + ": found a guide that opens with the velocity X, expected 0", velocity.place});
      return 0;
    }
    const auto sign = sign_at_points(velocity.opening);
    if (!by_sign || !sign || bodies_in_motion::vanishes_identically(original_, velocity.opening)) return sign;
    assume(contact.name + (*sign < 0   ? "-approaches"
                           : *sign > 0 ? "-opens"
                                       : "-stays-closed"),
           velocity.opening,
           *sign < 0   ? Relation::less
           : *sign > 0 ? Relation::greater
                       : Relation::equal,
           velocity.place);
    return sign;
  }

 private:
  static Relation relation_of(GeometryFact::Kind kind) {
    switch (kind) {
      case GeometryFact::Kind::zero:
        return Relation::equal;
      case GeometryFact::Kind::not_zero:
        return Relation::not_equal;
      case GeometryFact::Kind::positive:
        return Relation::greater;
      case GeometryFact::Kind::not_negative:
        break;
    }
    return Relation::greater_equal;
  }

  using Values = std::vector<std::pair<Rational, const MechanismValues*>>;

  Values at_points(const Expression& expression) const {
    const Program program = maker_.compiled().compile(expression);
    Values values;
    for (const MechanismValues& point : points_) {
      auto value = maker_.at(point).number(program);
      if (value.number) values.emplace_back(std::move(*value.number), &point);
    }
    return values;
  }

  /// The values of the symbols in an expression, or of all if it uses a definition.
  std::string where(const Expression& expression, const MechanismValues& point) const {
    ShownValues shown{std::vector<bool>(original_.parameters.size()), std::vector<bool>(original_.angles.size())};
    for (const std::string& symbol : symbols(expression)) {
      for (std::size_t i = 0; i < original_.parameters.size(); ++i) {
        if (original_.parameters[i].symbol == symbol) shown.parameters[i] = true;
      }
      for (std::size_t i = 0; i < original_.angles.size(); ++i) {
        if (original_.angles[i].cosine == symbol || original_.angles[i].sine == symbol) shown.angles[i] = true;
      }
      for (const MechanismDefinition& definition : original_.definitions) {
        if (definition.symbol != symbol) continue;
        shown.parameters.assign(original_.parameters.size(), true);
        shown.angles.assign(original_.angles.size(), true);
      }
    }
    const std::string text = values_text(original_, point, shown);
    return text.empty() ? text : " at " + text;
  }

  void refuse(Place place, const std::string& what, const Expression& expression, const Rational& value,
              const MechanismValues& point) {
    std::string text = what;
    const std::size_t at = text.find('X');
    if (at != std::string::npos) text.replace(at, 1, exact_text(value));
    mistakes_.add(place, text + where(expression, point));
  }

  /// What is not known to hold everywhere becomes a condition of the domain, once under its name. Others of that name
  /// are numbered.
  void assume(const std::string& name, const Expression& value, Relation relation, Place place) {
    const bodies_in_motion::Signs signs = bodies_in_motion::sure_signs(original_, value);
    if (relation == Relation::greater && !signs.negative && !signs.zero) return;
    if (relation == Relation::greater_equal && !signs.negative) return;
    if (relation == Relation::not_equal && !signs.zero) return;
    if (relation == Relation::less && !signs.positive && !signs.zero) return;
    const Expression condition = make_comparison({value, zero_literal()}, {relation});
    const std::string text = to_string(condition);
    std::string own = name;
    for (int i = 2;; ++i) {
      const auto same = std::ranges::find(mechanism_.assume, own, &MechanismCondition::name);
      if (same == mechanism_.assume.end()) break;
      if (to_string(same->condition.expression) == text) return;
      own = name + "-" + std::to_string(i);
    }
    mechanism_.assume.push_back({own, {condition, PlacedText("", place)}});
  }

  /// -1, 0 or +1 at all points; nothing if it depends on the point.
  std::optional<int> sign_at_points(const Expression& expression) const {
    if (bodies_in_motion::vanishes_identically(original_, expression)) return 0;
    const Values values = at_points(expression);
    if (values.empty()) return std::nullopt;
    const int first = sign(values.front().first);
    const bool all = std::ranges::all_of(values, [&](const auto& one) { return sign(one.first) == first; });
    return all ? std::optional(first) : std::nullopt;
  }

  void hold_open(const ElementVelocity& velocity, const std::string& name) {
    if (!velocity.distance) return;
    hold({GeometryFact::Kind::not_negative, velocity.distance, name + "-is-open",
          "contact " + name + ": found it X from closed, inside the surface, expected it apart", velocity.place});
  }

  void hold_touching(const ElementVelocity& velocity, const std::string& name) {
    if (!velocity.distance) return;
    hold({GeometryFact::Kind::zero, velocity.distance, name + "-is-closed",
          "contact " + name + ": found it X from closed, expected 0, or state = \"open\"", velocity.place});
  }

  void hold_closed(const ElementVelocity& velocity, MechanismContact& contact) {
    const std::string name = "contact " + contact.name + ": ";
    hold_touching(velocity, contact.name);
    const auto opening = sign_at_points(velocity.opening);
    if (opening == 0) {
      if (!bodies_in_motion::vanishes_identically(original_, velocity.opening)) {
        assume(contact.name + "-stays-closed", velocity.opening, Relation::equal, velocity.place);
      }
      return;
    }
    if (opening == 1 && !contact.bilateral) {
      if (velocity.state_given) {
        mistakes_.add(velocity.place, name + "found the state " + in_quotes(name_of(contact.start)) +
                                          ", but the velocities open it, expected no state");
      }
      contact.start = Start::open;
      return assume(contact.name + "-opens", velocity.opening, Relation::greater, velocity.place);
    }
    for (const auto& [value, point] : at_points(velocity.opening)) {
      if (value.is_zero() || (value > 0 && !contact.bilateral)) continue;
      const std::string what =
          value < 0 ? "found it to approach the surface with the velocity X (`slipproof impact` finds what follows), "
                      "expected it to rest or to open"
                    : "found a guide that opens with the velocity X, expected 0";
      return refuse(velocity.place, name + what, velocity.opening, value, *point);
    }
    mistakes_.add(velocity.place, name +
                                      "found a velocity of opening that is 0 for some parameters and above 0 for "
                                      "others, expected it to be one of them");
  }

  std::string name_of(Start start) const { return std::string(slipproof::name(start, original_.dimension)); }

  void settle_sliding(const ElementVelocity& velocity, const std::string& name, Start& start) {
    const auto sliding = sign_at_points(velocity.sliding);
    const auto start_of = [](int sign) {
      return sign > 0 ? Start::slides_forward : sign < 0 ? Start::slides_backward : Start::rest;
    };
    if (!sliding && !velocity.state_given) {
      mistakes_.add(velocity.place,
                    name + ": found a sliding velocity " + in_quotes(to_string(velocity.sliding)) +
                        " whose sign depends on parameters, expected state = \"slides+\", \"slides-\" or "
                        "\"rest\", or a domain that decides it");
      return;
    }
    if (sliding && velocity.state_given && start != start_of(*sliding)) {
      mistakes_.add(velocity.place, name + ": found the state " + in_quotes(name_of(start)) +
                                        ", but the velocities say " + in_quotes(name_of(start_of(*sliding))));
      return;
    }
    if (sliding) start = start_of(*sliding);
    if (bodies_in_motion::vanishes_identically(original_, velocity.sliding)) return;
    const Relation relation = start == Start::slides_forward    ? Relation::greater
                              : start == Start::slides_backward ? Relation::less
                                                                : Relation::equal;
    assume(name + (start == Start::rest ? "-rests" : "-slides"), velocity.sliding, relation, velocity.place);
  }

  /// In space: at rest, or with the direction of its sliding velocity.
  void settle_direction(const ElementVelocity& velocity, MechanismContact& contact) {
    const Expression square = bodies_in_motion::plus(bodies_in_motion::times(velocity.sliding, velocity.sliding),
                                                     bodies_in_motion::times(velocity.second, velocity.second));
    const auto slides = sign_at_points(square);
    if (!slides && !velocity.state_given) {
      mistakes_.add(velocity.place, contact.name +
                                        ": found a sliding velocity that is 0 for some parameters only, expected "
                                        "state = \"slides\" or \"rest\", or a domain that decides it");
      return;
    }
    const Start found = slides == 0 ? Start::rest : Start::slides_forward;
    if (slides && velocity.state_given && contact.start != found) {
      mistakes_.add(velocity.place, contact.name + ": found the state " + in_quotes(name_of(contact.start)) +
                                        ", but the velocities say " + in_quotes(name_of(found)));
      return;
    }
    if (slides) contact.start = found;
    if (contact.start == Start::rest) {
      for (const Expression& part : {velocity.sliding, velocity.second}) {
        if (bodies_in_motion::vanishes_identically(original_, part)) continue;
        assume(contact.name + "-rests", part, Relation::equal, velocity.place);
      }
      return;
    }
    contact.sliding.clear();
    for (const Expression& part : {velocity.sliding, velocity.second}) {
      const Expression along = velocity.speed ? bodies_in_motion::over(part, velocity.speed) : part;
      contact.sliding.push_back({along, PlacedText("", velocity.place)});
    }
    assume(contact.name + "-slides", velocity.speed ? velocity.speed : square, Relation::greater, velocity.place);
  }

  Mechanism& mechanism_;
  Mistakes& mistakes_;
  const Mechanism original_;  ///< before conditions are added
  ProblemMaker maker_;
  std::vector<MechanismValues> points_;
};

}  // namespace

void settle_geometry(const BodyGeometry& geometry, Mechanism& mechanism, Mistakes& mistakes) {
  Settlement settlement(mechanism, mistakes);
  for (const GeometryFact& fact : geometry.facts) settlement.hold(fact);
  for (const ElementVelocity& velocity : geometry.velocities) settlement.settle(velocity);
}

std::vector<std::optional<int>> settle_before_impact(const BodyGeometry& geometry, Mechanism& mechanism,
                                                     Mistakes& mistakes, bool by_sign) {
  Settlement settlement(mechanism, mistakes);
  for (const GeometryFact& fact : geometry.facts) settlement.hold(fact);
  std::vector<std::optional<int>> signs(mechanism.contacts.size());
  for (const ElementVelocity& velocity : geometry.velocities) {
    const auto sign = settlement.settle_before_impact(velocity, by_sign);
    if (velocity.element < signs.size()) signs[velocity.element] = sign;
  }
  return signs;
}

}  // namespace slipproof
