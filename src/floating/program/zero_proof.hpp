// Whether a result on a tape is 0 at all points, as a quotient of polynomials.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "base/algebra/polynomial.hpp"

namespace slipproof {

struct TapeNode;

class ZeroProver {
 public:
  /// `circles`: pairs of inputs whose squares add up to 1.
  ZeroProver(std::size_t inputs, std::vector<std::pair<std::size_t, std::size_t>> circles);

  /// True only if the node is 0 wherever none of the divisors before it vanishes. False if the proof would take more
  /// than a bounded amount of work. `nodes` are the tape's nodes before this one.
  bool is_zero(const TapeNode& node, const std::vector<TapeNode>& nodes, const std::vector<Rational>& constants);

 private:
  struct Fraction {
    MultiPolynomial numerator, denominator;
  };

  Fraction of(const TapeNode& node, const std::vector<TapeNode>& nodes, const std::vector<Rational>& constants);
  const Fraction& at(std::uint32_t place, const std::vector<TapeNode>& nodes, const std::vector<Rational>& constants);
  Fraction sum(const Fraction& x, const Fraction& y) const;
  bool vanishes(MultiPolynomial p) const;

  std::unique_ptr<PolynomialRing> ring_;
  std::vector<std::pair<std::size_t, std::size_t>> circles_;
  std::map<std::uint32_t, Fraction> known_;
  std::size_t inputs_;
};

}  // namespace slipproof
