#include "verify/polynomials.hpp"

#include <flint/fmpq_mpoly_factor.h>

#include <utility>

namespace slipproof {

namespace {

/// An fmpq that frees itself.
struct Scalar {
  explicit Scalar(const Rational& x) {
    fmpq_init(value);
    fmpq_set_mpq(value, x.backend().data());
  }
  ~Scalar() { fmpq_clear(value); }
  Scalar(const Scalar&) = delete;
  Scalar& operator=(const Scalar&) = delete;
  fmpq_t value;
};

}  // namespace

MultiPolynomial::MultiPolynomial(std::shared_ptr<PolynomialRing> ring) : ring_(std::move(ring)) {
  if (ring_) fmpq_mpoly_init(value_, ring_->context());
}

MultiPolynomial::MultiPolynomial(std::shared_ptr<PolynomialRing> ring, const Rational& constant)
    : MultiPolynomial(std::move(ring)) {
  fmpq_mpoly_set_fmpq(value_, Scalar(constant).value, ring_->context());
}

MultiPolynomial MultiPolynomial::variable(std::shared_ptr<PolynomialRing> ring, std::size_t index) {
  MultiPolynomial result(std::move(ring));
  fmpq_mpoly_gen(result.value_, static_cast<slong>(index), result.ring_->context());
  return result;
}

MultiPolynomial::MultiPolynomial(const MultiPolynomial& other) : MultiPolynomial(other.ring_) {
  constant_ = other.constant_;
  if (ring_) fmpq_mpoly_set(value_, other.value_, ring_->context());
}

MultiPolynomial::MultiPolynomial(MultiPolynomial&& other) noexcept
    : ring_(std::exchange(other.ring_, nullptr)), constant_(std::exchange(other.constant_, 0)) {
  value_[0] = other.value_[0];
}

MultiPolynomial& MultiPolynomial::operator=(MultiPolynomial other) noexcept {
  std::swap(ring_, other.ring_);
  std::swap(constant_, other.constant_);
  std::swap(value_[0], other.value_[0]);
  return *this;
}

MultiPolynomial::~MultiPolynomial() {
  if (ring_) fmpq_mpoly_clear(value_, ring_->context());
}

MultiPolynomial MultiPolynomial::in(const std::shared_ptr<PolynomialRing>& ring) const {
  return ring_ ? *this : MultiPolynomial(ring, Rational(constant_));
}

bool MultiPolynomial::is_zero() const {
  return ring_ ? fmpq_mpoly_is_zero(value_, ring_->context()) != 0 : constant_ == 0;
}
bool MultiPolynomial::is_constant() const {
  return !ring_ || fmpq_mpoly_is_fmpq(value_, ring_->context()) != 0;
}
bool MultiPolynomial::is_monic_constant() const {
  return ring_ ? fmpq_mpoly_is_one(value_, ring_->context()) != 0 : constant_ == 1;
}

MultiPolynomial MultiPolynomial::operator-() const {
  if (!ring_) return -constant_;
  MultiPolynomial result(ring_);
  fmpq_mpoly_neg(result.value_, value_, ring_->context());
  return result;
}

MultiPolynomial operator+(const MultiPolynomial& x, const MultiPolynomial& y) {
  if (!x.ring_ && !y.ring_) return x.constant_ + y.constant_;
  if (!x.ring_) return x.in(y.ring_) + y;
  if (!y.ring_) return x + y.in(x.ring_);
  MultiPolynomial result(x.ring_);
  fmpq_mpoly_add(result.value_, x.value_, y.value_, x.ring_->context());
  return result;
}

MultiPolynomial operator*(const MultiPolynomial& x, const MultiPolynomial& y) {
  if (!x.ring_ && !y.ring_) return x.constant_ * y.constant_;
  if (!x.ring_) return x.in(y.ring_) * y;
  if (!y.ring_) return x * y.in(x.ring_);
  MultiPolynomial result(x.ring_);
  fmpq_mpoly_mul(result.value_, x.value_, y.value_, x.ring_->context());
  return result;
}

void cancel(MultiPolynomial& x, MultiPolynomial& y) {
  if (y.is_monic_constant()) return;
  if (!x.ring_ && !y.ring_) return;  // two integers: left as they are
  const auto ring = x.ring_ ? x.ring_ : y.ring_;
  fmpq_mpoly_ctx_struct* context = ring->context();
  x = x.in(ring);
  y = y.in(ring);
  if (!y.is_constant()) {
    MultiPolynomial divisor(ring);
    if (fmpq_mpoly_gcd(divisor.value_, x.value_, y.value_, context) != 0) {
      fmpq_mpoly_divides(x.value_, x.value_, divisor.value_, context);
      fmpq_mpoly_divides(y.value_, y.value_, divisor.value_, context);
    }
  }
  fmpq_t lead;
  fmpq_init(lead);
  fmpq_mpoly_get_term_coeff_fmpq(lead, y.value_, 0, context);
  fmpq_mpoly_scalar_div_fmpq(x.value_, x.value_, lead, context);
  fmpq_mpoly_scalar_div_fmpq(y.value_, y.value_, lead, context);
  fmpq_clear(lead);
}

bool MultiPolynomial::is_one_signed() const {
  if (!ring_) return true;
  fmpq_t coefficient;
  fmpq_init(coefficient);
  bool positive = false, negative = false;
  for (slong i = 0; i < fmpq_mpoly_length(value_, ring_->context()); ++i) {
    fmpq_mpoly_get_term_coeff_fmpq(coefficient, value_, i, ring_->context());
    (fmpq_sgn(coefficient) > 0 ? positive : negative) = true;
  }
  fmpq_clear(coefficient);
  return !(positive && negative);
}

std::string MultiPolynomial::text(const std::vector<std::string>& names) const {
  if (!ring_) return std::to_string(constant_);
  std::vector<const char*> variables;
  for (const std::string& name : names) variables.push_back(name.c_str());
  char* text = fmpq_mpoly_get_str_pretty(value_, variables.data(), ring_->context());
  std::string result = text;
  flint_free(text);
  return result;
}

std::vector<MultiPolynomial> MultiPolynomial::factors() const {
  std::vector<MultiPolynomial> result;
  if (is_constant()) return result;
  fmpq_mpoly_factor_t factors;
  fmpq_mpoly_factor_init(factors, ring_->context());
  if (fmpq_mpoly_factor(factors, value_, ring_->context()) != 0) {
    for (slong i = 0; i < fmpq_mpoly_factor_length(factors, ring_->context()); ++i) {
      MultiPolynomial& factor = result.emplace_back(MultiPolynomial(ring_));
      fmpq_mpoly_factor_get_base(factor.value_, factors, i, ring_->context());
    }
  } else {
    result.push_back(*this);
  }
  fmpq_mpoly_factor_clear(factors, ring_->context());
  return result;
}

bool MultiPolynomial::has(std::size_t variable) const {
  return ring_ && fmpq_mpoly_degree_si(value_, static_cast<slong>(variable), ring_->context()) > 0;
}

SymbolicEvaluator symbolic(const Scope& scope, std::size_t first, std::size_t count) {
  auto ring = std::make_shared<PolynomialRing>(count);
  SymbolicEvaluator evaluator(scope, FractionField{ring});
  for (std::size_t i = 0; i < count; ++i) evaluator.set(first + i, Fraction(MultiPolynomial::variable(ring, i)));
  return evaluator;
}

}  // namespace slipproof
