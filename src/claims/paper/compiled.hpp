// A claims file compiled for evaluation.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/expression/evaluate.hpp"
#include "base/expression/program.hpp"
#include "claims/paper/claims_file.hpp"
#include "mechanics/points/problem.hpp"

namespace slipproof {

/// The values of the mechanism's symbols in a setting.
struct CompiledScene {
  std::vector<std::optional<Program>> parameters;   ///< by parameter of the mechanism; nothing: not given
  std::vector<std::pair<Program, Program>> angles;  ///< cosine and sine
  std::optional<Program> load;                      ///< over the force variable; nothing: there is no load

  /// All programs.
  std::vector<const Program*> programs() const;
};

/// The symbols of a setting as slots of one scope: the force, parameters, cosines and sines of angles, the quantities
/// of a motion, then the definitions of each reading. A definition has only one slot if it, and all that it needs, are
/// the same in both readings.
class CompiledSetting {
 public:
  explicit CompiledSetting(const Setting& setting);

  const Scope& scope() const { return scope_; }
  static std::size_t force_slot() { return 0; }
  static std::size_t parameter_slot(std::size_t index) { return 1 + index; }
  /// The slot of a quantity, by its index in Setting::quantities().
  std::size_t quantity_slot(std::size_t index) const { return first_quantity_ + index; }
  std::size_t quantities() const { return quantities_; }
  bool is_quantity(std::size_t slot) const { return slot - first_quantity_ < quantities_; }
  std::size_t definition_slot(std::size_t index, Reading reading) const {
    return definition_slots_[static_cast<std::size_t>(reading)][index];
  }
  /// Compiles an expression of the setting.
  Program compile(const Expression& expression, Reading reading) const;
  /// Compiles an equation between the mechanism's unknowns.
  Program compile_equation(const Expression& equation, Reading reading) const;
  /// The slot of an unknown of the mechanism, by its index; unknowns are quantities, too.
  std::size_t unknown_slot(std::size_t index) const { return unknown_slots_[index]; }
  std::size_t unknowns() const { return unknown_slots_.size(); }
  /// Replaces a definition, given by its index, by another expression, which must not lead back to it: in the printed
  /// reading, and in the repaired one if the definition is the same there.
  void redefine(std::size_t index, const Expression& expression);

  struct Boundary {
    std::size_t parameter;  ///< index
    Program value;
  };
  /// The values at which parameters are on a boundary; both readings if they differ.
  const std::vector<Boundary>& boundaries() const { return boundaries_; }
  /// Whether a program of the setting depends on the force or on a quantity.
  bool varies(const Program& program) const;
  /// The conditions that a point must meet to be realisable, in the order of Setting::realisable.
  const std::vector<Program>& realisable() const { return realisable_; }
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
  /// Makes problems of the setting's mechanism with its states before the motion.
  const ProblemMaker& maker() const { return *maker_; }
  const Mechanism& mechanism() const { return *mechanism_; }
  const std::vector<ElementKind::Start>& starts() const { return starts_; }
  /// The elements with the states that are modelled; complete(): whether all states of all elements are.
  const std::vector<ElementKind>& kinds() const { return kinds_; }
  bool complete() const { return complete_; }

 private:
  void compile_scene(const Setting& setting);
  std::optional<std::size_t> resolve(std::string_view symbol, Reading reading) const;
  /// Whether the expression depends on the force or on a quantity.
  bool varies(const Expression& e, Reading reading) const;
  /// A condition in which functions of varying numbers are written as cases, so that its truth over all forces can be
  /// found. A function that takes too many cases stays, and is undecided.
  Expression prepared(const Expression& e, Reading reading) const;
  void find_varying();
  /// The expression with those definitions written out that contain functions of varying numbers.
  Expression written_out(const Expression& e, Reading reading) const;

  Scope scope_;
  std::vector<bool> varying_;  ///< by slot
  std::size_t first_quantity_ = 0, quantities_ = 0;
  std::vector<std::size_t> unknown_slots_;
  std::map<std::string, std::size_t, std::less<>> slots_;  ///< slots of all symbols that are not definitions
  std::map<std::string, std::size_t, std::less<>> definition_indices_;
  std::array<std::vector<std::size_t>, 2> definition_slots_;
  std::array<std::vector<Expression>, 2> definitions_;  ///< by reading
  std::string force_;
  std::vector<Boundary> boundaries_;
  std::vector<Program> realisable_;
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

/// Assigns values from the paper's evaluator to the mechanism's symbols, except the load, in an evaluator over the
/// mechanism's own scope. False if a symbol has no value, or one that does not fit.
template <class T, class Field, class Fits>
bool put_scene(const CompiledSetting& setting, Evaluator<T, Field>& paper, Evaluator<T, Field>& mechanism,
               const Fits& fits) {
  const CompiledMechanism& compiled = setting.maker().compiled();
  const auto put = [&](std::size_t slot, const Program& program) {
    auto value = paper.number(program).number;
    if (!value || !fits(*value)) return false;
    mechanism.set(slot, std::move(*value));
    return true;
  };
  const CompiledScene& scene = setting.scene();
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

/// The compiled expressions of a body; `true` for conditions that its kind does not have.
struct CompiledBody {
  Program region;
  Program forces;
  Program closure;  ///< the closure of `forces`, which includes its ends
  Program holds;
  std::vector<Program> equations, assume;
};

struct CompiledClaim {
  CompiledBody printed;
  std::optional<CompiledBody> repaired;

  const CompiledBody& body(Reading reading) const {
    return reading == Reading::repaired && repaired ? *repaired : printed;
  }
};

/// The compiled settings and claims, in the order of the file.
struct CompiledClaims {
  explicit CompiledClaims(const ClaimsFile& file);

  std::vector<CompiledSetting> settings;
  std::vector<CompiledClaim> claims;
};

}  // namespace slipproof
