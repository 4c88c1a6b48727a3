// The mechanisms that come with slipproof, found by name, without a path.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

struct ShippedMechanism {
  std::string_view name;  ///< its file's stem
  std::string_view text;
};

/// The mechanisms that slipproof ships, in alphabetic order.
const std::vector<ShippedMechanism>& shipped_mechanisms();
/// Null if no shipped mechanism has this name.
const ShippedMechanism* find_shipped(std::string_view name);
Mechanism read_shipped(const ShippedMechanism& shipped, std::optional<ImpactRequest> impact = {});

/// The mechanism of a file, or the shipped one of this name if there is no such file. A relative path counts from
/// `directory`, or from the working directory if that is empty. Throws InputError.
Mechanism open_mechanism(const std::string& file_or_name, const std::string& directory = {},
                         MechanismRequest request = Dimensions::plane);

}  // namespace slipproof
