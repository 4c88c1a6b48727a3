// What touches, rubs or holds in a mechanism, and the states it can be in: the one table of contact states, with the
// equations and the conditions of each.
#pragma once

#include <array>
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
    limited,       ///< no N; |S| <= limit
    cone           ///< in space: T1^2 + T2^2 <= (mu N)^2
  };
  /// The state before the motion: at rest, sliding with the sign of its slip, or apart.
  enum class Start : std::uint8_t { rest, slides_forward, slides_backward, open };

  Law law = Law::coulomb;
  Start start = Start::rest;
  bool bilateral = false;  ///< a guide: N of either sign, and it never opens
  bool lifts = true;       ///< whether `lift` is modelled
  bool slips = true;       ///< of a cone at rest: whether `slip` is modelled, in a direction that nobody knows before
  /// The contact whose normal force limits this friction element, as for rolling resistance; its index is lower than
  /// the element's own. The element is `free` exactly if the contact lifts, and pulled if the contact is; `bilateral`
  /// and `lifts` are those of the contact.
  std::optional<std::size_t> contact = {};

  constexpr bool slides() const { return start == Start::slides_forward || start == Start::slides_backward; }
  /// Whether its states have linear equations, and all of them are modelled.
  constexpr bool all_modelled() const { return lifts && (law != Law::cone || start != Start::rest || slips); }
};

/// The state of one element. A tilde marks a guide that pulls: N <= 0, and the friction law has -N for N.
enum class ElementState : std::uint8_t {
  stick,                 ///< `stick`
  slip_forward,          ///< `slip+`: slip >= 0, S = -mu N
  slip_backward,         ///< `slip-`
  lift,                  ///< `lift`
  touch,                 ///< `touch`, of a frictionless contact
  pulled_stick,          ///< `stick~`
  pulled_slip_forward,   ///< `slip+~`
  pulled_slip_backward,  ///< `slip-~`
  free,                  ///< `free`, of a friction element whose contact lifts: S = 0
  slip                   ///< `slip`, in space: friction of the size mu N against the sliding velocity
};

inline constexpr std::size_t element_state_count = 10;  ///< length of tables by state

std::string_view name(ElementState state);
/// In space a contact slides in a direction that its velocities have, not forward or backward: `slides`.
std::string_view name(ElementKind::Start start, std::size_t dimension);
std::string_view name(ElementKind::Start start);  ///< the name in files: `rest`, `slides+`, `slides-`, `open`
std::optional<ElementState> parse_element_state(std::string_view text);  ///< nothing unless as written by name()

/// +1 for `slip+` and `slip+~`, -1 for `slip-` and `slip-~`, 0 otherwise.
constexpr int slip_direction(ElementState state) {
  if (state == ElementState::slip_forward || state == ElementState::pulled_slip_forward) return 1;
  return state == ElementState::slip_backward || state == ElementState::pulled_slip_backward ? -1 : 0;
}
/// Whether it is one of those with a tilde.
constexpr bool is_pulled(ElementState state) {
  return state >= ElementState::pulled_stick && state <= ElementState::pulled_slip_backward;
}

/// The states of an element, in the order in which modes are enumerated.
std::vector<ElementState> states(const ElementKind& kind);

/// A list of at most four equations or conditions of a state, known at compile time.
template <class Item>
class StateList {
 public:
  constexpr void add(Item item) { items_[count_++] = item; }
  constexpr std::size_t size() const { return count_; }
  constexpr Item operator[](std::size_t i) const { return items_[i]; }
  constexpr const Item* begin() const { return items_.data(); }
  constexpr const Item* end() const { return items_.data() + count_; }

 private:
  std::array<Item, 4> items_{};
  std::size_t count_ = 0;
};

/// An equation of a state.
enum class StateEquation : std::uint8_t {
  gap,               ///< gap = 0 (gap and slip are accelerations)
  slip,              ///< slip = 0
  second_slip,       ///< in space, of the other direction
  no_normal,         ///< N = 0
  no_tangent,        ///< S = 0
  no_second,         ///< in space, of the other direction
  resists_forward,   ///< S = -kinetic limit
  resists_backward,  ///< S = +kinetic limit
  drags,             ///< in space: T1 = -mu N d1, where d is the direction in which the contact slides
  drags_second       ///< T2 = -mu N d2
};
constexpr StateList<StateEquation> equations(const ElementKind& kind, ElementState state);

/// A condition of a state: a quantity that must be >= 0, and > 0 in a strict motion. The limits are mu N for a contact
/// (mu times -N if it is pulled), and the limit of a friction element.
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
constexpr StateList<StateCondition> conditions(const ElementKind& kind, ElementState state);
/// Whether T1^2 + T2^2 <= (static limit)^2 is a condition, too, the only one that is not linear.
constexpr bool holds_in_cone(const ElementKind& kind, ElementState state) {
  return kind.law == ElementKind::Law::cone && state == ElementState::stick;
}

/// A state for each element, in the order of the mechanism.
using MechanismMode = std::vector<ElementState>;
/// Whether the first states of a mode go together: a friction element at a contact follows the contact.
bool go_together(const std::vector<ElementKind>& kinds, const MechanismMode& mode);
/// The number of modes of these elements; may be rounded.
double mode_count(const std::vector<ElementKind>& kinds);
/// All modes of these elements, in the order of enumeration; or only those with the given states.
std::vector<MechanismMode> modes_of(const std::vector<ElementKind>& kinds);
std::vector<MechanismMode> modes_of(const std::vector<ElementKind>& kinds,
                                    const std::vector<std::vector<ElementState>>& states);
/// Whether a state is one of the element's; whether a mode is one of the elements'.
bool has_state(const ElementKind& kind, ElementState state);
bool has_mode(const std::vector<ElementKind>& kinds, const MechanismMode& mode);
std::string name(const MechanismMode& mode);  ///< joined by `/`: `stick/slip+`
/// Several of one motion, joined by ` = `.
std::string equal_modes(const std::vector<MechanismMode>& modes);

constexpr StateList<StateEquation> equations(const ElementKind& kind, ElementState state) {
  StateList<StateEquation> result;
  if (state == ElementState::free) {
    result.add(StateEquation::no_tangent);
    return result;
  }
  const bool frictionless = kind.law == ElementKind::Law::frictionless;
  if (state == ElementState::lift) {
    result.add(StateEquation::no_normal);
    if (!frictionless) result.add(StateEquation::no_tangent);
    if (kind.law == ElementKind::Law::cone) result.add(StateEquation::no_second);
    return result;
  }
  if (kind.law != ElementKind::Law::limited) result.add(StateEquation::gap);
  if (state == ElementState::touch) return result;
  if (kind.law == ElementKind::Law::cone) {
    const bool sticks = state == ElementState::stick;
    result.add(sticks ? StateEquation::slip : StateEquation::drags);
    result.add(sticks ? StateEquation::second_slip : StateEquation::drags_second);
    return result;
  }
  const int direction = slip_direction(state);
  result.add(direction > 0   ? StateEquation::resists_forward
             : direction < 0 ? StateEquation::resists_backward
                             : StateEquation::slip);
  return result;
}

constexpr StateList<StateCondition> conditions(const ElementKind& kind, ElementState state) {
  StateList<StateCondition> result;
  if (state == ElementState::free) return result;
  if (state == ElementState::lift) {
    if (kind.start != ElementKind::Start::open) result.add(StateCondition::opens);
    return result;
  }
  if (kind.law == ElementKind::Law::limited) {
    result.add(StateCondition::static_limit);
    result.add(StateCondition::kinetic_limit);
  } else if (!(kind.law == ElementKind::Law::frictionless && kind.bilateral)) {
    result.add(is_pulled(state) ? StateCondition::pulls : StateCondition::pushes);
  }
  if (state == ElementState::touch || kind.law == ElementKind::Law::cone) return result;
  const int direction = slip_direction(state);
  if (direction == 0) {
    result.add(StateCondition::holds_forward);
    result.add(StateCondition::holds_backward);
  } else if (!kind.slides()) {
    result.add(direction > 0 ? StateCondition::slips_forward : StateCondition::slips_backward);
  }
  return result;
}

}  // namespace slipproof
