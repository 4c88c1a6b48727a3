// Inside the reports on expected answers: numbers, exact and as binary64.
#pragma once

#include <string>

#include "base/algebra/real_roots.hpp"
#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "mechanics/kernel/motion.hpp"
#include "report/expected/expected.hpp"

namespace slipproof::expected {

/// A motion or a continuum, with a range for each quantity.
struct ToldMotion {
  std::string modes;  ///< joined by ` = `, strict ones first
  bool strict = false, continuum = false;
  std::vector<Range> accelerations, forces;  ///< in the order of acceleration_names() and force_names()
};
std::vector<ToldMotion> told_motions(const ExpectedAnswer& answer);

/// The nearest binary64 to a value; an end that is absent is infinite with this sign.
double binary64(const std::optional<Rational>& value, int sign);
/// Exactly, or empty.
std::string exact(const std::optional<Rational>& value);

/// An algebraic number: `3/4`, or `root of mu^2 - 2 in (1, 2)` with its nearest binary64.
struct ToldRoot {
  RealRoot place;  ///< all numbers in it have this nearest binary64
  double nearest = 0;
  std::string text;
};
ToldRoot told_root(const RealRoot& root, const std::string& symbol);

}  // namespace slipproof::expected
