// The statements whose proofs together prove a claim of a claims file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "claims/paper/claims_file.hpp"
#include "proofs/statement/statement_text.hpp"

namespace slipproof {

/// The claim in a reading as statements (proofs/FORMAT.md) about the raw equations of the model: ID, or ID with
/// suffixes that ClaimKind::state() of its kind names; and ID.defined..., if it assumes something with a divisor that
/// is not plainly of one sign. The repaired reading adds `.repaired` to ID if it differs. Empty if statements cannot
/// express the claim: `limit` without `from`, modes that are not modelled, and claims that would take too many cases.
std::vector<NamedStatement> claim_statements(const ClaimsFile& claims, const Claim& claim, Reading reading);

/// For a claim that is false: ID.refuted states that there are a bicycle, a force and, if the claim is about motions, a
/// motion against it; for a claim that some motion exists, that there is none. Empty if statements cannot express this,
/// for `limit`, and if the claim fails in another way.
std::vector<NamedStatement> claim_refutation(const ClaimsFile& claims, const Claim& claim, Reading reading);

/// What `expect` asks for: the statements of the claim, or those of its refutation if it says refuted; none if it says
/// undecided.
std::vector<NamedStatement> expected_statements(const ClaimsFile& claims, const Claim& claim, Reading reading);

/// Which claim has the statements of each name: V with two modes and V.1 would both have a V.1.
class StatementNames {
 public:
  explicit StatementNames(const ClaimsFile& claims) : claims_(claims) {}
  /// Throws InputError if one of the statements has the name of another claim's.
  void add(const Claim& claim, const std::vector<NamedStatement>& statements);

 private:
  const ClaimsFile& claims_;
  std::map<std::string, const Claim*> claim_of_;
};

/// In the domain of a setting, `given` implies `shown`. Both may use the unknowns of the model and the quantities of a
/// motion; these may be any numbers unless a motion is required.
struct Implication {
  std::string name;
  std::size_t setting = 0;
  std::vector<Expression> given;
  Expression shown;
  bool force_domain = true;           ///< the force is in its domain; if not, it is any number
  bool on_road = false;               ///< the unknowns satisfy the model's equations with both wheels on the road
  std::optional<MechanismMode> mode;  ///< the unknowns are a motion in this mode
};

/// The implication, in the printed reading, as a statement; nothing if statements cannot express it.
std::optional<std::string> implication_statement(const ClaimsFile& claims, const Implication& implication);

}  // namespace slipproof
