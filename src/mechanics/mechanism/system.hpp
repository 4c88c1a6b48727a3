// The equations of a mechanism and the forms of its elements, over any number type.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mechanics/mechanism/assemble.hpp"

namespace slipproof {

/// The coefficients of the unknowns, of the load, and the constant.
template <class T>
struct FormRow {
  std::vector<T> entries;
};
template <class T>
FormRow<T> operator-(FormRow<T> x) {
  for (T& entry : x.entries) entry = -entry;
  return x;
}
template <class T>
FormRow<T> operator+(FormRow<T> x, const FormRow<T>& y) {
  for (std::size_t i = 0; i < x.entries.size(); ++i) x.entries[i] = x.entries[i] + y.entries[i];
  return x;
}
template <class T>
FormRow<T> operator-(FormRow<T> x, const FormRow<T>& y) {
  for (std::size_t i = 0; i < x.entries.size(); ++i) x.entries[i] = x.entries[i] - y.entries[i];
  return x;
}

template <class T>
struct MechanismSystem {
  std::size_t unknowns = 0;
  std::vector<FormRow<T>> equations;               ///< those of the file, then the zeros of links
  std::vector<FormRow<T>> accelerations, forces;   ///< in the order of acceleration_names() and force_names()
  std::vector<ElementForms<FormRow<T>>> elements;  ///< contacts, then friction elements
};

/// Forms as rows of the numbers of an evaluator, for assemble().
template <class T, class Field>
class RowForms {
 public:
  RowForms(const Mechanism& mechanism, Evaluator<T, Field>& at) : unknowns_(mechanism.unknowns.size()), at_(at) {}

  FormRow<T> form(const CompiledForm& compiled, const std::string& what) {
    auto numbers = coefficients(compiled, at_, unknowns_);
    if (numbers) return {std::move(*numbers)};
    miss(what);
    return unit(0);
  }
  FormRow<T> unit(std::size_t unknown) const {
    FormRow<T> row{std::vector<T>(unknowns_ + 2, at_.field().constant(Rational(0)))};
    row.entries[unknown] = at_.field().constant(Rational(1));
    return row;
  }
  FormRow<T> limit(const Program& coefficient, std::size_t unknown, const std::string& what) {
    auto value = at_.number(coefficient);
    FormRow<T> row = unit(unknown);
    if (!value.number) miss(what);
    if (value.number) row.entries[unknown] = std::move(*value.number);
    return row;
  }

  /// Describes a coefficient without a value; empty if all have one.
  const std::string& without_value() const { return without_value_; }

 private:
  void miss(const std::string& what) {
    if (without_value_.empty()) without_value_ = what;
  }

  std::size_t unknowns_;
  Evaluator<T, Field>& at_;
  std::string without_value_;
};

/// The mechanism's system; the evaluator is over CompiledMechanism::scope(), with all values but the load's. Nothing
/// where a coefficient has no value.
template <class T, class Field>
std::optional<MechanismSystem<T>> system_of(const Mechanism& mechanism, const CompiledMechanism& compiled,
                                            const std::vector<ElementKind>& kinds, Evaluator<T, Field>& at) {
  RowForms<T, Field> forms(mechanism, at);
  MechanismSystem<T> system;
  assemble(mechanism, compiled, kinds, forms, system);
  if (!forms.without_value().empty()) return std::nullopt;
  return system;
}

}  // namespace slipproof
