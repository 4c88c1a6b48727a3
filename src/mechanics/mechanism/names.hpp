// The meanings of the names in a mechanism's expressions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

enum class NameKind : std::uint8_t {
  parameter,
  angle,  ///< the cosine (2 i) or the sine (2 i + 1) of angle i
  definition,
  load,
  acceleration,  ///< an unknown
  force,         ///< an unknown that no element has
  element_force,
  quantity,   ///< a gap or slip: index in acceleration_names()
  angle_name  ///< of the angle itself, which no expression may use
};
/// "the parameter", "the gap or slip", ...
std::string_view describe(NameKind kind);

/// A set of kinds.
using NameKinds = std::uint16_t;
constexpr NameKinds operator|(NameKind x, NameKind y) {
  return static_cast<NameKinds>((1U << static_cast<unsigned>(x)) | (1U << static_cast<unsigned>(y)));
}
constexpr NameKinds operator|(NameKinds x, NameKind y) {
  return static_cast<NameKinds>(x | (1U << static_cast<unsigned>(y)));
}
constexpr bool contains(NameKinds kinds, NameKind kind) {
  return ((kinds >> static_cast<unsigned>(kind)) & 1U) != 0;
}

class MechanismNames {
 public:
  struct Entry {
    NameKind kind;
    std::size_t index;  ///< among its kind; of unknowns, among all unknowns
  };

  /// Collects the names of a mechanism. If a name is given twice, the first one counts.
  explicit MechanismNames(const Mechanism& mechanism);
  std::optional<Entry> find(std::string_view name) const;
  /// The names of these kinds, in alphabetic order.
  std::vector<std::string_view> names(NameKinds kinds) const;

 private:
  std::map<std::string, Entry, std::less<>> entries_;
};

/// For each definition, whether it depends on the symbol, directly or through others.
std::vector<bool> definitions_with(const Mechanism& mechanism, const MechanismNames& names, std::string_view symbol);

/// "unknown WHAT 'FOUND', did you mean 'A'? expected one of A, B"; of at most 60 names these are listed.
std::string unknown_name(std::string_view what, std::string_view found, const std::vector<std::string_view>& known);

}  // namespace slipproof
