#include "floating/filter/filter.hpp"

#include "base/number/binary64.hpp"
#include "floating/filter/bounded_motion.hpp"
#include "floating/trade/arithmetic.hpp"

namespace slipproof {

namespace {

/// Whether the first tier decides or a later one, as a user would call it.
class FilterArithmetic : public Arithmetic {
 public:
  FilterArithmetic() : Arithmetic({"filter", 53}) {}

  void load(const std::vector<ForcedScene<Rational>>& scenes) override {
    scenes_ = &scenes;
    rounded_.clear();
    for (const auto& s : scenes) rounded_.push_back(nearest_binary64(s));
  }

  Answer answer(std::size_t scene) const override {
    const ConsistentModes found = consistent_modes((*scenes_)[scene]);
    return {found.consistent, found.strict, found.tier == Tier::filter, found.tier};
  }

  JudgedValues<std::optional<Rational>> motion(std::size_t scene, ContactMode mode) const override {
    const ForcedScene<Rational>& s = (*scenes_)[scene];
    switch (consistent_modes(s).tier) {
      case Tier::filter:
        return bounded_values(tracked_dynamics<Tracked>(rounded_[scene]), mode);
      case Tier::double_double:
        return bounded_values(tracked_dynamics<TrackedDouble2>(s), mode);
      case Tier::exact:
        break;
    }
    JudgedValues<std::optional<Rational>> values;
    const auto exact = exact_values(s, mode);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = to_rational(nearest_binary64(exact[i]));
    return values;
  }

  unsigned run() const override {
    unsigned seen = 0;
    for (std::size_t i = 0; i < rounded_.size(); ++i) {
      const ModeSets sets = filter_modes(rounded_[i]);
      seen += sets.undecided == 0 ? sets.consistent : consistent_modes((*scenes_)[i]).consistent;
    }
    return seen;
  }

 private:
  template <class N>
  static JudgedValues<std::optional<Rational>> bounded_values(const ReducedDynamics<N, N>& dynamics, ContactMode mode) {
    const ReducedMotion<N, N> motion(dynamics, mode);
    JudgedValues<std::optional<Rational>> values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Bounded b = bounded(motion.quantity(judged_quantities[i]));
      if (std::isfinite(b.error)) values[i] = to_rational(b.value);
    }
    return values;
  }

  const std::vector<ForcedScene<Rational>>* scenes_ = nullptr;
  std::vector<ForcedScene<double>> rounded_;
};

}  // namespace

std::unique_ptr<Arithmetic> filter_arithmetic() {
  return std::make_unique<FilterArithmetic>();
}

}  // namespace slipproof
