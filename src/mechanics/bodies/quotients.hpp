// Expressions of a mechanism as quotients of polynomials in its parameters and in t = tan(angle/2), with
// cos = (1 - t^2)/(1 + t^2) and sin = 2 t/(1 + t^2): a form that is 0 where its numerator is, and their arithmetic.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/algebra/polynomial.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof::bodies_in_motion {

struct Quotient {
  MultiPolynomial over, under;
};

/// An expression that is no such quotient: a function occurs in it, or a symbol that the mechanism does not have.
struct NoQuotient {};

/// All work with them throws Budget::Spent where the polynomials grow too long.
class Quotients {
 public:
  explicit Quotients(const Mechanism& mechanism);

  /// Throws NoQuotient.
  Quotient of(const Expression& e);
  Quotient number(const Rational& value) const { return whole(MultiPolynomial(ring_, value)); }
  static Quotient combined(Operation operation, const Quotient& x, const Quotient& y);
  /// In lowest terms.
  static Quotient shortened(Quotient x);
  /// The square root, with cosines and sines for t; nothing if it is no square.
  std::optional<Quotient> root(const Quotient& square) const;
  /// In lowest terms, with cosines and sines for t.
  Quotient on_circles(Quotient x) const;
  /// The factors of numerator and denominator, with cosines and sines for t. For a quotient in lowest terms.
  struct Factored {
    Factorization over, under;
  };
  Factored factored(const Quotient& x) const;
  /// The product of these factors. Throws ExpressionError where it is too long for people.
  Expression expression(const Quotient& x) const;

 private:
  std::size_t half_turn(std::size_t angle) const { return mechanism_.parameters.size() + angle; }
  Quotient whole(const MultiPolynomial& polynomial) const { return {polynomial, MultiPolynomial(ring_, 1)}; }
  MultiPolynomial on_circle(const MultiPolynomial& p, std::size_t angle, std::size_t circles) const;
  Factorization factors_on_circles(const MultiPolynomial& p, std::vector<std::size_t>& circles) const;
  void put_squares(Factorization& product, std::size_t from, std::size_t to) const;
  Quotient symbol(const std::string& name);

  const Mechanism& mechanism_;
  PolynomialRing ring_;
  std::size_t circles_;  ///< where the cosines and sines begin
  std::map<std::string, Quotient> symbols_;
};

/// A polynomial on circles as an expression. Throws ExpressionError where it is too long for people.
Expression read_back(const MultiPolynomial& polynomial);

}  // namespace slipproof::bodies_in_motion
