#include "proofs/branch/slack.hpp"

#include <utility>

namespace slipproof::prove {
namespace {

/// What a coordinate is a product of; absent while its sign is not known.
struct Slot {
  Product product;
  bool strict = true;
};

/// A replacement that is in use.
struct Substitution {
  Replacement replacement;
  Product denominator_product;
  std::size_t degree;  ///< of the polynomial before: the number of times it was multiplied by the denominator
};

struct Coordinates {
  std::vector<std::optional<Slot>> slots;
  std::vector<Substitution> substitutions;
};

class SlackSearch {
 public:
  SlackSearch(const std::vector<Fact>& facts, const std::vector<Fact>& derived, const SampleSet& negative, int attempts,
              Replacements& replacements, Budget& budget)
      : facts_(facts),
        derived_(derived),
        negative_(negative),
        attempts_(attempts),
        replacements_(replacements),
        budget_(budget) {}

  std::optional<SlackForm> run(const Polynomial& p, int depth) {
    Coordinates start;
    start.slots.resize(p.ring().size());
    SampleSet outside;  // where a fact in use is false
    for (const Fact& fact : facts_) {
      if (fact.sign == Sign::zero || fact.p.length() != 1) continue;
      const std::vector<std::size_t> variables = fact.p.variables();
      if (variables.size() != 1 || fact.p.degree(variables[0]) != 1) continue;
      if (!(fact.p == Polynomial::variable(p.ring(), variables[0]))) continue;
      outside |= fact.fails;
      std::optional<Slot>& slot = start.slots[variables[0]];
      if (!slot || fact.sign == Sign::positive) slot = Slot{{{fact.name, 1}}, fact.sign == Sign::positive};
    }
    for (int d = 0; d <= depth && attempts_ > 0; ++d) {
      if (auto found = extend(start, p, outside, d)) return found;
    }
    return std::nullopt;
  }

 private:
  std::optional<SlackForm> read_off(const Coordinates& at, const Polynomial& p) const {
    if (p.has_negative_coefficient()) return std::nullopt;
    SlackForm result;
    for (const Substitution& s : at.substitutions) {
      multiply(result.multiplier, s.denominator_product, static_cast<unsigned>(s.degree));
    }
    for (const Term& term : p.terms()) {
      WeightedProduct product{term.coefficient, {}};
      bool strict = true;
      for (std::size_t i = 0; i < term.exponents.size(); ++i) {
        if (term.exponents[i] == 0) continue;
        if (!at.slots[i]) return std::nullopt;
        multiply(product.product, at.slots[i]->product, static_cast<unsigned>(term.exponents[i]));
        strict = strict && at.slots[i]->strict;
      }
      result.strict = result.strict || strict;
      result.terms.push_back(std::move(product));
    }
    return result;
  }

  /// The product that a denominator is, where every factor of it is known to be positive.
  std::optional<Product> positive_product(const Coordinates& at, const Polynomial& c) const {
    if (c.is_one()) return Product();
    if (c.length() == 1) {
      Product result;
      const Term term = c.terms().front();
      for (std::size_t i = 0; i < term.exponents.size(); ++i) {
        if (term.exponents[i] == 0) continue;
        if (!at.slots[i] || !at.slots[i]->strict) return std::nullopt;
        multiply(result, at.slots[i]->product, static_cast<unsigned>(term.exponents[i]));
      }
      return result;
    }
    if (!at.substitutions.empty()) return std::nullopt;
    for (const std::vector<Fact>* known : {&facts_, &derived_}) {
      for (const Fact& fact : *known) {
        if (fact.sign == Sign::positive && fact.p == c) return Product{{fact.name, 1}};
      }
    }
    return std::nullopt;
  }

  /// Whether some fact, with those in use, excludes all samples at which p is negative.
  bool possible(const SampleSet& outside) const {
    for (const Fact& fact : facts_) {
      if (fact.sign != Sign::zero && (outside | fact.fails).contains(negative_)) return true;
    }
    return false;
  }

  /// p in the new coordinates; its denominators go into `multiplier`.
  Polynomial in_coordinates(const Coordinates& at, Polynomial p, Product& multiplier) const {
    for (const Substitution& s : at.substitutions) {
      const std::size_t degree = p.degree(s.replacement.variable);
      if (degree == 0) continue;
      multiply(multiplier, s.denominator_product, static_cast<unsigned>(degree));
      p = replacements_.applied(s.replacement, p);
    }
    return p;
  }

  /// The coordinates are the same afterwards, unless a form is found.
  std::optional<SlackForm> extend(Coordinates& at, const Polynomial& p, const SampleSet& outside, int depth) {
    if (depth == 0 && !outside.contains(negative_)) return std::nullopt;
    if (--attempts_ < 0) return std::nullopt;
    budget_.spend(p.length() + 1);
    if (depth == 0) return read_off(at, p);
    for (const Fact& fact : facts_) {
      budget_.spend(1);
      if (fact.sign == Sign::zero || fact.p.length() > 60) continue;
      const SampleSet next_outside = outside | fact.fails;
      if (depth == 1 ? !next_outside.contains(negative_) : !possible(next_outside)) continue;
      Product scale;
      const Polynomial slack = in_coordinates(at, fact.p, scale);
      for (const std::size_t variable : slack.variables()) {
        const bool replaced = [&] {
          for (const Substitution& s : at.substitutions) {
            if (s.replacement.variable == variable) return true;
          }
          return false;
        }();
        if (replaced || slack.degree(variable) != 1 || !p.contains(variable)) continue;
        if (slack.length() == 1 && at.slots[variable]) continue;
        Replacement replacement = replacements_.solved(slack, variable);
        auto denominator = positive_product(at, replacement.denominator);
        if (!denominator) continue;
        const Polynomial next_p = replacements_.applied(replacement, p);
        budget_.spend(next_p.length() + p.length());
        if (next_p.length() > 400) continue;
        Slot slot{scale, fact.sign == Sign::positive};
        slot.product[fact.name] += 1;
        std::optional<Slot> before = std::exchange(at.slots[variable], std::move(slot));
        at.substitutions.push_back({std::move(replacement), *std::move(denominator), p.degree(variable)});
        if (auto found = extend(at, next_p, next_outside, depth - 1)) return found;
        at.slots[variable] = std::move(before);
        at.substitutions.pop_back();
        if (attempts_ < 0) return std::nullopt;
      }
    }
    return std::nullopt;
  }

  const std::vector<Fact>& facts_;
  const std::vector<Fact>& derived_;
  const SampleSet& negative_;
  int attempts_;
  Replacements& replacements_;
  Budget& budget_;
};

}  // namespace

std::optional<SlackForm> find_slack_form(const std::vector<Fact>& facts, const std::vector<Fact>& derived,
                                         const Polynomial& p, const SampleSet& negative, SlackEffort effort,
                                         Replacements& replacements) {
  return SlackSearch(facts, derived, negative, effort.attempts, replacements, p.ring().budget()).run(p, effort.depth);
}

}  // namespace slipproof::prove
