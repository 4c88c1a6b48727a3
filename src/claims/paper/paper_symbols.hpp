// The symbols of a paper: those that are free, and those that it defines.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/expression/expression.hpp"
#include "claims/paper/paper.hpp"

namespace slipproof {

/// A symbol of the paper that may have any value in its domain.
struct Parameter {
  std::string symbol;
  Expression domain;  ///< over parameters
  std::string meaning;
  std::size_t line = 0;  ///< in the source; 0 if the paper does not have it
  /// If set, the parameter is the tangent of half of this angle, an index into PaperSymbols::angles: expressions
  /// contain only the angle's cosine and sine.
  std::optional<std::size_t> angle = {};

  bool is_positive() const;  ///< whether its domain says exactly that, in either order
};

/// Two symbols of the paper whose squares add up to 1.
struct PaperAngle {
  std::string name, cosine, sine;
  std::size_t parameter;  ///< index of the parameter whose domain is that of the angle

  /// The cosine and the sine in terms of the tangent of the half angle.
  Expression cosine_value() const;
  Expression sine_value() const;
};

/// The paper's variable for the force, or for another load: the only variable that a sample leaves open.
struct ForceVariable {
  std::string symbol;  ///< empty: the mechanism has no load
  /// Where the paper's statements apply, and the mechanism's own domain; over parameters and the force.
  Expression domain;
  std::size_t line = 0;
};

/// A symbol defined by the paper.
struct Definition {
  std::string symbol;
  std::string equation;  ///< number in the paper, `3.1`
  std::size_t line = 0;
  Expression printed;
  Expression repaired;  ///< null: as printed
  std::string why;      ///< why the print must be a misprint

  const Expression& value(Reading reading) const {
    return reading == Reading::repaired && repaired ? repaired : printed;
  }
  /// The paper uses the symbol without a definition; the file defines it as a quotient by 0.
  bool is_nowhere(Reading reading) const;
};

/// The name of a definition in references and lists: `3.1.b1`, or its symbol if the paper gives it no number.
std::string id(const Definition& definition);

/// What the paper speaks of.
struct PaperSymbols {
  std::vector<Parameter> parameters;
  std::vector<PaperAngle> angles;
  ForceVariable force;
  std::vector<Definition> definitions;  ///< none uses symbols that lead back to it

  /// The index of the parameter with this symbol, which must exist.
  std::size_t parameter_index(std::string_view symbol) const;
};

}  // namespace slipproof
