#include "proofs/branch/reduction.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace slipproof::prove {

namespace {

/// pivot^pivots * p = quotient * equation + remainder, the equation as it is oriented in the rule.
struct Division {
  Polynomial quotient, remainder;
  std::size_t pivots = 0;
};

Polynomial monomial(const Ring& ring, const Term& term) {
  Polynomial result(ring, term.coefficient);
  for (std::size_t i = 0; i < ring.size(); ++i) result *= power(Polynomial::variable(ring, i), term.exponents[i]);
  return result;
}

Division divided_by_product(const Rule& rule, const Polynomial& equation, const Polynomial& p) {
  const Ring& ring = p.ring();
  const Polynomial product = Polynomial::variable(ring, rule.variable) * Polynomial::variable(ring, *rule.second);
  Division result{Polynomial(ring), p};
  const auto contains_product = [&](const Term& term) {
    return term.exponents[rule.variable] > 0 && term.exponents[*rule.second] > 0;
  };
  while (true) {
    const std::vector<Term> terms = result.remainder.terms();
    const auto term = std::find_if(terms.begin(), terms.end(), contains_product);
    if (term == terms.end()) return result;
    const Polynomial factor = *monomial(ring, *term).divided_by(product);
    result.quotient += factor;
    result.remainder -= factor * equation;
  }
}

/// Shortens a polynomial by x^2 + y^2 + e = 0. From the terms in m x^2, m y^2 and m, with the same monomial m, it takes
/// a multiple of m times the equation if that leaves fewer, or as many of lower degree: on the unit circle 3 x^2 + y^2
/// becomes 2 x^2 + 1, 1 - x^2 becomes y^2, and x^2 stays.
class Circle {
 public:
  Circle(const Rule& rule, const Polynomial& equation, const Polynomial& p)
      : x_(rule.variable),
        y_(*rule.second),
        constant_(equation.coefficient(x_, 0).coefficient(y_, 0).constant()),
        quotient_(p.ring()) {
    for (Term& term : p.terms()) terms_.emplace(std::move(term.exponents), std::move(term.coefficient));
  }

  /// What the equation is multiplied by.
  Polynomial quotient() {
    while (shorten()) {
    }
    return quotient_;
  }

 private:
  using Exponents = std::vector<unsigned long>;
  using Three = std::array<Rational, 3>;  ///< the coefficients of m x^2, m y^2 and m

  /// The number of terms, and of those of higher degree.
  static std::pair<int, int> cost(const Three& c) {
    const int squares = (c[0].is_zero() ? 0 : 1) + (c[1].is_zero() ? 0 : 1);
    return {squares + (c[2].is_zero() ? 0 : 1), squares};
  }

  Three without(const Three& c, const Rational& multiple) const {
    return {c[0] - multiple, c[1] - multiple, c[2] - multiple * constant_};
  }

  bool shorten() {
    for (const auto& [exponents, coefficient] : terms_) {
      for (const std::size_t variable : {x_, y_}) {
        if (exponents[variable] < 2) continue;
        Exponents m = exponents;
        m[variable] -= 2;
        if (shorten_at(m)) return true;
      }
    }
    return false;
  }

  bool shorten_at(const Exponents& m) {
    std::array<Exponents, 3> monomials{m, m, m};
    monomials[0][x_] += 2;
    monomials[1][y_] += 2;
    Three terms;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = terms_.find(monomials[i]);
      if (found != terms_.end()) terms[i] = found->second;
    }
    Rational best;  // of two that leave as little, the smaller one: it does not turn signs round
    for (const Rational& multiple : {terms[0], terms[1], Rational(terms[2] / constant_)}) {
      const auto left = cost(without(terms, multiple)), least = cost(without(terms, best));
      if (left < least || (left == least && !best.is_zero() && abs(multiple) < abs(best))) best = multiple;
    }
    if (best.is_zero()) return false;
    const Three left = without(terms, best);
    for (std::size_t i = 0; i < 3; ++i) {
      terms_.erase(monomials[i]);
      if (!left[i].is_zero()) terms_.emplace(monomials[i], left[i]);
    }
    quotient_ += monomial(quotient_.ring(), {best, m});
    return true;
  }

  std::size_t x_, y_;
  Rational constant_;
  std::map<Exponents, Rational> terms_;
  Polynomial quotient_;
};

Division divided_by_circle(const Rule& rule, const Polynomial& equation, const Polynomial& p) {
  const Polynomial quotient = Circle(rule, equation, p).quotient();
  return {quotient, p - quotient * equation};
}

Division divided_by_variable(const Rule& rule, const Polynomial& equation, const Polynomial& p) {
  const std::size_t pivots = p.degree(rule.variable);
  if (pivots == 0) return {Polynomial(p.ring()), p};
  const Polynomial remainder = substitute(p, rule.variable, -rule.rest, rule.pivot);
  return {*(p * power(rule.pivot, pivots) - remainder).divided_by(equation), remainder, pivots};
}

/// The identities by which the result follows from the fact and `multiple` times the equation; for an equation in both
/// directions.
std::vector<Identity> identities(const Rule& rule, const Fact& fact, const Fact& result, std::size_t pivots,
                                 const Polynomial& multiple) {
  const std::string& equation = rule.equation.name;
  const Polynomial multiplier = power(rule.pivot, pivots);
  if (fact.sign == Sign::zero) {
    return {{{{1, {{result.name, 1}}}}, {{fact.name, -multiplier}, {equation, multiple}}},
            {{{1, {{result.name, 1}}}}, {{fact.name, multiplier}, {equation, -multiple}}}};
  }
  WeightedProduct product{1, {{fact.name, 1}}};
  multiply(product.product, rule.pivot_product.product, static_cast<unsigned>(pivots));
  for (std::size_t i = 0; i < pivots; ++i) product.coefficient *= rule.pivot_product.coefficient;
  return {{{std::move(product), {1, {{result.name, 1}}}}, {{equation, -multiple}}}};
}

}  // namespace

void reduce(Context& context, State& state, const Rule& rule, Fact& fact) {
  const Polynomial equation = rule.equation.p.scaled(rule.orientation);
  const Division division = rule.is_circle ? divided_by_circle(rule, equation, fact.p)
                            : rule.second  ? divided_by_product(rule, equation, fact.p)
                                           : divided_by_variable(rule, equation, fact.p);
  if (division.quotient.is_zero()) return;
  Fact result{context.fresh(), division.remainder, fact.sign};
  state.steps.push_back(
      have(result, identities(rule, fact, result, division.pivots, division.quotient.scaled(rule.orientation))));
  fact = std::move(result);
}

}  // namespace slipproof::prove
