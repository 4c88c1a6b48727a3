#include "floating/batch/bicycle_batch.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "base/number/format.hpp"
#include "base/parallel/in_parallel.hpp"
#include "mechanics/scene/bicycle_scene.hpp"

namespace slipproof {

namespace {

constexpr std::size_t J = 11;

/// The batch of the model with J or without it; each is made once.
const MechanismBatch& batch_of(bool with_J) {
  const auto make = [](bool given_J) {
    const Mechanism& mechanism = bicycle_mechanism();
    std::vector<bool> given(mechanism.parameters.size(), true);
    given[bicycle_parameter("J")] = given_J;
    return MechanismBatch(mechanism, starts(mechanism), given);
  };
  static const MechanismBatch with = make(true), without = make(false);
  return with_J ? with : without;
}

class Bicycles {
 public:
  Bicycles(const BicycleColumns& given, std::size_t first_number)
      : batch_(batch_of(given.numbers[J].size() > 0)), first_(first_number) {
    if (const auto missing = given.missing(); !missing.empty()) {
      throw std::invalid_argument(std::string(missing) + ": found no number, expected one of each bicycle, or of all");
    }
    columns_.parameters.resize(bicycle_mechanism().parameters.size());
    for (std::size_t i = 0; i < given.symbols.size(); ++i) {
      columns_.parameters[bicycle_parameter(given.symbols[i])] = given.numbers[i];
    }
    columns_.parameters[bicycle_parameter("external")] = Column(given.external ? 1.0 : 0.0);
    columns_.load = given.F;
    count_ = batch_.count(columns_);
    for (const MechanismMode& mode : batch_.modes()) {
      bits_.push_back(1U << (4 * static_cast<unsigned>(mode[0]) + static_cast<unsigned>(mode[1])));
    }
  }

  std::size_t count() const { return count_; }

  void decide(std::size_t begin, std::size_t end, BicycleModes& modes) const {
    const MechanismColumns some = part(begin, end - begin);
    MechanismAnswers answers = batch_.modes_at(some, Unsure::left);
    for (std::size_t i = 0; i < end - begin; ++i) {
      // If all bicycles are the same one, the answers are for one point.
      const std::size_t point = answers.status.size() == bits_.size() ? 0 : i;
      const auto row = std::span(answers.status).subspan(point * bits_.size(), bits_.size());
      modes.tiers[begin + i] = Tier::filter;
      if (std::ranges::find(row, ModeAt::unsure) != row.end()) {
        check(some, point, begin + i);
        batch_.decide(some, point, row);
        modes.tiers[begin + i] = Tier::exact;
      }
      unsigned consistent = 0, strict = 0;
      for (std::size_t mode = 0; mode < row.size(); ++mode) {
        if (row[mode] != ModeAt::inconsistent) consistent |= bits_[mode];
        if (row[mode] == ModeAt::strict) strict |= bits_[mode];
      }
      modes.consistent[begin + i] = static_cast<std::uint16_t>(consistent);
      modes.strict[begin + i] = static_cast<std::uint16_t>(strict);
    }
  }

 private:
  MechanismColumns part(std::size_t begin, std::size_t size) const {
    MechanismColumns some = columns_;
    for (Column& column : some.parameters) column = column.part(begin, size);
    some.load = some.load.part(begin, size);
    return some;
  }

  /// Throws std::invalid_argument if a bicycle is outside the domain. A point that binary64 decided is inside.
  void check(const MechanismColumns& some, std::size_t point, std::size_t bicycle) const {
    const auto refuse = [&](const std::string& what) {
      throw std::invalid_argument("bicycle " + std::to_string(first_ + bicycle) + ": " + what);
    };
    const Mechanism& mechanism = bicycle_mechanism();
    const auto need_finite = [&](const std::string& symbol, const Column& column) {
      if (column.size() == 0 || std::isfinite(column[point])) return;
      refuse(symbol + ": found " + (std::isnan(column[point]) ? "NaN" : "infinity") + ", expected a finite number");
    };
    for (std::size_t i = 0; i < some.parameters.size(); ++i) {
      need_finite(mechanism.parameters[i].symbol, some.parameters[i]);
    }
    need_finite("F", some.load);
    const MechanismValues values = batch_.values_at(some, point);
    for (const ProblemMaker::Broken& broken : batch_.maker().broken(values)) {
      const std::string& symbol = mechanism.parameters[broken.index].symbol;
      refuse(symbol + ": found " + decimal_text(values.parameters[broken.index], 6) + ", expected " +
             to_string(broken.condition->expression));
    }
  }

  const MechanismBatch& batch_;
  std::size_t first_, count_ = 0;
  MechanismColumns columns_;
  std::vector<unsigned> bits_;  ///< of the batch's modes
};

}  // namespace

std::string_view BicycleColumns::missing() const {
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    if (i != J && numbers[i].size() == 0) return symbols[i];
  }
  return F.size() == 0 ? "F" : "";
}

TierCounts BicycleModes::counts() const {
  TierCounts counts{};
  for (const Tier tier : tiers) ++counts[static_cast<std::size_t>(tier)];
  return counts;
}

BicycleModes consistent_modes(const BicycleColumns& given, unsigned threads, std::size_t first) {
  const Bicycles bicycles(given, first);
  BicycleModes modes;
  modes.consistent.resize(bicycles.count());
  modes.strict.resize(bicycles.count());
  modes.tiers.resize(bicycles.count());
  const auto decide = [&](std::size_t begin, std::size_t end) { bicycles.decide(begin, end, modes); };
  constexpr std::size_t piece = 4096;
  on_threads(threads, [&] { pieces_in_parallel(0, bicycles.count(), piece, decide); });
  return modes;
}

}  // namespace slipproof
