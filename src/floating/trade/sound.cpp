#include <algorithm>
#include <cmath>
#include <span>

#include "base/number/binary64.hpp"
#include "floating/batch/lane_points.hpp"
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

/// binary64 where it is sure, otherwise the kernel, called as a user would: as a batch, whose error bounds include the
/// rounding of inputs that are not binary64.
class FilterArithmetic : public ExactArithmetic {
 public:
  FilterArithmetic() : ExactArithmetic({"filter", 53}) {}

  void load(const Workload& workload) override {
    ExactArithmetic::load(workload);
    numbers_.assign(workload.scenes.at(0).size(), {});
    std::vector<bool> exact(numbers_.size(), true);  // by input: whether all its numbers are
    for (const TradeScene& scene : workload.scenes) {
      for (std::size_t i = 0; i < scene.size(); ++i) {
        const double nearest = numbers_[i].emplace_back(nearest_binary64(scene[i]));
        exact[i] = exact[i] && std::isfinite(nearest) && to_rational(nearest) == scene[i];
      }
    }
    columns_ = {};
    for (std::size_t i = 0; i + 1 < numbers_.size(); ++i) {
      columns_.parameters.push_back(mechanism().batch().given()[i] ? Column(numbers_[i]).rounded(!exact[i]) : Column());
    }
    columns_.load = Column(numbers_.back()).rounded(!exact.back());
    lanes_.emplace(mechanism().code());
  }

  std::vector<ModeAt> decide() override {
    std::vector<ModeAt> found = mechanism().batch().modes_at(columns_, Unsure::left).status;
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
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      put_point(columns_, mechanism().code().programs(), scene, lane, *lanes_);
    }
    const ModeRun::Values& found = lanes_->compute_values(mode);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const RunningError& x = mechanism().judged(i, found).constant;
      if (!std::isfinite(x.error[0])) return std::nullopt;
      values[i] = to_rational(x.value[0]);
    }
    return values;
  }

 private:
  std::vector<std::vector<double>> numbers_;  ///< the nearest binary64, by input
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
