// A claims file made ready for evaluation.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "claims/claims_file.hpp"
#include "expression/evaluate.hpp"
#include "expression/program.hpp"
#include "model/equations.hpp"

namespace slipproof {

/// The unknowns of the model's equations, as `equations` of claims call them, in the order of slipproof::Unknowns.
inline constexpr std::array<std::string_view, unknown_count> unknown_names{"a", "a_y", "phi", "eps1", "eps2", "eps3",
                                                                           "T", "S2",  "S3",  "N2",   "N3"};
std::optional<std::size_t> unknown_index(std::string_view symbol);

/// A setting's symbols as slots of one scope: quantities, the force, parameters, then the definitions of each reading.
/// A definition that is the same in both readings, with all that it needs, has one slot.
class CompiledSetting {
 public:
  explicit CompiledSetting(const Setting& setting);

  const Scope& scope() const { return scope_; }
  static std::size_t quantity_slot(Quantity quantity) { return static_cast<std::size_t>(quantity); }
  static std::size_t force_slot() { return quantity_count; }
  static std::size_t parameter_slot(std::size_t index) { return quantity_count + 1 + index; }
  std::size_t definition_slot(std::size_t index, Reading reading) const {
    return definition_slots_[static_cast<std::size_t>(reading)][index];
  }
  /// An expression of the setting.
  Program compile(const Expression& expression, Reading reading) const;
  /// An equation between the model's unknowns, which hide symbols of the same name.
  Program compile_equation(const Expression& equation, Reading reading) const;
  std::size_t unknown_slot(std::size_t index) const { return first_unknown_ + index; }
  /// Gives a definition, by its index, another expression, which must not lead back to it. In the printed reading, and
  /// in the other one if the definition is the same there.
  void redefine(std::size_t index, const Expression& expression);

  struct Boundary {
    std::size_t parameter;  ///< index
    Program value;
  };
  /// The values at which parameters are on a boundary, those of both readings where they differ.
  const std::vector<Boundary>& boundaries() const { return boundaries_; }
  /// What a bicycle that can be built has to meet, in the order of Setting::realisable.
  const std::vector<Program>& realisable() const { return realisable_; }
  /// By parameter.
  const std::vector<Program>& domains() const { return domains_; }
  const Program& force_domain() const { return *force_domain_; }
  /// Whether the values of the parameters are those of a bicycle, as one condition: domains and scene.
  const Program& is_bicycle() const { return *is_bicycle_; }
  /// In the order of scene_symbols; nothing for J if the setting does not have it.
  const std::vector<std::optional<Program>>& scene() const { return scene_; }

 private:
  std::optional<std::size_t> resolve(std::string_view symbol, Reading reading) const;
  /// Whether it depends on the force or on a quantity.
  bool varies(const Expression& e, Reading reading) const;
  /// Conditions, with functions of what varies as cases, so that the truth over all forces can be told; what takes too
  /// many cases stays, and is undecided.
  Expression prepared(const Expression& e, Reading reading) const;
  /// With the definitions written out that have functions of what varies.
  Expression written_out(const Expression& e, Reading reading) const;

  Scope scope_;
  std::size_t first_unknown_ = 0;
  std::map<std::string, std::size_t, std::less<>> slots_;  ///< of what is no definition
  std::map<std::string, std::size_t, std::less<>> definition_indices_;
  std::array<std::vector<std::size_t>, 2> definition_slots_;
  std::array<std::vector<Expression>, 2> definitions_;  ///< by reading
  std::string force_;
  std::vector<Boundary> boundaries_;
  std::vector<Program> realisable_;
  std::vector<Program> domains_;
  std::optional<Program> force_domain_, is_bicycle_;
  std::vector<std::optional<Program>> scene_;
};

/// The expressions of a body; `true` for conditions that its kind does not have.
struct CompiledBody {
  Program region;
  Program forces;
  Program closure;  ///< of `forces`, with its ends
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

/// In the order of the file.
struct CompiledClaims {
  explicit CompiledClaims(const ClaimsFile& file);

  std::vector<CompiledSetting> settings;
  std::vector<CompiledClaim> claims;
};

}  // namespace slipproof
