// A limit for work on long numbers that is the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "base/number/rational.hpp"
#include "base/parallel/stop.hpp"

namespace slipproof {

/// Work, in operations on 64-bit words (approximately); each takes one or two nanoseconds.
using Work = std::uint64_t;
inline constexpr Work unlimited = std::numeric_limits<Work>::max();

/// Sum and product that saturate at `unlimited`.
Work plus(Work x, Work y);
Work times(Work x, Work y);

/// The length of a number, and of numerator and denominator together.
std::size_t bit_count(const Integer& x);
std::size_t bit_count(const Rational& x);

/// The work of one product of two numbers with this many bits: n sqrt(n) for n words, between the schoolbook n^2 and
/// the fastest n log n, plus a constant.
Work product_work(std::size_t bits);

/// Thrown if the work would exceed the limit.
class TooMuchWork : public std::runtime_error {
 public:
  TooMuchWork() : std::runtime_error("too much work") {}
};

/// The work that is still allowed.
class Effort {
 public:
  explicit Effort(Work allowed) : left_(allowed) {}

  Work left() const { return left_; }
  bool allows(Work work) const { return work <= left_; }
  /// Subtracts work. Throws TooMuchWork if too little is left, which then becomes 0, and Stopped if a stop was
  /// requested.
  void spend(Work work) {
    stop_if_asked();
    if (!allows(work)) {
      left_ = 0;
      throw TooMuchWork();
    }
    left_ -= work;
  }

 private:
  Work left_;
};

}  // namespace slipproof
