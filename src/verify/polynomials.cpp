#include "verify/polynomials.hpp"

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

Evaluator<Fraction, FractionField> symbolic(const Scope& scope, std::size_t first, std::size_t count) {
  auto ring = std::make_shared<PolynomialRing>(count);
  Evaluator<Fraction, FractionField> evaluator(scope, FractionField{ring});
  for (std::size_t i = 0; i < count; ++i) evaluator.set(first + i, MultiPolynomial::variable(ring, i));
  return evaluator;
}

}  // namespace slipproof
