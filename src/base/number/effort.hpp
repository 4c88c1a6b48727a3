// A limit for work on long numbers that is the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "base/number/rational.hpp"
#include "base/parallel/stop.hpp"

namespace slipproof {

/// Counted in operations on words of 64 bits, about; one or two nanoseconds each.
using Work = std::uint64_t;
inline constexpr Work unlimited = std::numeric_limits<Work>::max();

/// A sum and a product that stay endless where they would be more.
Work plus(Work x, Work y);
Work times(Work x, Work y);

/// The length of a number, and of numerator and denominator together.
std::size_t bit_count(const Integer& x);
std::size_t bit_count(const Rational& x);

/// The work of one product of two numbers with this many bits: n sqrt(n) for n words, between the schoolbook n^2 and
/// the fastest n log n, plus a constant.
Work product_work(std::size_t bits);

/// More work would be needed than is allowed.
class TooMuchWork : public std::runtime_error {
 public:
  TooMuchWork() : std::runtime_error("too much work") {}
};

/// What may still be done.
class Effort {
 public:
  explicit Effort(Work allowed) : left_(allowed) {}

  Work left() const { return left_; }
  bool allows(Work work) const { return work <= left_; }
  /// Throws TooMuchWork, with nothing left, where that is not allowed, and Stopped where the call was asked to end.
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
