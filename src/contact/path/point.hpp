// A point on a path of solutions, through problems that lead from one near the answer to the given one
// (contact/MATHEMATICS.md).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "contact/enclosure/mode_system.hpp"
#include "contact/linear/double_double.hpp"

namespace slipproof {

using LongVector = Eigen::Matrix<DoubleDouble, Eigen::Dynamic, 1>;
using LongMatrix = Eigen::Matrix<DoubleDouble, Eigen::Dynamic, Eigen::Dynamic>;

/// A condition of the mode of a point: a quantity that must not be negative.
struct Margin {
  enum class Kind : std::uint8_t {
    end,    ///< t, of the path
    gap,    ///< u_N of an open contact
    force,  ///< r_N of a closed one
    cone,   ///< mu r_N - |r_T| of one that sticks
    slip    ///< |u_T| of one that slides, in its direction
  };
  Kind kind = Kind::end;
  std::size_t contact = 0;
  bool operator==(const Margin&) const = default;
};

/// A solution (x, w) of Coulomb's law with
///   w = A x + c + t (a (x - x0) + p),
/// where p is such that it is x0 for t = 1, and a > 0 in the rows of contacts is small beside A and large beside what
/// rounding changed in it. Its unknowns are steps: of free unknowns and forces, of the angle of u_T and of |u_T| where
/// a contact slides in space, and last of t. The problem must outlive it.
class PathPoint {
 public:
  /// Starts at t = 1, at the point nearest to `x` that satisfies the law (residual.hpp), in the interior of its mode.
  /// Each `attempt` uses another a.
  PathPoint(const MixedProblem& problem, std::span<const double> x, unsigned attempt);

  /// The number of unknowns apart from t, and of equations.
  Eigen::Index unknowns() const { return unknowns_; }
  /// The residuals of the equations. If `derivative` is given, sets its rows, with a column for t; leaves its last row
  /// unchanged.
  LongVector equations(LongMatrix* derivative = nullptr) const;
  void move(const LongVector& step);
  /// The largest of the step's forces, over the largest of x0, of its angles and its part in t.
  double size_of(const LongVector& step) const;

  std::vector<Margin> margins() const;
  DoubleDouble value(const Margin& margin) const;
  LongVector gradient(const Margin& margin) const;
  /// The natural size of the quantity of a margin, for comparison with its value.
  double scale(const Margin& margin) const;
  /// Switches to the mode beyond a margin that is 0. Returns the margin of the new mode that is 0 at this point.
  Margin pass(const Margin& margin);

  const DoubleDouble& t() const { return t_; }
  const std::vector<DoubleDouble>& x() const { return x_; }
  const ConeMode& mode() const { return mode_; }
  /// |u_T| of a contact that slides in space.
  const DoubleDouble& slip(std::size_t contact) const { return slip_[contact]; }

 private:
  using enum ConeState;

  bool has_friction(std::size_t contact) const { return problem_->dimension > 1 && problem_->mu[contact] > 0; }
  void number_unknowns();
  void set_tangential_force(std::size_t contact);
  DoubleDouble slope(std::size_t row) const;
  DoubleDouble row(std::size_t i) const;
  LongVector row_gradient(std::size_t i) const;
  void spread(LongVector& row, std::size_t component, const DoubleDouble& a) const;
  DoubleDouble tangential_force(std::size_t contact) const;

  const MixedProblem* problem_;  ///< a pointer, so that points can be assigned
  double force_ = 1;             ///< the largest of x0
  DoubleDouble t_ = 0;
  std::vector<DoubleDouble> x_, x0_, p_;
  std::vector<double> a_;
  ConeMode mode_;
  std::vector<DoubleDouble> slip_;                      ///< |u_T|, where a contact slides in space
  std::vector<std::array<DoubleDouble, 2>> direction_;  ///< of u_T, there
  std::vector<Eigen::Index> first_;                     ///< the first unknown of a closed contact
  Eigen::Index unknowns_ = 0;
};

}  // namespace slipproof
