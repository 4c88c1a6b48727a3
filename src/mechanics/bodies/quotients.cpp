#include "mechanics/bodies/quotients.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/expression/parser.hpp"
#include "mechanics/mechanism/algebra.hpp"

namespace slipproof::bodies_in_motion {

namespace {

/// Parameters, the angles as t, the load; then the cosine and sine of each angle.
PolynomialRing ring_of(const Mechanism& mechanism) {
  const auto values = value_names(mechanism);
  std::vector<std::string> names(values.begin(), values.end());
  for (const MechanismAngle& angle : mechanism.angles) names.insert(names.end(), {angle.cosine, angle.sine});
  return PolynomialRing(std::move(names));
}

std::optional<MultiPolynomial> square_root(const MultiPolynomial& p) {
  constexpr std::size_t longest = 500;
  if (p.length() > longest) return std::nullopt;
  const Factorization whole = p.factors();
  const auto constant = exact_root(whole.constant);
  if (!constant) return std::nullopt;
  MultiPolynomial result(p.ring(), *constant);
  for (const auto& [factor, exponent] : whole.factors) {
    if (exponent % 2 != 0) return std::nullopt;
    result *= power(factor, exponent / 2);
  }
  return result;
}

Factorization factors_of(const MultiPolynomial& p) {
  constexpr std::size_t longest = 200;
  return p.length() > longest ? p.as_irreducible() : p.factors();
}

auto find_factor(Factorization& product, const MultiPolynomial& factor) {
  return std::ranges::find(product.factors, factor, &std::pair<MultiPolynomial, unsigned>::first);
}

/// product * by^exponent
void multiply(Factorization& product, const Factorization& by, unsigned exponent) {
  if (exponent == 0) return;
  for (unsigned i = 0; i < exponent; ++i) product.constant *= by.constant;
  for (const auto& [factor, power] : by.factors) {
    const auto known = find_factor(product, factor);
    if (known == product.factors.end()) {
      product.factors.emplace_back(factor, power * exponent);
    } else {
      known->second += power * exponent;
    }
  }
}

/// The factors without their constant, which another one replaces.
Expression product_of_factors(const Factorization& product, const Rational& constant) {
  Expression result = make_number(constant);
  for (const auto& [factor, exponent] : product.factors) {
    const Expression one = read_back(factor);
    result = product_of(result, exponent == 1 ? one : make_power(one, static_cast<int>(exponent)));
  }
  return result;
}

Quotient raised(const Quotient& base, int exponent) {
  const auto n = static_cast<std::size_t>(exponent < 0 ? -exponent : exponent);
  const Quotient result{power(base.over, n), power(base.under, n)};
  return exponent < 0 ? Quotient{result.under, result.over} : result;
}

}  // namespace

Quotients::Quotients(const Mechanism& mechanism)
    : mechanism_(mechanism), ring_(ring_of(mechanism)), circles_(ring_.size() - 2 * mechanism.angles.size()) {
  constexpr std::uint64_t enough = 2'000'000;
  ring_.budget() = Budget(enough);
  for (std::size_t i = 0; i < circles_; ++i)
    symbols_.emplace(ring_.name(i), whole(MultiPolynomial::variable(ring_, i)));
  for (std::size_t i = 0; i < mechanism.angles.size(); ++i) {
    const MultiPolynomial t = MultiPolynomial::variable(ring_, half_turn(i));
    const MultiPolynomial one(ring_, 1), square = t * t;
    symbols_.insert_or_assign(mechanism.angles[i].cosine, Quotient{one - square, one + square});
    symbols_.insert_or_assign(mechanism.angles[i].sine, Quotient{t.scaled(2), one + square});
  }
}

Quotient Quotients::of(const Expression& e) {
  switch (e->operation) {
    case Operation::number:
      return number(e->number);
    case Operation::symbol:
      return symbol(e->symbol);
    case Operation::negate: {
      const Quotient x = of(e->operands[0]);
      return {-x.over, x.under};
    }
    case Operation::power:
      return raised(of(e->operands[0]), e->exponent);
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::divide:
      return combined(e->operation, of(e->operands[0]), of(e->operands[1]));
    default:
      throw NoQuotient{};
  }
}

std::optional<Quotient> Quotients::root(const Quotient& square) const {
  if (square.under.is_zero()) return std::nullopt;
  const auto root = square_root(square.over * square.under);
  if (!root) return std::nullopt;
  return on_circles({*root, square.under});
}

Quotient Quotients::on_circles(Quotient x) const {
  x = shortened(std::move(x));
  for (std::size_t i = 0; i < mechanism_.angles.size(); ++i) {
    const std::size_t t = half_turn(i);
    const std::size_t circles = (std::max(x.over.degree(t), x.under.degree(t)) + 1) / 2;
    x = {on_circle(x.over, i, circles), on_circle(x.under, i, circles)};
  }
  return shortened(x);
}

/// Of p/(1 + t^2)^n for each angle, where n, the least one, is added to `circles`. Factors of an odd degree are taken
/// together, or squared, so that n is no larger than for p as a whole.
Factorization Quotients::factors_on_circles(const MultiPolynomial& p, std::vector<std::size_t>& circles) const {
  const Factorization whole = factors_of(p);
  Factorization result{whole.constant, {}};
  const auto add = [&](MultiPolynomial factor, unsigned exponent) {
    for (std::size_t i = 0; i < circles.size(); ++i) {
      const std::size_t n = (factor.degree(half_turn(i)) + 1) / 2;
      circles[i] += n * exponent;
      factor = on_circle(factor, i, n);
    }
    multiply(result, factors_of(factor), exponent);
  };
  MultiPolynomial odd(ring_, 1);
  for (const auto& [factor, exponent] : whole.factors) {
    bool even = true;
    for (std::size_t i = 0; i < circles.size(); ++i) even = even && factor.degree(half_turn(i)) % 2 == 0;
    if (even) {
      add(factor, exponent);
    } else {
      if (exponent > 1) add(factor * factor, exponent / 2);
      if (exponent % 2 != 0) odd *= factor;
    }
  }
  add(odd, 1);
  return result;
}

/// Where `from` is a cosine and `to` the sine of its angle, or the other way: -to^2 for (from - 1) (from + 1).
void Quotients::put_squares(Factorization& product, std::size_t from, std::size_t to) const {
  const MultiPolynomial one(ring_, 1), x = MultiPolynomial::variable(ring_, from);
  const auto less = find_factor(product, x - one), more = find_factor(product, x + one);
  if (less == product.factors.end() || more == product.factors.end()) return;
  const unsigned common = std::min(less->second, more->second);
  less->second -= common;
  more->second -= common;
  if (common % 2 != 0) product.constant = -product.constant;
  std::erase_if(product.factors, [](const auto& entry) { return entry.second == 0; });
  multiply(product, {1, {{MultiPolynomial::variable(ring_, to), 2}}}, common);
}

Quotients::Factored Quotients::factored(const Quotient& x) const {
  std::vector<std::size_t> above(mechanism_.angles.size()), below(above.size());
  Factored result{factors_on_circles(x.over, above), factors_on_circles(x.under, below)};
  for (std::size_t i = 0; i < above.size(); ++i) {
    const std::size_t cosine = circles_ + 2 * i, sine = cosine + 1;
    // 1/(1 + t^2) = (1 + cos)/2
    const Factorization circle{{1, 2}, {{MultiPolynomial::variable(ring_, cosine) + MultiPolynomial(ring_, 1), 1}}};
    const std::size_t common = std::min(above[i], below[i]);
    multiply(result.over, circle, static_cast<unsigned>(below[i] - common));
    multiply(result.under, circle, static_cast<unsigned>(above[i] - common));
    for (Factorization* product : {&result.over, &result.under}) {
      put_squares(*product, cosine, sine);
      put_squares(*product, sine, cosine);
    }
  }
  return result;
}

Expression Quotients::expression(const Quotient& x) const {
  const Quotient least = shortened(x);
  if (least.over.is_zero()) return zero_literal();
  const auto [over, under] = factored(least);
  const Rational constant = over.constant / under.constant;
  return quotient_of(product_of_factors(over, Rational(numerator(constant))),
                     product_of_factors(under, Rational(denominator(constant))));
}

Quotient Quotients::shortened(Quotient x) {
  const auto common = x.over.common_divisor(x.under);
  if (common) x = {*x.over.divided_by(*common), *x.under.divided_by(*common)};
  return x.under.is_constant() ? Quotient{x.over.scaled(1 / x.under.constant()), MultiPolynomial(x.over.ring(), 1)} : x;
}

/// p/(1 + t^2)^circles, in the cosine and sine of the angle: 1/(1 + t^2) = (1 + cos)/2, t/(1 + t^2) = sin/2 and
/// t^2/(1 + t^2) = (1 - cos)/2.
MultiPolynomial Quotients::on_circle(const MultiPolynomial& p, std::size_t angle, std::size_t circles) const {
  const MultiPolynomial one(ring_, 1), cosine = MultiPolynomial::variable(ring_, circles_ + 2 * angle),
                                       sine = MultiPolynomial::variable(ring_, circles_ + 2 * angle + 1);
  MultiPolynomial result(ring_, 0);
  for (std::size_t k = 0; k <= p.degree(half_turn(angle)); ++k) {
    result += p.coefficient(half_turn(angle), k) * power((one - cosine).scaled({1, 2}), k / 2) *
              power(sine.scaled({1, 2}), k % 2) * power((one + cosine).scaled({1, 2}), circles - (k + 1) / 2);
  }
  return result;
}

Quotient Quotients::symbol(const std::string& name) {
  if (const auto known = symbols_.find(name); known != symbols_.end()) return known->second;
  for (const MechanismDefinition& definition : mechanism_.definitions) {
    if (definition.symbol != name) continue;
    const Quotient value = of(definition.expression.expression);
    symbols_.emplace(name, value);
    return value;
  }
  throw NoQuotient{};
}

Quotient Quotients::combined(Operation operation, const Quotient& x, const Quotient& y) {
  switch (operation) {
    case Operation::multiply:
      return {x.over * y.over, x.under * y.under};
    case Operation::divide:
      return {x.over * y.under, x.under * y.over};
    default:
      break;
  }
  const bool minus = operation == Operation::subtract;
  if (x.under == y.under) return {minus ? x.over - y.over : x.over + y.over, x.under};
  const MultiPolynomial left = x.over * y.under, right = y.over * x.under;
  return {minus ? left - right : left + right, x.under * y.under};
}

Expression read_back(const MultiPolynomial& polynomial) {
  return polynomial.is_constant() ? make_number(polynomial.constant())
                                  : parse_expression(polynomial.text(), Sort::number);
}

}  // namespace slipproof::bodies_in_motion
