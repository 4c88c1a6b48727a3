// The exact answer for many forces of one bicycle: exact intervals, brought to the binary64 inside them.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "base/number/binary64.hpp"
#include "support/bicycle/forced_scene.hpp"
#include "support/bicycle/mode_table.hpp"

namespace slipproof::test {

/// Modes as bits by their indices.
struct OracleModes {
  std::uint16_t consistent = 0, strict = 0;
};

class ForceOracle {
 public:
  explicit ForceOracle(const ForcedScene<Rational>& s) {
    const ModeTable table(s.bicycle, s.road, s.force_kind);
    for (const ModeSolution& mode : table.solutions()) {
      ranges_.push_back({mode.mode().index(), range(mode.closed()), range(mode.strict())});
      for (const auto& end : {mode.closed().lower(), mode.closed().upper()}) {
        if (end) ends_.push_back(nearest_binary64(*end));
      }
    }
  }

  /// Modes consistent at the force, and strictly so.
  OracleModes at(double force) const {
    OracleModes result;
    for (const auto& r : ranges_) {
      const auto bit = 1U << r.mode;
      if (r.closed.contains(force)) result.consistent = static_cast<std::uint16_t>(result.consistent | bit);
      if (r.strict.contains(force)) result.strict = static_cast<std::uint16_t>(result.strict | bit);
    }
    return result;
  }

  /// The binary64 nearest to where some mode begins or ends.
  const std::vector<double>& ends() const { return ends_; }

 private:
  struct Range {
    double lower, upper;
    bool contains(double x) const { return lower <= x && x <= upper; }
  };
  struct ModeRange {
    std::size_t mode;
    Range closed, strict;
  };

  /// The smallest and the largest binary64 in the interval.
  static Range range(const ForceInterval& interval) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (interval.empty()) return {infinity, -infinity};
    Range r{-infinity, infinity};
    if (interval.lower()) {
      const auto [below, above] = enclose(*interval.lower());
      r.lower = below == above && !interval.lower_closed() ? std::nextafter(above, infinity) : above;
    }
    if (interval.upper()) {
      const auto [below, above] = enclose(*interval.upper());
      r.upper = below == above && !interval.upper_closed() ? std::nextafter(below, -infinity) : below;
    }
    return r;
  }

  std::vector<ModeRange> ranges_;
  std::vector<double> ends_;
};

}  // namespace slipproof::test
