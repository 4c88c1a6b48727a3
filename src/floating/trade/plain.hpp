// Floating point as it is commonly used: what was computed is believed.
#pragma once

#include <cmath>

#include "floating/filter/mode_status.hpp"
#include "floating/trade/arithmetic.hpp"

namespace slipproof {

/// A number of the reduction. Everything that is not negative counts as positive, so that a boundary motion is found.
template <class T>
class Plain {
 public:
  Plain() : value_(0) {}
  explicit Plain(int constant) : value_(static_cast<T>(constant)) {}
  static Plain input(T value) {
    Plain x;
    x.value_ = std::move(value);
    return x;
  }
  const T& value() const { return value_; }

  friend Plain operator+(const Plain& x, const Plain& y) { return input(T(x.value_ + y.value_)); }
  friend Plain operator-(const Plain& x, const Plain& y) { return input(T(x.value_ - y.value_)); }
  friend Plain operator*(const Plain& x, const Plain& y) { return input(T(x.value_ * y.value_)); }
  friend Plain operator-(const Plain& x) { return input(T(-x.value_)); }
  friend bool certainly_positive(const Plain& x) { return x.value_ >= 0; }
  friend bool certainly_negative(const Plain& x) { return x.value_ < 0; }

 private:
  T value_;
};

/// All modes, unrolled: for types that the processor knows.
template <class T>
ModeSets unrolled_modes(const ForcedScene<T>& s) {
  return decide_modes(tracked_dynamics<Plain<T>>(s), s.bicycle.J.has_value());
}

/// The same for types whose operations are calls: unrolling would save nothing and compile for minutes.
template <class T>
ModeSets looped_modes(const ForcedScene<T>& s) {
  using N = Plain<T>;
  const auto dynamics = tracked_dynamics<N>(s);
  ModeSets sets;
  const auto add = [](std::uint16_t& set, ContactMode mode) {
    set = static_cast<std::uint16_t>(set | 1U << mode.index());
  };
  for (const ContactMode mode : all_modes()) {
    if (!mode.on_road() && !s.bicycle.J) continue;
    const ReducedMotion<N, N> motion(dynamics, mode);
    const bool flipped = certainly_negative(motion.determinant());
    bool certain = flipped || certainly_positive(motion.determinant()), violated = false;
    const ConditionList list = condition_list(mode);
    for (int i = 0; i < list.count && !violated; ++i) {
      const N numerator = motion.condition_value(list.items[static_cast<std::size_t>(i)]).numerator;
      const N side = flipped ? -numerator : numerator;
      violated = certainly_negative(side);
      certain = certain && certainly_positive(side);
    }
    if (!violated) add(certain ? sets.consistent : sets.undecided, mode);
  }
  return sets;
}

/// `Conversion` offers `T rounded(const Rational&)`, correctly rounded but for subnormals, and
/// `std::optional<Rational> exactly(const T&)`, nothing for NaN and the infinities.
template <class T, class Conversion, ModeSets (*modes)(const ForcedScene<T>&)>
class PlainArithmetic : public Arithmetic {
 public:
  using Arithmetic::Arithmetic;

  void load(const std::vector<ForcedScene<Rational>>& scenes) override {
    scenes_.clear();
    for (const auto& s : scenes) scenes_.push_back(convert<Rational, T>(s, Conversion::rounded));
  }

  Answer answer(std::size_t scene) const override {
    const auto dynamics = tracked_dynamics<Plain<T>>(scenes_[scene]);
    const ModeSets sets = modes(scenes_[scene]);
    bool divides = true;
    for (const ContactMode mode : all_modes()) {
      if ((sets.consistent >> mode.index() & 1U) == 0) continue;
      const ReducedMotion<Plain<T>, Plain<T>> motion(dynamics, mode);
      for (const Quantity q : judged_quantities) {
        const T unit = motion.quantity(q).denominator.value();
        divides = divides && unit != 0 && Conversion::exactly(unit).has_value();
      }
    }
    return {sets.consistent, std::nullopt, sets.undecided == 0 && divides, std::nullopt};
  }

  JudgedValues<std::optional<Rational>> motion(std::size_t scene, ContactMode mode) const override {
    const auto dynamics = tracked_dynamics<Plain<T>>(scenes_[scene]);
    const ReducedMotion<Plain<T>, Plain<T>> motion(dynamics, mode);
    JudgedValues<std::optional<Rational>> values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto q = motion.quantity(judged_quantities[i]);
      values[i] = Conversion::exactly(T(q.numerator.value() / q.denominator.value()));
    }
    return values;
  }

  unsigned run() const override {
    unsigned seen = 0;
    for (const auto& s : scenes_) seen += modes(s).consistent;
    return seen;
  }

 private:
  std::vector<ForcedScene<T>> scenes_;
};

}  // namespace slipproof
