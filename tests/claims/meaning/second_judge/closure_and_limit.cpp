// The two kinds of claims that proofs/MEANING.md gives paragraphs of their own: what `unique` leaves out, and `limit`.

#include "claims/meaning/second_judge/second_judge.hpp"

namespace slipproof::meaning {

namespace {

std::string opposite(const std::string& relation) {
  const std::map<std::string, std::string> opposites = {{"<", ">="}, {">=", "<"}, {">", "<="},
                                                        {"<=", ">"}, {"=", "!="}, {"!=", "="}};
  return opposites.at(relation);
}

Tree with_end(const Tree& left, const std::string& relation, const Tree& right) {
  if (relation == "!=") return make(Op::disjunction, {compare(left, "<=", right), compare(left, ">=", right)});
  return compare(left, relation == "<" || relation == ">" ? relation + "=" : relation, right);
}

Tree closure_of_chain(const Tree& chain, bool negated) {
  Tree result;
  for (std::size_t i = 0; i < chain->relations.size(); ++i) {
    const std::string relation = negated ? opposite(chain->relations[i]) : chain->relations[i];
    const Tree link = with_end(chain->parts[i], relation, chain->parts[i + 1]);
    result = result ? make(negated ? Op::disjunction : Op::conjunction, {result, link}) : link;
  }
  return result;
}

Tree replaced(const Tree& tree, const std::string& name, const Tree& by) {
  if (tree->op == Op::symbol) return tree->symbol == name ? by : tree;
  Node node = *tree;
  for (Tree& part : node.parts) part = replaced(part, name, by);
  return std::make_shared<const Node>(std::move(node));
}

/// Where the mechanism, or one of the conditions, can change with a parameter; the load is not the same for all x.
std::set<Rational> changes_with(const std::string& parameter, const World& world, std::vector<Tree> conditions) {
  const Setting& setting = world.setting();
  const std::string& X = setting.force;
  const std::string load = setting.mechanics ? setting.mechanics->load : "F";
  if (!load.empty()) {  // where it is the same at 0 and 1, it does not depend on the force
    const Tree& F = setting.scene.at(load);
    conditions.push_back(compare(replaced(F, X, number(0)), "=", replaced(F, X, number(1))));
  }
  const Variables variables{world.names(), {{parameter, Polynomial::variable(parameter)}}};
  std::set<Rational> result;
  for (const Tree& condition : conditions) {
    for (const Polynomial& p : critical(condition, variables)) result.merge(zeros(p, parameter));
  }
  return result;
}

}  // namespace

Tree closure(const Tree& condition, bool negated) {
  switch (condition->op) {
    case Op::truth:
      return truth(condition->truth != negated);
    case Op::negation:
      return closure(condition->parts[0], !negated);
    case Op::chain:
      return closure_of_chain(condition, negated);
    default:
      break;
  }
  const bool both = (condition->op == Op::conjunction) != negated;
  return make(both ? Op::conjunction : Op::disjunction,
              {closure(condition->parts[0], negated), closure(condition->parts[1], negated)});
}

std::vector<Rational> SecondJudge::values_of_parameter(const Claim& claim) const {
  std::vector<Tree> conditions = World::of_points(world_.setting());
  if (claim.region) conditions.push_back(claim.region);
  if (claim.from) conditions.push_back(compare(claim.from, "=", symbol(claim.parameter)));
  conditions.push_back(claim.holds);
  return everywhere(changes_with(claim.parameter, world_, conditions));
}

/// "All bicycles with p > v" for v close enough to s: what lies between the last values at which something changes; or
/// the last value, where it is a bicycle, and what lies just below it.
std::vector<Names> SecondJudge::last_bicycles(const Claim& claim) const {
  std::vector<Names> result;
  const std::vector<Rational> values = values_of_parameter(claim);
  for (std::size_t i = values.size(); i-- > 0;) {
    Names names = world_.names();
    names.values[claim.parameter] = values[i];
    const bool bicycle = World::is_bicycle(world_.setting(), names.values);
    if (bicycle) result.push_back(std::move(names));
    const bool between = i % 2 == 0;  // as everywhere() lists them
    if (!result.empty() && between) break;
  }
  return result;
}

Says SecondJudge::limit(const Claim& claim) const {
  Says all = Says::nothing;
  for (const Names& names : last_bicycles(claim)) {
    const Truth inside = claim.region ? truth_of(claim.region, names) : Truth(true);
    const Truth holds = truth_of(claim.holds, names);
    const bool valued = inside && (!*inside || holds);
    all = first_of(all, !valued ? Says::no_value : !*inside ? Says::nothing : *holds ? Says::right : Says::wrong);
  }
  return all;
}

}  // namespace slipproof::meaning
