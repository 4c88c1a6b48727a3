#include "proofs/branch/domination.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "base/algebra/linear_program.hpp"

namespace slipproof::prove {
namespace {

using Exponents = std::vector<unsigned long>;
using Coefficients = std::map<Exponents, Rational>;

constexpr std::size_t longest = 120, longest_fact = 30, most_multiples = 60;
constexpr int rounds = 3;

Coefficients coefficients_of(const Polynomial& p) {
  Coefficients result;
  for (Term& term : p.terms()) result.emplace(std::move(term.exponents), std::move(term.coefficient));
  return result;
}

std::optional<Exponents> quotient(const Exponents& x, const Exponents& y) {
  Exponents result(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < y[i]) return std::nullopt;
    result[i] = x[i] - y[i];
  }
  return result;
}

Exponents product(const Exponents& x, const Exponents& y) {
  Exponents result(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) result[i] = x[i] + y[i];
  return result;
}

class Domination {
 public:
  Domination(const std::vector<Fact>& facts, const Polynomial& p, Budget& budget)
      : size_(p.ring().size()), budget_(budget), target_(coefficients_of(p)) {
    signs_.resize(size_);
    for (const Fact& fact : facts) add(fact);
  }

  std::optional<SlackForm> find() {
    if (!std::all_of(target_.begin(), target_.end(), [&](const auto& term) { return known(term.first); })) {
      return std::nullopt;
    }
    collect_multiples();
    return weighted();
  }

 private:
  struct Shape {
    const Fact* fact;
    Coefficients coefficients;
  };
  struct Multiple {
    const Shape* shape;
    Exponents by;
  };

  /// A variable of known sign, or an inequality among such.
  void add(const Fact& fact) {
    if (fact.sign == Sign::zero || fact.p.length() > longest_fact) return;
    Coefficients coefficients = coefficients_of(fact.p);
    if (coefficients.size() > 1) {
      shapes_.push_back({&fact, std::move(coefficients)});
      return;
    }
    const auto& [exponents, coefficient] = *coefficients.begin();
    std::optional<std::size_t> variable;
    for (std::size_t i = 0; i < size_; ++i) {
      if (exponents[i] == 0) continue;
      if (exponents[i] > 1 || variable) return;
      variable = i;
    }
    if (!variable || coefficient != 1) return;
    const Fact*& sign = signs_[*variable];
    if (sign == nullptr || fact.sign == Sign::positive) sign = &fact;
  }

  bool known(const Exponents& monomial) const {
    for (std::size_t i = 0; i < size_; ++i) {
      if (monomial[i] > 0 && signs_[i] == nullptr) return false;
    }
    return true;
  }
  bool strict(const Exponents& monomial) const {
    for (std::size_t i = 0; i < size_; ++i) {
      if (monomial[i] > 0 && signs_[i]->sign != Sign::positive) return false;
    }
    return true;
  }
  Product as_product(const Exponents& monomial) const {
    Product result;
    for (std::size_t i = 0; i < size_; ++i) {
      if (monomial[i] > 0) multiply(result, {{signs_[i]->name, 1}}, static_cast<unsigned>(monomial[i]));
    }
    return result;
  }

  void collect_multiples() {
    std::set<Exponents> covered, open;
    for (const auto& [monomial, coefficient] : target_) {
      if (coefficient < 0) open.insert(monomial);
    }
    std::set<std::pair<const Shape*, Exponents>> taken;
    for (int round = 0; round < rounds && !open.empty(); ++round) {
      std::set<Exponents> next;
      for (const Exponents& monomial : open) {
        covered.insert(monomial);
        for (const Shape& shape : shapes_) cover(monomial, shape, taken, next);
      }
      for (const Exponents& monomial : covered) next.erase(monomial);
      open = std::move(next);
    }
  }

  /// The multiples of a fact in which a monomial has a negative coefficient; what is positive in them and not in the
  /// target is to be covered next.
  void cover(const Exponents& monomial, const Shape& shape, std::set<std::pair<const Shape*, Exponents>>& taken,
             std::set<Exponents>& next) {
    for (const auto& [exponents, coefficient] : shape.coefficients) {
      budget_.spend(1);
      if (coefficient > 0 || multiples_.size() >= most_multiples) continue;
      auto by = quotient(monomial, exponents);
      if (!by || !known(*by) || !taken.emplace(&shape, *by).second) continue;
      for (const auto& [others, factor] : shape.coefficients) {
        const Exponents brought = product(others, *by);
        const auto there = target_.find(brought);
        if (factor > 0 && (there == target_.end() || there->second < 0)) next.insert(brought);
      }
      multiples_.push_back({&shape, std::move(*by)});
    }
  }

  /// Weights >= 0, the last variable a bound on how much is strict.
  std::optional<SlackForm> weighted() const {
    const std::size_t n = multiples_.size();
    std::map<Exponents, AffineForm> left;
    const auto at = [&](const Exponents& monomial) -> AffineForm& {
      return left.try_emplace(monomial, AffineForm{0, std::vector<Rational>(n + 1)}).first->second;
    };
    for (const auto& [monomial, coefficient] : target_) at(monomial).constant = coefficient;
    std::vector<AffineForm> constraints;
    AffineForm strictly{0, std::vector<Rational>(n + 1)};
    for (std::size_t k = 0; k < n; ++k) {
      for (const auto& [exponents, coefficient] : multiples_[k].shape->coefficients) {
        const Exponents monomial = product(exponents, multiples_[k].by);
        if (!known(monomial)) return std::nullopt;
        at(monomial).coefficients[k] -= coefficient;
      }
      AffineForm& weight = constraints.emplace_back(AffineForm{0, std::vector<Rational>(n + 1)});
      weight.coefficients[k] = 1;
      if (multiples_[k].shape->fact->sign == Sign::positive && strict(multiples_[k].by)) strictly.coefficients[k] = 1;
    }
    for (const auto& [monomial, form] : left) {
      constraints.push_back(form);
      if (!strict(monomial)) continue;
      strictly.constant += form.constant;
      for (std::size_t k = 0; k < n; ++k) strictly.coefficients[k] += form.coefficients[k];
    }
    AffineForm objective{0, std::vector<Rational>(n + 1)}, bound{1, std::vector<Rational>(n + 1)};
    objective.coefficients[n] = bound.coefficients[n] = strictly.coefficients[n] = -1;
    constraints.push_back(std::move(strictly));
    constraints.push_back(std::move(bound));
    const std::size_t steps = constraints.size() * (n + 2);
    const LinearOptimum optimum = minimize(objective, constraints, budget_.left() / steps);
    budget_.spend(optimum.pivots * steps);
    if (optimum.kind != LinearOptimum::Kind::attained) return std::nullopt;
    return form(optimum.x, left, -optimum.value > 0);
  }

  SlackForm form(const std::vector<Rational>& weights, const std::map<Exponents, AffineForm>& left,
                 bool is_strict) const {
    SlackForm result;
    result.strict = is_strict;
    for (std::size_t k = 0; k < multiples_.size(); ++k) {
      if (weights[k].is_zero()) continue;
      Product whole = as_product(multiples_[k].by);
      multiply(whole, {{multiples_[k].shape->fact->name, 1}}, 1);
      result.terms.push_back({weights[k], std::move(whole)});
    }
    for (const auto& [monomial, form] : left) {
      const Rational coefficient = form.at(weights);
      if (!coefficient.is_zero()) result.terms.push_back({coefficient, as_product(monomial)});
    }
    return result;
  }

  std::size_t size_;
  Budget& budget_;
  Coefficients target_;
  std::vector<const Fact*> signs_;  ///< for each variable, if its sign is a fact
  std::vector<Shape> shapes_;
  std::vector<Multiple> multiples_;
};

}  // namespace

std::optional<SlackForm> find_dominated_form(const std::vector<Fact>& facts, const Polynomial& p,
                                             const SampleSet& negative, Budget& budget) {
  if (p.length() > longest) return std::nullopt;
  SampleSet outside;  // where some fact is false
  for (const Fact& fact : facts) outside |= fact.fails;
  if (!outside.contains(negative)) return std::nullopt;
  return Domination(facts, p, budget).find();
}

}  // namespace slipproof::prove
