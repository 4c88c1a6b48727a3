#include "contact/ranges/open_forces.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/number/binary64.hpp"
#include "contact/enclosure/sizes.hpp"
#include "contact/problem/parts.hpp"
#include "contact/ranges/cone_program.hpp"
#include "contact/ranges/force_set.hpp"
#include "contact/ranges/reduced_forces.hpp"

namespace slipproof {

namespace {

using Dense = Eigen::MatrixXd;
using DenseVector = Eigen::VectorXd;
using Index = Eigen::Index;

/// Of their sizes, around the answer: where free unknowns may be.
constexpr double free_box = 1e6;

/// One part of a problem, with an answer.
class OpenPart {
 public:
  OpenPart(const MixedProblem& problem, std::vector<double> x, ForceScales scales, double change, Effort& effort)
      : problem_(problem),
        x_(std::move(x)),
        scales_(std::move(scales)),
        effort_(effort),
        sets_(force_sets(problem, exact_rows(problem, x_), change)),
        reduced_(problem, sets_, scales_) {
    const auto rows = static_cast<Work>(problem.size()), columns = static_cast<Work>(reduced_.size());
    if (reduced_.size() == 0) return;  // with these velocities no contact has a force: nothing is open
    effort_.spend(times(4 * rows, times(columns, columns)));
    const Dense B(reduced_.derivative(problem, scales_));
    const double pivot = B.colwise().norm().maxCoeff();
    if (pivot > 0) decomposition_.setThreshold(std::min(1 / pivot, 0.5));  // what is below 1 is open
    decomposition_.compute(B);
    N_ = decomposition_.colsPermutation() *
         Dense(decomposition_.matrixZ().adjoint()).rightCols(reduced_.size() - decomposition_.rank());
    transposed_.A = transposed(problem.A);
    transposed_.c.assign(problem.size(), 0);
    program_.emplace(N_, reduced_.of(x_), reduced_.cones());
  }

  std::size_t directions() const { return static_cast<std::size_t>(N_.cols()); }

  /// Whether forces along the open directions change a contact's normal force.
  bool is_open(std::size_t contact) const {
    const Index j = reduced_.normal(contact);
    return j >= 0 && N_.row(j).norm() > 1e-9;
  }

  /// Bounds the sum of all normal forces first: it pays for what multipliers lack.
  void bound_sum() {
    DenseVector all = DenseVector::Zero(reduced_.size());
    for (std::size_t k = 0; k < sets_.size(); ++k) {
      if (reduced_.normal(k) >= 0) all[reduced_.normal(k)] = 1;
    }
    const auto bound = bound_of(all);
    if (bound && bound->lack < 1) sum_ = bound->value / (1 - bound->lack);
  }

  /// The normal force of one contact.
  NormalRange range(std::size_t contact) {
    DenseVector g = DenseVector::Zero(reduced_.size());
    g[reduced_.normal(contact)] = 1;
    NormalRange result{contact, 0, std::nullopt};
    if (const auto most = upper(g)) result.most = enclose(std::max(*most, Rational(0))).upper;
    if (const auto least = upper(-g)) result.least = std::max(0.0, -enclose(*least).upper);
    return result;
  }

 private:
  /// g . x <= value + lack * (sum of normal forces)
  struct Bound {
    Rational value, lack;
  };

  std::optional<Rational> upper(const DenseVector& g) {
    const auto bound = bound_of(g);
    if (!bound) return std::nullopt;
    if (bound->lack.is_zero()) return bound->value;
    if (!sum_) return std::nullopt;
    return bound->value + bound->lack * *sum_;
  }

  std::optional<Bound> bound_of(const DenseVector& g) {
    const auto multipliers = program_->multipliers(g, effort_);
    if (!multipliers) return std::nullopt;
    const DenseVector y = decomposition_.transpose().solve(g + *multipliers);
    if (!y.allFinite()) return std::nullopt;
    return verified(g, y);
  }

  /// g . x = g . x0 + y . A (x - x0) - z . (x - x0) with z = A^T y - g, all without rounding (contact/MATHEMATICS.md,
  /// (R1)).
  Bound verified(const DenseVector& g, const DenseVector& y) const {
    std::vector<double> multipliers;
    Bound bound;
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const double own = y[static_cast<Index>(i)] * scales_.force / scales_.change[i];
      multipliers.push_back(own);
      bound.value += abs(to_rational(own)) * to_rational(scales_.change[i]);
    }
    std::vector<Rational> z = exact_rows(transposed_, multipliers);
    for (std::size_t k = 0; k < sets_.size(); ++k) {
      if (reduced_.normal(k) < 0) continue;
      const Rational own = to_rational(g[reduced_.normal(k)]);
      z[problem_.normal(k)] -= own;
      bound.value += own * to_rational(x_[problem_.normal(k)]);
    }
    for (std::size_t j = 0; j < z.size(); ++j) bound.value += z[j] * to_rational(x_[j]);
    for (std::size_t j = 0; j < problem_.free; ++j)
      bound.value += abs(z[j]) * to_rational(free_box * scales_.unknown[j]);
    for (std::size_t k = 0; k < sets_.size(); ++k) {
      bound.lack = std::max(bound.lack, sets_[k].lack(std::span(z).subspan(problem_.normal(k), problem_.dimension)));
    }
    return bound;
  }

  const MixedProblem& problem_;
  std::vector<double> x_;
  ForceScales scales_;
  Effort& effort_;
  std::vector<ForceSet> sets_;
  ReducedForces reduced_;
  Eigen::CompleteOrthogonalDecomposition<Dense> decomposition_;
  Dense N_;
  MixedProblem transposed_;
  std::optional<ConeProgram> program_;
  std::optional<Rational> sum_;
};

double width(const NormalRange& range) {
  return range.most ? *range.most - range.least : std::numeric_limits<double>::infinity();
}

}  // namespace

std::optional<OpenForces> open_forces(const MixedProblem& problem, std::span<const double> x, double tolerance,
                                      Effort& effort) {
  OpenForces result;
  result.change = tolerance * contact_sizes(problem).velocity;
  const ForceScales scales = force_scales(problem, x, tolerance);
  const bool known = problem.is_coulomb() || problem.law.kind == FrictionLaw::associated;
  if (!known || !(result.change > 0) || !(scales.force > 0)) return std::nullopt;
  for (const ContactPart& part : parts_of(problem)) {
    const std::vector<std::size_t> rows = rows_of(problem, part);
    if (part.contacts.empty() || rows.size() > largest_open_part) continue;
    try {
      const MixedProblem own = part_of(problem, part, rows);
      OpenPart open(own, components(x, rows), scales.of_rows(rows), result.change, effort);
      result.directions += open.directions();
      if (open.directions() > 0) open.bound_sum();
      for (std::size_t k = 0; k < part.contacts.size(); ++k) {
        if (!open.is_open(k)) continue;
        NormalRange range = open.range(k);
        range.contact = part.contacts[k];
        result.ranges.push_back(range);
      }
    } catch (const TooMuchWork&) {
      result.all = false;
    }
  }
  if (result.directions == 0) return std::nullopt;
  std::ranges::stable_sort(result.ranges, std::greater(), width);
  return result;
}

}  // namespace slipproof
