// Whether the numbers of scenes side by side are smaller than those that error bounds are for.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>

#include "floating/filter/lane_vectors.hpp"

namespace slipproof {

/// What each number of scenes is smaller than, in the order in which convert() goes through them, by the upper halves
/// of its bits; numbers that are not set are smaller than any.
class Sizes {
 public:
  Sizes() { upper_.fill(INT32_MAX); }
  /// `size`: positive and finite.
  void set(std::size_t number, double size) {
    upper_[number] = static_cast<std::int32_t>(std::bit_cast<std::uint64_t>(size) >> 32U);
  }
  /// The upper halves of an even number and the next, side by side.
  std::int64_t pair(std::size_t even) const {
    std::int64_t halves = 0;
    std::memcpy(&halves, &upper_[even], sizeof halves);
    return halves;
  }

 private:
  std::array<std::int32_t, 16> upper_{};
};

/// Whether the numbers of scenes are smaller than sizes, told from the upper halves of their bits alone: read as
/// integers, magnitudes have the same order, and NaN comes last. A register compares two numbers of each scene.
template <class V>
class SizeCheck {
 public:
  explicit SizeCheck(const Sizes& sizes) : sizes_(sizes) {}

  void add(const V& x) {
    if (count_++ % 2 == 0) {
      even_ = x;
    } else {
      compare(even_, x);
    }
  }
  /// Negative where a number of a scene is not smaller.
  BitsOf<V> outside() {
    if (count_ % 2 != 0) add(V{});
    const auto inside = reinterpret_cast<BitsOf<V>>(inside_);
    return ~(inside & inside << 32);
  }

 private:
  using Halves = typename LaneTypes<width_of<V>>::Halves;

  void compare(const V& x, const V& y) {
    inside_ &= (upper(x, y, std::make_integer_sequence<int, 2 * width_of<V>>()) & INT32_MAX) -
               reinterpret_cast<Halves>(BitsOf<V>(BitsOf<V>{} + sizes_.pair(count_ - 2)));
  }
  /// Of a scene those of x and y, one after the other.
  template <int... half>
  static Halves upper(const V& x, const V& y, std::integer_sequence<int, half...>) {
    return __builtin_shufflevector(reinterpret_cast<Halves>(x), reinterpret_cast<Halves>(y),
                                   (half % 2 == 0 ? half + 1 : 2 * width_of<V> + half)...);
  }

  const Sizes& sizes_;
  std::size_t count_ = 0;
  V even_{};
  Halves inside_ = Halves{} - 1;
};

}  // namespace slipproof
