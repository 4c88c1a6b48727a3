// The modes that records claim, by numbers.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/elements/element.hpp"

namespace slipproof {

/// Stands for a record that claims no mode.
inline constexpr std::uint16_t no_mode = 0xFFFF;

/// Numbers the modes of a mechanism: in the order of enumeration, or, if there are more than max_modes, in the order in
/// which they occur. Thread-safe.
class RecordModes {
 public:
  explicit RecordModes(std::vector<ElementKind> kinds);

  bool has_all() const { return has_all_; }
  /// The number of modes, or of those that have occurred.
  std::size_t size() const;
  const MechanismMode& mode(std::size_t number) const;
  const std::string& name(std::size_t number) const;
  /// The number of a mode; nothing if the name is not a mode of the mechanism, or if more than 65,535 have occurred.
  std::optional<std::uint16_t> find(std::string_view name);
  /// A mode, to show how they are written.
  std::string example() const;

 private:
  std::optional<MechanismMode> parsed(std::string_view name) const;
  std::uint16_t add(MechanismMode mode);

  std::vector<ElementKind> kinds_;
  bool has_all_;
  mutable std::mutex mutex_;
  std::deque<MechanismMode> modes_;  // whose elements stay where they are
  std::deque<std::string> names_;
  std::map<std::string, std::uint16_t, std::less<>> places_;
};

}  // namespace slipproof
