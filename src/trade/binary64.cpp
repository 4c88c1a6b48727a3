#include "number/binary64.hpp"

#include "trade/plain.hpp"

namespace slipproof {

namespace {

struct Conversion {
  static double rounded(const Rational& x) { return nearest_binary64(x); }
  static std::optional<Rational> exactly(double x) {
    if (!std::isfinite(x)) return std::nullopt;
    return to_rational(x);
  }
};

}  // namespace

std::unique_ptr<Arithmetic> binary64_arithmetic() {
  return std::make_unique<PlainArithmetic<double, Conversion, true>>(TradeType{"binary64", 53});
}

}  // namespace slipproof
