// Inside the reading of mechanism files: what elements have in common, whether given by equations or by bodies.
#pragma once

#include "mechanics/reading/reader.hpp"

namespace slipproof::mechanism_reader {

class ElementParts {
 public:
  explicit ElementParts(Context& context) : context_(context), mechanism_(context.mechanism) {}

 protected:
  /// The tables of a key, at most `limit`; reports more.
  std::vector<const TomlValue*> tables(const TableReader& root, std::string_view key, std::size_t limit);
  /// The element's name, declared.
  std::string name_of(const TableReader& table);
  /// The name of a quantity or force: as the file has it, or the default.
  std::string named(const TableReader& table, std::string_view key, const std::string& otherwise);
  /// A new unknown of that name.
  std::size_t unknown(const TableReader& table, std::string_view key, const std::string& otherwise,
                      MechanismUnknown::Role role, std::size_t owner);
  void read_coefficients(const TableReader& table, MechanismContact& contact);
  /// Reads one expression for both, or { static = ..., kinetic = ... }. Reports what cannot be read, and uses 1 in its
  /// place, so that the element keeps its forces.
  void read_two(const TomlValue& value, const std::string& key, PlacedExpression& at_rest, PlacedExpression& in_slip);
  /// `bilateral`, `lift_needs`, `state`.
  void read_contact_states(const TableReader& table, MechanismContact& contact);
  void read_state(const TableReader& table, ElementKind::Start& start, const ElementKind& kind);
  bool in_space() const { return mechanism_.dimension == 3; }
  /// Two coordinates, in space three, or none.
  std::vector<PlacedExpression> coordinates(const TableReader& table, std::string_view key);
  std::vector<PlacedExpression> coordinates(const TomlValue& value, std::string_view key);

  Context& context_;
  Mechanism& mechanism_;
  bool named_well_ = false;  ///< the element's name is fine, and so names may be made of it

 private:
  void read_lift_needs(const TableReader& table, MechanismContact& contact);
};

}  // namespace slipproof::mechanism_reader
