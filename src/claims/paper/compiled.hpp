// A claims file compiled for evaluation.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "claims/paper/claims_file.hpp"
#include "mechanics/family/compiled_family.hpp"

namespace slipproof {

/// A setting's family, and in the slots behind it the definitions of each reading. A definition has only one slot if
/// it, and all that it needs, are the same in both readings.
class CompiledSetting : public CompiledFamily {
 public:
  explicit CompiledSetting(const Setting& setting);

  std::size_t definition_slot(std::size_t index, Reading reading) const {
    return definition_slots_[static_cast<std::size_t>(reading)][index];
  }
  /// Compiles an expression of the setting.
  Program compile(const Expression& expression, Reading reading) const;
  /// Compiles an equation between the mechanism's unknowns.
  Program compile_equation(const Expression& equation, Reading reading) const;
  /// Replaces a definition, given by its index, by another expression, which must not lead back to it: in the printed
  /// reading, and in the repaired one if the definition is the same there.
  void redefine(std::size_t index, const Expression& expression);

  struct Boundary {
    std::size_t parameter;  ///< index
    Program value;
  };
  /// The values at which parameters are on a boundary; both readings if they differ.
  const std::vector<Boundary>& boundaries() const { return boundaries_; }
  /// The conditions that a point must meet to be realisable, in the order of Setting::realisable.
  const std::vector<Program>& realisable() const { return realisable_; }

 private:
  /// The expression of a definition; null if the symbol is none.
  const Expression* definition(const std::string& symbol, Reading reading) const;
  std::optional<std::size_t> resolve(std::string_view symbol, Reading reading) const;
  /// Whether the expression depends on the force or on a quantity.
  bool may_vary(const Expression& e, Reading reading) const;
  /// A condition in which functions of varying numbers are written as cases.
  Expression prepared(const Expression& e, Reading reading) const;
  /// The expression with those definitions written out that contain functions of varying numbers.
  Expression written_out(const Expression& e, Reading reading) const;

  std::map<std::string, std::size_t, std::less<>> definition_indices_;  ///< but not of symbols of the family
  std::array<std::vector<std::size_t>, 2> definition_slots_;
  std::array<std::vector<Expression>, 2> definitions_;  ///< by reading
  std::vector<Boundary> boundaries_;
  std::vector<Program> realisable_;
};

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
