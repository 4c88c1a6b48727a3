// The forces at which a claim is judged: wherever its answer can change, and between.
#include <algorithm>

#include "claims/meaning/second_judge/second_judge.hpp"

namespace slipproof::meaning {

/// The free parameter of a continuum; no symbol of a setting can be called so.
static const std::string free_parameter = "#";

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

}  // namespace slipproof::meaning
