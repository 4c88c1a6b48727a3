#include "claims/meaning/second_judge/critical.hpp"

#include <algorithm>

namespace slipproof::meaning {

namespace {

/// Over everything that it was divided by: nothing is cancelled.
struct Fraction {
  Polynomial above, below;
};

/// More would take longer than it is worth.
constexpr std::size_t most_alternatives = 64;

class Walk {
 public:
  explicit Walk(const Variables& variables) : variables_(variables) {}

  std::vector<Polynomial> found;

  void truth(const Tree& tree) {
    if (tree->op != Op::chain) {
      for (const Tree& part : tree->parts) truth(part);
      return;
    }
    for (std::size_t i = 0; i < tree->relations.size(); ++i) {
      watch_differences(numbers(tree->parts[i]), numbers(tree->parts[i + 1]));
    }
  }

  /// All that a number may be, by which side each `min`, `max`, `abs` and `sign` in it takes; none if undefined.
  std::vector<Fraction> numbers(const Tree& tree) {
    switch (tree->op) {
      case Op::number:
        return {{tree->number, Rational(1)}};
      case Op::symbol:
        return of_symbol(tree->symbol);
      case Op::negate:
      case Op::absolute:
      case Op::signum:
        return of_one(tree->op, numbers(tree->parts[0]));
      case Op::power:
        return of_power(numbers(tree->parts[0]), tree->exponent);
      default:
        return of_two(tree->op, numbers(tree->parts[0]), numbers(tree->parts[1]));
    }
  }

 private:
  void watch(const Polynomial& polynomial) {
    if (!polynomial.is_number()) found.push_back(polynomial);
  }

  void watch_differences(const std::vector<Fraction>& left, const std::vector<Fraction>& right) {
    for (const Fraction& x : left) {
      for (const Fraction& y : right) watch(x.above * y.below - y.above * x.below);
    }
  }

  std::vector<Fraction> of_symbol(const std::string& name) {
    if (const auto found = variables_.symbols.find(name); found != variables_.symbols.end()) {
      return {{found->second, Rational(1)}};
    }
    const auto value = variables_.names.values.find(name);
    if (value != variables_.names.values.end()) return {{value->second, Rational(1)}};
    return numbers(variables_.names.definitions.at(name));
  }

  std::vector<Fraction> of_one(Op op, const std::vector<Fraction>& operands) {
    std::vector<Fraction> result;
    for (const Fraction& x : operands) {
      if (op != Op::negate) watch(x.above);
      if (op == Op::absolute) result.push_back(x);
      if (op != Op::signum) result.push_back({Polynomial() - x.above, x.below});
    }
    if (op == Op::signum && !operands.empty()) {
      for (const int value : {-1, 0, 1}) result.push_back({Rational(value), Rational(1)});
    }
    return result;
  }

  std::vector<Fraction> of_power(const std::vector<Fraction>& bases, int exponent) {
    std::vector<Fraction> result;
    for (const Fraction& base : bases) {
      Fraction power{Rational(1), Rational(1)};
      for (int i = 0; i < std::abs(exponent); ++i) power = {power.above * base.above, power.below * base.below};
      if (exponent < 0) {
        watch(base.above);
        if (base.above.is_zero()) continue;
        std::swap(power.above, power.below);
      }
      result.push_back(power);
    }
    return result;
  }

  std::vector<Fraction> of_two(Op op, const std::vector<Fraction>& left, const std::vector<Fraction>& right) {
    if (left.size() * right.size() > most_alternatives) throw OutOfReach("many alternatives");
    if (op == Op::minimum || op == Op::maximum) {
      watch_differences(left, right);
      std::vector<Fraction> both = left;
      both.insert(both.end(), right.begin(), right.end());
      return left.empty() || right.empty() ? std::vector<Fraction>() : both;
    }
    std::vector<Fraction> result;
    for (const Fraction& x : left) {
      for (const Fraction& y : right) {
        if (op == Op::divide) watch(y.above);
        if (op == Op::divide && y.above.is_zero()) continue;
        result.push_back(of_two(op, x, y));
      }
    }
    return result;
  }

  static Fraction of_two(Op op, const Fraction& x, const Fraction& y) {
    switch (op) {
      case Op::add:
        return {x.above * y.below + y.above * x.below, x.below * y.below};
      case Op::subtract:
        return {x.above * y.below - y.above * x.below, x.below * y.below};
      case Op::multiply:
        return {x.above * y.above, x.below * y.below};
      default:
        return {x.above * y.below, x.below * y.above};
    }
  }

  const Variables& variables_;
};

/// Nothing if it is not a rational one.
std::optional<Rational> square_root(const Rational& square) {
  if (square < 0) return std::nullopt;
  const Rational root(sqrt(numerator(square)), sqrt(denominator(square)));
  return root * root == square ? std::optional(root) : std::nullopt;
}

}  // namespace

Polynomial::Polynomial(const Rational& constant) {
  if (constant != 0) terms_[{}] = constant;
}

Polynomial Polynomial::variable(const std::string& name) {
  Polynomial result;
  result.terms_[{{name, 1}}] = 1;
  return result;
}

int Polynomial::degree() const {
  int highest = 0;
  for (const auto& [monomial, coefficient] : terms_) {
    int degree = 0;
    for (const auto& [variable, exponent] : monomial) degree += exponent;
    highest = std::max(highest, degree);
  }
  return highest;
}

Rational Polynomial::coefficient(const Monomial& monomial) const {
  const auto found = terms_.find(monomial);
  return found == terms_.end() ? Rational(0) : found->second;
}

Polynomial Polynomial::at(const std::string& variable, const Rational& value) const {
  Polynomial result;
  for (const auto& [monomial, coefficient] : terms_) {
    Monomial rest = monomial;
    const auto place = rest.find(variable);
    const int exponent = place == rest.end() ? 0 : place->second;
    if (place != rest.end()) rest.erase(place);
    Polynomial term;
    term.terms_[rest] = coefficient;
    result = result + term * Polynomial(*to_power(value, exponent));
  }
  return result;
}

Polynomial operator+(const Polynomial& x, const Polynomial& y) {
  Polynomial result = x;
  for (const auto& [monomial, coefficient] : y.terms_) {
    Rational& sum = result.terms_[monomial];
    sum += coefficient;
    if (sum == 0) result.terms_.erase(monomial);
  }
  return result;
}

Polynomial operator-(const Polynomial& x, const Polynomial& y) {
  return x + Polynomial(Rational(-1)) * y;
}

Polynomial operator*(const Polynomial& x, const Polynomial& y) {
  Polynomial result;
  for (const auto& [left, p] : x.terms_) {
    for (const auto& [right, q] : y.terms_) {
      Polynomial::Monomial monomial = left;
      for (const auto& [variable, exponent] : right) monomial[variable] += exponent;
      Polynomial term;
      term.terms_[monomial] = p * q;
      result = result + term;
    }
  }
  return result;
}

std::vector<Polynomial> critical(const Tree& tree, const Variables& variables) {
  Walk walk(variables);
  const bool condition = tree->op == Op::truth || tree->op == Op::chain || tree->op == Op::negation ||
                         tree->op == Op::conjunction || tree->op == Op::disjunction;
  if (condition) {
    walk.truth(tree);
  } else {
    walk.numbers(tree);
  }
  return walk.found;
}

std::set<Rational> zeros(const Polynomial& polynomial, const std::string& variable) {
  const Rational c = polynomial.constant(), b = polynomial.slope(variable);
  const Rational a = polynomial.coefficient({{variable, 2}});
  if (polynomial.degree() == 0) return {};
  if (polynomial.degree() == 1) return {Rational(-c / b)};
  if (polynomial.degree() > 2) throw OutOfReach("degree above two");
  const Rational discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return {};
  const auto root = square_root(discriminant);
  if (!root) throw OutOfReach("irrational zeros");
  return {Rational((-b - *root) / (2 * a)), Rational((-b + *root) / (2 * a))};
}

std::vector<Rational> everywhere(const std::set<Rational>& points) {
  if (points.empty()) return {Rational(0)};
  std::vector<Rational> result = {*points.begin() - 1};
  for (auto point = points.begin(); point != points.end(); ++point) {
    if (point != points.begin()) result.push_back((result.back() + *point) / 2);
    result.push_back(*point);
  }
  result.push_back(result.back() + 1);
  return result;
}

}  // namespace slipproof::meaning
