#include "floating/trade/mpfr_value.hpp"
#include "floating/trade/plain.hpp"

namespace slipproof {

namespace {

__extension__ typedef __float128 Binary128;
constexpr int bits = 113;

/// In two parts, each a long double, which has the same range.
struct Conversion {
  static Binary128 rounded(const Rational& x) {
    MpfrValue value(x, bits);
    const long double high = mpfr_get_ld(value.get(), MPFR_RNDZ);
    MpfrValue part(bits);
    mpfr_set_ld(part.get(), high, MPFR_RNDN);
    mpfr_sub(value.get(), value.get(), part.get(), MPFR_RNDN);
    return Binary128(high) + Binary128(mpfr_get_ld(value.get(), MPFR_RNDN));
  }
  static std::optional<Rational> exactly(Binary128 x) {
    if (!(x - x == 0)) return std::nullopt;
    const auto high = static_cast<long double>(x);
    MpfrValue value(bits), part(bits);
    mpfr_set_ld(value.get(), high, MPFR_RNDN);
    mpfr_set_ld(part.get(), static_cast<long double>(x - Binary128(high)), MPFR_RNDN);
    mpfr_add(value.get(), value.get(), part.get(), MPFR_RNDN);
    return exact_rational(value.get());
  }
};

}  // namespace

std::unique_ptr<Arithmetic> binary128_arithmetic() {
  return std::make_unique<PlainArithmetic<Binary128, Conversion, looped_modes<Binary128>>>(
      TradeType{"binary128", bits});
}

}  // namespace slipproof
