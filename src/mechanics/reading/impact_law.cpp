#include "mechanics/reading/impact_law.hpp"

namespace slipproof {

std::optional<ImpactLaw> read_impact_law(const TableReader& table) {
  const PlacedText* law = table.string("law");
  if (law == nullptr) return std::nullopt;
  const auto found = parse_impact_law(law->text());
  if (!found)
    table.refuse("law", "found " + in_quotes(law->text()) + ", expected " + std::string(expected_impact_laws));
  return found;
}

}  // namespace slipproof
