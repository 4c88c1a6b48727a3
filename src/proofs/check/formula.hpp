// Expressions and formulas: what they mean, and how they are read (grammar and normal form: proofs/FORMAT.md).
#pragma once

#include "proofs/check/polynomial.hpp"

namespace slipproof::check {

inline constexpr std::size_t kMaxAtoms = 100'000;  ///< of a formula
/// in a value of a statement or witness, without those in the names it uses
inline constexpr int kMaxOperators = 1'000;

/// numerator / denominator, defined where no polynomial in `divisors` is zero; the denominator is a product of those.
struct Fraction {
  Polynomial numerator;
  std::optional<Polynomial> denominator{};  ///< none is 1, where nothing is divided
  std::vector<Polynomial> divisors{};       ///< those that are not constant, each once
};

enum class Kind { zero, positive, non_negative, conjunction, disjunction };

/// p = 0, p > 0, p >= 0, or a conjunction or disjunction; of no parts the one is true, the other false.
struct Formula {
  Kind kind = Kind::zero;
  Polynomial polynomial{};
  std::vector<Formula> parts{};
  int depth = 0;
  std::size_t atoms = 1;
};

/// A conjunction or disjunction; of one part it is that part.
inline Formula combine(Kind kind, std::vector<Formula> parts) {
  if (parts.size() == 1) return Formula(std::move(parts.front()));
  int depth = 0;
  std::size_t atoms = 0;
  for (const Formula& part : parts) {
    depth = std::max(depth, part.depth + 1);
    atoms += part.atoms;
  }
  require(depth <= kMaxNesting, "a formula is nested too deeply");
  require(atoms <= kMaxAtoms, "a formula has too many comparisons");
  return {kind, {}, std::move(parts), depth, atoms};
}

inline Formula non_zero(const Polynomial& p) {
  return combine(Kind::disjunction, {{Kind::positive, p}, {Kind::positive, -p}});
}

inline Formula negation(const Formula& formula) {
  const Polynomial& p = formula.polynomial;
  if (formula.kind == Kind::zero) return non_zero(p);
  if (formula.kind == Kind::positive) return {Kind::non_negative, -p};
  if (formula.kind == Kind::non_negative) return {Kind::positive, -p};
  std::vector<Formula> parts;
  for (const Formula& part : formula.parts) parts.push_back(negation(part));
  return combine(formula.kind == Kind::conjunction ? Kind::disjunction : Kind::conjunction, std::move(parts));
}

/// The meanings of names.
struct Names {
  std::map<std::string, Fraction, std::less<>> values;
  std::map<std::string, Formula, std::less<>> formulas;
};

/// Reads expressions and formulas in the names given so far, by a function for each line of the grammar.
class FormulaReader : public Reader {
 public:
  using Reader::Reader;
  Names names;

  Formula formula() {
    std::vector<Formula> parts;
    do parts.push_back(conjunction());
    while (accept("or"));
    return combine(Kind::disjunction, std::move(parts));
  }

  Fraction value() {
    operators_ = 0;
    Fraction result = expression();
    require(operators_ <= kMaxOperators, "an expression has too many operators");
    return result;
  }

  /// An expression without division, in names of expressions without division.
  Polynomial polynomial() {
    Fraction value = expression();
    require(!value.denominator, "expected a polynomial with integer coefficients");
    return std::move(value.numerator);
  }

 private:
  /// The contents of brackets. A failure ends the reading, so the depth need not come down after one.
  template <class Read>
  auto nested(const char* closing, Read read) {
    require(++nesting_ <= kMaxNesting, "nested too deeply");
    auto result = read();
    expect(closing);
    --nesting_;
    return result;
  }

  Formula conjunction() {
    std::vector<Formula> parts;
    do parts.push_back(unit());
    while (accept("and"));
    return combine(Kind::conjunction, std::move(parts));
  }

  Formula unit() {
    if (accept("{")) return nested("}", [this] { return formula(); });
    if (accept("false")) return combine(Kind::disjunction, {});
    const auto named = names.formulas.find(peek());
    if (named == names.formulas.end()) return comparison_chain();
    name();
    return named->second;
  }

  Formula comparison_chain() {
    std::vector<Formula> parts;
    Fraction left = value();
    while (peek().find_first_of("<>=") != std::string_view::npos) {
      const std::string relation = take();
      Fraction right = value();
      parts.push_back(comparison(std::move(left), relation, right));
      left = std::move(right);
    }
    require(!parts.empty(), "expected a comparison");
    return combine(Kind::conjunction, std::move(parts));
  }

  /// x - y = n/d, and where d is not zero, n/d > 0 says n d > 0. The divisors come first, each as a condition.
  static Formula comparison(Fraction x, const std::string& relation, Fraction y) {
    const auto [n, denominator, divisors] = sum(std::move(x), negative(std::move(y)));
    const Polynomial d = one_or(denominator);
    std::vector<Formula> parts;
    for (const Polynomial& divisor : divisors) parts.push_back(non_zero(divisor));
    if (relation == "!=") parts.push_back(non_zero(n));
    if (relation == "=") parts.push_back({Kind::zero, n});
    if (relation == "<") parts.push_back({Kind::positive, -(n * d)});
    if (relation == "<=") parts.push_back({Kind::non_negative, -(n * d)});
    if (relation == ">") parts.push_back({Kind::positive, n * d});
    if (relation == ">=") parts.push_back({Kind::non_negative, n * d});
    return combine(Kind::conjunction, std::move(parts));
  }

  Fraction expression() {
    Fraction result = product();
    while (true) {
      const bool minus = accept("-");
      if (!minus && !accept("+")) return result;
      ++operators_;
      result = sum(std::move(result), minus ? negative(product()) : product());
    }
  }

  Fraction product() {
    Fraction result = power();
    while (true) {
      const bool divide = accept("/");
      if (!divide && !accept("*")) return result;
      ++operators_;
      result = times(std::move(result), divide ? inverse(power()) : power());
    }
  }

  Fraction power() {
    bool minus = false;
    while (accept("-")) minus = !minus;
    Fraction result = base();
    if (accept("^")) {
      const Fraction factor = result;
      for (int n = exponent(); n > 1; --n) result = times(std::move(result), factor);
    }
    return minus ? negative(std::move(result)) : result;
  }

  Fraction base() {
    if (accept("(")) return nested(")", [this] { return expression(); });
    const auto named = names.values.find(peek());
    if (named == names.values.end()) return {Polynomial(number())};
    name();
    return named->second;
  }

  static Polynomial one_or(const std::optional<Polynomial>& p) { return p.value_or(Polynomial(1)); }

  static Fraction negative(Fraction x) {
    x.numerator = -std::move(x.numerator);
    return x;
  }

  static Fraction sum(Fraction x, Fraction y) {
    add_divisors(x, y.divisors);
    if (x.denominator == y.denominator) {
      x.numerator += std::move(y.numerator);
    } else {
      x.numerator = x.numerator * one_or(y.denominator);
      x.numerator += y.numerator * one_or(x.denominator);
      x.denominator = one_or(x.denominator) * one_or(y.denominator);
    }
    return x;
  }

  static Fraction times(Fraction x, const Fraction& y) {
    add_divisors(x, y.divisors);
    x.numerator = x.numerator * y.numerator;
    if (y.denominator) x.denominator = one_or(x.denominator) * *y.denominator;
    return x;
  }

  static Fraction inverse(Fraction x) {
    require(!x.numerator.is_zero(), "division by zero");
    add_divisors(x, {x.numerator});
    x.denominator = std::exchange(x.numerator, one_or(x.denominator));
    return x;
  }

  static void add_divisors(Fraction& x, const std::vector<Polynomial>& more) {
    Work::spend(x.divisors.size() * more.size());
    for (const Polynomial& p : more) {
      const bool known = std::find(x.divisors.begin(), x.divisors.end(), p) != x.divisors.end();
      if (!known && !p.is_constant()) x.divisors.push_back(p);
    }
  }

  int nesting_ = 0, operators_ = 0;
};

}  // namespace slipproof::check
