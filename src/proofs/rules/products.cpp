#include "proofs/rules/products.hpp"

#include <algorithm>
#include <numeric>

#include "base/algebra/linear_program.hpp"

namespace slipproof::prove {
namespace {

constexpr std::size_t kMaxCandidates = 3000;  ///< before those are left out that cannot take part

using Monomial = std::vector<unsigned long>;

/// A line that an identity may have: a product of inequalities, or an equation times a monomial.
struct Candidate {
  Product product = {};
  bool strict = false;
  const Fact* equation = nullptr;
  Polynomial worth;
  Polynomial multiplier;  ///< of the equation
  /// The coefficients of `worth`, by the index of the monomial.
  std::vector<std::pair<std::size_t, Rational>> row = {};
};

unsigned long total_degree(const Monomial& monomial) {
  return std::accumulate(monomial.begin(), monomial.end(), 0UL);
}

unsigned long total_degree(const Polynomial& p) {
  unsigned long result = 0;
  for (const Term& term : p.terms()) result = std::max(result, total_degree(term.exponents));
  return result;
}

class ProductProgram {
 public:
  ProductProgram(const Ring& ring, Budget& budget) : ring_(ring), budget_(budget) {}

  /// All products of at most `degree` of the inequalities, those of few factors first; 1 is one of them.
  void add_products(const std::vector<const Fact*>& inequalities, unsigned degree) {
    candidates_.push_back({.strict = true, .worth = Polynomial(ring_, 1), .multiplier = Polynomial(ring_)});
    std::vector<std::size_t> last = {0};  // the factor of each candidate with the largest index
    std::size_t begin = 0;
    for (unsigned factors = 1; factors <= degree; ++factors) {
      const std::size_t end = candidates_.size();
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t k = last[i]; k < inequalities.size() && candidates_.size() < kMaxCandidates; ++k) {
          Candidate next = candidates_[i];
          next.product[inequalities[k]->name] += 1;
          next.strict = next.strict && inequalities[k]->sign == Sign::positive;
          next.worth *= inequalities[k]->p;
          budget_.spend(next.worth.length() + 1);
          candidates_.push_back(std::move(next));
          last.push_back(k);
        }
      }
      begin = end;
    }
    for (const Candidate& candidate : candidates_) degree_ = std::max(degree_, total_degree(candidate.worth));
  }

  /// The equation times all monomials that keep it within the products' degree.
  void add_multiples(const Fact& equation, std::size_t limit) {
    const unsigned long own = total_degree(equation.p);
    std::vector<Polynomial> monomials = {Polynomial(ring_, 1)};
    std::size_t begin = 0;
    std::vector<std::size_t> last = {0};
    for (unsigned long degree = own; degree < degree_; ++degree) {
      const std::size_t end = monomials.size();
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t v = last[i]; v < ring_.size() && monomials.size() < limit; ++v) {
          monomials.push_back(monomials[i] * Polynomial::variable(ring_, v));
          last.push_back(v);
        }
      }
      begin = end;
    }
    for (const Polynomial& monomial : monomials) {
      budget_.spend(equation.p.length());
      candidates_.push_back({.equation = &equation, .worth = equation.p * monomial, .multiplier = monomial});
    }
  }

  /// Weights for which the sum is zero, at most `rows` of them; the weights of strict products add up to 1.
  std::optional<Identity> solve(std::size_t rows) {
    for (Candidate& candidate : candidates_) {
      for (const Term& term : candidate.worth.terms()) {
        const std::size_t index = indices_.try_emplace(term.exponents, indices_.size()).first->second;
        candidate.row.emplace_back(index, term.coefficient);
      }
    }
    drop_impossible();
    if (candidates_.size() > rows) {
      candidates_.erase(candidates_.begin() + static_cast<std::ptrdiff_t>(rows), candidates_.end());
      drop_impossible();
    }
    if (std::none_of(candidates_.begin(), candidates_.end(), [](const Candidate& c) { return c.strict; })) {
      return std::nullopt;
    }
    return weighted();
  }

 private:
  /// A monomial with coefficients of one sign only cannot vanish: no candidate with it takes part.
  void drop_impossible() {
    std::size_t before = 0;
    do {
      std::vector<int> signs(indices_.size());  // 1: a positive coefficient, 2: a negative one, 3: both
      for (const Candidate& candidate : candidates_) {
        for (const auto& [index, coefficient] : candidate.row) {
          signs[index] |= candidate.equation != nullptr ? 3 : coefficient > 0 ? 1 : 2;
        }
      }
      before = candidates_.size();
      std::erase_if(candidates_, [&](const Candidate& candidate) {
        return std::any_of(candidate.row.begin(), candidate.row.end(),
                           [&](const auto& entry) { return signs[entry.first] != 3; });
      });
    } while (candidates_.size() < before);
  }

  /// By duality: looks for a number for each monomial such that every product comes to at least 0, every strict one to
  /// at least t, and every equation to 0. If t cannot be above 0, the multipliers of these conditions are the weights.
  std::optional<Identity> weighted() {
    std::map<std::size_t, std::size_t> columns;
    for (const Candidate& candidate : candidates_) {
      for (const auto& entry : candidate.row) columns.try_emplace(entry.first, columns.size());
    }
    const std::size_t t = columns.size();
    std::vector<AffineForm> constraints;
    const auto constrain = [&](const Candidate& candidate, int sign) {
      AffineForm form{0, std::vector<Rational>(t + 1)};
      for (const auto& [index, coefficient] : candidate.row) form.coefficients[columns[index]] = sign * coefficient;
      if (candidate.strict) form.coefficients[t] = -1;
      constraints.push_back(std::move(form));
    };
    for (const Candidate& candidate : candidates_) {
      constrain(candidate, 1);
      if (candidate.equation != nullptr) constrain(candidate, -1);
    }
    AffineForm objective{0, std::vector<Rational>(t + 1)}, bound{1, std::vector<Rational>(t + 1)};
    objective.coefficients[t] = bound.coefficients[t] = -1;
    constraints.push_back(bound);
    constexpr std::size_t steps_an_entry = 4;  // fractions, with a greatest common divisor each
    const std::size_t pivot_steps = constraints.size() * (t + 2) * steps_an_entry;
    const LinearOptimum optimum = minimize(objective, constraints, budget_.left() / pivot_steps);
    budget_.spend(optimum.pivots * pivot_steps);
    if (optimum.kind != LinearOptimum::Kind::attained || !optimum.value.is_zero()) return std::nullopt;
    return identity(optimum.multipliers);
  }

  /// The identity with a weight for each product, and for each equation two, whose difference counts.
  Identity identity(const std::vector<Rational>& weights) const {
    Identity identity;
    std::size_t next = 0;
    for (const Candidate& candidate : candidates_) {
      const Rational weight = weights[next++];
      if (candidate.equation == nullptr) {
        if (!weight.is_zero()) identity.terms.push_back({weight, candidate.product});
        continue;
      }
      const Polynomial multiple = candidate.multiplier.scaled(weight - weights[next++]);
      if (multiple.is_zero()) continue;
      const std::string& name = candidate.equation->name;
      if (identity.equations.empty() || identity.equations.back().first != name) {
        identity.equations.emplace_back(name, multiple);
      } else {
        identity.equations.back().second += multiple;
      }
    }
    return identity;
  }

  const Ring& ring_;
  Budget& budget_;
  std::vector<Candidate> candidates_;
  unsigned long degree_ = 0;
  std::map<Monomial, std::size_t> indices_;
};

}  // namespace

bool refute_products(Context& context, State& state) {
  if (context.reach.product_degree < 2) return false;
  std::vector<const Fact*> inequalities, equations;
  for (const std::vector<Fact>* facts : {&state.facts, &state.derived}) {
    for (const Fact& fact : *facts) (fact.sign == Sign::zero ? equations : inequalities).push_back(&fact);
  }
  std::stable_sort(inequalities.begin(), inequalities.end(), [](const Fact* x, const Fact* y) {
    const auto size = [](const Fact* fact) { return std::pair(total_degree(fact->p), fact->p.length()); };
    return size(x) < size(y);
  });
  const std::size_t limit = context.limits().products;
  ProductProgram program(context.ring(), context.budget());
  program.add_products(inequalities, context.reach.product_degree);
  for (const Fact* equation : equations) program.add_multiples(*equation, limit / 4);
  auto identity = program.solve(limit);
  if (!identity) return false;
  state.steps.push_back(contradiction(std::move(*identity)));
  return true;
}

}  // namespace slipproof::prove
