// The law of impact that a file names.
#pragma once

#include <optional>

#include "base/input/table_reader.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

inline constexpr std::string_view expected_impact_laws = "\"newton\", \"moreau\" or \"poisson\"";  ///< for messages

/// The value of the key `law`; nothing without the key. Reports any other value.
std::optional<ImpactLaw> read_impact_law(const TableReader& table);

}  // namespace slipproof
