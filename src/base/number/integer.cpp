#include "base/number/integer.hpp"

#include <algorithm>
#include <cctype>
#include <ostream>

namespace slipproof {

Integer::Integer(const std::string& digits, int base) {
  const std::size_t first = digits.starts_with('-') ? 1 : 0;
  const bool all_digits = std::all_of(digits.begin() + static_cast<std::ptrdiff_t>(first), digits.end(), [&](char c) {
    return base == 16 ? std::isxdigit(static_cast<unsigned char>(c)) != 0 : c >= '0' && c <= '9';
  });
  if (digits.size() == first || !all_digits) throw std::invalid_argument("not an integer: " + digits);
  fmpz_set_str(&value_, digits.c_str(), base);
}

double Integer::to_double() const {
  return mpz_get_d(GmpInteger(*this).get());
}

std::string Integer::str(int base) const {
  if (is_short() && base == 10) return std::to_string(value_);
  std::string text(fmpz_sizeinbase(&value_, base) + 2, '\0');
  fmpz_get_str(text.data(), base, &value_);
  text.resize(text.find('\0'));
  return text;
}

Integer abs(Integer x) {
  if (x.sign() < 0) x.negate();
  return x;
}

Integer gcd(const Integer& x, const Integer& y) {
  Integer z;
  fmpz_gcd(z.flint(), x.flint(), y.flint());
  return z;
}

Integer lcm(const Integer& x, const Integer& y) {
  Integer z;
  fmpz_lcm(z.flint(), x.flint(), y.flint());
  return z;
}

Integer pow(const Integer& base, unsigned long exponent) {
  Integer z;
  fmpz_pow_ui(z.flint(), base.flint(), exponent);
  return z;
}

Integer sqrt(const Integer& x) {
  if (x.sign() < 0) throw std::domain_error("the root of a negative number");
  Integer z;
  fmpz_sqrt(z.flint(), x.flint());
  return z;
}

Integer exact_quotient(const Integer& x, const Integer& y) {
  Integer z;
  fmpz_divexact(z.flint(), x.flint(), y.flint());
  return z;
}

std::ostream& operator<<(std::ostream& out, const Integer& x) {
  return out << x.str();
}

QuotientAndRemainder divide(const Integer& x, const Integer& y) {
  if (y.is_zero()) throw std::overflow_error("division by zero");
  QuotientAndRemainder result;
  fmpz_tdiv_qr(result.quotient.flint(), result.remainder.flint(), x.flint(), y.flint());
  return result;
}

GmpInteger::GmpInteger(const Integer& x) {
  const fmpz value = *x.flint();
  if (COEFF_IS_MPZ(value)) {
    *value_ = *COEFF_TO_PTR(value);
    return;
  }
  limb_ = value < 0 ? -static_cast<mp_limb_t>(value) : static_cast<mp_limb_t>(value);
  mpz_roinit_n(value_, &limb_, x.sign());
}

std::optional<Integer> exact_root(const Integer& x) {
  if (x.sign() < 0) return std::nullopt;
  const Integer root = sqrt(x);
  return root * root == x ? std::optional(root) : std::nullopt;
}

}  // namespace slipproof
