#include "claims/sampling/sampler.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/expression/filtered.hpp"
#include "mechanics/points/drawn_number.hpp"

namespace slipproof {

namespace {

bool is_true(FilteredEvaluator& evaluator, const Program& program) {
  return evaluator.truth(program) == Truth::yes;
}

std::vector<std::size_t> unmet_by(FilteredEvaluator& evaluator, const std::vector<Program>& conditions) {
  std::vector<std::size_t> unmet;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (!is_true(evaluator, conditions[i])) unmet.push_back(i);
  }
  return unmet;
}

/// An evaluator in which the setting's programs find the values of the parameters.
FilteredEvaluator evaluator_at(const CompiledSetting& setting, const std::vector<Rational>& values) {
  FilteredEvaluator evaluator(setting.scope());
  evaluator.set(CompiledSetting::parameter_slot(0), values);
  return evaluator;
}

/// Points of a setting, one after another in the same memory: thousands are examined, and few are kept.
class SamplePoint {
 public:
  SamplePoint(const CompiledSetting& setting, const std::vector<SureCondition>& domains)
      : setting_(setting), domains_(domains), evaluator_(setting.scope()), near_(domains.size()) {}

  SamplePoint& at(const std::vector<Rational>& values) {
    values_ = &values;
    for (std::size_t k = 0; k < values.size(); ++k) near_[k] = Approximate(values[k]);
    for (SureCondition& domain : domains_) domain.all_changed();
    is_set_ = false;
    return *this;
  }
  /// Must be called when the value of a parameter has changed.
  void changed(std::size_t parameter) {
    near_[parameter] = Approximate((*values_)[parameter]);
    for (SureCondition& domain : domains_) domain.changed(parameter);
    is_set_ = false;
  }
  bool allows(std::size_t parameter) {
    const Truth sure = domains_[parameter].truth(near_);
    return sure == Truth::undecided ? is_true(evaluator(), setting_.domains()[parameter]) : sure == Truth::yes;
  }
  /// Call after allows(): SureCondition::demanded() of the parameter's domain.
  const Approximate* demanded(std::size_t parameter) const { return domains_[parameter].demanded(parameter); }
  bool in_domain() {
    for (std::size_t k = 0; k < domains_.size(); ++k) {
      if (!allows(k)) return false;
    }
    return true;
  }
  std::vector<std::size_t> unrealisable() { return unmet_by(evaluator(), setting_.realisable()); }
  std::optional<Rational> value(const Program& program) { return evaluator().number(program).number; }

 private:
  FilteredEvaluator& evaluator() {
    if (!is_set_) evaluator_.set(CompiledSetting::parameter_slot(0), *values_);
    is_set_ = true;
    return evaluator_;
  }

  const CompiledSetting& setting_;
  std::vector<SureCondition> domains_;
  FilteredEvaluator evaluator_;
  std::vector<Approximate> near_;
  const std::vector<Rational>* values_ = nullptr;
  bool is_set_ = false;  ///< whether the evaluator has the current values
};

enum class Kind { integers, fractions, on_boundary, near_boundary, between_boundaries, extreme };
constexpr std::array kinds{Kind::integers,           Kind::fractions, Kind::on_boundary, Kind::near_boundary,
                           Kind::between_boundaries, Kind::extreme,   Kind::fractions,   Kind::on_boundary};

NumberKind number_kind(Kind kind) {
  if (kind == Kind::integers) return NumberKind::integers;
  return kind == Kind::extreme ? NumberKind::extreme : NumberKind::fractions;
}

/// Draws one parameter again, a limited number of times, until its domain allows it.
void draw_again(SamplePoint& point, std::size_t parameter, int times, Dice& dice, NumberKind kind, Rational& value) {
  if (point.allows(parameter)) return;
  if (const Approximate* const demanded = point.demanded(parameter); demanded && !may_be_drawn(*demanded, kind)) {
    for (; times > 1; --times) draw_number(dice, kind);  // all these draws are in vain
  }
  for (; times > 0 && !point.allows(parameter); --times) {
    value = draw_number(dice, kind).value();
    point.changed(parameter);
  }
}

std::vector<Rational> draw_all(SamplePoint& point, const std::vector<std::optional<Rational>>& only_values, Dice& dice,
                               NumberKind kind) {
  std::vector<Rational> values(only_values.size());
  for (int attempt = 0; attempt < 200; ++attempt) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] = draw_number(dice, kind).value();
      if (only_values[k]) values[k] = *only_values[k];
    }
    if (point.at(values).in_domain()) return values;
    // Domains of a single parameter are met soonest by drawing that parameter again.
    for (std::size_t k = 0; k < values.size(); ++k) draw_again(point, k, 20, dice, kind, values[k]);
    if (point.in_domain()) return values;
  }
  return {};
}

/// Draws single parameters again, if no further condition then breaks, until the mechanism can be built; false if it
/// does not succeed.
bool make_realisable(SamplePoint& point, Dice& dice, NumberKind kind, std::vector<Rational>& values) {
  const auto last = static_cast<int>(values.size()) - 1;
  std::size_t unmet = point.at(values).unrealisable().size();
  for (int attempt = 0; attempt < 400 && unmet > 0; ++attempt) {
    Rational drawn = draw_number(dice, kind).value();
    const auto parameter = static_cast<std::size_t>(dice.number(0, last));
    Rational& value = values[parameter];
    Rational before = std::exchange(value, std::move(drawn));
    point.changed(parameter);
    const bool inside = point.in_domain();
    const std::size_t still = inside ? point.unrealisable().size() : unmet;
    if (!inside || still > unmet) {
      value = std::move(before);
      point.changed(parameter);
    } else {
      unmet = still;
    }
  }
  return unmet == 0;
}

/// The boundaries of one parameter, ascending.
std::vector<Rational> boundaries_of(const CompiledSetting& setting, std::size_t parameter, SamplePoint& point) {
  std::vector<Rational> result;
  for (const auto& boundary : setting.boundaries()) {
    if (boundary.parameter != parameter) continue;
    if (auto value = point.value(boundary.value)) result.push_back(std::move(*value));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

Rational placed(const std::vector<Rational>& boundaries, Dice& dice, Kind kind) {
  const auto last = static_cast<int>(boundaries.size()) - 1;
  const Rational& here = boundaries[static_cast<std::size_t>(dice.number(0, last))];
  if (kind == Kind::on_boundary) return here;
  if (kind == Kind::near_boundary) {
    const Rational step = power_of_two(-dice.number(3, 60));
    return here + (dice.chance(2) ? step : Rational(-step)) * (here.is_zero() ? Rational(1) : here);
  }
  const Rational& other = boundaries[static_cast<std::size_t>(dice.number(0, last))];
  return here + (other - here) * Rational(dice.number(1, 7), 8);
}

}  // namespace

std::vector<std::size_t> unrealisable(const CompiledSetting& setting, const std::vector<Rational>& values) {
  FilteredEvaluator evaluator = evaluator_at(setting, values);
  return unmet_by(evaluator, setting.realisable());
}

std::optional<Rational> boundary_value(const CompiledSetting& setting, const CompiledSetting::Boundary& boundary,
                                       const std::vector<Rational>& values) {
  return evaluator_at(setting, values).number(boundary.value).number;
}

Sampler::Sampler(const CompiledSetting& setting, std::uint64_t seed, Among among)
    : setting_(&setting), seed_(seed), among_(among) {
  for (const Program& domain : setting.domains()) {
    domains_.emplace_back(setting.scope(), domain, CompiledSetting::parameter_slot(0), setting.domains().size());
  }
  FilteredEvaluator evaluator(setting.scope());
  for (const auto& value : setting.only_values()) {
    only_values_.push_back(value ? evaluator.number(*value).number : std::nullopt);
  }
}

std::vector<Rational> Sampler::at(std::uint64_t i) const {
  Dice dice(seed_, i);
  Kind kind = kinds[i % kinds.size()];
  // A mechanism that can be built has fractions, for example because wheels are smaller than the vehicle.
  if (among_ == Among::realisable && kind == Kind::integers) kind = Kind::fractions;
  SamplePoint point(*setting_, domains_);
  std::vector<Rational> values = draw_all(point, only_values_, dice, number_kind(kind));
  if (!values.empty() && among_ == Among::realisable && !make_realisable(point, dice, number_kind(kind), values))
    return {};
  if (values.empty() || kind == Kind::integers || kind == Kind::fractions || setting_->boundaries().empty())
    return values;
  if (kind == Kind::extreme && dice.chance(2)) return values;

  std::vector<std::size_t> bounded;
  for (const auto& boundary : setting_->boundaries()) {
    if (std::find(bounded.begin(), bounded.end(), boundary.parameter) == bounded.end()) {
      bounded.push_back(boundary.parameter);
    }
  }
  // Takes parameters with boundaries in the file's order, since the last may depend on those before it. Sometimes
  // places all on boundaries.
  const bool all = dice.chance(4);
  const std::size_t chosen = static_cast<std::size_t>(dice.number(0, static_cast<int>(bounded.size()) - 1));
  for (std::size_t k = 0; k < bounded.size(); ++k) {
    if (!all && k != chosen) continue;
    const auto boundaries = boundaries_of(*setting_, bounded[k], point.at(values));
    if (boundaries.empty()) continue;
    std::vector<Rational> moved = values;
    moved[bounded[k]] = placed(boundaries, dice, kind == Kind::extreme ? Kind::on_boundary : kind);
    if (!point.at(moved).in_domain()) continue;
    if (among_ == Among::all || point.unrealisable().empty()) values = std::move(moved);
  }
  return values;
}

}  // namespace slipproof
