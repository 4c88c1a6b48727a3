// What touches, rubs or holds in a planar mechanism, and the states it can be in: the one table of contact states, with
// the equations and the conditions of each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slipproof {

/// A contact, a frictionless contact, or a friction element with a limit of its own (a brake, a clutch).
struct ElementKind {
  enum class Law : std::uint8_t {
    coulomb,       ///< |S| <= mu N
    frictionless,  ///< no S
    limited        ///< no N; |S| <= limit
  };
  /// Before the motion: at rest, sliding with the sign of its slip, or apart.
  enum class Start : std::uint8_t { rest, slides_forward, slides_backward, open };

  Law law = Law::coulomb;
  Start start = Start::rest;
  bool bilateral = false;  ///< a guide: N of either sign, and it never opens
  bool lifts = true;       ///< whether `lift` is modelled

  bool slides() const { return start == Start::slides_forward || start == Start::slides_backward; }
};

/// The state of one element. A tilde marks a guide that pulls: N <= 0, and -N stands for N in the friction law.
enum class ElementState : std::uint8_t {
  stick,                 ///< `stick`
  slip_forward,          ///< `slip+`: slip >= 0, S = -mu N
  slip_backward,         ///< `slip-`
  lift,                  ///< `lift`
  touch,                 ///< `touch`, of a frictionless contact
  pulled_stick,          ///< `stick~`
  pulled_slip_forward,   ///< `slip+~`
  pulled_slip_backward,  ///< `slip-~`
};

std::string_view name(ElementState state);
std::optional<ElementState> parse_element_state(std::string_view text);  ///< nothing unless as written by name()

/// +1 for `slip+` and `slip+~`, -1 for `slip-` and `slip-~`, 0 otherwise.
int slip_direction(ElementState state);
/// Whether it is one of those with a tilde.
bool is_pulled(ElementState state);

/// The states of an element, in the order in which modes are enumerated.
std::vector<ElementState> states(const ElementKind& kind);

/// One equation of a state.
enum class StateEquation : std::uint8_t {
  gap,              ///< gap = 0
  slip,             ///< slip = 0
  no_normal,        ///< N = 0
  no_tangent,       ///< S = 0
  resists_forward,  ///< S = -kinetic limit
  resists_backward  ///< S = +kinetic limit
};
std::vector<StateEquation> equations(const ElementKind& kind, ElementState state);

/// One condition of a state: what must be >= 0, and > 0 in a strict motion. The limits are mu N of a contact (mu times
/// -N where it is pulled), and the limit of a friction element.
enum class StateCondition : std::uint8_t {
  pushes,          ///< N >= 0
  pulls,           ///< N <= 0
  holds_forward,   ///< S <= static limit
  holds_backward,  ///< S >= -static limit
  slips_forward,   ///< slip >= 0
  slips_backward,  ///< slip <= 0
  opens,           ///< gap >= 0
  static_limit,    ///< limit >= 0, of a friction element
  kinetic_limit
};
std::vector<StateCondition> conditions(const ElementKind& kind, ElementState state);

/// A state for each element, in the order of the mechanism.
using MechanismMode = std::vector<ElementState>;
std::string name(const MechanismMode& mode);  ///< joined by `/`: `stick/slip+`

}  // namespace slipproof
