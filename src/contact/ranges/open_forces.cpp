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

namespace slipproof {

namespace {

using Dense = Eigen::MatrixXd;
using DenseVector = Eigen::VectorXd;
using Index = Eigen::Index;

/// Of their sizes, around the answer: where free unknowns may be.
constexpr double free_box = 1e6;

/// What components of x and of A x + c are compared with.
struct Scales {
  double force = 0;             ///< the largest of the answer
  std::vector<double> unknown;  ///< of free unknowns
  std::vector<double> change;   ///< that rows of A x + c may have

  /// Of a part, whose free rows come first, as in the whole.
  Scales of_rows(const std::vector<std::size_t>& rows) const {
    Scales own{force, {}, {}};
    for (const std::size_t i : rows) {
      own.change.push_back(change[i]);
      if (i < unknown.size()) own.unknown.push_back(unknown[i]);
    }
    return own;
  }
};

std::vector<double> of_rows(std::span<const double> x, const std::vector<std::size_t>& rows) {
  std::vector<double> own;
  for (const std::size_t i : rows) own.push_back(x[i]);
  return own;
}

/// x = unknown y in the numbers in which everything is about 1: free unknowns, rays as one number, cones.
class Reduced {
 public:
  Reduced(const MixedProblem& problem, const std::vector<ForceSet>& sets, const Scales& scales) {
    for (std::size_t j = 0; j < problem.free; ++j) columns_.push_back({{j, scales.unknown[j]}});
    for (std::size_t k = 0; k < sets.size(); ++k) {
      place_.push_back(sets[k].kind == ForceSet::Kind::none ? -1 : size());
      add(sets[k], problem.normal(k), problem.dimension, scales.force);
    }
  }

  Index size() const { return static_cast<Index>(columns_.size()); }
  const std::vector<ConeProgram::Cone>& cones() const { return cones_; }
  /// Of a contact's normal force; negative if it is open.
  Index normal(std::size_t contact) const { return place_[contact]; }

  /// What rows change with y, over what they may.
  Dense derivative(const MixedProblem& problem, const Scales& scales) const {
    Dense B = Dense::Zero(static_cast<Index>(problem.size()), size());
    std::vector<std::vector<std::pair<Index, double>>> users(problem.size());  // of each component
    for (Index j = 0; j < size(); ++j) {
      for (const auto& [i, factor] : columns_[static_cast<std::size_t>(j)]) users[i].emplace_back(j, factor);
    }
    for (std::size_t i = 0; i < problem.size(); ++i) {
      for (std::size_t e = problem.A.starts[i]; e < problem.A.starts[i + 1]; ++e) {
        for (const auto& [j, factor] : users[problem.A.column[e]]) {
          B(static_cast<Index>(i), j) += problem.A.value[e] * factor / scales.change[i];
        }
      }
    }
    return B;
  }

  /// x of y: components that are no unknown are 0.
  std::vector<double> x_of(const DenseVector& y, std::size_t components) const {
    std::vector<double> x(components, 0);
    for (Index j = 0; j < size(); ++j) {
      for (const auto& [i, factor] : columns_[static_cast<std::size_t>(j)]) x[i] += factor * y[j];
    }
    return x;
  }

  DenseVector of(std::span<const double> x) const {
    DenseVector y(size());
    for (Index j = 0; j < size(); ++j) {
      const auto& [i, factor] = columns_[static_cast<std::size_t>(j)].front();
      y[j] = x[i] / factor;
    }
    return y;
  }

 private:
  void add(const ForceSet& set, std::size_t normal, std::size_t dimension, double force) {
    if (set.kind == ForceSet::Kind::none) return;
    const Index first = size();
    if (set.kind == ForceSet::Kind::ray) {
      auto& column = columns_.emplace_back();
      column.emplace_back(normal, force);
      for (std::size_t t = 0; t < set.slip.size(); ++t) {
        column.emplace_back(normal + 1 + t, -force * nearest_binary64(set.mu * set.slip[t]));
      }
    } else {
      for (std::size_t i = 0; i < dimension; ++i) columns_.push_back({{normal + i, force}});
    }
    cones_.push_back({first, size() - first, nearest_binary64(set.mu)});
  }

  std::vector<std::vector<std::pair<std::size_t, double>>> columns_;
  std::vector<Index> place_;
  std::vector<ConeProgram::Cone> cones_;
};

/// One part of a problem, with an answer.
class OpenPart {
 public:
  OpenPart(const MixedProblem& problem, std::vector<double> x, Scales scales, double change, Effort& effort)
      : problem_(problem),
        x_(std::move(x)),
        scales_(std::move(scales)),
        effort_(effort),
        sets_(force_sets(problem, exact_rows(problem, x_), change)),
        reduced_(problem, sets_, scales_) {
    const auto rows = static_cast<Work>(problem.size()), columns = static_cast<Work>(reduced_.size());
    if (reduced_.size() == 0) return;  // with these velocities no contact has a force: nothing is open
    effort_.spend(times(4 * rows, times(columns, columns)));
    const Dense B = reduced_.derivative(problem, scales_);
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

  /// The answer with its forces moved inside of what the law allows at its velocities, by this part of the largest one.
  std::optional<std::vector<double>> inside(double margin) const {
    if (!program_) return std::vector<double>(x_);
    const auto y = program_->inside(margin, effort_);
    return y ? std::optional(reduced_.x_of(*y, x_.size())) : std::nullopt;
  }

  /// What its velocities say of a contact.
  ConeState state(std::size_t contact) const {
    const ForceSet& set = sets_[contact];
    if (set.kind == ForceSet::Kind::none) return ConeState::open;
    if (set.slip.empty()) return ConeState::stick;
    if (set.slip.size() > 1) return ConeState::slide;
    return set.slip[0].sign() > 0 ? ConeState::slide_plus : ConeState::slide_minus;
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
  Scales scales_;
  Effort& effort_;
  std::vector<ForceSet> sets_;
  Reduced reduced_;
  Eigen::CompleteOrthogonalDecomposition<Dense> decomposition_;
  Dense N_;
  MixedProblem transposed_;
  std::optional<ConeProgram> program_;
  std::optional<Rational> sum_;
};

Scales scales_of(const MixedProblem& problem, std::span<const double> x, double tolerance, double change) {
  Scales scales;
  for (std::size_t i = problem.free; i < x.size(); ++i) scales.force = std::max(scales.force, std::abs(x[i]));
  const FreeSizes free = free_sizes(problem, scales.force);
  for (std::size_t i = 0; i < problem.free; ++i) {
    scales.unknown.push_back(free.unknowns[i] > 0 ? free.unknowns[i] : 1);
    scales.change.push_back(free.rows[i] > 0 ? tolerance * free.rows[i] : change);
  }
  scales.change.resize(problem.size(), change);
  return scales;
}

double width(const NormalRange& range) {
  return range.most ? *range.most - range.least : std::numeric_limits<double>::infinity();
}

}  // namespace

std::optional<OpenForces> open_forces(const MixedProblem& problem, std::span<const double> x, double tolerance,
                                      Effort& effort) {
  OpenForces result;
  result.change = tolerance * contact_sizes(problem).velocity;
  const Scales scales = scales_of(problem, x, tolerance, result.change);
  const bool known = problem.is_coulomb() || problem.law.kind == FrictionLaw::associated;
  if (!known || !(result.change > 0) || !(scales.force > 0)) return std::nullopt;
  for (const ContactPart& part : parts_of(problem)) {
    const std::vector<std::size_t> rows = rows_of(problem, part);
    if (part.contacts.empty() || rows.size() > largest_open_part) continue;
    try {
      const MixedProblem own = part_of(problem, part, rows);
      OpenPart open(own, of_rows(x, rows), scales.of_rows(rows), result.change, effort);
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

std::optional<InsideForces> forces_inside(const MixedProblem& problem, std::span<const double> x, double tolerance,
                                          double margin, Effort& effort) {
  InsideForces result{std::vector<double>(x.begin(), x.end()), ConeMode(problem.contacts(), ConeState::open)};
  double change = tolerance * contact_sizes(problem).velocity;
  const Scales scales = scales_of(problem, x, tolerance, change);
  if (!problem.is_coulomb() || !(change > 0) || !(scales.force > 0)) return std::nullopt;
  for (const ContactPart& part : parts_of(problem)) {
    const std::vector<std::size_t> rows = rows_of(problem, part);
    if (part.contacts.empty()) continue;
    if (rows.size() > largest_open_part) return std::nullopt;
    const MixedProblem own = part_of(problem, part, rows);
    const OpenPart open(own, of_rows(x, rows), scales.of_rows(rows), change, effort);
    const auto inside = open.inside(margin);
    if (!inside) return std::nullopt;
    for (std::size_t i = 0; i < rows.size(); ++i) result.x[rows[i]] = (*inside)[i];
    for (std::size_t k = 0; k < part.contacts.size(); ++k) result.mode[part.contacts[k]] = open.state(k);
  }
  return result;
}

}  // namespace slipproof
