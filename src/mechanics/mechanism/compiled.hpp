// A mechanism made ready for evaluation over any number type: names resolved once.
//
//   const CompiledMechanism compiled(mechanism);
//   Evaluator<T> at(compiled.scope());
//   at.set(compiled.parameter(0), ...); ...
//   const auto numbers = coefficients(compiled.equations[0], at, mechanism.unknowns.size());
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "base/expression/evaluate.hpp"
#include "mechanics/mechanism/forms.hpp"
#include "mechanics/mechanism/mechanism.hpp"
#include "mechanics/mechanism/names.hpp"

namespace slipproof {

/// A SymbolicForm without its zeros.
struct CompiledForm {
  std::vector<std::pair<std::size_t, Program>> terms;  ///< by unknown; the number of unknowns is the index of the load
  std::optional<Program> constant;                     ///< nothing: 0
};

/// A CompiledForm at a point: the coefficients of the unknowns and of the load, and the constant. Nothing if one of
/// them has no value, for example because of a division by zero.
template <class T, class Field>
std::optional<std::vector<T>> coefficients(const CompiledForm& form, Evaluator<T, Field>& at, std::size_t unknowns) {
  std::vector<T> result(unknowns + 2, at.field().constant(Rational(0)));
  for (const auto& [unknown, program] : form.terms) {
    auto value = at.number(program);
    if (!value.number) return std::nullopt;
    result[unknown] = std::move(*value.number);
  }
  if (form.constant) {
    auto value = at.number(*form.constant);
    if (!value.number) return std::nullopt;
    result[unknowns + 1] = std::move(*value.number);
  }
  return result;
}

struct CompiledContact {
  CompiledForm gap, slip, second;                            ///< accelerations; the second slip in space
  std::optional<Program> static_friction, kinetic_friction;  ///< nothing: frictionless
  std::vector<Program> sliding;                              ///< MechanismContact::sliding
  std::vector<Program> drag;                                 ///< in space: kinetic_friction times each of `sliding`
};

struct CompiledFriction {
  CompiledForm slip, static_limit, kinetic_limit;
};

struct CompiledBound {
  CompiledForm form;  ///< of the load alone
  Relation relation;  ///< to 0: greater, greater_equal or equal
};

/// Conditions and forms of a mechanism as programs over one scope: parameters, cosine and sine of each angle,
/// definitions, and the load.
class CompiledMechanism {
 public:
  explicit CompiledMechanism(const Mechanism& mechanism);

  const Scope& scope() const { return scope_; }
  std::size_t parameter(std::size_t index) const { return index; }
  std::size_t cosine(std::size_t angle) const { return parameters_ + 2 * angle; }
  std::size_t sine(std::size_t angle) const { return parameters_ + 2 * angle + 1; }
  std::size_t definition(std::size_t index) const { return parameters_ + 2 * angles_ + index; }
  std::size_t load() const { return scope_.slots.size() - 1; }  ///< also of a mechanism without one

  /// A number or condition over parameters, angle symbols, definitions and the load.
  Program compile(const Expression& expression) const;
  CompiledForm compile(const SymbolicForm& form) const;

  std::vector<CompiledForm> equations;  ///< those of the file, then the zeros of links
  std::vector<CompiledContact> contacts;
  std::vector<CompiledFriction> friction;
  std::vector<Program> parameter_domains, angle_domains, assume, realisable;
  std::vector<CompiledBound> load_domain;

 private:
  CompiledForm compile(const SymbolicForm& form, std::size_t load) const;

  std::size_t parameters_, angles_, unknowns_;
  MechanismNames names_;
  Scope scope_;
};

}  // namespace slipproof
