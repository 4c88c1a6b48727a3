#include <limits>

#include "floating/trade/mpfr_value.hpp"
#include "floating/trade/plain.hpp"

namespace slipproof {

namespace {

constexpr int bits = std::numeric_limits<long double>::digits;

struct Conversion {
  static long double rounded(const Rational& x) { return mpfr_get_ld(MpfrValue(x, bits).get(), MPFR_RNDN); }
  static std::optional<Rational> exactly(long double x) {
    MpfrValue value(bits);
    mpfr_set_ld(value.get(), x, MPFR_RNDN);
    return exact_rational(value.get());
  }
};

}  // namespace

std::unique_ptr<Arithmetic> long_double_arithmetic() {
  return std::make_unique<PlainArithmetic<long double, Conversion, unrolled_modes<long double>>>(
      TradeType{"long double", bits});
}

}  // namespace slipproof
