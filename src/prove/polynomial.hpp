// Multivariate polynomials over the rationals for the prover: a value type over FLINT's fmpq_mpoly.
#pragma once

#include <flint/fmpq_mpoly_factor.h>

#include <compare>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "number/rational.hpp"
#include "prove/budget.hpp"

namespace slipproof::prove {

/// The variables of one statement, and the work done with them: arithmetic spends the steps of the budget, and throws
/// Budget::Spent where none are left. Polynomials keep a pointer to their ring, which must outlive them.
class Ring {
 public:
  explicit Ring(std::vector<std::string> names);
  ~Ring();
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;

  std::size_t size() const { return names_.size(); }
  const std::string& name(std::size_t variable) const { return names_[variable]; }
  Budget& budget() const { return budget_; }

 private:
  friend class Polynomial;
  std::vector<std::string> names_;
  std::vector<const char*> pointers_;
  fmpq_mpoly_ctx_t context_;
  mutable Budget budget_;  ///< of whoever works with the polynomials, one thread at a time
};

struct Term {
  Rational coefficient;
  std::vector<unsigned long> exponents;
};

struct Factorization;

class Polynomial {
 public:
  explicit Polynomial(const Ring& ring, const Rational& constant = 0);
  static Polynomial variable(const Ring& ring, std::size_t index);
  /// Reads what text() writes, and any other polynomial in that syntax; nothing if it is none.
  static std::optional<Polynomial> parse(const Ring& ring, const std::string& text);

  const Ring& ring() const { return *ring_; }
  bool is_zero() const;
  bool is_constant() const;
  Rational constant() const;  ///< of a constant polynomial
  std::size_t length() const;
  std::size_t degree(std::size_t variable) const;
  std::size_t coefficient_bits() const;  ///< of the largest, where all are integers
  bool contains(std::size_t variable) const { return degree(variable) > 0; }
  std::vector<std::size_t> variables() const;
  std::vector<Term> terms() const;
  /// The coefficient of variable^exponent, a polynomial in the other variables.
  Polynomial coefficient(std::size_t variable, std::size_t exponent) const;
  std::string text() const;  ///< in the syntax of statements and certificates

  Polynomial& operator+=(const Polynomial& other);
  Polynomial& operator-=(const Polynomial& other);
  Polynomial& operator*=(const Polynomial& other);
  Polynomial operator-() const;
  friend Polynomial operator+(Polynomial x, const Polynomial& y) { return x += y; }
  friend Polynomial operator-(Polynomial x, const Polynomial& y) { return x -= y; }
  friend Polynomial operator*(Polynomial x, const Polynomial& y) { return x *= y; }
  bool operator==(const Polynomial& other) const;

  Polynomial scaled(const Rational& factor) const;
  /// The quotient where it is a polynomial.
  std::optional<Polynomial> divided_by(const Polynomial& divisor) const;
  Factorization factors() const;

 private:
  Factorization unfactored() const;

  struct Value;
  explicit Polynomial(std::shared_ptr<const Value> value);
  static std::shared_ptr<Value> blank(const Ring& ring);

  const Ring* ring_;
  std::shared_ptr<const Value> value_;  ///< never changed, so that copies are free
};

/// constant * product of factor^exponent; the factors are irreducible, primitive over the integers with positive
/// leading coefficient, and in a fixed order (short ones first).
struct Factorization {
  Rational constant;
  std::vector<std::pair<Polynomial, unsigned>> factors;
};

Polynomial power(const Polynomial& base, std::size_t exponent);

/// denominator^d p, with numerator / denominator for a variable in which p has the degree d.
Polynomial substitute(const Polynomial& p, std::size_t variable, const Polynomial& numerator,
                      const Polynomial& denominator);

}  // namespace slipproof::prove
