#include "verify/sampler.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "expression/filtered.hpp"
#include "number/dice.hpp"

namespace slipproof {

namespace {

/// Points of a setting, one after the other in the same memory: many are looked at for each that is kept.
class SamplePoint {
 public:
  explicit SamplePoint(const CompiledSetting& setting) : setting_(setting), evaluator_(setting.scope()) {}

  SamplePoint& at(const std::vector<Rational>& values) {
    evaluator_.set(CompiledSetting::parameter_slot(0), values);
    return *this;
  }
  /// One of them is another one now.
  void changed(std::size_t parameter) { evaluator_.changed(parameter); }
  bool allows(std::size_t parameter) { return is_true(setting_.domains()[parameter]); }
  bool in_domain() {
    return std::all_of(setting_.domains().begin(), setting_.domains().end(),
                       [&](const Program& domain) { return is_true(domain); });
  }
  std::vector<std::size_t> unrealisable() {
    std::vector<std::size_t> unmet;
    for (std::size_t i = 0; i < setting_.realisable().size(); ++i) {
      if (!is_true(setting_.realisable()[i])) unmet.push_back(i);
    }
    return unmet;
  }
  std::optional<Rational> value(const Program& program) { return evaluator_.number(program).number; }

 private:
  bool is_true(const Program& program) { return evaluator_.truth(program) == Truth::yes; }

  const CompiledSetting& setting_;
  FilteredEvaluator evaluator_;
};

enum class Kind { integers, fractions, on_boundary, near_boundary, between_boundaries, extreme };
constexpr std::array kinds{Kind::integers,           Kind::fractions, Kind::on_boundary, Kind::near_boundary,
                           Kind::between_boundaries, Kind::extreme,   Kind::fractions,   Kind::on_boundary};

constexpr int largest_numerator = 12, largest_denominator = 8;

/// In lowest terms once and for all: a sample may take thousands of them.
const Rational& small_fraction(int numerator, int denominator) {
  static const std::vector<Rational> all = [] {
    std::vector<Rational> fractions;
    for (int n = -largest_numerator; n <= largest_numerator; ++n) {
      for (int d = 1; d <= largest_denominator; ++d) fractions.emplace_back(n, d);
    }
    return fractions;
  }();
  return all[static_cast<std::size_t>((numerator + largest_numerator) * largest_denominator + denominator - 1)];
}

Rational draw(Dice& dice, Kind kind) {
  const int sign = dice.chance(4) ? -1 : 1;
  if (dice.chance(10)) return 0;
  if (kind == Kind::integers) return sign * dice.number(1, 6);
  const int denominator = dice.number(1, largest_denominator);
  const Rational& small = small_fraction(sign * dice.number(1, largest_numerator), denominator);
  if (kind != Kind::extreme || dice.chance(2)) return small;
  return small * power_of_two(dice.number(-40, 40));
}

std::vector<Rational> draw_all(SamplePoint& point, std::size_t parameters, Dice& dice, Kind kind) {
  std::vector<Rational> values(parameters);
  for (int attempt = 0; attempt < 200; ++attempt) {
    for (Rational& value : values) value = draw(dice, kind);
    if (point.at(values).in_domain()) return values;
    // Domains of one parameter alone are met soonest by drawing it alone again.
    for (std::size_t k = 0; k < values.size(); ++k) {
      for (int again = 0; again < 20; ++again) {
        if (point.allows(k)) break;
        values[k] = draw(dice, kind);
        point.changed(k);
      }
    }
    if (point.in_domain()) return values;
  }
  return {};
}

/// Draws single parameters anew, as long as no further condition breaks, until what the values are of can be built;
/// false if that does not come about.
bool make_realisable(SamplePoint& point, Dice& dice, Kind kind, std::vector<Rational>& values) {
  const auto last = static_cast<int>(values.size()) - 1;
  std::size_t unmet = point.at(values).unrealisable().size();
  for (int attempt = 0; attempt < 400 && unmet > 0; ++attempt) {
    Rational drawn = draw(dice, kind);
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

bool allows(const CompiledSetting& setting, std::size_t parameter, const std::vector<Rational>& values) {
  return SamplePoint(setting).at(values).allows(parameter);
}

bool in_domain(const CompiledSetting& setting, const std::vector<Rational>& values) {
  return SamplePoint(setting).at(values).in_domain();
}

std::vector<std::size_t> unrealisable(const CompiledSetting& setting, const std::vector<Rational>& values) {
  return SamplePoint(setting).at(values).unrealisable();
}

std::optional<Rational> boundary_value(const CompiledSetting& setting, const CompiledSetting::Boundary& boundary,
                                       const std::vector<Rational>& values) {
  return SamplePoint(setting).at(values).value(boundary.value);
}

std::vector<Rational> Sampler::at(std::uint64_t i) const {
  Dice dice(seed_, i);
  Kind kind = kinds[i % kinds.size()];
  // What can be built has fractions: wheels are smaller than the vehicle.
  if (among_ == Among::realisable && kind == Kind::integers) kind = Kind::fractions;
  SamplePoint point(*setting_);
  std::vector<Rational> values = draw_all(point, setting_->domains().size(), dice, kind);
  if (!values.empty() && among_ == Among::realisable && !make_realisable(point, dice, kind, values)) return {};
  if (values.empty() || kind == Kind::integers || kind == Kind::fractions || setting_->boundaries().empty())
    return values;
  if (kind == Kind::extreme && dice.chance(2)) return values;

  std::vector<std::size_t> bounded;
  for (const auto& boundary : setting_->boundaries()) {
    if (std::find(bounded.begin(), bounded.end(), boundary.parameter) == bounded.end()) {
      bounded.push_back(boundary.parameter);
    }
  }
  // Parameters with boundaries in the file's order; the last may depend on those before it. Sometimes all are placed.
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
