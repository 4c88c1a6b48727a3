#include "floating/tape/mechanism_batch.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/number/binary64.hpp"
#include "base/parallel/stop.hpp"
#include "floating/tape/mode_run.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "mechanics/mechanism/words.hpp"
#include "mechanics/scene/degrees.hpp"

namespace slipproof {

/// Columns, checked.
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

  bool has_load() const { return columns.load.size() > 0; }

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

MechanismAnswers MechanismBatch::modes_at(const MechanismColumns& columns, Unsure unsure) const {
  const Points points(*this, columns);
  MechanismAnswers answers{modes_.size(), std::vector<ModeAt>(points.count * modes_.size()), {}};
  if (code_ == nullptr) {
    for (std::size_t i = 0; i < points.count; ++i) pass_on(points, i, unsure, answers);
    return answers;
  }
  ModeRun run(*code_);
  for (std::size_t first = 0; first < points.count; first += lane_count) {
    stop_if_asked();
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const std::size_t point = std::min(first + lane, points.count - 1);
      for (std::size_t i = 0; i < columns.parameters.size(); ++i) {
        run.set(i, lane, given_[i] ? columns.parameters[i][point] : 0);
      }
      for (std::size_t i = 0; i < columns.tan_halves.size(); ++i) run.set_angle(i, lane, columns.tan_halves[i][point]);
      run.set(code_->programs().load(), lane, points.has_load() ? columns.load[point] : 0);
    }
    run.decide();
    for (std::size_t point = first; point < std::min<std::size_t>(points.count, first + lane_count); ++point) {
      const std::size_t lane = point - first;
      bool sure = true;
      for (std::size_t mode = 0; mode < modes_.size() && sure; ++mode) {
        const LaneModes& found = run.modes()[mode];
        ModeAt& status = answers.status[point * modes_.size() + mode];
        status = found.strict[lane] != 0     ? ModeAt::strict
                 : found.boundary[lane] != 0 ? ModeAt::boundary
                                             : ModeAt::inconsistent;
        sure = status != ModeAt::inconsistent || found.inconsistent[lane] != 0;
      }
      if (sure) {
        ++answers.tiers[static_cast<std::size_t>(Tier::filter)];
      } else {
        pass_on(points, point, unsure, answers);
      }
    }
  }
  return answers;
}

void MechanismBatch::pass_on(const Points& points, std::size_t point, Unsure unsure, MechanismAnswers& answers) const {
  const auto status = answers.status.begin() + static_cast<std::ptrdiff_t>(point * modes_.size());
  if (unsure == Unsure::left) {
    std::fill(status, status + static_cast<std::ptrdiff_t>(modes_.size()), ModeAt::unsure);
    return;
  }
  MechanismValues values = default_values(*mechanism_);
  values.starts = starts_;
  values.given = given_;
  for (std::size_t i = 0; i < values.parameters.size(); ++i) {
    if (given_[i]) values.parameters[i] = to_rational(points.columns.parameters[i][point]);
  }
  for (std::size_t i = 0; i < values.angles.size(); ++i) {
    values.angles[i] = point_of_tan_half(to_rational(points.columns.tan_halves[i][point]));
  }
  std::optional<Rational> load;
  if (points.has_load()) load = to_rational(points.columns.load[point]);
  std::fill(status, status + static_cast<std::ptrdiff_t>(modes_.size()), ModeAt::inconsistent);
  const FrictionProblem problem = without_equations(maker_.problem(values));
  for (const ConsistentMode& found : ModeSolver(problem, load).consistent()) {
    const auto place = std::find(modes_.begin(), modes_.end(), found.mode) - modes_.begin();
    status[place] = found.solutions.strict ? ModeAt::strict : ModeAt::boundary;
  }
  ++answers.tiers[static_cast<std::size_t>(Tier::exact)];
}

}  // namespace slipproof
