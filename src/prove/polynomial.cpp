#include "prove/polynomial.hpp"

#include <flint/flint.h>

#include <algorithm>
#include <stdexcept>

namespace slipproof::prove {
namespace {

// What arithmetic costs, in steps of about 0.1 microseconds.
constexpr std::size_t products_a_step = 2, text_steps = 5, factor_steps = 40;
/// Factoring cannot be stopped; what is longer is taken for irreducible.
constexpr std::size_t longest_factored = 2'000;

/// An fmpq that frees itself.
struct FlintRational {
  FlintRational() { fmpq_init(value); }
  explicit FlintRational(const Rational& x) : FlintRational() { fmpq_set_mpq(value, x.backend().data()); }
  ~FlintRational() { fmpq_clear(value); }
  FlintRational(const FlintRational&) = delete;
  FlintRational& operator=(const FlintRational&) = delete;
  Rational rational() const {
    Rational result;
    fmpq_get_mpq(result.backend().data(), value);
    return result;
  }
  fmpq_t value;
};

}  // namespace

Ring::Ring(std::vector<std::string> names) : names_(std::move(names)) {
  for (const std::string& name : names_) pointers_.push_back(name.c_str());
  fmpq_mpoly_ctx_init(context_, static_cast<slong>(names_.size()), ORD_LEX);
}

Ring::~Ring() {
  fmpq_mpoly_ctx_clear(context_);
}

struct Polynomial::Value {
  explicit Value(const Ring& ring) : ring(ring) { fmpq_mpoly_init(polynomial, ring.context_); }
  ~Value() { fmpq_mpoly_clear(polynomial, ring.context_); }
  Value(const Value&) = delete;
  Value& operator=(const Value&) = delete;

  const Ring& ring;
  fmpq_mpoly_t polynomial;
};

Polynomial::Polynomial(std::shared_ptr<const Value> value) : ring_(&value->ring), value_(std::move(value)) {}

std::shared_ptr<Polynomial::Value> Polynomial::blank(const Ring& ring) {
  return std::make_shared<Value>(ring);
}

Polynomial::Polynomial(const Ring& ring, const Rational& constant) : ring_(&ring) {
  const auto value = blank(ring);
  fmpq_mpoly_set_fmpq(value->polynomial, FlintRational(constant).value, ring.context_);
  value_ = value;
}

Polynomial Polynomial::variable(const Ring& ring, std::size_t index) {
  const auto value = blank(ring);
  fmpq_mpoly_gen(value->polynomial, static_cast<slong>(index), ring.context_);
  return Polynomial(value);
}

std::optional<Polynomial> Polynomial::parse(const Ring& ring, const std::string& text) {
  const auto value = blank(ring);
  const int error = fmpq_mpoly_set_str_pretty(value->polynomial, text.c_str(),
                                              const_cast<const char**>(ring.pointers_.data()), ring.context_);
  if (error != 0) return std::nullopt;
  return Polynomial(value);
}

bool Polynomial::is_zero() const {
  return fmpq_mpoly_is_zero(value_->polynomial, ring_->context_) != 0;
}
bool Polynomial::is_constant() const {
  return fmpq_mpoly_is_fmpq(value_->polynomial, ring_->context_) != 0;
}

Rational Polynomial::constant() const {
  FlintRational result;
  fmpq_mpoly_get_fmpq(result.value, value_->polynomial, ring_->context_);
  return result.rational();
}

std::size_t Polynomial::length() const {
  return static_cast<std::size_t>(fmpq_mpoly_length(value_->polynomial, ring_->context_));
}

std::size_t Polynomial::degree(std::size_t variable) const {
  return static_cast<std::size_t>(
      std::max<slong>(0, fmpq_mpoly_degree_si(value_->polynomial, static_cast<slong>(variable), ring_->context_)));
}

std::size_t Polynomial::coefficient_bits() const {
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

std::vector<std::size_t> Polynomial::variables() const {
  std::vector<std::size_t> result;
  std::vector<slong> degrees(ring_->size());
  fmpq_mpoly_degrees_si(degrees.data(), value_->polynomial, ring_->context_);
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    if (degrees[i] > 0) result.push_back(i);
  }
  return result;
}

std::vector<Term> Polynomial::terms() const {
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

Polynomial Polynomial::coefficient(std::size_t variable, std::size_t exponent) const {
  const auto result = blank(*ring_);
  const slong variables[] = {static_cast<slong>(variable)};
  const ulong exponents[] = {exponent};
  fmpq_mpoly_get_coeff_vars_ui(result->polynomial, value_->polynomial, variables, exponents, 1, ring_->context_);
  return Polynomial(result);
}

std::string Polynomial::text() const {
  ring_->budget().spend(length() * text_steps + 1);
  // The pretty-printer does not change the names, though it takes them as pointers to non-const.
  char* text =
      fmpq_mpoly_get_str_pretty(value_->polynomial, const_cast<const char**>(ring_->pointers_.data()), ring_->context_);
  std::string result(text);
  flint_free(text);
  return result;
}

Polynomial& Polynomial::operator+=(const Polynomial& other) {
  const auto result = blank(*ring_);
  fmpq_mpoly_add(result->polynomial, value_->polynomial, other.value_->polynomial, ring_->context_);
  value_ = result;
  return *this;
}

Polynomial& Polynomial::operator-=(const Polynomial& other) {
  const auto result = blank(*ring_);
  fmpq_mpoly_sub(result->polynomial, value_->polynomial, other.value_->polynomial, ring_->context_);
  value_ = result;
  return *this;
}

Polynomial& Polynomial::operator*=(const Polynomial& other) {
  ring_->budget().spend(length() * other.length() / products_a_step + 1);
  const auto result = blank(*ring_);
  fmpq_mpoly_mul(result->polynomial, value_->polynomial, other.value_->polynomial, ring_->context_);
  value_ = result;
  return *this;
}

Polynomial Polynomial::operator-() const {
  return scaled(-1);
}

bool Polynomial::operator==(const Polynomial& other) const {
  return fmpq_mpoly_equal(value_->polynomial, other.value_->polynomial, ring_->context_) != 0;
}

Polynomial Polynomial::scaled(const Rational& factor) const {
  const auto result = blank(*ring_);
  fmpq_mpoly_scalar_mul_fmpq(result->polynomial, value_->polynomial, FlintRational(factor).value, ring_->context_);
  return Polynomial(result);
}

std::optional<Polynomial> Polynomial::divided_by(const Polynomial& divisor) const {
  ring_->budget().spend(length() + divisor.length());
  const auto result = blank(*ring_);
  if (fmpq_mpoly_divides(result->polynomial, value_->polynomial, divisor.value_->polynomial, ring_->context_) == 0)
    return std::nullopt;
  return Polynomial(result);
}

/// As if it were irreducible: its content and its primitive part.
Factorization Polynomial::unfactored() const {
  Integer numerators = 0, denominators = 1;
  for (const Term& term : terms()) {
    numerators = gcd(numerators, Integer(numerator(term.coefficient)));
    denominators = lcm(denominators, Integer(denominator(term.coefficient)));
  }
  Rational content(numerators, denominators);
  if (terms().front().coefficient < 0) content = -content;
  return {content, {{scaled(1 / content), 1}}};
}

Factorization Polynomial::factors() const {
  Factorization result{0, {}};
  if (is_zero()) return result;
  if (length() > longest_factored) return unfactored();
  ring_->budget().spend(length() * (factor_steps + length() / 8));
  fmpq_mpoly_factor_t factorization;
  fmpq_mpoly_factor_init(factorization, ring_->context_);
  if (fmpq_mpoly_factor(factorization, value_->polynomial, ring_->context_) == 0) {
    fmpq_mpoly_factor_clear(factorization, ring_->context_);
    throw std::runtime_error("a polynomial could not be factored");
  }
  fmpq_mpoly_factor_make_integral(factorization, ring_->context_);
  FlintRational constant;
  fmpq_mpoly_factor_get_constant_fmpq(constant.value, factorization, ring_->context_);
  result.constant = constant.rational();
  for (slong i = 0; i < factorization->num; ++i) {
    const auto base = blank(*ring_);
    fmpq_mpoly_factor_get_base(base->polynomial, factorization, i, ring_->context_);
    Polynomial factor(base);
    const unsigned exponent = static_cast<unsigned>(fmpq_mpoly_factor_get_exp_si(factorization, i, ring_->context_));
    if (factor.terms().front().coefficient < 0) {
      factor = -factor;
      if (exponent % 2 == 1) result.constant = -result.constant;
    }
    result.factors.emplace_back(std::move(factor), exponent);
  }
  fmpq_mpoly_factor_clear(factorization, ring_->context_);
  std::sort(result.factors.begin(), result.factors.end(), [](const auto& x, const auto& y) {
    return x.first.length() != y.first.length() ? x.first.length() < y.first.length() : x.first.text() < y.first.text();
  });
  return result;
}

Polynomial power(const Polynomial& base, std::size_t exponent) {
  Polynomial result(base.ring(), 1);
  for (std::size_t i = 0; i < exponent; ++i) result *= base;
  return result;
}

Polynomial substitute(const Polynomial& p, std::size_t variable, const Polynomial& numerator,
                      const Polynomial& denominator) {
  std::size_t k = p.degree(variable);
  Polynomial result = p.coefficient(variable, k), denominators(p.ring(), 1);
  while (k-- > 0) {
    denominators *= denominator;
    result = result * numerator + p.coefficient(variable, k) * denominators;
  }
  return result;
}

}  // namespace slipproof::prove
