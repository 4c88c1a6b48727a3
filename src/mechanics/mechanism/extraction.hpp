// Inside the extraction of forms: expressions as linear combinations of some of their symbols.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/expression/cases.hpp"
#include "mechanics/mechanism/mechanism.hpp"
#include "mechanics/mechanism/names.hpp"

namespace slipproof::mechanism_forms {

/// An expression that is not linear, and its place.
struct NotLinear {
  Expression where;
  std::string message;
};

struct Linear {
  Expression constant;                      ///< never null
  std::map<std::size_t, Expression> terms;  ///< by unknown; the number of unknowns is the index of the load
};

class Extraction {
 public:
  /// The mechanism must outlive the extraction.
  explicit Extraction(const Mechanism& mechanism);
  Extraction(const Extraction&) = delete;
  Extraction& operator=(const Extraction&) = delete;

  /// Throws NotLinear.
  Linear linear(const Expression& expression) const;
  /// Throws NotLinear.
  SymbolicForm form(const Expression& expression) const;
  SymbolicForm form(const Linear& linear) const;
  /// True if the expression contains no division, directly or in a definition; it may be left out of a form, since it
  /// has a value everywhere.
  bool divides_by_nothing(const Expression& expression) const;
  /// Whether the load occurs, directly or in a definition.
  bool has_load(const Expression& expression) const;
  const MechanismNames& names() const { return names_; }

 private:
  Linear scaled(const Linear& linear, const Expression& factor, bool factor_first) const;
  Linear symbol(const Expression& expression) const;
  Linear product(const Expression& expression) const;
  Linear sum(const Expression& expression) const;
  std::string variable(const Linear& linear) const;
  bool uses(const Expression& expression, const std::vector<bool>& definitions) const;

  const Mechanism& mechanism_;
  MechanismNames names_;
  std::vector<bool> loaded_;    ///< by definition: whether it depends on the load
  std::vector<bool> dividing_;  ///< by definition: whether it divides
  OfExpression defined_;        ///< divides_by_nothing()
};

}  // namespace slipproof::mechanism_forms
