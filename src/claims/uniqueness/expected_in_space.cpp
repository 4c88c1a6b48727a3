#include "claims/uniqueness/expected_in_space.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/input/diagnostic.hpp"
#include "base/number/format.hpp"
#include "contact/rest/rest.hpp"
#include "contact/space/solve_space.hpp"
#include "contact/space/space_plane.hpp"
#include "mechanics/planes/sets_along.hpp"

namespace slipproof {

namespace {

/// Nothing of a scene that moves, or of which rest is no question.
std::optional<RestAnswer> rest_of(const MechanismScene& scene) {
  RestQuestions questions;
  const auto& threshold = scene.threshold;
  const bool along_load = threshold && scene.mechanism.load && scene.mechanism.load->symbol == threshold->parameter;
  if (threshold && !along_load) questions.parameter = threshold->parameter;
  try {
    return find_rest(scene, questions);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// The proved ends of rest along the threshold.
std::vector<ProvedEnd> ends_of(const std::optional<RestAnswer>& rest) {
  std::vector<ProvedEnd> ends;
  if (!rest) return ends;
  const auto add = [&](const std::optional<ProvedEnd>& end) {
    if (end) ends.push_back(*end);
  };
  if (rest->parameter) {
    add(rest->parameter->from), add(rest->parameter->to);
  } else if (rest->loads) {
    add(rest->loads->from), add(rest->loads->to);
  }
  return ends;
}

class ThresholdInSpace {
 public:
  ThresholdInSpace(const MechanismScene& scene, std::string id, std::vector<ProvedEnd> ends)
      : scene_(scene), id_(std::move(id)), ends_(std::move(ends)) {}

  std::vector<ChangeInSpace> changes() const {
    std::vector<ChangeInSpace> result;
    const std::vector<Place> places = coarse();
    for (std::size_t i = 1; i < places.size(); ++i) {
      const Place &left = places[i - 1], &right = places[i];
      if (left.set == right.set) continue;
      const auto end = std::ranges::find_if(
          ends_, [&](const ProvedEnd& one) { return left.x <= one.lower && one.upper <= right.x; });
      if (end != ends_.end()) {
        result.push_back({end->lower, end->upper, *left.set, *right.set});
        continue;
      }
      for (const ChangeInSpace& wide : between(left.x, right.x)) {
        std::ranges::move(between(wide.lower, wide.upper), std::back_inserter(result));
      }
    }
    return result;
  }

 private:
  using Place = SetsAlong::Place;

  /// Evenly spaced values at which all motions are found, which at a threshold itself may be too hard.
  std::vector<Place> coarse() const {
    constexpr int parts = 8;
    const SceneThreshold& along = *scene_.threshold;
    std::vector<Place> places;
    for (int i = 0; i <= parts; ++i) {
      const Rational x = along.from + (along.to - along.from) * Rational(i, parts);
      MotionSet set = at(x);
      if (set.complete) places.push_back({x, std::move(set)});
    }
    return places;
  }

  /// To a 1024th of the way.
  std::vector<ChangeInSpace> between(const Rational& from, const Rational& to) const {
    const auto solve = [&](const Rational& x) -> std::optional<MotionSet> {
      MotionSet set = at(x);
      if (!set.complete) refuse("not all motions were found at " + exact_text(x));
      return set;
    };
    const SetsAlong along = sets_along({scene_.threshold->parameter, from, to}, 1, solve, {});
    std::vector<ChangeInSpace> result;
    const auto runs = along.runs();
    for (std::size_t r = 1; r < runs.size(); ++r) {
      const auto &below = along.places[runs[r - 1].second], &above = along.places[runs[r].first];
      result.push_back({below.x, above.x, *below.set, *above.set});
    }
    return result;
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError({{scene_.mechanism.file, 0, 0, id_ + ": [threshold]: " + why}});
  }

  MotionSet at(const Rational& x) const {
    CompleteOptions options;
    options.effort = effort_of_a_place;
    try {
      return motion_set(solve_space(with_values(scene_, {{scene_.threshold->parameter, x}}), options));
    } catch (const std::invalid_argument& error) {
      refuse(error.what());
    }
  }

  const MechanismScene& scene_;
  const std::string id_;
  const std::vector<ProvedEnd> ends_;
};

}  // namespace

ExpectedInSpace expected_in_space(MechanismScene scene, const std::string& id) {
  ExpectedInSpace result{id, {}, std::nullopt, std::nullopt, {}};
  const std::optional<RestAnswer> rest = rest_of(scene);
  if (rest) result.can_rest = rest->decision.can, result.must_rest = rest->must.must;
  if (scene.threshold) result.changes = ThresholdInSpace(scene, id, ends_of(rest)).changes();
  // Whether it must rest is found by all motions: these are not sought again.
  const bool known = rest && rest->must.space && rest->must.space->complete();
  result.solved = known ? *rest->must.space : solve_space(std::move(scene));
  return result;
}

}  // namespace slipproof
