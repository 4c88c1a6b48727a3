// Conversions between rationals and floating-point types, by MPFR.
#pragma once

#include <mpfr.h>

#include <optional>

#include "base/number/rational.hpp"

namespace slipproof {

/// An MPFR number that frees itself.
class MpfrValue {
 public:
  explicit MpfrValue(int bits) { mpfr_init2(value_, bits); }
  MpfrValue(const Rational& x, int bits) : MpfrValue(bits) { mpfr_set_q(value_, GmpRational(x).get(), MPFR_RNDN); }
  MpfrValue(const MpfrValue&) = delete;
  MpfrValue& operator=(const MpfrValue&) = delete;
  ~MpfrValue() { mpfr_clear(value_); }

  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

/// The value of a finite number; nothing for NaN and the infinities.
inline std::optional<Rational> exact_rational(mpfr_srcptr x) {
  if (mpfr_number_p(x) == 0) return std::nullopt;
  mpq_t value;
  mpq_init(value);
  mpfr_get_q(value, x);
  const Rational result(value);
  mpq_clear(value);
  return result;
}

}  // namespace slipproof
