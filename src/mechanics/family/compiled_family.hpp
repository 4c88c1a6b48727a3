// A family compiled for evaluation.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/expression/evaluate.hpp"
#include "base/expression/program.hpp"
#include "mechanics/family/family.hpp"
#include "mechanics/points/problem.hpp"

namespace slipproof {

/// The values of the mechanism's symbols in a family.
struct CompiledScene {
  std::vector<std::optional<Program>> parameters;   ///< by parameter of the mechanism; nothing: not given
  std::vector<std::pair<Program, Program>> angles;  ///< cosine and sine
  std::optional<Program> load;                      ///< over the force variable; nothing: there is no load

  /// All programs.
  std::vector<const Program*> programs() const;
};

/// The symbols of a family as slots of one scope: the force, free parameters, cosines and sines of free angles, and the
/// quantities of a motion; then what a setting adds.
class CompiledFamily {
 public:
  explicit CompiledFamily(const Family& family);

  const Scope& scope() const { return scope_; }
  static std::size_t force_slot() { return 0; }
  static std::size_t parameter_slot(std::size_t index) { return 1 + index; }
  /// The slot of a quantity, by its index in Family::quantities().
  std::size_t quantity_slot(std::size_t index) const { return first_quantity_ + index; }
  std::size_t quantities() const { return quantities_; }
  bool is_quantity(std::size_t slot) const { return slot - first_quantity_ < quantities_; }
  /// The slot of an unknown of the mechanism, by its index; unknowns are quantities, too.
  std::size_t unknown_slot(std::size_t index) const { return unknown_slots_[index]; }
  std::size_t unknowns() const { return unknown_slots_.size(); }
  /// Whether a program of the family depends on the force or on a quantity.
  bool varies(const Program& program) const;

  /// By parameter.
  const std::vector<Program>& domains() const { return domains_; }
  /// By parameter: its value, if its domain is `NAME = CONSTANT`.
  const std::vector<std::optional<Program>>& only_values() const { return only_values_; }
  const Program& force_domain() const { return *force_domain_; }
  /// One condition: whether the values of the parameters are a point of the mechanism, by domains and scene.
  const Program& is_point() const { return *is_point_; }
  const CompiledScene& scene() const { return scene_; }
  /// The part of is_point() about the scene alone, without the slope of the load.
  const Program& is_scene() const { return *is_scene_; }
  /// Makes problems of the family's mechanism with its states before the motion.
  const ProblemMaker& maker() const { return *maker_; }
  const Mechanism& mechanism() const { return *mechanism_; }
  const std::vector<ElementKind::Start>& starts() const { return starts_; }
  /// The elements with the states that are modelled; complete(): whether all states of all elements are.
  const std::vector<ElementKind>& kinds() const { return kinds_; }
  bool complete() const { return complete_; }

 protected:
  /// The slot of a symbol of the family.
  std::optional<std::size_t> find_slot(std::string_view symbol) const;
  /// Whether an expression over the family's symbols alone depends on the force or on a quantity.
  bool varies_itself(const Expression& e) const;
  /// A condition in which functions of numbers that vary are written as cases, so that its truth over all forces can be
  /// found. Null if there are no functions, or if they take too many cases: they stay, and are undecided.
  static Expression in_cases(const Expression& condition, const std::function<bool(const Expression&)>& varies,
                             const std::function<bool(const std::string&)>& may_lack_value);
  /// Finds the slots that vary, among them those that were added.
  void find_varying();

  Scope scope_;

 private:
  Program compile(const Expression& expression) const;
  void compile_scene(const Family& family);

  std::map<std::string, std::size_t, std::less<>> slots_;
  std::vector<bool> varying_;  ///< by slot
  std::size_t first_quantity_ = 0, quantities_ = 0;
  std::vector<std::size_t> unknown_slots_;
  std::vector<Program> domains_;
  std::vector<std::optional<Program>> only_values_;
  std::optional<Program> force_domain_, is_point_, is_scene_;
  std::shared_ptr<const Mechanism> mechanism_;
  std::shared_ptr<const ProblemMaker> maker_;
  std::vector<ElementKind::Start> starts_;
  std::vector<ElementKind> kinds_;
  bool complete_ = true;
  CompiledScene scene_;
};

/// The slots that programs use, each once and ascending: directly, or through definitions.
std::vector<std::size_t> slots_behind(const Scope& scope, const std::vector<const Program*>& programs);

/// Whether the values are inside the domain of one free parameter; in the second form, of all.
bool allows(const CompiledFamily& family, std::size_t parameter, const std::vector<Rational>& values);
bool in_domain(const CompiledFamily& family, const std::vector<Rational>& values);

/// Assigns values from the family's evaluator to the mechanism's symbols, except the load, in an evaluator over the
/// mechanism's own scope. False if a symbol has no value, or one that does not fit.
template <class T, class Field, class Fits>
bool put_scene(const CompiledFamily& family, Evaluator<T, Field>& symbols, Evaluator<T, Field>& mechanism,
               const Fits& fits) {
  const CompiledMechanism& compiled = family.maker().compiled();
  const auto put = [&](std::size_t slot, const Program& program) {
    auto value = symbols.number(program).number;
    if (!value || !fits(*value)) return false;
    mechanism.set(slot, std::move(*value));
    return true;
  };
  const CompiledScene& scene = family.scene();
  for (std::size_t i = 0; i < scene.parameters.size(); ++i) {
    if (!scene.parameters[i]) {
      mechanism.set(compiled.parameter(i), mechanism.field().constant(Rational(0)));
    } else if (!put(compiled.parameter(i), *scene.parameters[i])) {
      return false;
    }
  }
  for (std::size_t i = 0; i < scene.angles.size(); ++i) {
    const auto& [cosine, sine] = scene.angles[i];
    if (!put(compiled.cosine(i), cosine) || !put(compiled.sine(i), sine)) return false;
  }
  return true;
}

}  // namespace slipproof
