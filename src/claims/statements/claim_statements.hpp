// The statements whose proofs together prove a claim of a claims file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "claims/paper/claims_file.hpp"
#include "proofs/statement/statement_text.hpp"

namespace slipproof {

/// The claim in a reading as statements (proofs/FORMAT.md) about the raw equations of the model:
/// - interval: ID.only-then (a motion of the mode needs a force of `forces`) and ID.always (each such force has one);
/// - impossible, formula: ID, or ID.1, ID.2, ... where there are several modes;
/// - cover, consequence: ID;
/// - motions: ID.1, ID.2, ... (there is a motion in each mode), ID.1.one, ... (only one) and ID.complete (each motion
/// is
///   in one of the modes);
/// - equivalence: ID.forwards (where `forces`, there `holds`) and ID.backwards;
/// - system: ID.forwards (the equations follow) and ID.backwards (what meets them can be completed to the rest);
/// - exists: ID;
/// - limit, if it has `from`: ID.eventually (greater values of the parameter have `holds`), ID.from (it is defined)
/// and,
///   where the parameter may be bounded, ID.beyond (there are greater values);
/// - unique: those of unique_statements.hpp;
/// - and where what the claim assumes divides by something that is not plainly of one sign: ID.defined..., that it has
/// a
///   value.
/// The repaired reading adds `.repaired` to ID where it is another one. Empty where statements cannot say what the
/// claim says: `limit` without `from`, modes that are not modelled, and what would take too many cases.
std::vector<NamedStatement> claim_statements(const ClaimsFile& claims, const Claim& claim, Reading reading);

/// For a claim that is false: ID.refuted, that there are a bicycle, a force and (where the claim is about them) a
/// motion against it; of a claim that some motion exists, that there is none. Empty where statements cannot say it, for
/// `limit` and where the claim fails in another way.
std::vector<NamedStatement> claim_refutation(const ClaimsFile& claims, const Claim& claim, Reading reading);

/// Of all claims in all readings: the claim, or, where `expect` says refuted, its refutation; nothing where it says
/// undecided.
std::vector<NamedStatement> paper_statements(const ClaimsFile& claims);

/// The same of one claim in a reading.
std::vector<NamedStatement> expected_statements(const ClaimsFile& claims, const Claim& claim, Reading reading);

/// In the domain of a setting, `given` implies `shown`. Both may use the unknowns of the model and the quantities of a
/// motion; these are any numbers, unless a motion is asked for.
struct Implication {
  std::string name;
  std::size_t setting = 0;
  std::vector<Expression> given;
  Expression shown;
  bool on_road = false;               ///< the unknowns obey the model's equations with both wheels on the road
  std::optional<MechanismMode> mode;  ///< they are a motion in this mode
};

/// The implication, in the printed reading, as a statement; nothing where statements cannot say it.
std::optional<std::string> implication_statement(const ClaimsFile& claims, const Implication& implication);

}  // namespace slipproof
