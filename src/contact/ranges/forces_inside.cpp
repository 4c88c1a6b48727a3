#include "contact/ranges/forces_inside.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/enclosure/residual.hpp"
#include "contact/enclosure/sizes.hpp"
#include "contact/problem/parts.hpp"
#include "contact/problem/tolerance.hpp"
#include "contact/ranges/reduced_forces.hpp"

namespace slipproof {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

/// x + d with the d nearest to a given one that changes rows little: of least |B d|^2 + |d - given|^2. Singular values
/// of B below 1 are what may change. Free unknowns are not held where they are. As (d, B d) it is the solution of a
/// sparse symmetric system, which is factored once: [D B^T; B -1].
class OpenDirections {
 public:
  OpenDirections(const Sparse& B, Index free) : B_(B), held_(VectorXd::Ones(B.cols())) {
    constexpr double hardly = 1e-2;
    held_.head(free).setConstant(hardly);
    const Index n = B.cols();
    std::vector<Eigen::Triplet<double>> entries;
    for (Index j = 0; j < n; ++j) entries.emplace_back(j, j, held_[j]);
    for (Index i = 0; i < B.rows(); ++i) entries.emplace_back(n + i, n + i, -1);
    for (Index j = 0; j < n; ++j) {
      for (Sparse::InnerIterator e(B, j); e; ++e) entries.emplace_back(n + e.row(), j, e.value());
    }
    Sparse system(n + B.rows(), n + B.rows());
    system.setFromTriplets(entries.begin(), entries.end());
    factor_.compute(system);
  }

  bool is_regular() const { return factor_.info() == Eigen::Success; }
  Work work() const {
    const auto& L = factor_.matrixL().nestedExpression();
    return 4 * static_cast<Work>(L.nonZeros()) + 30 * static_cast<Work>(L.cols());
  }

  VectorXd nearest(const VectorXd& given) const {
    VectorXd right = VectorXd::Zero(B_.cols() + B_.rows());
    right.head(B_.cols()) = held_.cwiseProduct(given);
    return factor_.solve(right).head(B_.cols());
  }

 private:
  const Sparse& B_;
  VectorXd held_;
  Eigen::SimplicialLDLT<Sparse> factor_;
};

/// Rows with large entries are divided by a number, so that the factors are accurate: what they may change is then
/// more, but far below what forces of full size change.
Sparse with_smaller_rows(Sparse B) {
  constexpr double largest = 1e4;
  VectorXd rows = VectorXd::Constant(B.rows(), largest);
  for (Index j = 0; j < B.cols(); ++j) {
    for (Sparse::InnerIterator e(B, j); e; ++e) rows[e.row()] = std::max(rows[e.row()], std::abs(e.value()));
  }
  return (largest / rows.array()).matrix().asDiagonal() * B;
}

/// Forces are to be near a point.
struct Nearness {
  VectorXd point;
  double radius;  ///< of each component

  void project(const std::vector<ForceCone>& cones, VectorXd& x) const {
    for (const ForceCone& cone : cones) {
      for (Index i = cone.first; i < cone.first + cone.size; ++i) {
        x[i] = std::clamp(x[i], point[i] - radius, point[i] + radius);
      }
    }
  }
};

/// A point of x + open directions in the cones with their apex at `margin`, to a quarter of it: by the alternating
/// direction method of multipliers. Nothing if none is found: where there is none, the distance that is left soon stays
/// as it is. Throws TooMuchWork.
std::optional<VectorXd> point_inside(const OpenDirections& open, const std::vector<ForceCone>& cones,
                                     const VectorXd& start, double margin, const std::optional<Nearness>& near,
                                     Effort& effort) {
  constexpr int most_steps = 5'000, steps = 100;
  constexpr double slow = 0.9;
  double before = std::numeric_limits<double>::infinity();
  VectorXd x = start, s = start, lambda = VectorXd::Zero(start.size());
  for (int i = 0; i < most_steps; ++i) {
    effort.spend(open.work());
    s = x + lambda;
    if (near) near->project(cones, s);
    project_on_cones(cones, s, margin);
    const double left = (x - s).lpNorm<Eigen::Infinity>();
    if (left <= margin / 4) return x;
    if (i % steps == 0 && !(left <= slow * std::exchange(before, left))) break;
    lambda += x - s;
    x = start + open.nearest(s - lambda - start);
    if (!x.allFinite()) break;
  }
  return std::nullopt;
}

/// What its velocities say of a contact.
ConeState state_of(const ForceSet& set) {
  if (set.kind == ForceSet::Kind::none) return ConeState::open;
  if (set.slip.empty()) return ConeState::stick;
  if (set.slip.size() > 1) return ConeState::slide;
  return set.slip[0].sign() > 0 ? ConeState::slide_plus : ConeState::slide_minus;
}

/// A part's x; nothing where none is found.
std::optional<std::vector<double>> part_inside(const MixedProblem& part, const std::vector<double>& x,
                                               const std::vector<ForceSet>& sets, const ForceScales& scales,
                                               double margin, Effort& effort, const std::vector<double>& toward) {
  constexpr double largest = 0.95 * contact_near;  // of a change of forces
  const ReducedForces reduced(part, sets, scales);
  if (reduced.size() == 0) return x;
  const Sparse B = with_smaller_rows(reduced.derivative(part, scales));
  const OpenDirections open(B, static_cast<Index>(part.free));
  if (!open.is_regular()) return std::nullopt;
  VectorXd start = reduced.of(x);
  std::optional<Nearness> near;
  if (!toward.empty()) {
    near = Nearness{reduced.of(toward), largest};
    start += open.nearest(near->point - start);
  }
  const auto y = point_inside(open, reduced.cones(), start, margin, near, effort);
  return y ? std::optional(reduced.x_of(*y, x.size())) : std::nullopt;
}

}  // namespace

std::optional<InsideForces> forces_inside(const MixedProblem& problem, std::span<const double> x, double tolerance,
                                          double margin, Effort& effort, std::span<const double> toward) {
  InsideForces result{std::vector<double>(x.begin(), x.end()), ConeMode(problem.contacts(), ConeState::open)};
  const double change = tolerance * contact_sizes(problem).velocity;
  const ForceScales scales = force_scales(problem, x, tolerance);
  if (!problem.is_coulomb() || !(change > 0) || !(scales.force > 0)) return std::nullopt;
  for (const ContactPart& part : parts_of(problem)) {
    const std::vector<std::size_t> rows = rows_of(problem, part);
    if (part.contacts.empty()) continue;
    const MixedProblem own = part_of(problem, part, rows);
    const std::vector<double> at = components(x, rows);
    const std::vector<ForceSet> sets = force_sets(own, exact_rows(own, at), change);
    const auto inside = part_inside(own, at, sets, scales.of_rows(rows), margin, effort,
                                    toward.empty() ? std::vector<double>() : components(toward, rows));
    if (!inside) return std::nullopt;
    for (std::size_t i = 0; i < rows.size(); ++i) result.x[rows[i]] = (*inside)[i];
    for (std::size_t k = 0; k < part.contacts.size(); ++k) result.mode[part.contacts[k]] = state_of(sets[k]);
  }
  return result;
}

}  // namespace slipproof
