#include <algorithm>
#include <cmath>
#include <span>

#include "base/number/binary64.hpp"
#include "floating/tape/mode_run.hpp"
#include "floating/trade/arithmetic.hpp"

namespace slipproof {

namespace {

/// The exact kernel alone.
class ExactArithmetic : public Arithmetic {
 public:
  explicit ExactArithmetic(TradeType type = {"exact", 0}) : Arithmetic(std::move(type)) {}

  void load(const Workload& workload) override { workload_ = &workload; }
  std::vector<ModeAt> decide() override {
    std::vector<ModeAt> found;
    for (std::size_t i = 0; i < scenes(); ++i) std::ranges::copy(exact(i).status, std::back_inserter(found));
    return found;
  }
  std::optional<Tier> tier(std::size_t) const override { return Tier::exact; }
  std::optional<JudgedValues<Rational>> motion(std::size_t scene, std::size_t) override { return exact(scene).values; }

 protected:
  std::size_t scenes() const { return workload_->scenes.size(); }
  const TradedMechanism& mechanism() const { return *workload_->mechanism; }
  ExactAnswer exact(std::size_t scene) const { return mechanism().exact(workload_->scenes[scene]); }

 private:
  const Workload* workload_ = nullptr;
};

/// binary64 where it is sure, otherwise the kernel, called as a user would: as a batch if all numbers are binary64,
/// otherwise by lanes whose error bounds include the rounding of the inputs.
class FilterArithmetic : public ExactArithmetic {
 public:
  FilterArithmetic() : ExactArithmetic({"filter", 53}) {}

  void load(const Workload& workload) override {
    ExactArithmetic::load(workload);
    numbers_.assign(workload.scenes.at(0).size(), {});
    exact_.assign(numbers_.size(), true);
    for (const TradeScene& scene : workload.scenes) {
      for (std::size_t i = 0; i < scene.size(); ++i) {
        const double nearest = numbers_[i].emplace_back(nearest_binary64(scene[i]));
        exact_[i] = exact_[i] && std::isfinite(nearest) && to_rational(nearest) == scene[i];
      }
    }
    columns_ = {};
    for (std::size_t i = 0; i + 1 < numbers_.size(); ++i) {
      columns_.parameters.push_back(mechanism().batch().given()[i] ? Column(numbers_[i]) : Column());
    }
    columns_.load = Column(numbers_.back());
    lanes_.emplace(mechanism().code());
  }

  std::vector<ModeAt> decide() override {
    const bool all_exact = std::ranges::find(exact_, false) == exact_.end();
    std::vector<ModeAt> found = all_exact ? mechanism().batch().modes_at(columns_, Unsure::left).status : by_lanes();
    tiers_.assign(scenes(), Tier::filter);
    for (std::size_t i = 0; i < scenes(); ++i) {
      const std::span modes(&found[i * mechanism().modes()], mechanism().modes());
      if (std::ranges::find(modes, ModeAt::unsure) == modes.end()) continue;
      std::ranges::copy(exact(i).status, modes.begin());
      tiers_[i] = Tier::exact;
    }
    return found;
  }

  std::optional<Tier> tier(std::size_t scene) const override { return tiers_[scene]; }

  std::optional<JudgedValues<Rational>> motion(std::size_t scene, std::size_t mode) override {
    JudgedValues<Rational> values;
    if (tiers_[scene] == Tier::exact) {
      values = exact(scene).values;
      for (Rational& value : values) value = to_rational(nearest_binary64(value));
      return values;
    }
    decide_lanes(scene);
    const ModeRun::Values& found = lanes_->compute_values(mode);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const RunningError& x = mechanism().judged(i, found).constant;
      if (!std::isfinite(x.error[0])) return std::nullopt;
      values[i] = to_rational(x.value[0]);
    }
    return values;
  }

 private:
  void decide_lanes(std::size_t first) {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const std::size_t scene = std::min(first + lane, scenes() - 1);
      for (std::size_t i = 0; i < numbers_.size(); ++i) lanes_->set(i, lane, numbers_[i][scene], exact_[i]);
    }
    lanes_->decide();
  }

  std::vector<ModeAt> by_lanes() {
    std::vector<ModeAt> found;
    for (std::size_t scene = 0; scene < scenes(); ++scene) {
      const std::size_t lane = scene % lane_count;
      if (lane == 0) decide_lanes(scene);
      for (const LaneModes& mode : lanes_->modes()) {
        found.push_back(mode.strict[lane] != 0         ? ModeAt::strict
                        : mode.boundary[lane] != 0     ? ModeAt::boundary
                        : mode.inconsistent[lane] != 0 ? ModeAt::inconsistent
                                                       : ModeAt::unsure);
      }
    }
    return found;
  }

  std::vector<std::vector<double>> numbers_;  ///< the nearest binary64, by input
  std::vector<bool> exact_;                   ///< by input: whether all its numbers are exact
  MechanismColumns columns_;
  std::optional<ModeRun> lanes_;
  std::vector<Tier> tiers_;
};

}  // namespace

void add_sound_arithmetics(Arithmetics& all) {
  all.push_back(std::make_unique<FilterArithmetic>());
  all.push_back(std::make_unique<ExactArithmetic>());
}

}  // namespace slipproof
