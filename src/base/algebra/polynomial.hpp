// Polynomials in several variables over the rationals: a value type over FLINT's fmpq_mpoly, and the only place that
// knows it. The prover searches with them, and src/claims/verify compares what claims say as functions of their
// parameters.
#pragma once

#include <flint/fmpq_mpoly_factor.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/algebra/budget.hpp"
#include "base/number/rational.hpp"

namespace slipproof {

/// The order of the terms of a polynomial, leading term first.
enum class MonomialOrder : std::uint8_t {
  lexicographic,                ///< groups terms by powers of a variable: for elimination
  degree_reverse_lexicographic  ///< keeps greatest common divisors short
};

/// The variables, and the work done with polynomials in them: arithmetic spends the steps of the budget, and throws
/// Budget::Spent if none are left. By default there is no limit. Polynomials keep a pointer to their ring, which must
/// outlive them; polynomials of different rings do not mix.
class PolynomialRing {
 public:
  explicit PolynomialRing(std::vector<std::string> names, MonomialOrder order = MonomialOrder::lexicographic);
  ~PolynomialRing();
  PolynomialRing(const PolynomialRing&) = delete;
  PolynomialRing& operator=(const PolynomialRing&) = delete;

  std::size_t size() const { return names_.size(); }
  const std::string& name(std::size_t variable) const { return names_[variable]; }
  Budget& budget() const { return budget_; }

 private:
  friend class MultiPolynomial;
  std::vector<std::string> names_;
  std::vector<const char*> pointers_;
  fmpq_mpoly_ctx_t context_;
  mutable Budget budget_;  ///< of all work in this ring, one thread at a time
};

struct Term {
  Rational coefficient;
  std::vector<unsigned long> exponents;  ///< by variable of the ring
};

struct Factorization;

/// Copies are free, and one thread at a time works with those of one ring. Products take as many steps as their terms
/// have pairs, sums are not counted.
class MultiPolynomial {
 public:
  explicit MultiPolynomial(const PolynomialRing& ring, const Rational& constant = 0);
  static MultiPolynomial variable(const PolynomialRing& ring, std::size_t index);
  /// Reads what text() writes, and any other polynomial in that syntax; nothing for other texts.
  static std::optional<MultiPolynomial> parse(const PolynomialRing& ring, const std::string& text);

  const PolynomialRing& ring() const { return *ring_; }
  bool is_zero() const;
  bool is_one() const;
  bool is_constant() const;
  Rational constant() const;             ///< requires a constant polynomial
  Rational leading_coefficient() const;  ///< requires a polynomial other than 0
  std::size_t length() const;            ///< the number of its terms
  std::size_t degree(std::size_t variable) const;
  std::size_t coefficient_bits() const;  ///< bits of the largest coefficient, if all are integers
  bool has_negative_coefficient() const;
  bool contains(std::size_t variable) const { return degree(variable) > 0; }
  std::vector<std::size_t> variables() const;
  std::vector<Term> terms() const;
  /// The coefficient of variable^exponent, a polynomial in the other variables.
  MultiPolynomial coefficient(std::size_t variable, std::size_t exponent) const;
  /// Text in the syntax of statements, certificates and claims. Cached, and shared with copies.
  const std::string& text() const;

  MultiPolynomial& operator+=(const MultiPolynomial& other);
  MultiPolynomial& operator-=(const MultiPolynomial& other);
  MultiPolynomial& operator*=(const MultiPolynomial& other);
  MultiPolynomial operator-() const;
  friend MultiPolynomial operator+(MultiPolynomial x, const MultiPolynomial& y) { return x += y; }
  friend MultiPolynomial operator-(MultiPolynomial x, const MultiPolynomial& y) { return x -= y; }
  friend MultiPolynomial operator*(MultiPolynomial x, const MultiPolynomial& y) { return x *= y; }
  bool operator==(const MultiPolynomial& other) const;
  /// A key that is equal for copies of one polynomial, and differs from all other keys while one of the copies lives.
  const void* identity() const { return value_.get(); }

  MultiPolynomial scaled(const Rational& factor) const;
  /// The quotient if it is a polynomial, otherwise nothing. The divisor must not be 0.
  std::optional<MultiPolynomial> divided_by(const MultiPolynomial& divisor) const;
  /// The greatest common divisor, monic; nothing where FLINT gives up.
  std::optional<MultiPolynomial> common_divisor(const MultiPolynomial& other) const;
  /// The factorization into irreducible polynomials. It cannot be interrupted, so a caller with a time limit checks the
  /// length first. If FLINT gives up, returns as_irreducible().
  Factorization factors() const;
  /// The content and the primitive part, treated as irreducible. The polynomial must not be 0.
  Factorization as_irreducible() const;

 private:
  struct Value;
  explicit MultiPolynomial(std::shared_ptr<const Value> value);
  static std::shared_ptr<Value> blank(const PolynomialRing& ring);

  const PolynomialRing* ring_;
  std::shared_ptr<const Value> value_;  ///< never changed, so that copies are free
};

/// constant * product of factor^exponent; the factors are irreducible, primitive over the integers with positive
/// leading coefficient, and in the same order at every call.
struct Factorization {
  Rational constant;
  std::vector<std::pair<MultiPolynomial, unsigned>> factors;
};

MultiPolynomial power(const MultiPolynomial& base, std::size_t exponent);

/// denominator^d p, with numerator / denominator for a variable in which p has the degree d.
MultiPolynomial substitute(const MultiPolynomial& p, std::size_t variable, const MultiPolynomial& numerator,
                           const MultiPolynomial& denominator);

}  // namespace slipproof
