#include "claims/meaning/second_judge/second_judge.hpp"

#include <algorithm>

namespace slipproof::meaning {

std::string_view name(Says says) {
  constexpr std::string_view names[] = {"nothing", "no value", "right", "wrong"};
  return names[static_cast<std::size_t>(says)];
}

Says first_of(Says x, Says y) {
  for (const Says says : {Says::wrong, Says::no_value, Says::right}) {
    if (x == says || y == says) return says;
  }
  return Says::nothing;
}

bool SecondJudge::multiplies(const Tree& tree) const {
  const auto has_quantity = [&](const Tree& part) {
    const auto names = symbols(part);
    return std::any_of(names.begin(), names.end(), [&](const std::string& s) { return world_.is_quantity(s); });
  };
  if (tree->op == Op::multiply && has_quantity(tree->parts[0]) && has_quantity(tree->parts[1])) return true;
  if (tree->op == Op::divide && has_quantity(tree->parts[1])) return true;
  if (tree->op == Op::power && has_quantity(tree->parts[0])) return true;
  return std::any_of(tree->parts.begin(), tree->parts.end(), [&](const Tree& part) { return multiplies(part); });
}

Says SecondJudge::force_by_force(const Claim& claim, const std::vector<Rational>& forces,
                                 const std::function<Says(const Rational&)>& at_force) const {
  Says all = Says::nothing;
  for (const Rational& x : forces) {
    const Truth here = at(claim.forces, x);
    all = first_of(all, !here ? Says::no_value : *here ? at_force(x) : Says::nothing);
  }
  return all;
}

Says SecondJudge::judge(std::size_t index) const {
  const Claim& claim = file_.claims[index];
  if (!domain_is_an_interval()) return Says::no_value;
  if (claim.kind == "cover") return cover(claim);
  if (claim.kind == "limit") return limit(claim);
  const Truth region = truth_of(or_true(claim.region), world_.names());
  if (!region) return Says::no_value;
  if (!*region) return Says::nothing;
  if (claim.kind == "interval") return interval(claim);
  if (claim.kind == "impossible") return impossible(claim);
  if (claim.kind == "formula") return claim.modes.empty() ? formula(claim) : formula_of_motions(claim);
  if (claim.kind == "motions") return motions(claim);
  if (claim.kind == "unique") return unique(claim);
  if (claim.kind == "force-cover") return force_cover(claim);
  if (claim.kind == "equivalence") return equivalence(claim);
  if (claim.kind == "exists") return exists(claim);
  return claim.kind == "consequence" ? consequence(claim) : system(claim);
}

Says SecondJudge::interval(const Claim& claim) const {
  const Mode& mode = claim.modes.front();
  if (!world_.modelled(mode)) return Says::no_value;
  Says all = Says::right;
  for (const Rational& x : forces({claim.forces})) {
    const Truth here = at(claim.forces, x);
    const bool right = is_true(here) == world_.has_motion(mode, x);
    all = first_of(all, !here ? Says::no_value : right ? Says::right : Says::wrong);
  }
  return all;
}

Says SecondJudge::impossible(const Claim& claim) const {
  return force_by_force(claim, forces({claim.forces}), [&](const Rational& x) {
    for (const Mode& mode : claim.modes) {
      if (world_.has_motion(mode, x)) return Says::wrong;
    }
    return all_modelled(claim.modes) ? Says::right : Says::no_value;
  });
}

Says SecondJudge::formula(const Claim& claim) const {
  return force_by_force(claim, forces({claim.forces, claim.holds}), [&](const Rational& x) {
    const Truth holds = at(claim.holds, x);
    return !holds ? Says::no_value : *holds ? Says::right : Says::wrong;
  });
}

Says SecondJudge::formula_of_motions(const Claim& claim) const {
  const bool continuum = std::any_of(claim.modes.begin(), claim.modes.end(), [&](const Mode& mode) {
    const Solutions* found = world_.solutions(mode);
    return found != nullptr && found->free;
  });
  if (continuum && multiplies(claim.holds)) throw OutOfReach("a formula of a continuum that is not linear");
  std::set<Rational> changes;
  for (const Mode& mode : claim.modes) {
    if (const Solutions* found = world_.solutions(mode)) changes.merge(changes_of_motion(claim.holds, *found));
  }
  return force_by_force(claim, forces({claim.forces}, changes), [&](const Rational& x) {
    std::vector<Truth> truths;
    for (const Mode& mode : claim.modes) {
      for (const Truth truth : truths_of_mode(claim, mode, x)) truths.push_back(truth);
    }
    if (any(truths, false)) return Says::wrong;
    if (any(truths, {}) || !all_modelled(claim.modes)) return Says::no_value;
    return truths.empty() ? Says::nothing : Says::right;
  });
}

Says SecondJudge::motions(const Claim& claim) const {
  return force_by_force(claim, forces({claim.forces}), [&](const Rational& x) {
    const Motions found = motions_at(x);
    const auto one = [&](const Mode& mode) { return !world_.modelled(mode) || found.in(mode) == 1; };
    if (!std::all_of(claim.modes.begin(), claim.modes.end(), one) || !found.all_in(claim.modes)) return Says::wrong;
    return everything_modelled() ? Says::right : Says::no_value;
  });
}

Says SecondJudge::unique(const Claim& claim) const {
  const auto conditions = conditions_on_forces(claim);
  if (!conditions) return Says::no_value;
  std::vector<Tree> with_closures = *conditions;
  for (const Tree& condition : *conditions) with_closures.push_back(closure(condition));
  const auto all = forces(with_closures);
  for (auto named = conditions->begin() + 1; named != conditions->end(); ++named) {
    if (!always_defined(*named, all)) return Says::no_value;
  }
  return force_by_force(claim, all, [&](const Rational& x) {
    if (near_one_of(claim.except, x)) return Says::nothing;
    const Motions found = world_.motions(x, false);
    bool right = true, stated = false;
    for (const std::size_t other : claim.claims) {
      if (!states(other, x)) continue;
      stated = true;
      right = right && exactly_one_in(found, {file_.claims[other].modes.front()});
    }
    if (!stated && near_one_of(claim.claims, x)) return Says::nothing;
    if (!stated) right = exactly_one_in(found, claim.modes);
    if (!right) return Says::wrong;
    return everything_modelled() ? Says::right : Says::no_value;
  });
}

/// Those of the claim, and of the claims that it names where their regions are true; nothing if one is undefined.
std::optional<std::vector<Tree>> SecondJudge::conditions_on_forces(const Claim& claim) const {
  std::vector<Tree> result = {or_true(claim.forces)};
  std::vector<std::size_t> named = claim.claims;
  named.insert(named.end(), claim.except.begin(), claim.except.end());
  for (const std::size_t i : named) {
    const Truth region = truth_of(or_true(file_.claims[i].region), world_.names());
    if (!region) return std::nullopt;
    if (*region) result.push_back(or_true(file_.claims[i].forces));
  }
  return result;
}

bool SecondJudge::states(std::size_t claim, const Rational& x) const {
  const Claim& stated = file_.claims[claim];
  return is_true(truth_of(or_true(stated.region), world_.names())) && is_true(at(stated.forces, x));
}

bool SecondJudge::near_one_of(const std::vector<std::size_t>& claims, const Rational& x) const {
  return std::any_of(claims.begin(), claims.end(), [&](std::size_t i) {
    const Claim& claim = file_.claims[i];
    return is_true(truth_of(or_true(claim.region), world_.names())) && is_true(at(closure(or_true(claim.forces)), x));
  });
}

/// Or it may be so: no motion was found, but there are modes of which nothing is known.
bool SecondJudge::exactly_one_in(const Motions& found, const std::vector<Mode>& modes) const {
  if (found.none()) return !all_modelled(modes);
  return found.exactly_one() && found.all_in(modes);
}

Says SecondJudge::force_cover(const Claim& claim) const {
  std::vector<Tree> conditions = {or_true(claim.forces)};
  for (const std::size_t i : claim.claims) conditions.push_back(or_true(file_.claims[i].forces));
  return force_by_force(claim, forces(conditions), [&](const Rational& x) {
    std::vector<Truth> truths;
    for (const std::size_t i : claim.claims) {
      const Truth region = truth_of(or_true(file_.claims[i].region), world_.names());
      const Truth stated = at(or_true(file_.claims[i].forces), x);
      const bool never = (region && !*region) || (stated && !*stated);
      truths.push_back(never ? Truth(false) : region && stated ? Truth(true) : Truth());
    }
    if (any(truths, true)) return Says::right;
    return any(truths, {}) ? Says::no_value : Says::wrong;
  });
}

Says SecondJudge::equivalence(const Claim& claim) const {
  const auto all = forces({claim.forces, claim.holds});
  if (all.empty()) return Says::nothing;
  bool defined = true;
  for (const Rational& x : all) {
    const Truth left = at(claim.forces, x), right = at(claim.holds, x);
    if (left && right && *left != *right) return Says::wrong;
    defined = defined && left && right;
  }
  return defined ? Says::right : Says::no_value;
}

Says SecondJudge::exists(const Claim& claim) const {
  const auto all = forces({claim.forces});
  for (const Rational& x : all) {
    const bool in_each = std::all_of(claim.modes.begin(), claim.modes.end(),
                                     [&](const Mode& mode) { return world_.has_motion(mode, x); });
    if (is_true(at(claim.forces, x)) && in_each) return Says::right;
  }
  return always_defined(claim.forces, all) && all_modelled(claim.modes) ? Says::nothing : Says::no_value;
}

Says SecondJudge::cover(const Claim& claim) const {
  const Truth region = truth_of(or_true(claim.region), world_.names());
  if (!region) return Says::no_value;
  if (!*region) return Says::nothing;
  std::vector<Truth> truths;
  for (const std::size_t i : claim.claims) {
    truths.push_back(truth_of(or_true(file_.claims[i].region), world_.names()));
  }
  if (any(truths, true)) return Says::right;
  return any(truths, {}) ? Says::no_value : Says::wrong;
}

Says SecondJudge::consequence(const Claim& claim) const {
  const Equations assumed = hypotheses(claim);
  Equations shown;
  add(shown, claim.equations);
  if (!assumed.fine || !shown.fine) return Says::no_value;
  const Echelon echelon(assumed.rows, first_columns(world_.constant_column()));
  if (!echelon.solvable()) return Says::nothing;
  const bool right =
      std::all_of(shown.rows.begin(), shown.rows.end(), [&](const Row& row) { return echelon.implies(row); });
  return right ? Says::right : Says::wrong;
}

Says SecondJudge::system(const Claim& claim) const {
  const Equations assumed = hypotheses(claim), shown = right_side(claim);
  if (!assumed.fine || !shown.fine) return Says::no_value;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < world_.unknowns().size(); ++i) {
    if (!shown.symbols.contains(world_.unknowns()[i])) order.push_back(i);
  }
  const std::set<std::size_t> others(order.begin(), order.end());
  for (const std::size_t column : first_columns(world_.constant_column())) {
    if (!others.contains(column)) order.push_back(column);
  }
  const Echelon left(assumed.rows, order), right(shown.rows, order);
  if (!left.solvable() && !right.solvable()) return Says::nothing;
  if (!left.solvable() || !right.solvable()) return Says::wrong;
  const Rows projected = left.without(others);
  const bool same =
      std::all_of(projected.begin(), projected.end(), [&](const Row& row) { return right.implies(row); }) &&
      std::all_of(shown.rows.begin(), shown.rows.end(), [&](const Row& row) { return left.implies(row); });
  return same ? Says::right : Says::wrong;
}

SecondJudge::Equations SecondJudge::hypotheses(const Claim& claim) const {
  Equations result;
  add(result, claim.given);
  add(result, claim.claims);
  if (claim.given.empty() && claim.claims.empty()) {
    result.rows = world_.model_rows(claim.modes.empty() ? std::nullopt : std::optional(claim.modes.front()));
  }
  add(result, claim.assume);
  return result;
}

SecondJudge::Equations SecondJudge::right_side(const Claim& claim) const {
  Equations result;
  add(result, claim.given);
  add(result, claim.equations);
  return result;
}

void SecondJudge::add(Equations& equations, const std::vector<std::size_t>& claims) const {
  for (const std::size_t i : claims) add(equations, file_.claims[i].equations);
}

void SecondJudge::add(Equations& equations, const std::vector<Tree>& trees) const {
  for (const Tree& tree : trees) {
    equations.symbols.merge(symbols(tree));
    const auto row = linear(tree, world_);
    equations.fine = equations.fine && row;
    if (row) equations.rows.push_back(*row);
  }
}

Truth SecondJudge::at(const Tree& condition, const Rational& x) const {
  return truth_of(or_true(condition), world_.at(x));
}

bool SecondJudge::always_defined(const Tree& condition, const std::vector<Rational>& forces) const {
  return std::all_of(forces.begin(), forces.end(), [&](const Rational& x) { return at(condition, x).has_value(); });
}

bool SecondJudge::all_modelled(const std::vector<Mode>& modes) const {
  return std::all_of(modes.begin(), modes.end(), [&](const Mode& mode) { return world_.modelled(mode); });
}

}  // namespace slipproof::meaning
