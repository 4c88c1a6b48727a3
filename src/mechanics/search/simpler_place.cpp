#include "mechanics/search/simpler_place.hpp"

#include <algorithm>
#include <utility>

#include "mechanics/points/degrees.hpp"

namespace slipproof {

Complexity complexity(const SearchPlace& place) {
  std::vector<Rational> values;
  for (std::size_t i = 0; i < place.values.parameters.size(); ++i) {
    if (place.values.given[i]) values.push_back(place.values.parameters[i]);
  }
  for (const MechanismValues::Circle& angle : place.values.angles) {
    values.push_back(angle.cosine);
    values.push_back(angle.sine);
  }
  if (place.load) values.push_back(*place.load);
  return complexity(values);
}

std::vector<FoundOverLoads> MotionFinder::at(const MechanismValues& values) const {
  if (in_space_) return {{in_space_(*mechanism_, values), ForceInterval()}};
  const FrictionProblem problem = maker_.problem(values);
  if (problem.has_load && problem.load_domain.empty()) return {};
  std::vector<std::size_t> not_modelled;
  for (std::size_t i = 0; i < mechanism_->contacts.size(); ++i) {
    if (!missing_for_lift(mechanism_->contacts[i], values.given).empty()) not_modelled.push_back(i);
  }
  if (!mechanism_->impact) return found_over_loads(without_equations(problem), not_modelled, hysteresis_apart_);
  const ImpactEnergy energy(*mechanism_, maker_, values, std::nullopt);
  return {{found_outcomes(without_equations(problem), not_modelled, energy), ForceInterval()}};
}

std::optional<SearchPlace> MotionFinder::place_of(const FoundMotions& wanted, const std::vector<FoundOverLoads>& all,
                                                  const MechanismValues& values) const {
  std::optional<SearchPlace> best;
  for (const FoundOverLoads& one : all) {
    if (one.found != wanted) continue;
    SearchPlace place{values, mechanism_->load ? std::optional(one.loads.sample()) : std::nullopt};
    if (!best || complexity(place) < complexity(*best)) best = std::move(place);
  }
  return best;
}

namespace {

/// The way to a simpler place.
class Descent {
 public:
  Descent(SearchPlace place, const FoundMotions& wanted, const MotionFinder& finder, const DomainSampler& domain,
          std::size_t budget)
      : place_(std::move(place)), wanted_(wanted), finder_(finder), domain_(domain), budget_(budget) {}

  /// The smallest numbers first, wherever they do: a few tries bring the most.
  SearchPlace run() {
    for (const int height : {1, tallest}) {
      for (bool improved = true; improved && budget_ > 0;) {
        improved = false;
        for (const std::size_t i : tall_first()) improved = parameter(i, height) || improved;
        for (std::size_t i = 0; i < place_.values.angles.size(); ++i) improved = angle(i, height) || improved;
      }
    }
    return std::move(place_);
  }

 private:
  static constexpr int tallest = 3;  ///< of numbers that are tried in any case

  std::vector<std::size_t> tall_first() const {
    const auto& values = place_.values;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < values.parameters.size(); ++i) {
      if (values.given[i]) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
      return height(values.parameters[x]) > height(values.parameters[y]);
    });
    return order;
  }

  static std::vector<Rational> candidates(const Rational& value, int height) {
    return height < tallest ? numbers_up_to(height) : simpler_numbers(value, height);
  }

  bool parameter(std::size_t index, int height) {
    const Rational here = place_.values.parameters[index];
    for (const Rational& candidate : candidates(here, height)) {
      if (candidate == here) continue;
      MechanismValues values = place_.values;
      values.parameters[index] = candidate;
      if (try_out(values)) return true;
      const MechanismValues alike = with_equal_ones(here, candidate);
      if (alike.parameters != values.parameters && try_out(alike)) return true;
      MechanismValues restored = values;
      domain_.restore(restored, index);
      if (restored.parameters != values.parameters && try_out(restored)) return true;
    }
    return false;
  }

  /// What is thin holds because values are equal, or cancel.
  MechanismValues with_equal_ones(const Rational& here, const Rational& candidate) const {
    MechanismValues values = place_.values;
    for (std::size_t i = 0; i < values.parameters.size(); ++i) {
      Rational& value = values.parameters[i];
      if (!values.given[i]) continue;
      if (value == here) {
        value = candidate;
      } else if (value == Rational(-here)) {
        value = -candidate;
      }
    }
    return values;
  }

  bool angle(std::size_t index, int height) {
    const MechanismValues::Circle& here = place_.values.angles[index];
    if (here.cosine == -1) return false;
    for (const Rational& candidate : candidates(Rational(here.sine / (1 + here.cosine)), height)) {
      MechanismValues values = place_.values;
      values.angles[index] = point_of_tan_half(candidate);
      if (try_out(values)) return true;
    }
    return false;
  }

  /// Takes the values if they are simpler and the same motions are found there.
  bool try_out(const MechanismValues& values) {
    const Complexity now = complexity(place_);
    const SearchPlace bare{values, place_.load ? std::optional(Rational(1)) : std::nullopt};
    if (budget_ == 0 || !(complexity(bare) < now) || !domain_.contains(values)) return false;
    --budget_;
    try {
      auto found = finder_.place_of(wanted_, finder_.at(values), values);
      if (!found || !(complexity(*found) < now)) return false;
      place_ = std::move(*found);
      return true;
    } catch (const NoValue&) {
      return false;
    }
  }

  SearchPlace place_;
  const FoundMotions& wanted_;
  const MotionFinder& finder_;
  const DomainSampler& domain_;
  std::size_t budget_;
};

}  // namespace

SearchPlace simpler(SearchPlace place, const FoundMotions& wanted, const MotionFinder& finder,
                    const DomainSampler& domain, std::size_t budget) {
  return Descent(std::move(place), wanted, finder, domain, budget).run();
}

}  // namespace slipproof
