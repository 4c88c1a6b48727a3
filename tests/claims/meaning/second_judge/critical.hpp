// Where a condition can change: the zeros of all that is compared and of all that is divided by. Between two
// neighbouring ones it is the same everywhere, so that to judge at each of them and between them is to judge
// everywhere.
#pragma once

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "claims/meaning/second_judge/tree.hpp"

namespace slipproof::meaning {

/// What the second judge does not decide; such a claim is left out.
struct OutOfReach : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// In any variables, multiplied out: by monomial, which is the exponent of each variable. No coefficient is zero.
class Polynomial {
 public:
  using Monomial = std::map<std::string, int>;

  Polynomial() = default;
  Polynomial(const Rational& constant);  // NOLINT: a number is a polynomial
  static Polynomial variable(const std::string& name);

  bool is_zero() const { return terms_.empty(); }
  bool is_number() const { return degree() == 0; }
  int degree() const;  ///< in all variables together; of zero: 0
  Rational coefficient(const Monomial& monomial) const;
  Rational constant() const { return coefficient({}); }
  Rational slope(const std::string& variable) const { return coefficient({{variable, 1}}); }
  Polynomial at(const std::string& variable, const Rational& value) const;

  friend Polynomial operator+(const Polynomial& x, const Polynomial& y);
  friend Polynomial operator-(const Polynomial& x, const Polynomial& y);
  friend Polynomial operator*(const Polynomial& x, const Polynomial& y);

 private:
  std::map<Monomial, Rational> terms_;
};

/// Symbols that are no numbers but polynomials in variables; all others are numbers or definitions.
struct Variables {
  Names names;
  std::map<std::string, Polynomial> symbols;
};

/// Polynomials such that the tree's value or truth is the same wherever they all have the same signs. Some of them may
/// not matter: of `max(x, y)` both sides are carried on.
std::vector<Polynomial> critical(const Tree& tree, const Variables& variables);

/// Real zeros of a polynomial in one variable. Out of reach unless all of them are rational and easily found.
std::set<Rational> zeros(const Polynomial& polynomial, const std::string& variable);

/// Each of the points, one between each two neighbours, and one beyond either end.
std::vector<Rational> everywhere(const std::set<Rational>& points);

}  // namespace slipproof::meaning
