// A mode as a function of the load, for the computation of cells: its accelerations and forces, exact and approximate.
// The approximation usually suffices to distinguish two motions.
#pragma once

#include <optional>
#include <vector>

#include "base/rounding/approximate.hpp"
#include "mechanics/kernel/mode_solver.hpp"

namespace slipproof {

using OverLoads = std::vector<Affine<Rational>>;
using ForcesOverLoads = std::vector<std::optional<Affine<Rational>>>;

/// The same at one load.
OverLoads at(const OverLoads& values, const Rational& load);
ForcesOverLoads at(const ForcesOverLoads& values, const Rational& load);

/// A space in which at most the load is free, in integers: a value on it takes one greatest common divisor.
class IntegerSpace {
 public:
  explicit IntegerSpace(const AffineSpace& space);
  Affine<Rational> on(const AffineForm& form) const;

 private:
  Integer denominator_;
  std::vector<Integer> values_;  ///< constant and slope of each unknown, times the denominator
};

/// Forms in binary64, coefficient by coefficient and then the constant.
using NearForms = std::vector<std::vector<Approximate>>;

NearForms near(const std::vector<AffineForm>& forms);

/// A mode of a problem, both of which must outlive it. Computes its numbers on demand. Not shared between threads.
class ModeOfCells {
 public:
  /// `accelerations` are the problem's, near(), or left out.
  ModeOfCells(const FrictionProblem& problem, const ConsistentMode& mode, const NearForms& accelerations = {});

  /// The accelerations with their errors; none where they were left out or the mode is not regular.
  const std::vector<Affine<Approximate>>& near() const { return near_; }

  const ConsistentMode& found() const { return *found_; }
  /// Whether its equations leave one solution for each load.
  bool regular() const { return space().dimension() == 0 && space().load_is_free(); }
  /// An acceleration of a determined mode.
  const Affine<Rational>& acceleration(std::size_t i) const;
  OverLoads accelerations() const;
  ForcesOverLoads forces() const;
  std::vector<Rational> accelerations_at(const Rational& load) const;

 private:
  const AffineSpace& space() const { return found_->solutions.space; }
  std::optional<Affine<Rational>> exact(const AffineForm& form) const;

  const FrictionProblem* problem_;
  const ConsistentMode* found_;
  mutable std::vector<std::optional<Affine<Rational>>> accelerations_;
  mutable std::optional<IntegerSpace> integers_;
  std::vector<Affine<Approximate>> near_;
};

/// Whether two motions surely differ: at a load, or as functions of it.
bool surely_differ(const ModeOfCells& x, const ModeOfCells& y, const std::optional<Rational>& load);

/// The load at which the first `accelerations` accelerations of two motions agree; nothing unless it is exactly one
/// load.
std::optional<Rational> crossing(const ModeOfCells& x, const ModeOfCells& y, std::size_t accelerations);

}  // namespace slipproof
