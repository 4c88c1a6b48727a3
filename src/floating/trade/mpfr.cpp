#include <boost/multiprecision/mpfr.hpp>

#include "floating/trade/mpfr_value.hpp"
#include "floating/trade/plain.hpp"

namespace slipproof {

namespace {

template <unsigned digits>
using Mpfr =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<digits>, boost::multiprecision::et_off>;

template <class T>
struct Conversion {
  static T rounded(const Rational& x) {
    T result;
    mpfr_set_q(result.backend().data(), GmpRational(x).get(), MPFR_RNDN);
    return result;
  }
  static std::optional<Rational> exactly(const T& x) { return exact_rational(x.backend().data()); }
};

template <unsigned digits>
std::unique_ptr<Arithmetic> arithmetic() {
  using T = Mpfr<digits>;
  return std::make_unique<PlainArithmetic<T, Conversion<T>, looped_modes<T>>>(
      TradeType{"MPFR " + std::to_string(digits) + " digits", static_cast<int>(mpfr_get_prec(T().backend().data()))});
}

}  // namespace

std::unique_ptr<Arithmetic> mpfr50_arithmetic() {
  return arithmetic<50>();
}
std::unique_ptr<Arithmetic> mpfr100_arithmetic() {
  return arithmetic<100>();
}
std::unique_ptr<Arithmetic> mpfr200_arithmetic() {
  return arithmetic<200>();
}

}  // namespace slipproof
