#include "floating/filter/vector_kernel.hpp"
#include "floating/trade/mpfr_value.hpp"
#include "floating/trade/plain.hpp"

namespace slipproof {

namespace {

struct Conversion {
  static float rounded(const Rational& x) { return mpfr_get_flt(MpfrValue(x, 24).get(), MPFR_RNDN); }
  static std::optional<Rational> exactly(float x) {
    MpfrValue value(24);
    mpfr_set_flt(value.get(), x, MPFR_RNDN);
    return exact_rational(value.get());
  }
};

/// Inlined and compiled as the filter is, so that the two differ in nothing but what is believed.
ModeSets modes(const ForcedScene<float>& s) {
  return in_registers_of_four([&] { return unrolled_modes(s); });
}

}  // namespace

std::unique_ptr<Arithmetic> binary32_arithmetic() {
  return std::make_unique<PlainArithmetic<float, Conversion, modes>>(TradeType{"binary32", 24});
}

}  // namespace slipproof
