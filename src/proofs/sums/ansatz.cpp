#include "proofs/sums/ansatz.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace slipproof::prove::sums {

namespace {

constexpr std::size_t most_facts = 14;  ///< the shortest ones
constexpr std::size_t largest_basis = 150, most_blocks = 150;

using Exponents = std::vector<unsigned long>;

struct Variable {
  std::size_t index;
  std::size_t highest;  ///< its largest exponent
};

/// Monomials in some variables, by degree.
std::vector<Polynomial> monomials_up_to(const Ring& ring, const std::vector<Variable>& variables,
                                        unsigned long degree) {
  std::vector<Polynomial> result = {Polynomial(ring, 1)};
  std::vector<std::size_t> last = {0};
  std::size_t begin = 0;
  for (unsigned long d = 1; d <= degree; ++d) {
    const std::size_t end = result.size();
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t v = last[i]; v < variables.size() && result.size() <= largest_basis; ++v) {
        if (result[i].degree(variables[v].index) >= variables[v].highest) continue;
        result.push_back(result[i] * Polynomial::variable(ring, variables[v].index));
        last.push_back(v);
      }
    }
    begin = end;
  }
  return result;
}

Rational largest_coefficient(const Polynomial& p) {
  Rational largest = 0;
  for (const Term& term : p.terms()) largest = std::max(largest, absolute(term.coefficient));
  return largest;
}

class Maker {
 public:
  Maker(Context& context, const State& state, const Shape& shape) : context_(context), shape_(shape) {
    for (const std::vector<Fact>* facts : {&state.facts, &state.derived}) {
      for (const Fact& fact : *facts) {
        if (fact.p.is_constant() || degree_of(fact.p) > shape.degree) continue;
        (fact.sign == Sign::zero ? equations_ : inequalities_).push_back(&fact);
        for (const std::size_t v : fact.p.variables()) degrees_[v] = std::max(degrees_[v], fact.p.degree(v));
      }
    }
    std::stable_sort(inequalities_.begin(), inequalities_.end(),
                     [](const Fact* x, const Fact* y) { return x->p.length() < y->p.length(); });
    if (inequalities_.size() > most_facts) inequalities_.resize(most_facts);
  }

  /// With `sparse` no variable gets a higher degree than it has in a fact.
  std::optional<Ansatz> make(bool sparse) {
    sparse_ = sparse;
    add_products({{}, Polynomial(context_.ring(), 1), 1, true, {}}, 0, shape_.factors);
    for (const Fact* equation : equations_) {
      ansatz_.multiples.push_back(
          {equation->name, equation->p, monomials(shape_.degree - degree_of(equation->p), equation->p, 1)});
    }
    if (too_large_) return std::nullopt;
    return std::move(ansatz_);
  }

 private:
  /// For a factor of p, `times` of them.
  std::vector<Polynomial> monomials(unsigned long degree, const Polynomial& p, std::size_t times) {
    std::vector<Variable> variables;
    for (const auto& [v, highest] : degrees_) {
      const std::size_t own = p.degree(v);
      variables.push_back({v, sparse_ ? (highest - std::min(highest, own)) / times : degree});
    }
    std::vector<Polynomial> result = monomials_up_to(context_.ring(), variables, degree);
    too_large_ = too_large_ || result.size() > largest_basis;
    return result;
  }

  /// The product, and so many more factors from the facts from `first` on.
  void add_products(const Block& block, std::size_t first, int factors) {
    add_squares(block);
    for (std::size_t i = first; i < inequalities_.size() && factors > 0; ++i) {
      const Fact& fact = *inequalities_[i];
      if (degree_of(block.multiplier) + degree_of(fact.p) > shape_.degree) continue;
      too_large_ = too_large_ || ansatz_.blocks.size() > most_blocks;
      if (too_large_) return;
      Block next = block;
      multiply(next.product, {{fact.name, 1}});
      next.multiplier *= fact.p;
      next.strict = block.strict && fact.sign == Sign::positive;
      add_products(next, i, factors - 1);
    }
  }

  /// The multiplier alone, and with a sum of squares.
  void add_squares(Block block) {
    block.scale = 1 / largest_coefficient(block.multiplier);
    block.multiplier = block.multiplier.scaled(block.scale);
    block.basis = {Polynomial(context_.ring(), 1)};
    ansatz_.blocks.push_back(block);
    const unsigned long half = (shape_.degree - degree_of(block.multiplier)) / 2;
    if (half == 0) return;
    block.basis = monomials(half, block.multiplier, 2);
    if (shape_.lifted && block.strict && !block.product.empty()) {
      std::erase_if(block.basis, [&](const Polynomial& monomial) { return degree_of(monomial) != half; });
    } else {
      block.strict = false;
    }
    ansatz_.blocks.push_back(std::move(block));
  }

  Context& context_;
  const Shape& shape_;
  std::vector<const Fact*> inequalities_, equations_;
  std::map<std::size_t, std::size_t> degrees_;  ///< of each variable, in the facts
  Ansatz ansatz_;
  bool sparse_ = false, too_large_ = false;
};

Exponents exponents_of(const Polynomial& monomial) {
  return monomial.terms().front().exponents;
}

Exponents plus(Exponents x, const Exponents& y) {
  std::transform(x.begin(), x.end(), y.begin(), x.begin(), std::plus<>());
  return x;
}

/// Which signs a monomial of the sum has: 1 from squares with a positive coefficient, 2 with a negative one, 3 both.
std::map<Exponents, int> signs_of_monomials(Context& context, const Ansatz& ansatz) {
  std::map<Exponents, int> signs;
  for (const Block& block : ansatz.blocks) {
    const std::vector<Term> terms = block.multiplier.terms();
    std::vector<Exponents> basis;
    for (const Polynomial& monomial : block.basis) basis.push_back(exponents_of(monomial));
    context.budget().spend(terms.size() * basis.size() * basis.size());
    for (std::size_t i = 0; i < basis.size(); ++i) {
      for (std::size_t j = i; j < basis.size(); ++j) {
        const Exponents pair = plus(basis[i], basis[j]);
        for (const Term& term : terms) signs[plus(pair, term.exponents)] |= i != j ? 3 : term.coefficient > 0 ? 1 : 2;
      }
    }
  }
  for (const Multiple& multiple : ansatz.multiples) {
    for (const Polynomial& monomial : multiple.monomials) {
      for (const Term& term : (multiple.p * monomial).terms()) signs[term.exponents] = 3;
    }
  }
  return signs;
}

bool drop_lonely_squares(Context& context, Ansatz& ansatz) {
  const std::map<Exponents, int> signs = signs_of_monomials(context, ansatz);
  bool dropped = false;
  for (Block& block : ansatz.blocks) {
    const std::vector<Term> terms = block.multiplier.terms();
    const std::size_t erased = std::erase_if(block.basis, [&](const Polynomial& monomial) {
      const Exponents square = plus(exponents_of(monomial), exponents_of(monomial));
      return std::any_of(terms.begin(), terms.end(),
                         [&](const Term& term) { return signs.at(plus(square, term.exponents)) != 3; });
    });
    dropped = dropped || erased > 0;
  }
  std::erase_if(ansatz.blocks, [](const Block& block) { return block.basis.empty(); });
  return dropped;
}

using Parity = std::uint64_t;  ///< of the exponents of each variable

Parity parity_of(const Exponents& exponents) {
  Parity result = 0;
  for (std::size_t v = 0; v < exponents.size(); ++v) result |= Parity{exponents[v] % 2} << v;
  return result;
}

/// The span of parities over the field of two elements.
class Parities {
 public:
  Parity reduced(Parity x) const {
    for (const Parity generator : generators_) x = std::min(x, x ^ generator);
    return x;
  }
  void add(Parity x) {
    x = reduced(x);
    if (x == 0) return;
    generators_.push_back(x);
    std::sort(generators_.rbegin(), generators_.rend());
  }

 private:
  std::vector<Parity> generators_;  ///< with different highest bits, the largest first
};

void split_by_parity(Ansatz& ansatz) {
  Parities even;
  for (const Block& block : ansatz.blocks) {
    for (const Term& term : block.multiplier.terms()) even.add(parity_of(term.exponents));
  }
  for (const Multiple& multiple : ansatz.multiples) {
    for (const Term& term : multiple.p.terms()) even.add(parity_of(term.exponents));
  }
  const auto kind = [&](const Polynomial& monomial) { return even.reduced(parity_of(exponents_of(monomial))); };
  std::vector<Block> blocks;
  for (const Block& block : ansatz.blocks) {
    std::map<Parity, std::vector<Polynomial>> kinds;
    for (const Polynomial& monomial : block.basis) kinds[kind(monomial)].push_back(monomial);
    for (auto& [parity, basis] : kinds) {
      blocks.push_back(block);
      blocks.back().basis = std::move(basis);
    }
  }
  ansatz.blocks = std::move(blocks);
  for (Multiple& multiple : ansatz.multiples) {
    std::erase_if(multiple.monomials, [&](const Polynomial& monomial) { return kind(monomial) != 0; });
  }
}

}  // namespace

unsigned long degree_of(const Polynomial& p) {
  unsigned long result = 0;
  for (const Term& term : p.terms()) {
    result = std::max(result, std::accumulate(term.exponents.begin(), term.exponents.end(), 0UL));
  }
  return result;
}

std::optional<Ansatz> make_ansatz(Context& context, const State& state, const Shape& shape) {
  auto ansatz = Maker(context, state, shape).make(false);
  return ansatz ? std::move(ansatz) : Maker(context, state, shape).make(true);
}

bool simplify(Context& context, Ansatz& ansatz) {
  while (drop_lonely_squares(context, ansatz)) {
  }
  split_by_parity(ansatz);
  return std::any_of(ansatz.blocks.begin(), ansatz.blocks.end(), [](const Block& block) { return block.strict; });
}

}  // namespace slipproof::prove::sums
