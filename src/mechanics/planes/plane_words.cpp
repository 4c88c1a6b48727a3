#include "mechanics/planes/plane_words.hpp"

#include <array>
#include <string_view>

namespace slipproof {

namespace {

std::string state_in_words(ElementState state) {
  static constexpr std::array<std::string_view, element_state_count> words{
      "sticks",         "slips (+)",         "slips (-)",         "is open", "touches",
      "sticks, pulled", "slips (+), pulled", "slips (-), pulled", "is free", "slips"};
  return std::string(words[static_cast<std::size_t>(state)]);
}

std::string mode_in_words(const std::vector<std::string>& elements, const MechanismMode& mode, bool in_space) {
  std::string text;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const bool slips = in_space && mode[i] == ElementState::slip_forward;
    text += (text.empty() ? "" : ", ") + elements[i] + " " + (slips ? "slips" : state_in_words(mode[i]));
  }
  return text;
}

std::vector<MotionQuantity> quantities_of(const Mechanism& mechanism) {
  std::vector<MotionQuantity> all;
  for (const std::string& symbol : acceleration_names(mechanism)) all.push_back({symbol, false, all.size()});
  const std::size_t accelerations = all.size();
  for (const std::string& symbol : force_names(mechanism)) all.push_back({symbol, true, all.size() - accelerations});
  return all;
}

}  // namespace

void tell_of_mechanism(Plane& plane, const Mechanism& mechanism) {
  plane.quantities = quantities_of(mechanism);
  std::vector<std::string> elements;
  for (std::size_t i = 0; i < mechanism.elements(); ++i) elements.push_back(element_name(mechanism, i));
  plane.words = [elements, in_space = mechanism.dimension == 3](const MechanismMode& mode) {
    return mode_in_words(elements, mode, in_space);
  };
}

}  // namespace slipproof
