#include "mechanics/search/points.hpp"

#include <array>

#include "mechanics/points/drawn_number.hpp"

namespace slipproof {

namespace {

enum class Kind : std::uint8_t { ones, integers, fractions, wide, thin };
constexpr std::array kinds{Kind::ones, Kind::integers, Kind::fractions, Kind::thin, Kind::wide};

using Drawing = DomainSampler::Drawing;

NumberKind number_kind(Kind kind) {
  constexpr std::array all{NumberKind::ones, NumberKind::integers, NumberKind::fractions, NumberKind::wide,
                           NumberKind::fractions};
  return all[static_cast<std::size_t>(kind)];
}

/// Draws the symbols of one point.
class SymbolDraw {
 public:
  SymbolDraw(Dice& dice, Kind kind) : dice_(dice), kind_(kind) {}

  Rational operator()(const Drawing& drawing) {
    if (drawing.fixed && !dice_.chance(8)) return drawing.roots->front();
    if (!drawing.roots->empty()) {
      // Where the domain is narrow, its bounds and what is next to them are soonest in it.
      if (drawing.attempt >= 8 && dice_.chance(2)) return beside(any_of(*drawing.roots));
      if (kind_ == Kind::thin && dice_.chance(6)) return any_of(*drawing.roots);
    }
    if (kind_ == Kind::thin && drawing.parameters > 0 && dice_.chance(2)) return related(drawing);
    return plain(drawing.attempt < 20 ? kind_ : Kind::fractions);
  }

 private:
  Rational plain(Kind kind) { return draw_number(dice_, number_kind(kind)).value(); }

  const Rational& any_of(const std::vector<Rational>& values, std::size_t count) {
    return values[static_cast<std::size_t>(dice_.number(0, static_cast<int>(count) - 1))];
  }
  const Rational& any_of(const std::vector<Rational>& values) { return any_of(values, values.size()); }

  Rational beside(const Rational& bound) {
    const int turn = dice_.number(0, 2);
    if (turn == 0) return bound;
    const Rational step = power_of_two(-dice_.number(0, 12));
    return turn == 1 ? Rational(bound + step) : Rational(bound - step);
  }

  /// The value of another parameter, its opposite, or a sum, difference or product of two.
  Rational related(const Drawing& drawing) {
    const auto& known = drawing.values->parameters;
    const Rational& x = any_of(known, drawing.parameters);
    const Rational& y = any_of(known, drawing.parameters);
    switch (dice_.number(0, 5)) {
      case 0:
        return -x;
      case 1:
        return x + y;
      case 2:
        return x - y;
      case 3:
        return x * y;
      default:
        return x;
    }
  }

  Dice& dice_;
  Kind kind_;
};

}  // namespace

std::vector<bool> PointSampler::given(std::uint64_t turn) const {
  std::vector<bool> result(mechanism_->parameters.size(), true);
  unsigned optional = 0;
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!mechanism_->parameters[i].optional) continue;
    result[i] = ((turn >> (optional % 64)) & 1U) == 0;
    ++optional;
  }
  return result;
}

std::optional<MechanismValues> PointSampler::at(std::uint64_t i) const {
  constexpr int attempts = 20;
  const std::uint64_t turn = i / kinds.size();
  const bool buildable = turn % 2 == 1 && !mechanism_->realisable.empty();
  Dice dice(seed_, i);
  SymbolDraw draw(dice, kinds[i % kinds.size()]);
  const auto given = this->given(turn / 2);
  const auto draw_symbol = [&](const Drawing& drawing) { return draw(drawing); };
  for (int attempt = 0; buildable && attempt < attempts; ++attempt) {
    if (auto values = realisable_.sample(given, draw_symbol)) return values;
  }
  for (int attempt = 0; attempt < attempts; ++attempt) {
    // Where a later parameter has another bound, it may be too narrow for what was drawn of the first.
    const auto way = attempt < attempts / 2 ? DomainSampler::Way::draw : DomainSampler::Way::solve;
    if (auto values = domain_.sample(given, draw_symbol, way)) return values;
  }
  return std::nullopt;
}

}  // namespace slipproof
