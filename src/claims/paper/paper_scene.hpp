// What a paper says of a mechanism: which one it is, its state before the motion, and the values of its symbols.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/expression/expression.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

struct PaperScene {
  std::shared_ptr<const Mechanism> mechanism;
  std::string mechanism_name;              ///< the name in the file; `bicycle` for settings in the old form
  std::string along;                       ///< a parameter that is used as the load; empty: the mechanism's own load
  std::vector<ElementKind::Start> starts;  ///< the states of the elements before the motion
  /// The values of the mechanism's symbols: given parameters, cosines and sines of angles, over the paper's parameters;
  /// and the load, over the force, too.
  std::map<std::string, Expression, std::less<>> scene;

  /// Writes an expression over the mechanism's parameters, definitions, angles and load in the paper's symbols.
  Expression in_paper(const Expression& of_mechanism) const;
  /// For each parameter of the mechanism, whether it is given.
  std::vector<bool> given() const;
  /// The elements with the states that are modelled, taking all parameters as given, as modes are written.
  std::vector<ElementKind> kinds() const;
  std::vector<ElementKind> all_kinds() const;
  /// The names of a motion's quantities that `holds` may use: accelerations, gaps, slips, then forces.
  std::vector<std::string> quantities() const;
  /// The index among the mechanism's unknowns of the unknown with this symbol; nothing if there is none.
  std::optional<std::size_t> unknown_index(std::string_view symbol) const;
};

}  // namespace slipproof
