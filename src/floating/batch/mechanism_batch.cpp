#include "floating/batch/mechanism_batch.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "base/number/binary64.hpp"
#include "floating/batch/sure_points.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "mechanics/mechanism/words.hpp"
#include "mechanics/scene/degrees.hpp"

namespace slipproof {

/// The columns after they were checked.
struct MechanismBatch::Points {
  const MechanismColumns& columns;
  std::size_t count = 1;

  Points(const MechanismBatch& batch, const MechanismColumns& given) : columns(given) {
    const Mechanism& mechanism = *batch.mechanism_;
    if (given.parameters.size() != mechanism.parameters.size() || given.tan_halves.size() != mechanism.angles.size()) {
      throw std::invalid_argument("not as many columns as the mechanism has parameters and angles");
    }
    for (std::size_t i = 0; i < given.parameters.size(); ++i) {
      if ((given.parameters[i].size() > 0) != batch.given_[i]) {
        throw std::invalid_argument("a parameter without a number, or with one that was not said to be given");
      }
      measure(given.parameters[i]);
    }
    for (const Column& column : given.tan_halves) measure(column);
    measure(given.load);
    check();
  }

 private:
  void measure(const Column& column) { count = std::max(count, column.size()); }

  void check() const {
    const auto fits = [this](const Column& column) { return column.size() <= 1 || column.size() == count; };
    if (!std::all_of(columns.parameters.begin(), columns.parameters.end(), fits) ||
        !std::all_of(columns.tan_halves.begin(), columns.tan_halves.end(), fits) || !fits(columns.load)) {
      throw std::invalid_argument("a column of neither one nor all points");
    }
  }
};

std::string_view name(Tier tier) {
  return tier == Tier::filter ? "filter" : "exact";
}

MechanismBatch::MechanismBatch(const Mechanism& mechanism)
    : MechanismBatch(mechanism, starts(mechanism), std::vector<bool>(mechanism.parameters.size(), true)) {}

MechanismBatch::MechanismBatch(const Mechanism& mechanism, std::vector<ElementKind::Start> starts,
                               std::vector<bool> given)
    : mechanism_(&mechanism), maker_(mechanism), starts_(std::move(starts)), given_(std::move(given)) {
  const auto kinds = element_kinds(mechanism, starts_, given_);
  refuse_too_many_modes(mechanism, kinds);
  modes_ = modes_of(kinds);
  if (auto programs = mode_programs(mechanism, starts_, given_)) {
    code_ = std::make_unique<const ModeCode>(std::move(*programs));
  }
}

MechanismBatch::~MechanismBatch() = default;

const BlockCode& MechanismBatch::block_code(const std::vector<bool>& constant) const {
  const std::lock_guard lock(mutex_);
  auto& code = blocks_[constant];
  if (!code) code = std::make_unique<const BlockCode>(code_->programs(), constant);
  return *code;
}

MechanismAnswers MechanismBatch::modes_at(const MechanismColumns& columns, Unsure unsure) const {
  const Points points(*this, columns);
  MechanismAnswers answers{modes_.size(), std::vector<ModeAt>(points.count * modes_.size(), ModeAt::unsure), {}};
  const auto row = [&](std::size_t point) {
    return std::span(answers.status).subspan(point * modes_.size(), modes_.size());
  };
  const auto pass_on = [&](std::size_t point) {
    if (unsure == Unsure::left) return;
    decide(columns, point, row(point));
    ++answers.tiers[static_cast<std::size_t>(Tier::exact)];
  };
  if (code_ == nullptr) {
    for (std::size_t i = 0; i < points.count; ++i) pass_on(i);
    return answers;
  }
  SurePoints sure(*this, columns);
  sure.decide(points.count, [&](std::size_t point, std::span<const ModeAt> status, const auto&) {
    if (std::ranges::find(status, ModeAt::unsure) != status.end()) {
      pass_on(point);
      return;
    }
    std::ranges::copy(status, row(point).begin());
    ++answers.tiers[static_cast<std::size_t>(Tier::filter)];
  });
  return answers;
}

MechanismValues MechanismBatch::values_at(const MechanismColumns& columns, std::size_t point) const {
  MechanismValues values = default_values(*mechanism_);
  values.starts = starts_;
  values.given = given_;
  for (std::size_t i = 0; i < values.parameters.size(); ++i) {
    if (given_[i]) values.parameters[i] = to_rational(columns.parameters[i][point]);
  }
  for (std::size_t i = 0; i < values.angles.size(); ++i) {
    values.angles[i] = point_of_tan_half(to_rational(columns.tan_halves[i][point]));
  }
  return values;
}

void MechanismBatch::decide(const MechanismColumns& columns, std::size_t point, std::span<ModeAt> modes) const {
  std::optional<Rational> load;
  if (columns.load.size() > 0) load = to_rational(columns.load[point]);
  std::ranges::fill(modes, ModeAt::inconsistent);
  const FrictionProblem problem = without_equations(maker_.problem(values_at(columns, point)));
  for (const ConsistentMode& found : ModeSolver(problem, load).consistent()) {
    const auto place = std::ranges::find(modes_, found.mode) - modes_.begin();
    modes[static_cast<std::size_t>(place)] = found.solutions.strict ? ModeAt::strict : ModeAt::boundary;
  }
}

}  // namespace slipproof
