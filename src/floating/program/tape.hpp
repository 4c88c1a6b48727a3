// Straight-line programs over the parameters of a mechanism, made once and run at many points.
//
// A tape is a list of operations, each on results before it; what is computed twice stands once. While it is made every
// result is also known at two random points modulo a prime: what vanishes at both, and is proved to vanish at all
// points, as a polynomial, becomes the literal 0. So rows that depend on each other at every point are seen to do so,
// which no rounded arithmetic could see. Nothing rests on a result that is not the literal 0.
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
  TapeRef first = 0;   ///< operand; of an input its number, of a constant its place among the constants
  TapeRef second = 0;  ///< the other operand
};

/// What an input is known to be, on its domain. It guides the choice of pivots and proves nothing.
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
  /// The divisor must not be the literal 0; where it vanishes at a point the result means nothing.
  TapeRef divide(TapeRef x, TapeRef y);
  /// The same by the reciprocal, which is computed once.
  TapeRef divide_often(TapeRef x, TapeRef y);
  TapeRef negate(TapeRef x);

  /// Positive on the domain: as InputSign it proves nothing.
  void assume_positive(TapeRef x) { signs_[x] = {true, false, true}; }

  const std::vector<TapeNode>& nodes() const { return nodes_; }
  const std::vector<Rational>& constants() const { return constants_; }

  /// How bad a divisor a result is.
  enum class Doubt : std::uint8_t { literal, nonzero_in_domain, one_sign, any, looks_like_zero };
  Doubt doubt_as_divisor(TapeRef x) const;

  using Residues = std::array<std::uint64_t, 2>;
  /// Of x / y at the two random points; the same where two quotients are.
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
