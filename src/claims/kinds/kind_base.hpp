// The parts that most kinds of claims have in common.
#pragma once

#include <algorithm>
#include <vector>

#include "claims/identity/claim_change.hpp"
#include "claims/judge/claim_judge.hpp"
#include "claims/paper/claim_kind.hpp"
#include "claims/statements/claim_writer.hpp"

namespace slipproof {

class KindBase : public ClaimKind {
 public:
  using ClaimKind::ClaimKind;

  /// True if its region is empty, or contains none of the forces that the claim is about.
  bool says_nothing(const Implications& logic, std::size_t claim, const ClaimBody& body) const override;
  /// Calls settle_holds() if only `holds` has changed. Otherwise checks whether the claim is about the same bicycles
  /// and forces as before, and then settle_theorem().
  ClaimChange::Result settle(const ClaimChange& change) const override;

 protected:
  using Need = ClaimField::Need;
  using Assumptions = ClaimWriter::Assumptions;
  using Intervals = ClaimJudge::Intervals;

  /// Settles a `holds` that is not equivalent to the old one under `given`.
  virtual ClaimChange::Result settle_holds(const ClaimChange& change, const std::vector<Expression>& given) const;
  /// Settles a changed claim that is true for all parameters.
  virtual ClaimChange::Result settle_theorem(const ClaimChange& change) const;

 private:
  ClaimChange::Result settle_where(const ClaimChange& change) const;
};

inline bool names(const Modes& modes, const MechanismMode& mode) {
  return std::find(modes.begin(), modes.end(), mode) != modes.end();
}

/// Whether the two lists have a mode in common.
inline bool have_common(const Modes& x, const Modes& y) {
  return std::any_of(x.begin(), x.end(), [&](const MechanismMode& mode) { return names(y, mode); });
}

/// The parts cut to `forces`, without empty ones.
inline ClaimJudge::Intervals within(ClaimJudge::Intervals parts, const ForceInterval& forces) {
  for (ForceInterval& part : parts) part.intersect(forces);
  std::erase_if(parts, [](const ForceInterval& part) { return part.empty(); });
  return parts;
}

}  // namespace slipproof
