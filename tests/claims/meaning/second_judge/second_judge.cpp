#include "claims/meaning/second_judge/second_judge.hpp"

#include <algorithm>

namespace slipproof::meaning {

namespace {

/// The free parameter of a continuum; no symbol of a setting can be called so.
const std::string free_parameter = "#";

Tree or_true(const Tree& condition) {
  return condition ? condition : truth(true);
}

bool any(const std::vector<Truth>& truths, Truth wanted) {
  return std::find(truths.begin(), truths.end(), wanted) != truths.end();
}

}  // namespace

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

/// "A mechanism without a load has one force, which nothing depends on."
std::vector<Rational> SecondJudge::forces(const std::vector<Tree>& conditions, std::set<Rational> more) const {
  if (world_.setting().force.empty()) return {Rational(0)};
  more.merge(changes(conditions));
  more.merge(changes({world_.force_domain()}));
  more.insert(world_.ends().begin(), world_.ends().end());
  std::vector<Rational> result = everywhere(more);
  std::erase_if(result, [&](const Rational& x) { return !is_true(at(world_.force_domain(), x)); });
  return result;
}

std::vector<Rational> SecondJudge::places(std::size_t index) const {
  if (world_.setting().force.empty()) return {Rational(0)};
  const Claim& claim = file_.claims[index];
  std::set<Rational> points = changes({world_.force_domain(), claim.forces});
  points.insert(world_.ends().begin(), world_.ends().end());
  for (const auto& named : {claim.claims, claim.except}) {
    for (const std::size_t i : named) points.merge(changes({file_.claims[i].forces}));
  }
  if (!claim.holds || claim.kind == "limit") return everywhere(points);
  if (claim.modes.empty()) points.merge(changes({claim.holds}));
  for (const Mode& mode : claim.modes) {
    if (const Solutions* found = world_.solutions(mode)) points.merge(changes_of_motion(claim.holds, *found));
  }
  return everywhere(points);
}

bool SecondJudge::domain_is_an_interval() const {
  const Tree& domain = world_.force_domain();
  std::vector<Truth> truths;
  for (const Rational& x : everywhere(changes({domain}))) truths.push_back(at(domain, x));
  const auto first = std::find(truths.begin(), truths.end(), Truth(true));
  const auto behind = std::find(first, truths.end(), Truth(false));
  return !any(truths, {}) && std::find(behind, truths.end(), Truth(true)) == truths.end();
}

std::set<Rational> SecondJudge::changes(const std::vector<Tree>& conditions) const {
  const std::string& X = world_.setting().force;
  std::set<Rational> result;
  for (const Tree& condition : conditions) {
    const Variables variables{world_.names(), {{X, Polynomial::variable(X)}}};
    for (const Polynomial& polynomial : critical(or_true(condition), variables)) result.merge(zeros(polynomial, X));
  }
  return result;
}

std::vector<Polynomial> SecondJudge::critical_of_motion(const Tree& holds, const Solutions& solutions) const {
  const std::string& X = world_.setting().force;
  Variables variables{world_.names(), {{X, Polynomial::variable(X)}}};
  for (const auto& [name, plane] : solutions.motion) variables.symbols[name] = plane.polynomial(X, free_parameter);
  return critical(holds, variables);
}

/// In a continuum, where two of the lines at which something changes meet; all of them have to be straight.
std::set<Rational> SecondJudge::changes_of_motion(const Tree& holds, const Solutions& solutions) const {
  const std::string& X = world_.setting().force;
  std::vector<Polynomial> lines = critical_of_motion(holds, solutions);
  std::set<Rational> result;
  if (!solutions.free) {
    for (const Polynomial& polynomial : lines) result.merge(zeros(polynomial, X));
    return result;
  }
  for (const Plane& condition : solutions.conditions) lines.push_back(condition.polynomial(X, free_parameter));
  for (const Polynomial& p : lines) {
    if (p.degree() > 1) throw OutOfReach("a curve in a continuum");
    if (p.slope(free_parameter) == 0) result.merge(zeros(p, X));
    for (const Polynomial& q : lines) {
      const Polynomial meeting = Polynomial(q.slope(free_parameter)) * p - Polynomial(p.slope(free_parameter)) * q;
      result.merge(zeros(meeting, X));
    }
  }
  return result;
}

std::vector<Plane> SecondJudge::planes(const Claim& claim, const Solutions& solutions) const {
  std::vector<Plane> result;
  if (!solutions.free || !claim.holds) return result;
  const std::string& X = world_.setting().force;
  for (const Polynomial& p : critical_of_motion(claim.holds, solutions)) {
    result.push_back({p.constant(), p.slope(X), p.slope(free_parameter)});
  }
  return result;
}

std::vector<Truth> SecondJudge::truths_of_mode(const Claim& claim, const Mode& mode, const Rational& x) const {
  const Solutions* solutions = world_.solutions(mode);
  if (solutions == nullptr) return {};
  std::vector<Truth> result;
  for (const Rational& t : solutions->parameters(x, planes(claim, *solutions))) {
    if (!solutions->meets(x, t, world_.setting().strict)) continue;
    result.push_back(holds_of_motion(claim.holds, solutions->at(x, t), x));
  }
  return result;
}

Truth SecondJudge::holds_of_motion(const Tree& holds, const Motion& motion, const Rational& x) const {
  Names names = world_.at(x);
  for (const auto& [name, value] : motion) names.values[name] = value;
  return truth_of(holds, names);
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
