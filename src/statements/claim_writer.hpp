// Statements about a setting of a claims file, line by line; claim_statements.cpp and claim_refutations.cpp say which.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "statements/claim_statements.hpp"
#include "statements/setting_writer.hpp"

namespace slipproof {

class ClaimWriter : public SettingWriter {
 public:
  ClaimWriter(const ClaimsFile& claims, const Claim& claim, Reading reading);

  const ClaimsFile& claims() const { return claims_; }
  const Claim& claim() const { return claim_; }
  const ClaimBody& body() const { return body_; }

  using Assumptions = std::vector<std::pair<std::string, Expression>>;  ///< by name; `true` is left out

  /// For all parameters with `assumptions`, and all motions: `shown`.
  struct Implication {
    std::string suffix;
    Assumptions assumptions;
    std::optional<MotionText> motion = {};
    bool force_domain = true;  ///< whether the force is where the paper stands
    std::string hints = {};    ///< lines after the assumptions
  };
  void implied(const Implication& implication, const Expression& shown);
  void implied(const Implication& implication, const std::string& shown, const std::vector<Expression>& uses);
  /// For all parameters with `assumptions`, and all values of the other unknowns, some `unknowns` with `shown`.
  void exists(const Implication& implication, const std::vector<std::string>& unknowns, const MotionText& shown,
              const std::vector<Expression>& uses = {});
  /// The same of all unknowns of a motion.
  void exists(const Implication& implication, const MotionText& motion);
  /// No parameters with `assumptions` have all of `motions` at once.
  void impossible_together(const std::string& suffix, const Assumptions& assumptions,
                           const std::vector<MotionText>& motions);
  /// Between the boundaries of the setting that `regions` name, all of one parameter, in the order in which the setting
  /// lists them; a boundary belongs to the cell above it. Whatever their order, every value lies in one.
  std::vector<Expression> cells(const std::vector<Expression>& regions) const;
  /// Hints to split at the boundaries that are numbers.
  std::string hints_to_numbers() const;
  /// Some parameters, force and motion with all of `truths`.
  void somewhere(const std::string& suffix, const std::vector<Expression>& truths,
                 const std::vector<MotionText>& motions, const std::vector<Expression>& more_uses = {});

  /// Empty where something could not be said.
  std::vector<NamedStatement> take() { return complete() ? std::move(statements_) : std::vector<NamedStatement>{}; }

 private:
  std::string opening(const std::string& suffix);
  /// The lines of the assumptions; what the scene has to define for them joins `uses`.
  std::string assumed(const Assumptions& assumptions, std::vector<Expression>& uses);

  const ClaimsFile& claims_;
  const Claim& claim_;
  const ClaimBody& body_;
  std::string name_;
  std::vector<NamedStatement> statements_;
};

/// The equations of claims, and others.
std::vector<Expression> equations_of(const ClaimWriter& writer, const std::vector<std::size_t>& claims,
                                     const std::vector<Expression>& others);
/// Joined by `and`.
Expression all_of(const std::vector<Expression>& truths);

}  // namespace slipproof
