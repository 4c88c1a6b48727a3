// Several scenes side by side in vector registers: the filter's numbers and decisions for each lane.
#pragma once

#include <cstdint>

#include "floating/filter/bounds.hpp"
#include "floating/filter/lane_vectors.hpp"
#include "floating/filter/mode_status.hpp"
#include "floating/filter/shared_bounds.hpp"

namespace slipproof {

// These numbers are copied member by member: GCC copies a struct in halves of a register, and to load from two stores
// is what processors stall at.

/// Tracked, lane by lane. Of positive inputs value and magnitude are the same register until something is subtracted.
template <class V>
struct TrackedLanes {
  V value{}, magnitude{};

  TrackedLanes() = default;
  TrackedLanes(const TrackedLanes& x) : value(x.value), magnitude(x.magnitude) {}
  TrackedLanes& operator=(const TrackedLanes& x) {
    value = x.value;
    magnitude = x.magnitude;
    return *this;
  }
  explicit TrackedLanes(int constant) : value(in_all_lanes<V>(constant)), magnitude(absolute(value)) {}
  TrackedLanes(const V& v, const V& m) : value(v), magnitude(m) {}
  static TrackedLanes input(const V& x) { return {x, absolute(x)}; }

  V error() const { return magnitude * (error_roundings * unit_roundoff) + underflow_error; }

  friend TrackedLanes operator+(const TrackedLanes& x, const TrackedLanes& y) {
    return {x.value + y.value, x.magnitude + y.magnitude};
  }
  friend TrackedLanes operator*(const TrackedLanes& x, const TrackedLanes& y) {
    return {x.value * y.value, x.magnitude * y.magnitude};
  }
  friend TrackedLanes operator-(const TrackedLanes& x) { return {-x.value, x.magnitude}; }
  friend TrackedLanes operator-(const TrackedLanes& x, const TrackedLanes& y) {
    return {x.value - y.value, x.magnitude + y.magnitude};
  }
};

template <class V>
inline V value_of(const TrackedLanes<V>& x) {
  return x.value;
}

/// binary64 lane by lane, for bounds that are known beforehand.
template <class V>
struct PlainLanes {
  V value{};

  PlainLanes() = default;
  PlainLanes(const PlainLanes& x) : value(x.value) {}
  PlainLanes& operator=(const PlainLanes& x) {
    value = x.value;
    return *this;
  }
  explicit PlainLanes(int constant) : value(in_all_lanes<V>(constant)) {}
  static PlainLanes input(const V& x) {
    PlainLanes lanes;
    lanes.value = x;
    return lanes;
  }

  friend PlainLanes operator+(const PlainLanes& x, const PlainLanes& y) { return input(x.value + y.value); }
  friend PlainLanes operator-(const PlainLanes& x, const PlainLanes& y) { return input(x.value - y.value); }
  friend PlainLanes operator*(const PlainLanes& x, const PlainLanes& y) { return input(x.value * y.value); }
  friend PlainLanes operator-(const PlainLanes& x) { return input(-x.value); }
};

template <class V>
inline V smaller(const V& x, const V& y) {
  return x < y ? x : y;
}
template <class V>
inline V larger(const V& x, const V& y) {
  return x > y ? x : y;
}

/// Where decide_lanes() has its error bounds from: each number's own,
template <class V>
struct OwnBounds {
  using N = TrackedLanes<V>;

  /// The conditions of a mode, their numbers as they are and with the sign of the condition.
  class Conditions {
   public:
    void add(const N& number, const V& value) {
      const V error = number.error();
      least_ = smaller(least_, V(value - error));
      most_ = smaller(most_, V(value + error));
    }
    /// Negative where it is sure that all hold strictly, or that one fails, and which sign the determinant has; of
    /// these negative where one fails.
    BitsOf<V> sure(const N& determinant) const {
      return bits(V(determinant.error() - absolute(determinant.value))) & (bits(V(V{} - least_)) | bits(most_));
    }
    BitsOf<V> fails() const { return bits(least_); }

   private:
    V least_ = in_all_lanes<V>(HUGE_VAL), most_ = least_;
  };

  V A(const N& x) const { return x.error(); }
  V I3(const N& x) const { return x.error(); }
  Conditions conditions(std::size_t) const { return {}; }
};

/// or those of a scene that is larger than all, one for each mode.
template <class V>
struct CommonBounds {
  using N = PlainLanes<V>;
  const SharedBounds& shared;

  class Conditions {
   public:
    explicit Conditions(double error) : error_(in_all_lanes<V>(error)) {}
    void add(const N&, const V& value) {
      least_ = any_ ? smaller(least_, value) : value;
      any_ = true;
    }
    BitsOf<V> sure(const N& determinant) const {
      return bits(V(error_ - smaller(absolute(determinant.value), absolute(least_))));
    }
    BitsOf<V> fails() const { return bits(least_); }

   private:
    V error_, least_{};
    bool any_ = false;
  };

  V A(const N&) const { return in_all_lanes<V>(shared.A); }
  V I3(const N&) const { return in_all_lanes<V>(shared.I3); }
  Conditions conditions(std::size_t mode) const { return Conditions(shared.modes[mode]); }
};

/// judge<index>() for each mode that is modelled.
template <class Judge>
inline void each_modelled(bool detachment, const Judge& judge) {
  [&]<std::size_t... index>(std::index_sequence<index...>) {
    (
        [&] {
          if (all_modes()[index].on_road() || detachment) judge.template operator()<index>();
        }(),
        ...);
  }
  (std::make_index_sequence<16>());
}

/// decide_modes() for every lane, without a branch on a value: negative where any mode is undecided, else the modes
/// that are consistent, bit i for the mode with index i. What is sure is told by sign bits, those of differences:
/// nothing may be NaN.
template <class V, class Bounds>
inline BitsOf<V> decide_lanes(const ReducedDynamics<typename Bounds::N, typename Bounds::N>& dynamics, bool detachment,
                              const Bounds& bounds) {
  using N = typename Bounds::N;
  using Bits = BitsOf<V>;
  using Words = typename LaneTypes<width_of<V>>::Words;
  // A wheel that may have no inertia may spin as it likes.
  Bits decided = bits(V(bounds.A(dynamics.A) - dynamics.A.value)) & bits(V(bounds.I3(dynamics.I3) - dynamics.I3.value));
  Bits fail{};
  std::int64_t modes = 0;
  const auto judge = [&]<std::size_t index>() {
    constexpr ContactMode mode = all_modes()[index];
    constexpr ConditionList list = condition_list(mode);
    const ReducedMotion<N, N> motion(dynamics, mode);
    const N determinant = motion.determinant();
    const Bits orientation = bits(determinant.value) & sign_bit<V>();
    auto conditions = bounds.conditions(index);
    for (std::size_t i = 0; i < static_cast<std::size_t>(list.count); ++i) {
      const N side = motion.condition_value(list.items[i]).numerator;
      conditions.add(side, from_bits(Bits(bits(side.value) ^ orientation)));
    }
    decided &= conditions.sure(determinant);
    modes |= std::int64_t{1} << index;
    fail |= reinterpret_cast<Bits>(Words(reinterpret_cast<Words>(conditions.fails()) >> 63 << index));
  };
  each_modelled(detachment, judge);
  return (modes & ~fail) | (~decided & sign_bit<V>());
}

}  // namespace slipproof
