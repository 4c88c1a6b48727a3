// Physical units with products, quotients and comparison.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace slipproof {

/// A unit such as kg m^2 or N. Values; safe to use from several threads.
class Unit {
 public:
  Unit();  ///< 1

  /// False if the unit could not be computed: a power above the 255th, or any unit if the library's table of units is
  /// missing.
  bool known() const { return unit_ != nullptr; }
  Unit operator*(const Unit& other) const;
  Unit operator/(const Unit& other) const;
  /// The power; nothing for exponents beyond 255.
  std::optional<Unit> power(int exponent) const;
  /// True for equal dimension and size: N and kg m/s^2, but not N and kN.
  bool operator==(const Unit& other) const;
  /// True for equal dimension: N and kN.
  bool same_dimension(const Unit& other) const;
  /// The unit in base units, `m.kg.s-2`; 1 for a number.
  std::string text() const;

 private:
  friend std::optional<Unit> parse_unit(std::string_view text);
  explicit Unit(void* unit);
  std::shared_ptr<void> unit_;  ///< representation of the library
};

/// False if udunits or its table of units is not installed; then no unit is known.
bool has_units();

/// `kg m^2`, `m/s^2`, `N m`, `1`; nothing if it is no unit, or without udunits.
std::optional<Unit> parse_unit(std::string_view text);

}  // namespace slipproof
