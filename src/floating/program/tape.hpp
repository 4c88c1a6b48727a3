// Straight-line programs over the parameters of a mechanism, made once and run at many points.
//
// A tape is a list of operations on earlier results; the same operation is stored only once. While the tape is made,
// each result is also computed at two random points modulo a prime. A result that is 0 at both, and is proved to be the
// polynomial 0, becomes the literal 0. In this way rows that depend on each other at every point are recognised, which
// rounded arithmetic could not do. No conclusion relies on a result being 0 unless it is the literal 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "base/number/rational.hpp"
#include "floating/program/zero_proof.hpp"

namespace slipproof {

/// A result on a tape, by its place.
using TapeRef = std::uint32_t;

enum class TapeOperation : std::uint8_t { constant, input, add, subtract, multiply, divide, negate };

struct TapeNode {
  TapeOperation operation = TapeOperation::constant;
  TapeRef first = 0;   ///< operand; for an input its number, for a constant its place among the constants
  TapeRef second = 0;  ///< the other operand
};

/// What is known of an input on its domain. It guides the choice of pivots and proves nothing.
enum class InputSign : std::uint8_t { unknown, not_negative, positive };

class TapeBuilder {
 public:
  static constexpr TapeRef zero = 0, one = 1;  ///< the literals

  /// `circles`: pairs of inputs whose squares add up to 1.
  TapeBuilder(std::vector<InputSign> inputs, std::vector<std::pair<std::size_t, std::size_t>> circles);

  TapeRef constant(const Rational& value);
  TapeRef input(std::size_t index) const { return inputs_[index]; }
  TapeRef add(TapeRef x, TapeRef y);
  TapeRef subtract(TapeRef x, TapeRef y);
  TapeRef multiply(TapeRef x, TapeRef y);
  /// The divisor must not be the literal 0. At a point where the divisor vanishes the result has no meaning.
  TapeRef divide(TapeRef x, TapeRef y);
  /// The same, using the reciprocal, which is computed once.
  TapeRef divide_often(TapeRef x, TapeRef y);
  TapeRef negate(TapeRef x);

  /// States that x is positive on the domain. Like InputSign, it proves nothing.
  void assume_positive(TapeRef x) { signs_[x] = {true, false, true}; }

  const std::vector<TapeNode>& nodes() const { return nodes_; }
  const std::vector<Rational>& constants() const { return constants_; }

  /// How unsuitable a result is as a divisor.
  enum class Doubt : std::uint8_t { literal, nonzero_in_domain, one_sign, any, looks_like_zero };
  Doubt doubt_as_divisor(TapeRef x) const;

  using Residues = std::array<std::uint64_t, 2>;
  /// x / y at the two random points; equal for two quotients that are the same.
  Residues quotient_residues(TapeRef x, TapeRef y) const;

 private:
  struct Signs {
    bool not_negative = false, not_positive = false, not_zero = false;
  };

  const Rational* literal(TapeRef x) const;
  TapeRef make(TapeOperation operation, TapeRef x, TapeRef y);
  TapeRef push(const TapeNode& node, const Residues& residues, const Signs& signs);
  Residues residues(TapeOperation operation, TapeRef x, TapeRef y) const;
  Signs signs(TapeOperation operation, TapeRef x, TapeRef y) const;

  std::vector<TapeNode> nodes_;
  std::vector<Rational> constants_;
  std::vector<Residues> residues_;
  std::vector<Signs> signs_;
  std::vector<TapeRef> inputs_;
  std::map<std::tuple<TapeOperation, TapeRef, TapeRef>, TapeRef> known_;
  std::map<Rational, TapeRef> literals_;
  ZeroProver prover_;
};

}  // namespace slipproof
