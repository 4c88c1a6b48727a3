// What a record of certify may contain.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace slipproof {

/// Parameters of the scene, in the forms of a scene file, then the solver's answer.
enum class Field : std::uint8_t {
  M,
  R,
  h,
  b2,
  b3,
  I1,
  I2,
  I3,
  r1,
  r2,
  L,
  J,
  f,
  g,
  F,  // NOLINT: the symbols of the model
  h0,
  b,
  M2,
  M3,
  mu,
  P,
  a,
  a_y,
  phi,
  eps2,
  eps3,
  S2,
  S3,
  N2,
  N3
};
inline constexpr std::size_t field_count = 30;
inline constexpr std::size_t direct_count = 15;  ///< Field::M ... Field::F: the parameters of Bicycle, Road and force
inline constexpr std::size_t parameter_count = 21;  ///< and the other forms
inline constexpr std::size_t answer_count = field_count - parameter_count;

inline constexpr std::array<std::string_view, field_count> field_names{
    "M",  "R", "h",  "b2", "b3", "I1", "I2", "I3",  "r1",  "r2",   "L",    "J",  "f",  "g",  "F",
    "h0", "b", "M2", "M3", "mu", "P",  "a",  "a_y", "phi", "eps2", "eps3", "S2", "S3", "N2", "N3"};

constexpr std::size_t index(Field f) {
  return static_cast<std::size_t>(f);
}
constexpr std::uint32_t bit(Field f) {
  return std::uint32_t{1} << index(f);
}

inline std::optional<Field> parse_field(std::string_view name) {
  for (std::size_t i = 0; i < field_count; ++i) {
    if (field_names[i] == name) return static_cast<Field>(i);
  }
  return std::nullopt;
}

}  // namespace slipproof
