// A mechanism with some symbols free: which values the free ones may have, and what the others are in terms of them.
//
//   A ladder against a wall with m = 2 and the coefficient of friction free: parameters = { mu > 0 }, scene = { m: 2,
//   mu: mu, F: F }, force = F.
//
// The setting of a paper has a family in the paper's own symbols; a scene becomes one when a symbol is freed
// (freed_scene.hpp).
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/expression/expression.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// A symbol that may have any value in its domain.
struct FreeParameter {
  std::string symbol;
  Expression domain;  ///< over free parameters
  std::string meaning = {};
  std::size_t line = 0;  ///< in the paper's source; 0 if no paper has it
  /// If set, the parameter is the tangent of half of this angle, an index into Family::angles: expressions contain only
  /// the angle's cosine and sine.
  std::optional<std::size_t> angle = {};

  bool is_positive() const;  ///< whether its domain says exactly that, in either order
};

/// Two symbols whose squares add up to 1.
struct FreeAngle {
  std::string name, cosine, sine;
  std::size_t parameter;  ///< index of the parameter whose domain is that of the angle

  /// The cosine and the sine in terms of the tangent of the half angle.
  Expression cosine_value() const;
  Expression sine_value() const;
};

/// The variable for the force, or for another load: the only variable that a point of the family leaves open.
struct ForceVariable {
  std::string symbol;  ///< empty: the mechanism has no load
  /// The forces that count, within the mechanism's own domain; over free parameters and the force.
  Expression domain;
  std::size_t line = 0;
};

struct Family {
  std::shared_ptr<const Mechanism> mechanism;
  std::vector<ElementKind::Start> starts;  ///< the states of the elements before the motion
  std::vector<FreeParameter> parameters;
  std::vector<FreeAngle> angles;
  ForceVariable force;
  /// The values of the mechanism's symbols: given parameters, cosines and sines of angles, over the free parameters;
  /// and the load, over the force, too.
  std::map<std::string, Expression, std::less<>> scene;

  /// The index of the free parameter with this symbol, which must exist.
  std::size_t parameter_index(std::string_view symbol) const;
  /// Writes an expression over the mechanism's parameters, definitions, angles and load in the family's symbols.
  Expression in_family(const Expression& of_mechanism) const;
  /// Restricts the forces to those that the mechanism's load may have.
  void restrict_force_to_load();
  /// For each parameter of the mechanism, whether it is given.
  std::vector<bool> given() const;
  /// The elements with the states that are modelled, taking all parameters as given, as modes are written.
  std::vector<ElementKind> kinds() const;
  std::vector<ElementKind> all_kinds() const;
  /// The names of a motion's quantities: accelerations, gaps, slips, then forces.
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
};

}  // namespace slipproof
