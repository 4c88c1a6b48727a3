#include "report/phase/plane_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "mechanics/bicycle/contact_mode.hpp"
#include "mechanics/bicycle_modes/bicycle_motions.hpp"

namespace slipproof {

namespace {

std::string wheels_in_words(const MechanismMode& mode) {
  constexpr std::array<std::string_view, 4> does{"rolls", "slips forwards", "slips backwards", "is off the road"};
  const auto rear = static_cast<std::size_t>(mode[0]), front = static_cast<std::size_t>(mode[1]);
  if (rear != front) return fmt::format("rear wheel {}, front wheel {}", does[rear], does[front]);
  constexpr std::array<std::string_view, 4> both{"roll", "slip forwards", "slip backwards", "are off the road"};
  return fmt::format("both wheels {}", both[rear]);
}

/// The quantities of the model, where the mechanism of the bicycle has them.
std::vector<MotionQuantity> model_quantities() {
  const auto accelerations = acceleration_names(bicycle_mechanism()), forces = force_names(bicycle_mechanism());
  std::vector<MotionQuantity> all;
  for (const Quantity quantity : all_quantities()) {
    const std::string_view symbol = name(quantity);
    const auto force = std::find(forces.begin(), forces.end(), symbol);
    const bool is_force = force != forces.end();
    const auto place = is_force ? force - forces.begin()
                                : std::find(accelerations.begin(), accelerations.end(), symbol) - accelerations.begin();
    all.push_back({std::string(symbol), is_force, static_cast<std::size_t>(place)});
  }
  return all;
}

std::string state_in_words(ElementState state) {
  static constexpr std::array<std::string_view, 8> words{
      "sticks",  "slips (+)",      "slips (-)",         "is open",
      "touches", "sticks, pulled", "slips (+), pulled", "slips (-), pulled"};
  return std::string(words[static_cast<std::size_t>(state)]);
}

std::string mode_in_words(const std::vector<std::string>& elements, const MechanismMode& mode) {
  std::string text;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    text += (text.empty() ? "" : ", ") + elements[i] + " " + state_in_words(mode[i]);
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

void tell_of_bicycles(Plane& plane) {
  plane.quantities = model_quantities();
  plane.words = wheels_in_words;
}

void tell_of_mechanism(Plane& plane, const Mechanism& mechanism) {
  plane.quantities = quantities_of(mechanism);
  std::vector<std::string> elements;
  for (std::size_t i = 0; i < mechanism.elements(); ++i) elements.push_back(element_name(mechanism, i));
  plane.words = [elements](const MechanismMode& mode) { return mode_in_words(elements, mode); };
}

}  // namespace slipproof
