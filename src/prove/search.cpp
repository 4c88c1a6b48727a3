#include "prove/search.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace slipproof::prove {

/// An equation used to eliminate: of a variable, pivot * variable + rest = 0 with a pivot of known sign; or of a
/// product of two variables that stands alone in it.
struct Search::Rule {
  Fact equation;
  std::size_t variable;
  std::optional<std::size_t> second;  ///< the other variable of the product
  Polynomial pivot;                   ///< positive
  Rational pivot_constant;            ///< pivot = pivot_constant * product of the facts in pivot_product
  Product pivot_product;
  Polynomial rest;
  int orientation;  ///< of the equation: pivot * variable + rest = orientation * equation
};

struct Search::KnownSign {
  int orientation = 1;  ///< orientation * p > 0 or >= 0 is the fact
  bool strict = true;
  std::string name;
};

struct Search::State {
  Proof steps;
  std::vector<Fact> facts;
  std::vector<Fact> derived;  ///< signs that follow from the facts, for denominators
  std::vector<std::pair<std::string, Formula>> disjunctions;
  std::vector<Rule> rules;
  std::map<std::string, KnownSign> signs;     ///< by the text of an irreducible polynomial
  std::map<std::string, bool> unknown_signs;  ///< searched without success; whether thoroughly

  State branch() const {
    State result = *this;
    result.steps.clear();
    return result;
  }
};

namespace {

Rational absolute(const Rational& x) {
  return x < 0 ? Rational(-x) : x;
}

Step contradiction(Identity identity) {
  Step step;
  step.identities.push_back(std::move(identity));
  return step;
}

Step have(const Fact& fact, std::vector<Identity> identities) {
  Step step;
  step.rule = Step::Rule::have;
  step.name = fact.name;
  step.polynomial = {fact.p};
  step.sign = fact.sign;
  step.identities = std::move(identities);
  return step;
}

/// p as factors whose signs are known and the others.
struct Split {
  Rational constant;  ///< times the signs of the known factors: p = constant * product of `known` facts * unknown
  Product known;
  bool known_strict = true;
  std::vector<std::pair<Polynomial, unsigned>> unknown;
};

}  // namespace

bool Search::add_formula(State& state, const std::string& name, const Formula& formula) {
  if (formula.kind == Formula::Kind::atom) return add(state, {name, formula.polynomial.front(), formula.sign});
  if (formula.kind == Formula::Kind::disjunction) {
    state.disjunctions.emplace_back(name, formula);
    return false;
  }
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    if (add_formula(state, name + "." + std::to_string(i + 1), formula.parts[i])) return true;
  }
  return false;
}

/// Brings a new fact into the state; true if the state is contradictory, its steps then end in the contradiction.
bool Search::add(State& state, Fact fact) {
  for (std::string before; before != fact.name;) {  // a later rule may bring back the product of an earlier one
    before = fact.name;
    for (const Rule& rule : state.rules) reduce(state, rule, fact);
  }
  bool keep = true;
  if (normalize(state, fact, keep)) return true;
  if (!keep) return false;
  for (const Fact& other : state.facts) {
    if (other.sign == fact.sign && other.p == fact.p) return false;
  }
  if (fact.sign != Sign::zero) {
    state.unknown_signs.clear();
    const Factorization f = fact.p.factors();
    if (f.factors.size() == 1 && f.factors[0].second == 1 && absolute(f.constant) == 1) {
      KnownSign& known = state.signs[f.factors[0].first.text()];
      if (known.name.empty() || !known.strict) {
        known = {f.constant > 0 ? 1 : -1, fact.sign == Sign::positive, fact.name};
      }
    }
  }
  state.facts.push_back(std::move(fact));
  return false;
}

/// Subtracts multiples of the rule's equation until the fact no longer contains its variable (or product).
void Search::reduce(State& state, const Rule& rule, Fact& fact) {
  const Ring& ring = fact.p.ring();
  Polynomial reduced = fact.p;
  Polynomial quotient(ring);
  std::size_t pivots = 0;
  const Polynomial equation = rule.equation.p.scaled(rule.orientation);
  if (rule.second) {
    const Polynomial product = Polynomial::variable(ring, rule.variable) * Polynomial::variable(ring, *rule.second);
    bool again = true;
    while (again) {
      again = false;
      for (const Term& term : reduced.terms()) {
        if (term.exponents[rule.variable] == 0 || term.exponents[*rule.second] == 0) continue;
        Polynomial monomial(ring, term.coefficient);
        for (std::size_t i = 0; i < ring.size(); ++i) {
          monomial *= power(Polynomial::variable(ring, i), term.exponents[i]);
        }
        const Polynomial factor = *monomial.divided_by(product);
        quotient += factor;
        reduced -= factor * equation;
        again = true;
        break;
      }
    }
    if (quotient.is_zero()) return;
  } else {
    pivots = fact.p.degree(rule.variable);
    if (pivots == 0) return;
    reduced = fact.p.coefficient(rule.variable, pivots);
    Polynomial denominators(ring, 1);
    for (std::size_t k = pivots; k-- > 0;) {
      denominators *= rule.pivot;
      reduced = -(reduced * rule.rest) + fact.p.coefficient(rule.variable, k) * denominators;
    }
    quotient = *(fact.p * denominators - reduced).divided_by(equation);
  }
  const Polynomial multiplier = power(rule.pivot, pivots);
  Fact result{fresh(), reduced, fact.sign};
  const Polynomial equation_multiple = quotient.scaled(rule.orientation);
  std::vector<Identity> identities;
  if (fact.sign == Sign::zero) {
    identities.push_back(
        {{{1, {{result.name, 1}}}}, {{fact.name, -multiplier}, {rule.equation.name, equation_multiple}}});
    identities.push_back(
        {{{1, {{result.name, 1}}}}, {{fact.name, multiplier}, {rule.equation.name, -equation_multiple}}});
  } else {
    Product product = {{fact.name, 1}};
    multiply(product, rule.pivot_product, static_cast<unsigned>(pivots));
    Rational coefficient = 1;
    for (std::size_t i = 0; i < pivots; ++i) coefficient *= rule.pivot_constant;
    identities.push_back(
        {{{coefficient, product}, {1, {{result.name, 1}}}}, {{rule.equation.name, -equation_multiple}}});
  }
  state.steps.push_back(have(result, std::move(identities)));
  fact = std::move(result);
}

/// Drops factors of known sign, and settles what is trivially true (keep = false) or false (returns true).
bool Search::normalize(State& state, Fact& fact, bool& keep) {
  if (fact.p.is_zero()) {
    keep = false;
    if (fact.sign != Sign::positive) return false;
    state.steps.push_back(contradiction({{{1, {{fact.name, 1}}}}, {}}));
    return true;
  }
  const Factorization factors = fact.p.factors();
  Rational constant = factors.constant;
  Product known;
  std::vector<std::pair<Polynomial, unsigned>> unknown;
  for (const auto& [factor, exponent] : factors.factors) {
    const KnownSign* sign = sign_of(state, factor);
    if (sign == nullptr || !sign->strict || sign->name == fact.name) {
      unknown.emplace_back(factor, exponent);
      continue;
    }
    multiply(known, {{sign->name, 1}}, exponent);
    if (sign->orientation < 0 && exponent % 2 == 1) constant = -constant;
  }
  const Polynomial one(fact.p.ring(), 1);
  if (unknown.empty()) {
    keep = false;
    if (fact.sign == Sign::zero) {
      state.steps.push_back(
          contradiction({{{absolute(constant), known}}, {{fact.name, one.scaled(constant > 0 ? -1 : 1)}}}));
      return true;
    }
    if (constant > 0) return false;
    state.steps.push_back(contradiction({{{1, {{fact.name, 1}}}, {absolute(constant), known}}, {}}));
    return true;
  }
  const bool single = unknown.size() == 1 && (fact.sign == Sign::zero || unknown[0].second % 2 == 1);
  if (known.empty() && (!single || (unknown[0].second == 1 && absolute(constant) == 1))) return false;
  Polynomial rest = one;
  if (single) {
    rest = unknown[0].first;
  } else {
    for (const auto& [factor, exponent] : unknown) rest *= power(factor, exponent);
  }
  const unsigned exponent = single ? unknown[0].second : 1;
  if (constant < 0) rest = -rest;  // |constant| * known * rest^exponent = p
  Fact result{fresh(), rest, fact.sign};
  Product opposite = known;
  opposite[result.name] += exponent;
  std::vector<Identity> identities;
  if (fact.sign == Sign::zero) {
    // For an even exponent the sign of rest does not matter, and both identities are alike.
    const bool even = exponent % 2 == 0;
    const int sign = even && constant < 0 ? -1 : 1;
    identities.push_back({{{absolute(constant), opposite}}, {{fact.name, one.scaled(-sign)}}});
    identities.push_back({{{absolute(constant), opposite}}, {{fact.name, one.scaled(even ? -sign : 1)}}});
  } else {
    identities.push_back({{{absolute(constant), opposite}, {1, {{fact.name, 1}}}}, {}});
  }
  state.steps.push_back(have(result, std::move(identities)));
  fact = std::move(result);
  return false;
}

/// The sign of an irreducible polynomial, as a fact; nullptr while unknown.
const Search::KnownSign* Search::sign_of(State& state, const Polynomial& factor, bool thorough) {
  const std::string text = factor.text();
  const auto known = state.signs.find(text);
  if (known != state.signs.end() && (known->second.strict || !thorough)) return &known->second;
  const auto unknown = state.unknown_signs.find(text);
  if (unknown == state.unknown_signs.end() || (thorough && !unknown->second)) {
    for (const int orientation : {1, -1}) {
      const auto form = find_slack_form(state.facts, state.derived, factor.scaled(orientation),
                                        thorough ? limits_.slack_depth : 2, thorough ? limits_.slack_attempts : 300);
      if (!form || (!form->strict && known != state.signs.end())) continue;
      Fact fact{fresh(), factor.scaled(orientation), form->strict ? Sign::positive : Sign::non_negative};
      Identity identity{form->terms, {}};
      Product negated = form->multiplier;
      negated[fact.name] += 1;
      identity.terms.push_back({1, negated});
      state.steps.push_back(have(fact, {identity}));
      state.derived.push_back(fact);
      return &(state.signs[text] = KnownSign{orientation, form->strict, fact.name});
    }
    state.unknown_signs[text] = thorough;
  }
  return known != state.signs.end() ? &known->second : nullptr;
}

/// The cheapest equation to eliminate with: constant pivots first, then pivots of known sign; variables declared last
/// go first.
std::optional<Search::Rule> Search::find_rule(State& state, std::size_t first) {
  std::optional<Rule> best;
  std::pair<std::size_t, std::size_t> best_cost;
  std::vector<Fact> equations;
  for (const Fact& fact : state.facts) {
    if (fact.sign == Sign::zero) equations.push_back(fact);
  }
  for (const Fact& fact : equations) {
    const std::vector<std::size_t> variables = fact.p.variables();
    // A product of two variables, both only there, and declared after all others: F * sigma = P.
    if (variables.size() == 3 && fact.p.length() == 2) {
      const Polynomial product = fact.p.coefficient(variables[1], 1).coefficient(variables[2], 1);
      const Polynomial single = fact.p.coefficient(variables[0], 1);
      if (product.is_constant() && !product.is_zero() && single.is_constant() && !single.is_zero()) {
        const Rational c = product.constant();
        if (absolute(c) == 1) {
          const int orientation = c > 0 ? 1 : -1;
          return Rule{fact, variables[1], variables[2], Polynomial(fact.p.ring(), 1), 1, {}, fact.p, orientation};
        }
      }
    }
    for (const std::size_t variable : variables) {
      if (variable < first || fact.p.degree(variable) != 1) continue;
      if (variable < statement_.first_unknown() && variables.back() >= statement_.first_unknown()) continue;
      Polynomial pivot = fact.p.coefficient(variable, 1);
      const std::pair<std::size_t, std::size_t> cost{pivot.is_constant() ? 0 : pivot.length(), 1000 - variable};
      if (best && best_cost <= cost) continue;
      int orientation = 1;
      Product product;
      const Factorization factors = pivot.factors();
      if (factors.constant < 0) orientation = -1;
      bool known = true;
      for (const auto& [factor, exponent] : factors.factors) {
        const KnownSign* sign = sign_of(state, factor);
        if (sign == nullptr || !sign->strict) {
          known = false;
          break;
        }
        multiply(product, {{sign->name, 1}}, exponent);
        if (sign->orientation < 0 && exponent % 2 == 1) orientation = -orientation;
      }
      if (!known) continue;
      best = Rule{fact,
                  variable,
                  std::nullopt,
                  pivot.scaled(orientation),
                  absolute(factors.constant),
                  product,
                  fact.p.coefficient(variable, 0).scaled(orientation),
                  orientation};
      best_cost = cost;
    }
  }
  return best;
}

bool Search::apply_rule(State& state, const Rule& rule) {
  std::vector<Fact> facts;
  facts.swap(state.facts);
  // What the rule does not touch stays; the rest comes back reduced.
  std::vector<Fact> touched;
  for (Fact& fact : facts) {
    if (fact.name == rule.equation.name) continue;
    const bool contains = fact.p.contains(rule.variable) && (!rule.second || fact.p.contains(*rule.second));
    (contains ? touched : state.facts).push_back(std::move(fact));
  }
  state.rules.push_back(rule);
  state.unknown_signs.clear();
  for (Fact& fact : touched) {
    reduce(state, state.rules.back(), fact);
    bool keep = true;
    if (normalize(state, fact, keep)) return true;
    if (keep) {
      if (add(state, std::move(fact))) return true;
    }
  }
  return false;
}

/// Eliminates with every equation that allows it.
bool Search::eliminate(State& state, std::size_t first) {
  while (const auto rule = find_rule(state, first)) {
    if (apply_rule(state, *rule)) return true;
  }
  return false;
}

/// Looks for a single fact that the others contradict.
bool Search::refute_facts(State& state, bool thorough) {
  for (std::size_t i = 0; i < state.facts.size(); ++i) {
    const Fact fact = state.facts[i];
    if (fact.sign == Sign::zero || (fact.p.length() == 1 && !thorough)) continue;
    const auto form = find_slack_form(state.facts, state.derived, -fact.p, thorough ? limits_.slack_depth : 1,
                                      thorough ? limits_.slack_attempts : 100);
    if (!form || (!form->strict && fact.sign != Sign::positive)) continue;
    Identity identity{form->terms, {}};
    Product product = form->multiplier;
    product[fact.name] += 1;
    identity.terms.push_back({1, product});
    state.steps.push_back(contradiction(std::move(identity)));
    return true;
  }
  return false;
}

/// Fourier-Motzkin: two facts linear in a variable, with coefficients of opposite known signs, give one without it.
bool Search::refute_pairs(State& state, std::vector<Polynomial>& candidates, bool thorough) {
  struct Bound {
    Fact fact;
    Product coefficient;  ///< times `constant` > 0
    Rational constant;
    Polynomial rest;
    Polynomial magnitude;
    bool strict_coefficient;
  };
  const Ring& ring = statement_.ring();
  for (std::size_t variable = ring.size(); variable-- > 0;) {
    std::vector<Bound> lower;
    std::vector<Bound> upper;
    const std::vector<Fact> facts = state.facts;
    for (const Fact& fact : facts) {
      if (fact.sign == Sign::zero || fact.p.degree(variable) != 1) continue;
      const Polynomial c = fact.p.coefficient(variable, 1);
      const Factorization factors = c.factors();
      Rational constant = factors.constant;
      Product product;
      bool known = true;
      bool strict = true;
      for (const auto& [factor, exponent] : factors.factors) {
        const KnownSign* sign = sign_of(state, factor, thorough);
        if (sign == nullptr) {
          candidates.push_back(factor);
          known = false;
          continue;
        }
        multiply(product, {{sign->name, 1}}, exponent);
        if (sign->orientation < 0 && exponent % 2 == 1) constant = -constant;
        strict = strict && sign->strict;
      }
      if (!known) continue;
      if (product.contains(fact.name)) continue;
      (constant > 0 ? lower : upper)
          .push_back(
              {fact, product, absolute(constant), fact.p.coefficient(variable, 0), constant > 0 ? c : -c, strict});
    }
    for (const Bound& l : lower) {
      for (const Bound& u : upper) {
        const Polynomial r = l.rest * u.magnitude + u.rest * l.magnitude;
        Product left = u.coefficient;
        multiply(left, {{l.fact.name, 1}});
        Product right = l.coefficient;
        multiply(right, {{u.fact.name, 1}});
        Identity identity{{{u.constant, left}, {l.constant, right}}, {}};
        const bool strict = (l.fact.sign == Sign::positive && u.strict_coefficient) ||
                            (u.fact.sign == Sign::positive && l.strict_coefficient);
        if (r.is_zero()) {
          if (!strict) continue;
          state.steps.push_back(contradiction(std::move(identity)));
          return true;
        }
        const Factorization factors = r.factors();
        Rational constant = factors.constant;
        Product product;
        bool known = true;
        bool strict_sign = true;
        std::vector<Polynomial> open;
        for (const auto& [factor, exponent] : factors.factors) {
          const KnownSign* sign = sign_of(state, factor, thorough);
          if (sign == nullptr) {
            known = false;
            open.push_back(factor);
            continue;
          }
          multiply(product, {{sign->name, 1}}, exponent);
          if (sign->orientation < 0 && exponent % 2 == 1) constant = -constant;
          strict_sign = strict_sign && sign->strict;
        }
        if (known && constant < 0 && (strict || strict_sign)) {
          identity.terms.push_back({absolute(constant), product});
          state.steps.push_back(contradiction(std::move(identity)));
          return true;
        }
        if (!known && open.size() == 1) candidates.push_back(open.front());
      }
    }
  }
  return false;
}

/// Forgets disjunctions p > 0 or p < 0 where the sign is known: their branches have nothing to say.
void Search::drop_known_cases(State& state) {
  for (std::size_t i = 0; i < state.disjunctions.size();) {
    const Formula& formula = state.disjunctions[i].second;
    bool useless = false;
    if (formula.parts.size() == 2 && formula.parts[0].kind == Formula::Kind::atom &&
        formula.parts[1].kind == Formula::Kind::atom && formula.parts[0].sign == Sign::positive &&
        formula.parts[1].sign == Sign::positive &&
        formula.parts[0].polynomial.front() == -formula.parts[1].polynomial.front()) {
      useless = !formula.parts[0].polynomial.front().is_zero();
      for (const auto& [factor, exponent] : formula.parts[0].polynomial.front().factors().factors) {
        const KnownSign* sign = sign_of(state, factor);
        if (sign == nullptr || !sign->strict) useless = false;
      }
    }
    if (useless) {
      state.disjunctions.erase(state.disjunctions.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
}

bool Search::close_cases(State& state, std::size_t which, int depth) {
  const auto [name, formula] = state.disjunctions[which];
  Step step;
  step.rule = Step::Rule::cases;
  step.name = name;
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    State branch = state.branch();
    branch.disjunctions.erase(branch.disjunctions.begin() + static_cast<std::ptrdiff_t>(which));
    if (!add_formula(branch, name + "." + std::to_string(i + 1), formula.parts[i]) && !close(branch, depth))
      return false;
    step.branches.push_back(std::move(branch.steps));
  }
  state.steps.push_back(std::move(step));
  return true;
}

bool Search::close_split(State& state, const Polynomial& p, int depth) {
  Step step;
  step.rule = Step::Rule::split;
  step.name = fresh();
  step.polynomial = {p};
  for (const int sign : {-1, 0, 1}) {
    State branch = state.branch();
    const Fact fact{step.name, sign < 0 ? -p : p, sign == 0 ? Sign::zero : Sign::positive};
    if (!add(branch, fact) && !close(branch, depth)) return false;
    step.branches.push_back(std::move(branch.steps));
  }
  state.steps.push_back(std::move(step));
  return true;
}

std::vector<Polynomial> Search::split_candidates(State& state, const std::vector<Polynomial>& from_pairs) {
  std::vector<Polynomial> result;
  std::vector<std::pair<std::size_t, Polynomial>> counted;
  const auto propose = [&](const Polynomial& p, std::size_t weight = 1) {
    if (p.is_constant()) return;
    for (auto& [count, other] : counted) {
      if (other == p) {
        count += weight;
        return;
      }
    }
    if (state.signs.contains(p.text()) && state.signs.at(p.text()).strict) return;
    counted.emplace_back(weight, p);
  };
  for (const Polynomial& hint : statement_.hints()) {
    Fact reduced{"", hint, Sign::zero};
    State scratch = state.branch();
    for (const Rule& rule : state.rules) reduce(scratch, rule, reduced);
    for (const auto& [factor, exponent] : reduced.p.factors().factors) {
      propose(factor, 1000);
    }
  }
  for (const Fact& fact : state.facts) {
    if (fact.sign == Sign::zero) {
      const Factorization factors = fact.p.factors();
      for (const auto& [factor, exponent] : factors.factors) {
        if (factors.factors.size() > 1) propose(factor);
      }
      const std::size_t last = fact.p.variables().back();
      if (fact.p.degree(last) == 1) {
        for (const auto& [factor, exponent] : fact.p.coefficient(last, 1).factors().factors) propose(factor, 5000);
      }
    } else {
      const Factorization factors = fact.p.factors();
      if (factors.factors.size() > 1) {
        for (const auto& [factor, exponent] : factors.factors) propose(factor);
      }
    }
  }
  for (const Polynomial& p : from_pairs) propose(p);
  std::stable_sort(counted.begin(), counted.end(), [](const auto& x, const auto& y) {
    return x.first != y.first ? x.first > y.first : x.second.length() < y.second.length();
  });
  for (auto& [count, p] : counted) result.push_back(std::move(p));
  return result;
}

/// Closes the state: on success its steps end in a contradiction or a split all of whose branches do.
bool Search::close(State& state, int depth) {
  if (eliminate(state)) return true;
  drop_known_cases(state);
  if (refute_facts(state, false)) return true;
  if (!state.disjunctions.empty()) {
    // Alternatives that can be opened one at a time: the shortest first.
    std::size_t which = 0;
    for (std::size_t i = 1; i < state.disjunctions.size(); ++i) {
      if (state.disjunctions[i].second.parts.size() < state.disjunctions[which].second.parts.size()) which = i;
    }
    if (state.disjunctions[which].second.parts.size() > 4) {  // long ones are mostly negated conclusions: try without
      State bare = state;
      bare.disjunctions.clear();
      if (close(bare, std::min(depth, 1))) {
        state = std::move(bare);
        return true;
      }
    }
    return close_cases(state, which, depth);
  }
  std::vector<Polynomial> candidates;
  if (refute_pairs(state, candidates, false)) return true;
  if (refute_facts(state, true)) return true;
  candidates.clear();
  if (refute_pairs(state, candidates, true)) return true;
  if (leftover_.facts.empty() || depth == limits_.split_depth) {
    leftover_.facts.clear();
    for (const Fact& fact : state.facts) {
      leftover_.facts.push_back(fact.name + ": " + fact.p.text() +
                                (fact.sign == Sign::zero       ? " = 0"
                                 : fact.sign == Sign::positive ? " > 0"
                                                               : " >= 0"));
    }
  }
  if (depth == 0) return false;
  const std::vector<Polynomial> proposed = split_candidates(state, candidates);
  for (std::size_t i = 0; i < proposed.size() && i < static_cast<std::size_t>(limits_.split_candidates); ++i) {
    if (close_split(state, proposed[i], depth - 1)) return true;
  }
  return false;
}

/// Solves the conclusion's equations for the unknowns, states the solution as a witness, and closes what is left.
bool Search::close_by_witness(State& state) {
  const Ring& ring = statement_.ring();
  State solving = state.branch();
  solving.disjunctions.clear();
  const std::function<void(const Formula&)> collect = [&](const Formula& formula) {
    if (formula.kind == Formula::Kind::atom && formula.sign == Sign::zero) {
      add(solving, {fresh(), formula.polynomial.front(), Sign::zero});
    }
    if (formula.kind == Formula::Kind::conjunction) {
      for (const Formula& part : formula.parts) collect(part);
    }
  };
  collect(statement_.shown());
  eliminate(solving, statement_.unknowns().front());
  Step step;
  step.rule = Step::Rule::witness;
  step.name = "goal";
  std::vector<std::string> values;
  for (const std::size_t unknown : statement_.unknowns()) {
    // unknown = numerator / denominator: reduce the unknown itself with a mark for its pivots.
    Polynomial numerator = Polynomial::variable(ring, unknown);
    Polynomial denominator(ring, 1);
    for (const Rule& rule : solving.rules) {
      if (rule.second || !numerator.contains(rule.variable)) continue;
      const std::size_t degree = numerator.degree(rule.variable);
      Polynomial reduced = numerator.coefficient(rule.variable, degree);
      Polynomial pivots(ring, 1);
      for (std::size_t k = degree; k-- > 0;) {
        pivots *= rule.pivot;
        reduced = -(reduced * rule.rest) + numerator.coefficient(rule.variable, k) * pivots;
      }
      numerator = std::move(reduced);
      denominator *= pivots;
      // Cancel what both have in common.
      for (const auto& [factor, exponent] : denominator.factors().factors) {
        for (unsigned i = 0; i < exponent; ++i) {
          const auto shorter = numerator.divided_by(factor);
          if (!shorter) break;
          numerator = *shorter;
          denominator = *denominator.divided_by(factor);
        }
      }
    }
    for (const std::size_t other : statement_.unknowns()) {
      if (numerator.contains(other)) return false;
    }
    values.push_back(denominator.is_constant() ? numerator.scaled(1 / denominator.constant()).text()
                                               : "(" + numerator.text() + ")/(" + denominator.text() + ")");
    step.values.emplace_back(ring.name(unknown), values.back());
  }
  state.steps.push_back(step);
  std::vector<Formula> failures;
  for (const Polynomial& divisor : statement_.divisors(values)) failures.push_back(atom(divisor, Sign::zero));
  failures.push_back(negation(statement_.shown(values)));
  return add_formula(state, step.name, combine(Formula::Kind::disjunction, std::move(failures))) ||
         close(state, limits_.split_depth);
}

/// Proves existence: by a witness, or, where the signs of its pivots are not known, by splits on the statement's hints.
bool Search::close_existence(State& state, std::size_t hint) {
  if (eliminate(state) || refute_facts(state, false)) return true;
  State attempt = state;
  if (close_by_witness(attempt)) {
    state = std::move(attempt);
    return true;
  }
  if (hint == statement_.hints().size()) {
    std::vector<Polynomial> candidates;
    return refute_pairs(state, candidates, true) || refute_facts(state, true);
  }
  Step step;
  step.rule = Step::Rule::split;
  step.name = fresh();
  step.polynomial = {statement_.hints()[hint]};
  for (const int sign : {-1, 0, 1}) {
    State branch = state.branch();
    const Polynomial p = step.polynomial.front().scaled(sign < 0 ? -1 : 1);
    if (!add(branch, {step.name, p, sign == 0 ? Sign::zero : Sign::positive}) && !close_existence(branch, hint + 1)) {
      return false;
    }
    step.branches.push_back(std::move(branch.steps));
  }
  state.steps.push_back(std::move(step));
  return true;
}

std::optional<Proof> Search::prove() {
  State start;
  bool closed = false;
  for (const auto& [name, formula] : statement_.assumptions()) closed = closed || add_formula(start, name, formula);
  closed = closed || eliminate(start);
  const int deepest = limits_.split_depth;
  for (limits_.split_depth = std::min(deepest, 1); !closed; ++limits_.split_depth) {
    State state = start;
    if (statement_.unknowns().empty()) {
      closed = add_formula(state, "goal", negation(statement_.shown())) || close(state, limits_.split_depth);
    } else {
      closed = close_existence(state, 0);
    }
    if (closed) start = std::move(state);
    if (!closed && limits_.split_depth >= deepest) return std::nullopt;
  }
  limits_.split_depth = deepest;
  prune(start.steps);
  return std::move(start.steps);
}

}  // namespace slipproof::prove
