#include "proofs/rules/pairs.hpp"

#include "proofs/branch/signs.hpp"

namespace slipproof::prove {

namespace {

/// A polynomial as constant * a product of facts; known signs are moved into the constant.
struct SignedProduct {
  Rational constant;
  Product product;
  bool strict = true;                 ///< all its facts are: it is not 0
  std::vector<Polynomial> open = {};  ///< its factors of unknown sign
};

/// A fact p >= 0 or p > 0 with p = coefficient * variable + rest.
struct Bound {
  const Fact* fact;
  SignedProduct coefficient;

  bool strict() const { return fact->sign == Sign::positive; }
};

class PairSearch {
 public:
  PairSearch(Context& context, State& state, Pass pass) : context_(context), state_(state), pass_(pass) {}

  PairsResult run() {
    for (std::size_t variable = context_.ring().size(); variable-- > 0;) {
      if (refute(variable)) return {true, {}};
    }
    return {false, std::move(open_)};
  }

 private:
  SignedProduct signed_product(const Polynomial& p) {
    const Factorization& factors = context_.factored(p);
    SignedProduct result{factors.constant, {}};
    for (const auto& [factor, exponent] : factors.factors) {
      const KnownSign* sign = sign_of(context_, state_, factor, pass_);
      if (sign == nullptr) {
        result.open.push_back(factor);
        continue;
      }
      multiply(result.product, {{sign->name, 1}}, exponent);
      if (sign->orientation < 0 && exponent % 2 == 1) result.constant = -result.constant;
      result.strict = result.strict && sign->strict;
    }
    return result;
  }

  bool refute(std::size_t variable) {
    std::vector<Bound> lower, upper;
    for (const Fact& fact : state_.facts) {
      if (fact.sign == Sign::zero || fact.p.degree(variable) != 1) continue;
      SignedProduct coefficient = signed_product(context_.slope(fact.p, variable));
      open_.insert(open_.end(), coefficient.open.begin(), coefficient.open.end());
      if (!coefficient.open.empty() || coefficient.product.contains(fact.name)) continue;
      const bool positive = coefficient.constant > 0;
      (positive ? lower : upper).push_back({&fact, std::move(coefficient)});
    }
    for (const Bound& l : lower) {
      for (const Bound& u : upper) {
        if (refute(l, u, variable)) return true;
      }
    }
    return false;
  }

  /// By l's fact times u's coefficient and u's fact times l's, which add up to something without the variable.
  bool refute(const Bound& l, const Bound& u, std::size_t variable) {
    const Polynomial sum = context_.without(variable, l.fact->p, u.fact->p);
    Identity identity{{times_fact(u.coefficient, *l.fact), times_fact(l.coefficient, *u.fact)}, {}};
    const bool strict = (l.strict() && u.coefficient.strict) || (u.strict() && l.coefficient.strict);
    if (!sum.is_zero()) {
      SignedProduct value = signed_product(sum);
      if (value.open.size() == 1) open_.push_back(std::move(value.open.front()));
      if (!value.open.empty() || value.constant > 0 || (!strict && !value.strict)) return false;
      identity.terms.push_back({absolute(value.constant), std::move(value.product)});
    } else if (!strict) {
      return false;
    }
    state_.steps.push_back(contradiction(std::move(identity)));
    return true;
  }

  static WeightedProduct times_fact(const SignedProduct& coefficient, const Fact& fact) {
    WeightedProduct result{absolute(coefficient.constant), coefficient.product};
    multiply(result.product, {{fact.name, 1}});
    return result;
  }

  Context& context_;
  State& state_;
  Pass pass_;
  std::vector<Polynomial> open_;
};

}  // namespace

PairsResult refute_pairs(Context& context, State& state, Pass pass) {
  return PairSearch(context, state, pass).run();
}

}  // namespace slipproof::prove
