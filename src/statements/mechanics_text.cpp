#include "statements/mechanics_text.hpp"

#include <fmt/format.h>

namespace slipproof {

std::string mechanics_text(ForceKind kind) {
  const bool external = kind == ForceKind::external;
  return fmt::format(
      "let gap2 = -(a_y - phi*b2)\n"
      "let gap3 = -(a_y + phi*b3)\n"
      "let slip2 = a - phi*h - eps2*R\n"
      "let slip3 = a - phi*h - eps3*R\n"
      "define forces: M*a = S2 + S3{} and M*a_y = M*g - N2 - N3\n"
      "define pitch: J*phi + I1*eps1 + I2*eps2 + I3*eps3 = N2*b2 - N3*b3 - (S2 + S3)*(h + R){}\n"
      "define bodies: I1*eps1 = F*L + T*r1 and I2*eps2 = -S2*R - T*r2 and I3*eps3 = -S3*R\n"
      "define chain: (eps1 - phi)*r1 = (eps2 - phi)*r2\n",
      external ? " - F" : "", external ? " + F*(L + h)" : "");
}

std::string state_name(Wheel wheel, ContactState state) {
  const char* side = wheel == Wheel::rear ? "rear" : "front";
  switch (state) {
    case ContactState::stick:
      return fmt::format("{}_sticks", side);
    case ContactState::slip_forward:
      return fmt::format("{}_slips_forwards", side);
    case ContactState::slip_backward:
      return fmt::format("{}_slips_backwards", side);
    default:
      return fmt::format("{}_lifts", side);
  }
}

namespace {

/// The equation of a state, or that it fails, of wheel j.
std::string equation_text(StateEquation equation, int j, const char* is) {
  switch (equation) {
    case StateEquation::gap:
      return fmt::format("gap{} {} 0", j, is);
    case StateEquation::slip:
      return fmt::format("slip{} {} 0", j, is);
    case StateEquation::no_normal:
      return fmt::format("N{} {} 0", j, is);
    case StateEquation::no_tangent:
      return fmt::format("S{} {} 0", j, is);
    case StateEquation::resists_forward:
      return fmt::format("S{0} {1} -f*N{0}", j, is);
    case StateEquation::resists_backward:
      break;
  }
  return fmt::format("S{0} {1} f*N{0}", j, is);
}

/// The condition of a state, of wheel j. Both of those on the friction of a wheel that sticks stand at the first.
std::string condition_text(StateCondition condition, int j, bool strict) {
  const char* above = strict ? ">" : ">=";
  const char* below = strict ? "<" : "<=";
  switch (condition) {
    case StateCondition::pushes:
      return fmt::format("N{} {} 0", j, above);
    case StateCondition::holds_forward:
      return fmt::format("-f*N{0} {1} S{0} {1} f*N{0}", j, below);
    case StateCondition::slips_forward:
      return fmt::format("slip{} {} 0", j, above);
    case StateCondition::slips_backward:
      return fmt::format("slip{} {} 0", j, below);
    case StateCondition::opens:
      return fmt::format("gap{} {} 0", j, above);
    default:
      return {};
  }
}

/// That it fails.
std::string missed_text(StateCondition condition, int j) {
  switch (condition) {
    case StateCondition::pushes:
      return fmt::format("N{} < 0", j);
    case StateCondition::holds_forward:
      return fmt::format("S{0} < -f*N{0} or S{0} > f*N{0}", j);
    case StateCondition::slips_forward:
      return fmt::format("slip{} < 0", j);
    case StateCondition::slips_backward:
      return fmt::format("slip{} > 0", j);
    case StateCondition::opens:
      return fmt::format("gap{} < 0", j);
    default:
      return {};
  }
}

int number_of(Wheel wheel) {
  return wheel == Wheel::rear ? 2 : 3;
}

/// What the items of a list say, joined by a word; those that say nothing are left out.
template <class Items, class Text>
std::string joined(const Items& items, const char* word, const Text& text) {
  std::string result;
  for (const auto item : items) {
    const std::string part = text(item);
    if (!part.empty()) result += (result.empty() ? "" : word) + part;
  }
  return result;
}

}  // namespace

std::string contact_equations(Wheel wheel, ContactState state) {
  return joined(equations(ElementKind{}, state), " and ",
                [&](StateEquation equation) { return equation_text(equation, number_of(wheel), "="); });
}

std::string state_definition(Wheel wheel, ContactState state, bool strict) {
  const std::string all = joined(conditions(ElementKind{}, state), " and ", [&](StateCondition condition) {
    return condition_text(condition, number_of(wheel), strict);
  });
  return fmt::format("define {}: {} and {}\n", state_name(wheel, state), contact_equations(wheel, state), all);
}

namespace {

/// One of a state's equations or conditions fails.
std::string state_missed_text(Wheel wheel, ContactState state) {
  const int j = number_of(wheel);
  return joined(equations(ElementKind{}, state), " or ",
                [&](StateEquation equation) { return equation_text(equation, j, "!="); }) +
         " or " + joined(conditions(ElementKind{}, state), " or ", [&](StateCondition condition) {
           return missed_text(condition, j);
         });
}

}  // namespace

std::string mode_missed_text(ContactMode mode) {
  return state_missed_text(Wheel::rear, mode.rear) + " or " + state_missed_text(Wheel::front, mode.front);
}

std::string mode_text(ContactMode mode) {
  return state_name(Wheel::rear, mode.rear) + " and " + state_name(Wheel::front, mode.front);
}

}  // namespace slipproof
