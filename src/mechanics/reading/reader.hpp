// Inside the reading of mechanism files: what its parts share.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/input/table_reader.hpp"
#include "mechanics/bodies/bodies.hpp"
#include "mechanics/mechanism/mechanism.hpp"
#include "mechanics/mechanism/names.hpp"

namespace slipproof::mechanism_reader {

class Context {
 public:
  Context(Mechanism& result, Mistakes& list) : mechanism(result), mistakes(list) {}

  /// The expression of a key's string. A mistake is reported and leaves it null, as does an absent key.
  PlacedExpression expression(const TableReader& table, std::string_view key, Sort sort);
  PlacedExpression expression(const TomlValue& value, std::string_view name, Sort sort);
  /// A condition: `real` and an absent one are `true`.
  PlacedExpression condition(const TableReader& table, std::string_view key);
  PlacedExpression condition(const TomlValue& value, std::string_view name);
  /// The text of a key; empty if it is absent or, which is reported, no string.
  std::string text(const TableReader& table, std::string_view key);
  /// The text of a required key.
  std::string required(const TableReader& table, std::string_view key, std::string_view expected);

  /// A symbol that nothing else in the mechanism has; it is reported if not.
  void declare(const std::string& symbol, Place place);
  /// Declares the name of an element among those of elements; returns whether it is valid.
  bool declare_element(const std::string& name, Place place);

  void refuse(const PlacedExpression& placed, const Expression& part, std::string_view key,
              const std::string& message) {
    mistakes.add(placed.place(part), std::string(key) + ": " + message);
  }

  Mechanism& mechanism;
  Mistakes& mistakes;
  bool bodies_named_well = true;  ///< false: what one is called is a mistake, so that it may be meant elsewhere
  bool sound = true;              ///< false if some expression could not be read; missing symbols may occur in it

 private:
  PlacedExpression parsed(const PlacedText& text, std::string_view name, Sort sort);

  std::vector<std::string> symbols_, elements_;
};

/// No file has more of anything: the work of reading one is bounded.
inline constexpr std::size_t max_symbols = 1'000, max_unknowns = 64, max_elements = 64, max_shapes = 1'000;
/// Of scenes by bodies: for `rest`, which tries no modes, and in space, where none is tried by itself. In the plane
/// ProblemMaker refuses more than max_elements where motions are asked for.
inline constexpr std::size_t max_scene_elements = 2'000, max_scene_bodies = 600;
/// Returns whether count <= limit; otherwise reports it.
bool within(std::size_t count, std::size_t limit, std::string_view key, Place place, Mistakes& mistakes);

/// [parameters], [assume], [realisable], [definitions], [angles], [load], [unknowns].
void read_symbols(const TableReader& root, Context& context);
/// [[contact]], [[friction]], [[link]], [[shape]]. After the symbols.
void read_elements(const TableReader& root, Context& context);
/// [[shape]] alone, beside the pictures of bodies.
void read_shapes(const TableReader& root, Context& context);
/// gravity, [[body]], [[contact]], [[joint]], [[friction]], [[force]], [[torque]]: elements and unknowns of the
/// mechanism, with what their equations follow from. In place of [unknowns], elements and equations.
Bodies read_bodies(const TableReader& root, Context& context);
/// Reports wrong symbols in the expressions of bodies, as check_uses() does.
void check_uses(Bodies& bodies, Context& context);
/// [motion] or [equations], [units], energy. After the elements.
void read_equations(const TableReader& root, Context& context);
/// Symbols that do not exist or must not be used where they are, and expressions too large to evaluate. Those become
/// null. When everything is read.
void check_uses(Context& context);
/// Checks the complete file: accelerations that occur nowhere, the number of equations.
void check_whole(Context& context);

/// Reports conditions of the domain that exclude each other, if linear ones show it. Only for files without other
/// mistakes.
void check_domain(Context& context);

/// "rest", "slides+", "slides-", "open", in space "rest", "slides", "open"; nothing, and a report "KEY: found ..." at
/// the place, for anything else and for what the element cannot be.
std::optional<ElementKind::Start> read_start(std::string_view text, std::string_view key, Place place,
                                             const ElementKind& kind, std::size_t dimension, Mistakes& mistakes);

}  // namespace slipproof::mechanism_reader
