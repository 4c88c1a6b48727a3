#include "mechanics/elements/element.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace slipproof {

namespace {

using Law = ElementKind::Law;
using Start = ElementKind::Start;
using State = ElementState;

constexpr std::array<std::string_view, element_state_count> names{"stick",  "slip+",  "slip-",  "lift", "touch",
                                                                  "stick~", "slip+~", "slip-~", "free", "slip"};

std::vector<State> slipping(Start start) {
  switch (start) {
    case Start::slides_forward:
      return {State::slip_forward};
    case Start::slides_backward:
      return {State::slip_backward};
    default:
      return {State::stick, State::slip_forward, State::slip_backward};
  }
}

/// Of a contact in space.
std::vector<State> closed_in_space(const ElementKind& kind) {
  if (kind.slides()) return {State::slip};
  return kind.slips ? std::vector{State::stick, State::slip} : std::vector{State::stick};
}

State pulled(State state) {
  switch (state) {
    case State::stick:
      return State::pulled_stick;
    case State::slip_forward:
      return State::pulled_slip_forward;
    default:
      return State::pulled_slip_backward;
  }
}

/// Whether a friction element at a contact may be in a state while the contact is in another. A frictionless guide is
/// in one state, whatever the sign of its force.
bool follows(State own, State contact) {
  if (own == State::free || contact == State::lift) return own == State::free && contact == State::lift;
  return contact == State::touch || is_pulled(own) == is_pulled(contact);
}

}  // namespace

std::string_view name(ElementState state) {
  return names[static_cast<std::size_t>(state)];
}

std::string_view name(ElementKind::Start start) {
  constexpr std::array<std::string_view, 4> starts{"rest", "slides+", "slides-", "open"};
  return starts[static_cast<std::size_t>(start)];
}

std::string_view name(ElementKind::Start start, std::size_t dimension) {
  return dimension == 3 && start == ElementKind::Start::slides_forward ? "slides" : name(start);
}

std::optional<ElementState> parse_element_state(std::string_view text) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == text) return static_cast<ElementState>(i);
  }
  return std::nullopt;
}

std::vector<ElementState> states(const ElementKind& kind) {
  const State apart = kind.law == Law::limited ? State::free : State::lift;
  if (kind.start == Start::open) return {apart};
  std::vector<State> result = kind.law == Law::frictionless ? std::vector{State::touch}
                              : kind.law == Law::cone       ? closed_in_space(kind)
                                                            : slipping(kind.start);
  if (kind.law == Law::limited && !kind.contact) return result;
  if (kind.bilateral) {
    if (kind.law == Law::frictionless || kind.law == Law::cone) return result;
    const std::size_t pushed = result.size();
    for (std::size_t i = 0; i < pushed; ++i) result.push_back(pulled(result[i]));
  } else if (kind.lifts) {
    result.push_back(apart);
  }
  return result;
}

bool go_together(const std::vector<ElementKind>& kinds, const MechanismMode& mode) {
  for (std::size_t i = 0; i < mode.size(); ++i) {
    if (kinds[i].contact && !follows(mode[i], mode[*kinds[i].contact])) return false;
  }
  return true;
}

double mode_count(const std::vector<ElementKind>& kinds) {
  double count = 1;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i].contact) continue;
    double own = 0;
    for (const ElementState state : states(kinds[i])) {
      double with = 1;
      for (const ElementKind& kind : kinds) {
        if (kind.contact == i) {
          with *= static_cast<double>(std::ranges::count_if(states(kind), [&](State s) { return follows(s, state); }));
        }
      }
      own += with;
    }
    count *= own;
  }
  return count;
}

std::vector<MechanismMode> modes_of(const std::vector<ElementKind>& kinds) {
  std::vector<std::vector<ElementState>> all;
  for (const ElementKind& kind : kinds) all.push_back(states(kind));
  return modes_of(kinds, all);
}

std::vector<MechanismMode> modes_of(const std::vector<ElementKind>& kinds,
                                    const std::vector<std::vector<ElementState>>& states) {
  std::vector<MechanismMode> modes{MechanismMode{}};
  for (const std::vector<ElementState>& choice : states) {
    std::vector<MechanismMode> longer;
    for (const MechanismMode& mode : modes) {
      for (const ElementState state : choice) {
        longer.push_back(mode);
        longer.back().push_back(state);
        if (!go_together(kinds, longer.back())) longer.pop_back();
      }
    }
    modes = std::move(longer);
  }
  return modes;
}

bool has_state(const ElementKind& kind, ElementState state) {
  const std::vector<ElementState> known = states(kind);
  return std::find(known.begin(), known.end(), state) != known.end();
}

bool has_mode(const std::vector<ElementKind>& kinds, const MechanismMode& mode) {
  return std::equal(kinds.begin(), kinds.end(), mode.begin(), mode.end(), has_state) && go_together(kinds, mode);
}

std::string equal_modes(const std::vector<MechanismMode>& modes) {
  std::string text;
  for (const MechanismMode& mode : modes) text += (text.empty() ? "" : " = ") + name(mode);
  return text;
}

std::string name(const MechanismMode& mode) {
  std::string text;
  for (const ElementState state : mode) {
    if (!text.empty()) text += '/';
    text += name(state);
  }
  return text;
}

}  // namespace slipproof
