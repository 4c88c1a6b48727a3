#include "floating/tape/mechanism_batch.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "base/number/binary64.hpp"
#include "base/parallel/stop.hpp"
#include "floating/tape/block_points.hpp"
#include "floating/tape/lane_points.hpp"
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

namespace {

constexpr std::size_t chunk_points = 256;

}  // namespace

MechanismAnswers MechanismBatch::modes_at(const MechanismColumns& columns, Unsure unsure) const {
  const Points points(*this, columns);
  MechanismAnswers answers{modes_.size(), std::vector<ModeAt>(points.count * modes_.size()), {}};
  if (code_ == nullptr) {
    for (std::size_t i = 0; i < points.count; ++i) pass_on(points, i, unsure, answers);
    return answers;
  }
  const auto see = [&](std::size_t point, std::size_t mode, ModeAt status) {
    answers.status[point * modes_.size() + mode] = status;
  };
  LanePoints lanes(*code_, columns, given_);
  std::optional<BlockPoints> blocks;
  if (points.count >= block_points) blocks.emplace(code_->programs(), columns, given_);
  std::vector<std::size_t> left;
  for (std::size_t begin = 0; begin < points.count; begin += chunk_points) {
    stop_if_asked();
    const std::size_t end = std::min(points.count, begin + chunk_points);
    left.clear();
    if (blocks) {
      blocks->decide(begin, end, see, left);
    } else {
      for (std::size_t point = begin; point < end; ++point) left.push_back(point);
    }
    answers.tiers[static_cast<std::size_t>(Tier::filter)] += end - begin - left.size();
    for (std::size_t i = 0; i < left.size(); i += lane_count) {
      const auto some = std::span(left).subspan(i, std::min<std::size_t>(lane_count, left.size() - i));
      lanes.decide(some, see);
      for (const std::size_t point : some) {
        const auto status = answers.status.begin() + static_cast<std::ptrdiff_t>(point * modes_.size());
        if (std::find(status, status + static_cast<std::ptrdiff_t>(modes_.size()), ModeAt::unsure) ==
            status + static_cast<std::ptrdiff_t>(modes_.size())) {
          ++answers.tiers[static_cast<std::size_t>(Tier::filter)];
        } else {
          pass_on(points, point, unsure, answers);
        }
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
