#include "base/algebra/polynomial.hpp"

#include <flint/flint.h>

#include <algorithm>

namespace slipproof {
namespace {

// What arithmetic costs, in steps of about 0.1 microseconds.
constexpr std::size_t products_a_step = 2, text_steps = 5, factor_steps = 40;

/// An fmpq that frees itself.
struct FlintRational {
  FlintRational() { fmpq_init(value); }
  ~FlintRational() { fmpq_clear(value); }
  FlintRational(const FlintRational&) = delete;
  FlintRational& operator=(const FlintRational&) = delete;
  Rational rational() const { return Rational(value); }
  fmpq_t value;
};

}  // namespace

PolynomialRing::PolynomialRing(std::vector<std::string> names, MonomialOrder order) : names_(std::move(names)) {
  for (const std::string& name : names_) pointers_.push_back(name.c_str());
  fmpq_mpoly_ctx_init(context_, static_cast<slong>(names_.size()),
                      order == MonomialOrder::lexicographic ? ORD_LEX : ORD_DEGREVLEX);
}

PolynomialRing::~PolynomialRing() {
  fmpq_mpoly_ctx_clear(context_);
}

struct MultiPolynomial::Value {
  explicit Value(const PolynomialRing& ring) : ring(ring) { fmpq_mpoly_init(polynomial, ring.context_); }
  ~Value() { fmpq_mpoly_clear(polynomial, ring.context_); }
  Value(const Value&) = delete;
  Value& operator=(const Value&) = delete;

  const PolynomialRing& ring;
  fmpq_mpoly_t polynomial;
  mutable std::string text;  ///< once somebody has asked for it
};

MultiPolynomial::MultiPolynomial(std::shared_ptr<const Value> value) : ring_(&value->ring), value_(std::move(value)) {}

std::shared_ptr<MultiPolynomial::Value> MultiPolynomial::blank(const PolynomialRing& ring) {
  return std::make_shared<Value>(ring);
}

MultiPolynomial::MultiPolynomial(const PolynomialRing& ring, const Rational& constant) : ring_(&ring) {
  const auto value = blank(ring);
  const fmpq flint = constant.flint();
  fmpq_mpoly_set_fmpq(value->polynomial, &flint, ring.context_);
  value_ = value;
}

MultiPolynomial MultiPolynomial::variable(const PolynomialRing& ring, std::size_t index) {
  const auto value = blank(ring);
  fmpq_mpoly_gen(value->polynomial, static_cast<slong>(index), ring.context_);
  return MultiPolynomial(value);
}

std::optional<MultiPolynomial> MultiPolynomial::parse(const PolynomialRing& ring, const std::string& text) {
  const auto value = blank(ring);
  const int error = fmpq_mpoly_set_str_pretty(value->polynomial, text.c_str(),
                                              const_cast<const char**>(ring.pointers_.data()), ring.context_);
  if (error != 0) return std::nullopt;
  return MultiPolynomial(value);
}

bool MultiPolynomial::is_zero() const {
  return fmpq_mpoly_is_zero(value_->polynomial, ring_->context_) != 0;
}
bool MultiPolynomial::is_one() const {
  return fmpq_mpoly_is_one(value_->polynomial, ring_->context_) != 0;
}
bool MultiPolynomial::is_constant() const {
  return fmpq_mpoly_is_fmpq(value_->polynomial, ring_->context_) != 0;
}

Rational MultiPolynomial::constant() const {
  FlintRational result;
  fmpq_mpoly_get_fmpq(result.value, value_->polynomial, ring_->context_);
  return result.rational();
}

Rational MultiPolynomial::leading_coefficient() const {
  FlintRational result;
  fmpq_mpoly_get_term_coeff_fmpq(result.value, value_->polynomial, 0, ring_->context_);
  return result.rational();
}

std::size_t MultiPolynomial::length() const {
  return static_cast<std::size_t>(fmpq_mpoly_length(value_->polynomial, ring_->context_));
}

std::size_t MultiPolynomial::degree(std::size_t variable) const {
  return static_cast<std::size_t>(
      std::max<slong>(0, fmpq_mpoly_degree_si(value_->polynomial, static_cast<slong>(variable), ring_->context_)));
}

std::size_t MultiPolynomial::coefficient_bits() const {
  const auto& [content, primitive] = *value_->polynomial;
  const fmpz* largest = nullptr;
  for (slong i = 0; i < primitive->length; ++i) {
    const fmpz* coefficient = primitive->coeffs + i;
    if (largest == nullptr || fmpz_cmpabs(coefficient, largest) > 0) largest = coefficient;
  }
  if (largest == nullptr) return 0;
  fmpz_t product;
  fmpz_init(product);
  fmpz_mul(product, largest, fmpq_numref(content));
  const std::size_t bits = fmpz_bits(product);
  fmpz_clear(product);
  return bits;
}

bool MultiPolynomial::has_negative_coefficient() const {
  const auto& [content, primitive] = *value_->polynomial;
  const int sign = fmpq_sgn(content);
  for (slong i = 0; i < primitive->length; ++i) {
    if (fmpz_sgn(primitive->coeffs + i) * sign < 0) return true;
  }
  return false;
}

std::vector<std::size_t> MultiPolynomial::variables() const {
  std::vector<std::size_t> result;
  std::vector<slong> degrees(ring_->size());
  fmpq_mpoly_degrees_si(degrees.data(), value_->polynomial, ring_->context_);
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    if (degrees[i] > 0) result.push_back(i);
  }
  return result;
}

std::vector<Term> MultiPolynomial::terms() const {
  std::vector<Term> result;
  FlintRational coefficient;
  for (std::size_t i = 0; i < length(); ++i) {
    Term term{0, std::vector<unsigned long>(ring_->size())};
    fmpq_mpoly_get_term_coeff_fmpq(coefficient.value, value_->polynomial, static_cast<slong>(i), ring_->context_);
    fmpq_mpoly_get_term_exp_ui(term.exponents.data(), value_->polynomial, static_cast<slong>(i), ring_->context_);
    term.coefficient = coefficient.rational();
    result.push_back(std::move(term));
  }
  return result;
}

MultiPolynomial MultiPolynomial::coefficient(std::size_t variable, std::size_t exponent) const {
  const auto result = blank(*ring_);
  const slong variables[] = {static_cast<slong>(variable)};
  const ulong exponents[] = {exponent};
  fmpq_mpoly_get_coeff_vars_ui(result->polynomial, value_->polynomial, variables, exponents, 1, ring_->context_);
  return MultiPolynomial(result);
}

const std::string& MultiPolynomial::text() const {
  ring_->budget().spend(length() * text_steps + 1);
  std::string& known = value_->text;
  if (!known.empty()) return known;
  // The pretty-printer does not change the names, though it takes them as pointers to non-const.
  char* text =
      fmpq_mpoly_get_str_pretty(value_->polynomial, const_cast<const char**>(ring_->pointers_.data()), ring_->context_);
  known = text;
  flint_free(text);
  return known;
}

MultiPolynomial& MultiPolynomial::operator+=(const MultiPolynomial& other) {
  if (other.is_zero()) return *this;
  if (is_zero()) return *this = other;
  const auto result = blank(*ring_);
  fmpq_mpoly_add(result->polynomial, value_->polynomial, other.value_->polynomial, ring_->context_);
  value_ = result;
  return *this;
}

MultiPolynomial& MultiPolynomial::operator-=(const MultiPolynomial& other) {
  if (other.is_zero()) return *this;
  const auto result = blank(*ring_);
  fmpq_mpoly_sub(result->polynomial, value_->polynomial, other.value_->polynomial, ring_->context_);
  value_ = result;
  return *this;
}

MultiPolynomial& MultiPolynomial::operator*=(const MultiPolynomial& other) {
  ring_->budget().spend(length() * other.length() / products_a_step + 1);
  if (other.is_one()) return *this;
  if (is_one()) return *this = other;
  const auto result = blank(*ring_);
  fmpq_mpoly_mul(result->polynomial, value_->polynomial, other.value_->polynomial, ring_->context_);
  value_ = result;
  return *this;
}

MultiPolynomial MultiPolynomial::operator-() const {
  return scaled(-1);
}

bool MultiPolynomial::operator==(const MultiPolynomial& other) const {
  return fmpq_mpoly_equal(value_->polynomial, other.value_->polynomial, ring_->context_) != 0;
}

MultiPolynomial MultiPolynomial::scaled(const Rational& factor) const {
  const auto result = blank(*ring_);
  const fmpq flint = factor.flint();
  fmpq_mpoly_scalar_mul_fmpq(result->polynomial, value_->polynomial, &flint, ring_->context_);
  return MultiPolynomial(result);
}

std::optional<MultiPolynomial> MultiPolynomial::divided_by(const MultiPolynomial& divisor) const {
  ring_->budget().spend(length() + divisor.length());
  const auto result = blank(*ring_);
  if (fmpq_mpoly_divides(result->polynomial, value_->polynomial, divisor.value_->polynomial, ring_->context_) == 0)
    return std::nullopt;
  return MultiPolynomial(result);
}

std::optional<MultiPolynomial> MultiPolynomial::common_divisor(const MultiPolynomial& other) const {
  ring_->budget().spend(length() + other.length());
  const auto result = blank(*ring_);
  if (fmpq_mpoly_gcd(result->polynomial, value_->polynomial, other.value_->polynomial, ring_->context_) == 0)
    return std::nullopt;
  return MultiPolynomial(result);
}

Factorization MultiPolynomial::as_irreducible() const {
  Integer numerators = 0, denominators = 1;
  for (const Term& term : terms()) {
    numerators = gcd(numerators, numerator(term.coefficient));
    denominators = lcm(denominators, denominator(term.coefficient));
  }
  Rational content(numerators, denominators);
  if (leading_coefficient() < 0) content = -content;
  return {content, {{scaled(1 / content), 1}}};
}

Factorization MultiPolynomial::factors() const {
  Factorization result{0, {}};
  if (is_zero()) return result;
  ring_->budget().spend(length() * (factor_steps + length() / 8));
  fmpq_mpoly_factor_t factorization;
  fmpq_mpoly_factor_init(factorization, ring_->context_);
  if (fmpq_mpoly_factor(factorization, value_->polynomial, ring_->context_) == 0) {
    fmpq_mpoly_factor_clear(factorization, ring_->context_);
    return as_irreducible();
  }
  fmpq_mpoly_factor_make_integral(factorization, ring_->context_);
  FlintRational constant;
  fmpq_mpoly_factor_get_constant_fmpq(constant.value, factorization, ring_->context_);
  result.constant = constant.rational();
  for (slong i = 0; i < factorization->num; ++i) {
    const auto base = blank(*ring_);
    fmpq_mpoly_factor_get_base(base->polynomial, factorization, i, ring_->context_);
    MultiPolynomial factor(base);
    const unsigned exponent = static_cast<unsigned>(fmpq_mpoly_factor_get_exp_si(factorization, i, ring_->context_));
    if (factor.leading_coefficient() < 0) {
      factor = -factor;
      if (exponent % 2 == 1) result.constant = -result.constant;
    }
    result.factors.emplace_back(std::move(factor), exponent);
  }
  fmpq_mpoly_factor_clear(factorization, ring_->context_);
  return result;
}

MultiPolynomial power(const MultiPolynomial& base, std::size_t exponent) {
  MultiPolynomial result(base.ring(), 1);
  for (std::size_t i = 0; i < exponent; ++i) result *= base;
  return result;
}

MultiPolynomial substitute(const MultiPolynomial& p, std::size_t variable, const MultiPolynomial& numerator,
                           const MultiPolynomial& denominator) {
  std::size_t k = p.degree(variable);
  MultiPolynomial result = p.coefficient(variable, k), denominators(p.ring(), 1);
  while (k-- > 0) {
    denominators *= denominator;
    result = result * numerator + p.coefficient(variable, k) * denominators;
  }
  return result;
}

}  // namespace slipproof
