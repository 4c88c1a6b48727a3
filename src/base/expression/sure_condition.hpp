// A condition in straight-line code over binary64 with bounds, for points that come by the thousand and mostly differ
// in one coordinate: what does not depend on that one keeps its value.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "base/expression/evaluate.hpp"
#include "base/rounding/approximate.hpp"

namespace slipproof {

/// A condition evaluated with error bounds, incrementally. Not for use by several threads.
class SureCondition {
 public:
  /// `coordinates` is the number of coordinates of the point; their slots begin at `first`.
  SureCondition(const Scope& scope, const Program& condition, std::size_t first, std::size_t coordinates);

  /// Call one of these before the next truth(): all coordinates have changed, or one.
  void all_changed() { stale_ = coordinates_; }
  void changed(std::size_t coordinate) {
    if (stale_ == coordinate || behind_[coordinate].empty()) return;
    stale_ = stale_ == nothing() ? coordinate : coordinates_;
  }

  /// Returns yes or no if the error bounds prove it; undecided otherwise, and where an expression has no value.
  Truth truth(const std::vector<Approximate>& point) {
    if (stale_ != nothing()) run(point);
    return results_.back().truth;
  }
  /// The only value of a coordinate for which the condition can hold, if one of its equations gives this value without
  /// using the coordinate; otherwise null. Refers to the point of the last call of truth().
  const Approximate* demanded(std::size_t coordinate) const {
    return demands_[coordinate] ? &results_[*demands_[coordinate]].number : nullptr;
  }

 private:
  struct Step {
    Operation operation;
    Relation relation;
    int exponent;
    std::uint32_t first, second;  ///< other steps, or a coordinate
  };
  struct Result {
    Approximate number{0, std::numeric_limits<double>::infinity()};  ///< infinite error: nothing known
    Truth truth = Truth::undecided;
  };
  class Writer;

  void note_demands(std::uint32_t i);
  std::size_t nothing() const { return coordinates_ + 1; }
  void run(const std::vector<Approximate>& point);
  Approximate number(const Step& step) const;
  Truth truth(const Step& step) const;

  std::size_t coordinates_;
  std::vector<Step> steps_;
  std::vector<Result> results_;  ///< by step
  /// The steps to repeat, by changed coordinate; last, those for several.
  std::vector<std::vector<std::uint32_t>> behind_;
  std::size_t stale_;                                  ///< its place there, or nothing()
  std::vector<std::optional<std::uint32_t>> demands_;  ///< by coordinate, the step whose value it must equal
};

}  // namespace slipproof
