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
    case ContactState::lift:
      break;
  }
  return fmt::format("{}_lifts", side);
}

std::string contact_equations(Wheel wheel, ContactState state) {
  const int j = wheel == Wheel::rear ? 2 : 3;
  switch (state) {
    case ContactState::stick:
      return fmt::format("gap{0} = 0 and slip{0} = 0", j);
    case ContactState::slip_forward:
      return fmt::format("gap{0} = 0 and S{0} = -f*N{0}", j);
    case ContactState::slip_backward:
      return fmt::format("gap{0} = 0 and S{0} = f*N{0}", j);
    case ContactState::lift:
      break;
  }
  return fmt::format("N{0} = 0 and S{0} = 0", j);
}

std::string state_definition(Wheel wheel, ContactState state, bool strict) {
  const char* above = strict ? ">" : ">=";
  const char* below = strict ? "<" : "<=";
  const int j = wheel == Wheel::rear ? 2 : 3;
  std::string conditions;
  switch (state) {
    case ContactState::stick:
      conditions = fmt::format("N{0} {1} 0 and -f*N{0} {2} S{0} {2} f*N{0}", j, above, below);
      break;
    case ContactState::slip_forward:
      conditions = fmt::format("N{0} {1} 0 and slip{0} {1} 0", j, above);
      break;
    case ContactState::slip_backward:
      conditions = fmt::format("N{0} {1} 0 and slip{0} {2} 0", j, above, below);
      break;
    case ContactState::lift:
      conditions = fmt::format("gap{0} {1} 0", j, above);
      break;
  }
  return fmt::format("define {}: {} and {}\n", state_name(wheel, state), contact_equations(wheel, state), conditions);
}

namespace {

/// One of a state's equations or conditions fails.
std::string state_missed_text(Wheel wheel, ContactState state) {
  const int j = wheel == Wheel::rear ? 2 : 3;
  switch (state) {
    case ContactState::stick:
      return fmt::format("gap{0} != 0 or slip{0} != 0 or N{0} < 0 or S{0} < -f*N{0} or S{0} > f*N{0}", j);
    case ContactState::slip_forward:
      return fmt::format("gap{0} != 0 or S{0} != -f*N{0} or N{0} < 0 or slip{0} < 0", j);
    case ContactState::slip_backward:
      return fmt::format("gap{0} != 0 or S{0} != f*N{0} or N{0} < 0 or slip{0} > 0", j);
    case ContactState::lift:
      break;
  }
  return fmt::format("N{0} != 0 or S{0} != 0 or gap{0} < 0", j);
}

}  // namespace

std::string mode_missed_text(ContactMode mode) {
  return state_missed_text(Wheel::rear, mode.rear) + " or " + state_missed_text(Wheel::front, mode.front);
}

std::string mode_text(ContactMode mode) {
  return state_name(Wheel::rear, mode.rear) + " and " + state_name(Wheel::front, mode.front);
}

}  // namespace slipproof
