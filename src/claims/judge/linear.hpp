// Numbers that are linear in some variables, or a mark that a number is not linear.
#pragma once

#include <optional>
#include <vector>

#include "base/expression/evaluate.hpp"

namespace slipproof {

/// constant + coefficients . variables. Most numbers are constants and have no coefficients.
struct Linear {
  Rational constant = 0;
  std::vector<Rational> coefficients;  ///< all coefficients, or none for a constant
  bool linear = true;

  bool is_constant() const { return coefficients.empty(); }
  static Linear variable(std::size_t i, std::size_t count) {
    Linear form;
    form.coefficients.resize(count);
    form.coefficients[i] = 1;
    return form;
  }
  Linear scaled(const Rational& factor) const {
    Linear result = *this;
    result.constant *= factor;
    for (Rational& c : result.coefficients) {
      if (!c.is_zero()) c *= factor;
    }
    return result;
  }
};

inline Linear operator+(Linear x, const Linear& y) {
  x.constant += y.constant;
  if (x.is_constant()) {
    x.coefficients = y.coefficients;
  } else {
    for (std::size_t i = 0; i < y.coefficients.size(); ++i) {
      if (!y.coefficients[i].is_zero()) x.coefficients[i] += y.coefficients[i];
    }
  }
  x.linear = x.linear && y.linear;
  return x;
}
inline Linear operator-(const Linear& x) {
  return x.scaled(-1);
}
inline Linear operator-(const Linear& x, const Linear& y) {
  return x + -y;
}
inline Linear operator*(const Linear& x, const Linear& y) {
  Linear result = y.is_constant() ? x.scaled(y.constant) : y.scaled(x.constant);
  result.linear = x.linear && y.linear && (x.is_constant() || y.is_constant());
  return result;
}
inline Linear operator/(const Linear& x, const Linear& y) {
  Linear result = y.is_constant() ? x.scaled(1 / y.constant) : x;
  result.linear = x.linear && y.linear && y.is_constant();
  return result;
}

/// Two of them can be compared if they differ by a constant.
struct LinearField {
  Linear constant(const Rational& value) const {
    Linear form;
    form.constant = value;
    return form;
  }
  bool is_zero(const Linear& x) const { return x.linear && x.is_constant() && x.constant.is_zero(); }
  std::optional<int> compare(const Linear& x, const Linear& y) const {
    const Linear d = x - y;
    return d.linear && d.is_constant() ? std::optional(sign(d.constant)) : std::nullopt;
  }
};

}  // namespace slipproof
