#include "base/number/binary64.hpp"

#include "floating/filter/vector_kernel.hpp"
#include "floating/trade/plain.hpp"

namespace slipproof {

namespace {

struct Conversion {
  static double rounded(const Rational& x) { return nearest_binary64(x); }
  static std::optional<Rational> exactly(double x) {
    if (!std::isfinite(x)) return std::nullopt;
    return to_rational(x);
  }
};

/// Inlined and compiled as the filter is, so that the two differ in nothing but what is believed.
ModeSets modes(const ForcedScene<double>& s) {
  return in_registers_of_four([&] { return unrolled_modes(s); });
}

}  // namespace

std::unique_ptr<Arithmetic> binary64_arithmetic() {
  return std::make_unique<PlainArithmetic<double, Conversion, modes>>(TradeType{"binary64", 53});
}

}  // namespace slipproof
