// How a paper describes a mechanism: its symbols and definitions, and the values of the mechanism's symbols in terms of
// them.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/expression/expression.hpp"
#include "claims/paper/paper.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// A symbol of the paper that may have any value in its domain.
struct Parameter {
  std::string symbol;
  Expression domain;  ///< over parameters
  std::string meaning;
  std::size_t line = 0;  ///< in the source; 0 if the paper does not have it
  /// If set, the parameter is the tangent of half of this angle, an index into Setting::angles: expressions contain
  /// only the angle's cosine and sine.
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

/// A value of a parameter at which something changes: `b = b1`.
struct Boundary {
  std::string symbol;
  Expression value;  ///< over parameters and definitions, independent of the symbol and of the force
};

/// A condition that a mechanism must meet if it can be built.
struct Realisable {
  std::string name;
  Expression condition;  ///< over parameters and definitions, in the repaired reading; independent of the force
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

/// One way in which the paper describes a mechanism: which symbols are free, and which scene they give.
struct Setting {
  std::string id;
  std::string statement;
  std::size_t line = 0;
  std::shared_ptr<const Mechanism> mechanism;
  std::string mechanism_name;              ///< the name in the file; `bicycle` for settings in the old form
  std::string along;                       ///< a parameter that is used as the load; empty: the mechanism's own load
  std::vector<ElementKind::Start> starts;  ///< the states of the elements before the motion
  bool strict = true;                      ///< the paper's motions satisfy their conditions strictly
  std::vector<Parameter> parameters;
  std::vector<PaperAngle> angles;
  ForceVariable force;
  /// The values of the mechanism's symbols: given parameters, cosines and sines of angles, over the paper's parameters;
  /// and the load, over the force, too.
  std::map<std::string, Expression, std::less<>> scene;
  std::vector<Definition> definitions;  ///< none uses symbols that lead back to it
  std::vector<Boundary> boundaries;
  std::vector<Realisable> realisable;  ///< empty: the file does not say what can be built

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

  /// The conditions under which the scene is a point of the mechanism and the load is a polynomial of degree at most 1
  /// in the force.
  struct PointConditions {
    std::vector<Expression> truths;   ///< domains, assumptions, and that no divisor in a coefficient is 0
    std::vector<Expression> defined;  ///< numbers that must have a value
    Expression slope;  ///< slope of the load in the force variable, not 0; null if the load is not linear as written
  };
  PointConditions point_conditions() const;

  /// The index of the parameter with this symbol, which must exist.
  std::size_t parameter_index(std::string_view symbol) const;
};

}  // namespace slipproof
