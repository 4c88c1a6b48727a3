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

/// Of the terms of a polynomial; the first of them is its leading term.
enum class MonomialOrder : std::uint8_t {
  lexicographic,                ///< shows at once how a variable occurs: for elimination
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
  std::vector<unsigned long> exponents;  ///< of each variable of the ring
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
  Rational constant() const;             ///< of a constant polynomial
  Rational leading_coefficient() const;  ///< of one that is not 0
  std::size_t length() const;            ///< the number of its terms
  std::size_t degree(std::size_t variable) const;
  std::size_t coefficient_bits() const;  ///< of the largest, where all are integers
  bool has_negative_coefficient() const;
  bool contains(std::size_t variable) const { return degree(variable) > 0; }
  std::vector<std::size_t> variables() const;
  std::vector<Term> terms() const;
  /// The coefficient of variable^exponent, a polynomial in the other variables.
  MultiPolynomial coefficient(std::size_t variable, std::size_t exponent) const;
  /// In the syntax of statements, certificates and claims; kept, so that copies have it, too.
  const std::string& text() const;

  MultiPolynomial& operator+=(const MultiPolynomial& other);
  MultiPolynomial& operator-=(const MultiPolynomial& other);
  MultiPolynomial& operator*=(const MultiPolynomial& other);
  MultiPolynomial operator-() const;
  friend MultiPolynomial operator+(MultiPolynomial x, const MultiPolynomial& y) { return x += y; }
  friend MultiPolynomial operator-(MultiPolynomial x, const MultiPolynomial& y) { return x -= y; }
  friend MultiPolynomial operator*(MultiPolynomial x, const MultiPolynomial& y) { return x *= y; }
  bool operator==(const MultiPolynomial& other) const;
  /// Equal for copies of one polynomial, and different from all others as long as one of the copies lives.
  const void* identity() const { return value_.get(); }

  MultiPolynomial scaled(const Rational& factor) const;
  /// The quotient where it is a polynomial; the divisor must not be 0.
  std::optional<MultiPolynomial> divided_by(const MultiPolynomial& divisor) const;
  /// The greatest common divisor, monic; nothing where FLINT gives up.
  std::optional<MultiPolynomial> common_divisor(const MultiPolynomial& other) const;
  /// Cannot be stopped once begun, so a caller with a limit checks the length first. If FLINT gives up, returns
  /// as_irreducible().
  Factorization factors() const;
  /// Its content and its primitive part, as if that had no factors; of a polynomial that is not 0.
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
