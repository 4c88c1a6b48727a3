#include "contact/path/follow.hpp"

#include <Eigen/LU>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel/stop.hpp"
#include "contact/linear/rounding.hpp"
#include "contact/path/long_number.hpp"
#include "contact/path/point.hpp"

namespace slipproof {

namespace {

constexpr double converged = 1e-20;  ///< steps of Newton's method, in the measure of PathPoint::size_of
constexpr double accepted = 1e-6;    ///< the same where rounding stops it before: along what hardly determines x
constexpr double largest_step = 0.5, least_step = 1e-15;
constexpr double least_t = 0x1p-60;  ///< what is left is beyond the digits of the equations

/// The factors of a derivative, of which mostly few entries are not 0 where bodies are unknowns.
class LongFactors {
 public:
  /// Throws TooMuchWork.
  void compute(const LongMatrix& J, Effort& effort) {
    const Eigen::Index n = J.rows();
    const auto size = static_cast<Work>(n);
    std::vector<Eigen::Triplet<DoubleDouble>> entries;
    for (Eigen::Index j = 0; j < n; ++j) {
      for (Eigen::Index i = 0; i < n; ++i) {
        if (J(i, j).high != 0) entries.emplace_back(i, j, J(i, j));
      }
    }
    is_sparse_ = 10 * entries.size() <= size * size;
    effort.spend(is_sparse_ ? times(size, size) : times(size * size, size));
    if (!is_sparse_) {
      dense_.compute(J);
      return;
    }
    Eigen::SparseMatrix<DoubleDouble> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    sparse_.compute(matrix);
    is_regular_ = sparse_.info() == Eigen::Success;
    if (!is_regular_) return;
    effort.spend(4 * times(static_cast<Work>(sparse_.nnzL()), static_cast<Work>(sparse_.nnzU())) / size);
  }

  bool is_regular() const { return !is_sparse_ || is_regular_; }
  LongVector solve(const LongVector& right) const {
    return is_sparse_ ? LongVector(sparse_.solve(right)) : LongVector(dense_.solve(right));
  }

 private:
  bool is_sparse_ = false, is_regular_ = false;
  Eigen::PartialPivLU<LongMatrix> dense_;
  Eigen::SparseLU<Eigen::SparseMatrix<DoubleDouble>> sparse_;
};

class PathWalk {
 public:
  PathWalk(PathPoint point, Effort& effort) : point_(std::move(point)), effort_(effort) {}

  /// Whether it comes to t = 0.
  bool run() {
    LongVector border = -point_.gradient({});  // t falls
    double length = 0.05;
    while (true) {
      stop_if_asked();
      if (!prepare(border)) return false;
      const std::optional<Margin> met = step(length);
      if (!moved_) return false;
      if (point_.t().high < least_t) return ends_well();
      if (met && !land(*met)) return false;
      border = met ? point_.gradient(point_.pass(*met)) : tangent_;
      if (!(point_.t().high < 4)) return false;
    }
  }

  /// At t = 0 no margin is negative. Where equations are exactly dependent there, that is left to the enclosure.
  bool ends_well() {
    const PathPoint before = point_;
    if (land({}) && point_.t().high < least_t) return within(point_.margins(), nullptr);
    point_ = before;
    return true;
  }

  const PathPoint& point() const { return point_; }

 private:
  /// Factors the derivative, bordered by a row along which the path goes up, and finds its direction.
  bool prepare(const LongVector& border) {
    const Eigen::Index n = point_.unknowns() + 1;
    LongMatrix J = LongMatrix::Zero(n, n);
    point_.equations(&J);
    J.row(n - 1) = border.transpose();
    scale_.assign(static_cast<std::size_t>(n), 1);
    for (Eigen::Index i = 0; i < n; ++i) {
      double largest = 0;
      for (Eigen::Index j = 0; j < n; ++j) largest = std::max(largest, std::abs(J(i, j).high));
      if (!(largest > 0) || !std::isfinite(largest)) return false;
      const double s = std::ldexp(1.0, exponent_to_one(largest));
      scale_[static_cast<std::size_t>(i)] = s;
      for (Eigen::Index j = 0; j < n; ++j) J(i, j) = {J(i, j).high * s, J(i, j).low * s};
    }
    factors_.compute(J, effort_);
    if (!factors_.is_regular()) return false;
    LongVector up = LongVector::Zero(n);
    up[n - 1] = 1;
    tangent_ = solve(std::move(up));
    const double size = point_.size_of(tangent_);
    if (!(size > 0) || !std::isfinite(size)) return false;
    tangent_ /= DoubleDouble(size);
    return true;
  }

  LongVector solve(LongVector right) const {
    for (Eigen::Index i = 0; i < right.size(); ++i) right[i] *= scale_[static_cast<std::size_t>(i)];
    return factors_.solve(right);
  }

  /// One step along the tangent and back to the path, to the first margin if that is near. Returns that margin.
  std::optional<Margin> step(double& length) {
    const PathPoint start = point_;
    const std::vector<Margin> margins = point_.margins();
    double nearest = std::numeric_limits<double>::infinity();
    Margin first;
    for (const Margin& m : margins) {
      const double slope = point_.gradient(m).dot(tangent_).high;
      const double until = slope < 0 ? std::max(0.0, point_.value(m).high / -slope) : nearest;
      if (until < nearest) {
        nearest = until;
        first = m;
      }
    }
    moved_ = true;
    for (double tried = length; tried > least_step; tried = std::min(tried, nearest) / 2) {
      const bool meets = nearest <= tried;
      if (advance(std::min(tried, nearest), meets ? &first : nullptr) && within(margins, meets ? &first : nullptr)) {
        length = tried == length ? std::min(2 * length, largest_step) : tried;
        return meets ? std::optional(first) : std::nullopt;
      }
      point_ = start;
    }
    moved_ = false;
    return std::nullopt;
  }

  /// Newton's method with the factors at hand, on the path: across the border's direction, or to where `margin` is 0.
  bool advance(double length, const Margin* margin) {
    point_.move(tangent_ * DoubleDouble(length));
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 25; ++i) {
      const LongVector d = correction(margin);
      const double size = point_.size_of(d);
      if (!std::isfinite(size) || (i > 0 && !(size < 0.7 * last))) return i > 0 && last < accepted;
      point_.move(d);
      if (size < converged) return true;
      last = size;
    }
    return last < accepted;
  }

  /// Onto the margin to the last digit, with factors of this place: what is left of it would be multiplied by the
  /// condition of the next mode's equations.
  bool land(const Margin& margin) {
    if (!prepare(point_.gradient(margin))) return false;
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 6; ++i) {
      const LongVector d = correction(&margin);
      const double size = point_.size_of(d);
      if (!std::isfinite(size)) return false;
      if (i > 2 && !(size < 0.7 * last)) break;
      point_.move(d);
      if (size < converged) return true;
      last = size;
    }
    return last < accepted;
  }

  LongVector correction(const Margin* margin) const {
    LongVector F = point_.equations();
    F[F.size() - 1] = 0;
    LongVector d = -solve(std::move(F));
    if (margin == nullptr) return d;
    const LongVector g = point_.gradient(*margin);
    d += tangent_ * ((-point_.value(*margin) - g.dot(d)) / g.dot(tangent_));
    return d;
  }

  bool within(const std::vector<Margin>& margins, const Margin* met) const {
    return std::all_of(margins.begin(), margins.end(), [&](const Margin& m) {
      return (met != nullptr && m == *met) || point_.value(m).high >= -1e-13 * point_.scale(m);
    });
  }

  PathPoint point_;
  Effort& effort_;
  LongFactors factors_;
  std::vector<double> scale_;  ///< of the rows of the derivative
  LongVector tangent_;
  bool moved_ = false;
};

}  // namespace

std::optional<PathEnd> follow_path(const MixedProblem& problem, std::span<const double> x, Effort& effort) {
  constexpr unsigned attempts = 8;
  for (unsigned attempt = 0; attempt < attempts; ++attempt) {
    PathWalk walk(PathPoint(problem, x, attempt), effort);
    if (!walk.run()) continue;
    PathEnd end{walk.point().mode(), {}, {}};
    for (const DoubleDouble& value : walk.point().x()) end.x.push_back(exact_number(value));
    for (std::size_t k = 0; k < problem.contacts(); ++k) {
      const bool slides = end.mode[k] == ConeState::slide;
      const DoubleDouble& N = walk.point().x()[problem.normal(k)];
      end.slip.push_back(slides ? exact_number(walk.point().slip(k) / (DoubleDouble(problem.mu[k]) * N)) : Rational(0));
    }
    return end;
  }
  return std::nullopt;
}

}  // namespace slipproof
