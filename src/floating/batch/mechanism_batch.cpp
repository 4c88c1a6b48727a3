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
#include "mechanics/points/degrees.hpp"

namespace slipproof {

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

std::size_t MechanismBatch::count(const MechanismColumns& columns) const {
  if (columns.parameters.size() != mechanism_->parameters.size() ||
      columns.tan_halves.size() != mechanism_->angles.size()) {
    throw std::invalid_argument("not as many columns as the mechanism has parameters and angles");
  }
  for (std::size_t i = 0; i < given_.size(); ++i) {
    if ((columns.parameters[i].size() > 0) != given_[i]) {
      throw std::invalid_argument("a parameter without a number, or with one that was not said to be given");
    }
  }
  std::size_t count = 1;
  const auto measure = [&](const Column& column) { count = std::max(count, column.size()); };
  const auto check = [&](const Column& column) {
    if (column.size() > 1 && column.size() != count) {
      throw std::invalid_argument("a column of neither one nor all points");
    }
  };
  const auto each = [&](const auto& see) {
    std::ranges::for_each(columns.parameters, see);
    std::ranges::for_each(columns.tan_halves, see);
    see(columns.load);
  };
  each(measure);
  each(check);
  return count;
}

MechanismAnswers MechanismBatch::modes_at(const MechanismColumns& columns, Unsure unsure) const {
  const std::size_t points = count(columns);
  MechanismAnswers answers{modes_.size(), std::vector<ModeAt>(points * modes_.size(), ModeAt::unsure), {}};
  const auto row = [&](std::size_t point) {
    return std::span(answers.status).subspan(point * modes_.size(), modes_.size());
  };
  const auto pass_on = [&](std::size_t point) {
    if (unsure == Unsure::left) return;
    decide(columns, point, row(point));
    ++answers.tiers[static_cast<std::size_t>(Tier::exact)];
  };
  if (code_ == nullptr) {
    for (std::size_t i = 0; i < points; ++i) pass_on(i);
    return answers;
  }
  SurePoints sure(*this, columns);
  sure.decide(points, [&](std::size_t point, std::span<const ModeAt> status, const auto&) {
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
