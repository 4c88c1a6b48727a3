// How a paper looks at a mechanism: its symbols and definitions, and what the mechanism's symbols are in them.
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
#include "mechanics/bicycle/bicycle.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// A symbol of the paper that may take any value in its domain.
struct Parameter {
  std::string symbol;
  Expression domain;  ///< over parameters
  std::string meaning;
  std::size_t line = 0;  ///< of the source; 0 if the paper does not have it
  /// The tangent of half of this angle of the paper, among Setting::angles: expressions know its cosine and sine only.
  std::optional<std::size_t> angle = {};

  bool is_positive() const;  ///< its domain says just that, in whatever order
};

/// Two symbols of the paper whose squares add up to 1.
struct PaperAngle {
  std::string name, cosine, sine;
  std::size_t parameter;  ///< index; its domain is that of the angle

  /// The cosine and the sine by the tangent of half of it.
  Expression cosine_value() const;
  Expression sine_value() const;
};

/// The paper's variable for the force, or whatever the load is: the only one that a sample leaves open.
struct ForceVariable {
  std::string symbol;  ///< empty: the mechanism has no load
  Expression domain;   ///< where the paper stands, and the mechanism's own domain; over parameters and the force
  std::size_t line = 0;
};

/// A parameter set to the value at which something changes: `b = b1`.
struct Boundary {
  std::string symbol;
  Expression value;  ///< over parameters and definitions, independent of the symbol and of the force
};

/// Something that one could build has to meet.
struct Realisable {
  std::string name;
  Expression condition;  ///< over parameters and definitions, these as repaired; independent of the force
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
  /// The paper uses the symbol and does not say what it is; it stands in the file as a quotient by 0.
  bool is_nowhere(Reading reading) const;
};

/// What a definition is called in references and lists: `3.1.b1`, or its symbol where the paper gives it no number.
std::string id(const Definition& definition);

/// One way in which the paper looks at a mechanism: which symbols are free and what they are in a scene of it.
struct Setting {
  std::string id;
  std::string statement;
  std::size_t line = 0;
  std::shared_ptr<const Mechanism> mechanism;
  std::string mechanism_name;              ///< as the file names it; of the bicycle of old settings, `bicycle`
  std::string along;                       ///< another parameter as the load; empty: the mechanism's own
  std::vector<ElementKind::Start> starts;  ///< of the elements, before the motion
  bool strict = true;                      ///< the paper's motions satisfy their conditions strictly
  std::vector<Parameter> parameters;
  std::vector<PaperAngle> angles;
  ForceVariable force;
  /// What the symbols of the mechanism are: parameters that are given, cosines and sines of angles over the paper's
  /// parameters; the load over the force, too.
  std::map<std::string, Expression, std::less<>> scene;
  std::vector<Definition> definitions;  ///< each uses only symbols that do not lead back to it
  std::vector<Boundary> boundaries;
  std::vector<Realisable> realisable;  ///< none: nothing is said about what can be built

  /// What an expression over the mechanism's parameters, definitions, angles and load is in the paper's symbols.
  Expression in_paper(const Expression& of_mechanism) const;
  /// Whether each parameter of the mechanism is given.
  std::vector<bool> given() const;
  /// The elements as their states are modelled; with all parameters given, as modes are written.
  std::vector<ElementKind> kinds() const;
  std::vector<ElementKind> all_kinds() const;
  /// Names of what a motion consists of, as `holds` knows them: accelerations, gaps, slips, then forces.
  std::vector<std::string> quantities() const;
  /// Of a symbol of an unknown of the mechanism, among its unknowns.
  std::optional<std::size_t> unknown_index(std::string_view symbol) const;

  /// What makes the scene a point of the mechanism, and the load a polynomial of degree 1 at most in the force.
  struct PointConditions {
    std::vector<Expression> truths;   ///< domains, assumptions, and that no coefficient divides by 0
    std::vector<Expression> defined;  ///< numbers that have to have a value
    Expression slope;  ///< of the load in the force variable, not 0; null if that is not linear as it stands
  };
  PointConditions point_conditions() const;

  /// Of a symbol that is a parameter.
  std::size_t parameter_index(std::string_view symbol) const;
};

}  // namespace slipproof
