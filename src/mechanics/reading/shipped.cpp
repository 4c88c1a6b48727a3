#include "mechanics/reading/shipped.hpp"

#include <algorithm>
#include <filesystem>

#include "base/input/diagnostic.hpp"
#include "mechanics/mechanism/names.hpp"
#include "mechanics/reading/read_mechanism.hpp"

namespace slipproof {

const ShippedMechanism* find_shipped(std::string_view name) {
  const auto& all = shipped_mechanisms();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Mechanism read_shipped(const ShippedMechanism& shipped, std::optional<ImpactRequest> impact) {
  Mechanism mechanism = parse_mechanism(shipped.text, std::string(shipped.name) + ".toml", impact);
  mechanism.shipped = true;
  return mechanism;
}

Mechanism open_mechanism(const std::string& file_or_name, const std::string& directory, MechanismRequest request) {
  const std::filesystem::path path = std::filesystem::path(directory) / file_or_name;
  std::error_code error;
  const bool is_there = !file_or_name.empty() && std::filesystem::exists(path, error);
  if (const ShippedMechanism* shipped = find_shipped(file_or_name); shipped != nullptr && !is_there) {
    return read_shipped(*shipped, request.impact);
  }
  if (!is_there && path.extension() != ".toml") {
    std::vector<std::string_view> known;
    for (const ShippedMechanism& one : shipped_mechanisms()) known.push_back(one.name);
    Mistakes mistakes("");
    mistakes.add({}, "no such file, and " + unknown_name("mechanism", file_or_name, known));
    mistakes.refuse_if_any();
  }
  Mechanism mechanism = read_mechanism(path, request.impact);
  refuse_other(mechanism, request.dimensions);
  return mechanism;
}

}  // namespace slipproof
