// The mechanics in the syntax of statements, for a person to compare with the model; tests/prove holds it against the
// equations of src/model.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "claims/claims_file.hpp"
#include "model/contact_mode.hpp"

namespace slipproof {

/// The unknowns of a motion, in the order in which statements declare them.
inline constexpr std::array<std::string_view, 11> motion_unknowns{"a", "a_y", "phi", "eps1", "eps2", "eps3",
                                                                  "T", "S2",  "S3",  "N2",   "N3"};
inline constexpr std::array all_contact_states{ContactState::stick, ContactState::slip_forward,
                                               ContactState::slip_backward, ContactState::lift};
/// The formulas that mechanics_text() defines.
inline constexpr const char* dynamics = "forces and pitch and bodies and chain";

/// The seven equations of motion over the scene's symbols and the unknowns; gaps and slips of the contacts.
std::string mechanics_text(ForceKind kind);

/// The name of a wheel's contact state, and the line that defines it.
std::string state_name(Wheel wheel, ContactState state);
std::string state_definition(Wheel wheel, ContactState state, bool strict);
/// `rear_sticks and front_lifts`
std::string mode_text(ContactMode mode);
/// That a motion is not in the mode, boundary motions of the mode counted as in it.
std::string mode_missed_text(ContactMode mode);
/// The two equations of a contact state alone, without its conditions.
std::string contact_equations(Wheel wheel, ContactState state);

}  // namespace slipproof
