#include "claims/kinds/kind_base.hpp"

namespace slipproof {

bool KindBase::says_nothing(const Implications& logic, std::size_t, const ClaimBody& body) const {
  Lemmas lemmas;
  if (traits().needs_no_force) return logic.of_any_force().implies({body.region}, make_truth(false), lemmas);
  return logic.has_value({body.region}, body.where(), lemmas) &&
         logic.implies({body.region, body.where()}, make_truth(false), lemmas);
}

ClaimChange::Result KindBase::settle(const ClaimChange& change) const {
  using Kind = Settlement::Kind;
  const ClaimBody &before = change.before(), &after = change.after();
  const Implications& in = change.in();
  const Implications everywhere = traits().needs_no_force ? in.of_any_force() : in;
  Lemmas lemmas;
  const bool holds = change.holds_differs();
  if (holds && !change.where_differs()) {
    if (is_true_of_any_motion(everywhere, after, lemmas)) {
      return change.made(Kind::vacuous, "true of all parameters in their domains, whatever the motion",
                         std::move(lemmas));
    }
    const std::vector<Expression> given{before.region, before.where()};
    if (everywhere.equivalent(given, before.holds, after.holds, lemmas)) {
      return change.made(Kind::equivalent, "before and after imply each other", std::move(lemmas));
    }
    return settle_holds(change, given);
  }
  if (!traits().says_by_region) {
    if (auto result = holds ? std::nullopt : settle_where(change)) return result;
    return settle_theorem(change);
  }
  if (!everywhere.equivalent({}, before.region, after.region, lemmas)) return std::nullopt;
  if (in.equivalent({before.region}, before.forces, after.forces, lemmas) && !holds) {
    return change.made(Kind::equivalent, "before and after imply each other", std::move(lemmas));
  }
  return settle_theorem(change);
}

/// Settles a change of the region or of the forces, if both are about the same motions.
ClaimChange::Result KindBase::settle_where(const ClaimChange& change) const {
  const ClaimBody &before = change.before(), &after = change.after();
  const Implications& in = change.in();
  Lemmas lemmas;
  const Expression x = conjunction(before.region, before.forces), y = conjunction(after.region, after.forces);
  if (in.equivalent({}, x, y, lemmas)) {
    return change.made(Settlement::Kind::equivalent, "before and after imply each other", std::move(lemmas));
  }
  // If there are several modes, all of them have a motion there, so conditions on the motions of one are true.
  for (const MechanismMode& mode : moving(before)) {
    lemmas.clear();
    const auto implied = [&](const Expression& e, const Expression& other) {
      if (in.implies({e}, other, lemmas)) return true;
      // Conditions that the motions of the mode satisfy in this region in any case.
      const bool original = same(other, x) && same(before.region, after.region);
      if (original && in.implies({before.region}, before.forces, lemmas, mode)) return true;
      return in.implies({e}, other, lemmas, mode);
    };
    if (!implied(x, y) || !implied(y, x) || !in.divides_alike({}, x, y, lemmas)) continue;
    return change.made(Settlement::Kind::equivalent,
                       "before and after are true of the same motions in " + slipproof::name(mode), std::move(lemmas));
  }
  return std::nullopt;
}

ClaimChange::Result KindBase::settle_holds(const ClaimChange&, const std::vector<Expression>&) const {
  return std::nullopt;
}

ClaimChange::Result KindBase::settle_theorem(const ClaimChange&) const {
  return std::nullopt;
}

}  // namespace slipproof
