// What the names in a setting's expressions stand for, and which expressions depend on what.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "claims/paper/claims_file.hpp"

namespace slipproof {

class SettingNames {
 public:
  enum class Kind { parameter, force, quantity, definition };
  struct Entry {
    Kind kind;
    std::size_t index;  ///< index within its kind; 0 for the force; for a cosine or sine, the parameter of its angle
  };

  /// The setting must outlive it. If a name is given twice, the first one counts.
  explicit SettingNames(const Setting& setting);

  std::optional<Entry> find(std::string_view name) const;
  const std::map<std::string, Entry, std::less<>>& all() const { return entries_; }

  /// A definition in the given reading.
  const Expression& definition(std::size_t index, Reading reading) const;

  /// The definitions that an expression needs, directly or through others, by ascending index.
  std::vector<std::size_t> needs(const Expression& expression, Reading reading) const;
  /// Whether an expression depends on a symbol, directly or through definitions.
  bool depends(const Expression& expression, Reading reading, std::string_view symbol) const;
  /// Whether an expression has different meanings in the two readings.
  bool readings_differ(const Expression& expression) const;

 private:
  /// Symbols have ids, in this order: quantities, the force, parameters, definitions.
  std::size_t definitions() const { return quantities_ + 1 + setting_->parameters.size(); }
  std::size_t id(Entry entry) const;
  void add(const std::string& name, Kind kind, std::size_t index) { entries_.try_emplace(name, Entry{kind, index}); }
  void find_reach(Reading reading);
  /// By id, whether an expression depends on the symbol.
  std::vector<bool> reach(const Expression& expression, Reading reading) const;

  const Setting* setting_;
  std::size_t quantities_ = 0;
  std::map<std::string, Entry, std::less<>> entries_;
  std::array<std::vector<std::vector<bool>>, 2> reach_;  ///< by reading, definition and id
};

}  // namespace slipproof
