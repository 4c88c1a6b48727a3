#include "contact/judge/find/sweeps.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "base/parallel/stop.hpp"
#include "contact/judge/find/contact_newton.hpp"

namespace slipproof {

namespace {

/// One contact, for given forces of the others: u = W r + rest.
template <int size>
class OneContact {
 public:
  using Block = Eigen::Matrix<double, size, size>;
  using Part = Eigen::Matrix<double, size, 1>;

  OneContact(const MixedProblem& problem, std::size_t contact, const Block& W)
      : W_(W), inverse_(W.inverse()), mu_(problem.mu[contact]), law_(problem.law.kind) {
    const double norm = W.norm();
    step_ = norm > 0 ? 1 / norm : 1;
    const std::size_t tangents = size - 1;
    if (law_ == FrictionLaw::fixed) bounds_ = std::span(problem.law.bounds).subspan(tangents * contact, tangents);
    by_law_ = problem.is_coulomb() && W(0, 0) > 0;
  }

  Part solve(const Part& rest, const Part& before) const {
    if (!by_law_) return iterated(rest, before);
    if (rest[0] >= 0) return Part::Zero();
    if constexpr (size > 1) {
      if (mu_ > 0) {
        // A contact may have several solutions of its own: those like what was before come first.
        const bool slipped = tangent_length(before) >= 0.999999 * mu_ * before[0];
        std::optional<Part> slips;
        if (slipped && before[0] > 0 && (slips = slipping(rest, before))) return *slips;
        const Part sticks = -(inverse_ * rest);
        if (tangent_length(sticks) <= mu_ * sticks[0]) return sticks;
        if (!slipped && (slips = slipping(rest, before))) return *slips;
        return iterated(rest, before);
      }
    }
    Part r = Part::Zero();
    r[0] = -rest[0] / W_(0, 0);
    return r;
  }

 private:
  static double tangent_length(const Part& r) {
    if constexpr (size == 1) return 0;
    return r.template tail<size - 1>().norm();
  }

  /// The force at which it slips in the plane, or in a direction near that of `before`.
  std::optional<Part> slipping(const Part& rest, const Part& before) const {
    if constexpr (size == 2) {
      for (const double direction : {before[1] > 0 ? -1.0 : 1.0, before[1] > 0 ? 1.0 : -1.0}) {
        const Part edge(1, -mu_ * direction);
        const double N = -rest[0] / W_.row(0).dot(edge);
        if (N >= 0 && direction * (rest[1] + N * W_.row(1).dot(edge)) >= 0) return N * edge;
      }
    } else if constexpr (size == 3) {
      return slipping_in_space(rest, before);
    }
    return std::nullopt;
  }

  struct AtAngle {
    Part r;
    double across, along;  ///< the velocity's parts across the direction of slip, and along it
  };
  AtAngle at(double angle, const Part& rest) const {
    const double c = std::cos(angle), s = std::sin(angle);
    const Part edge(1, -mu_ * c, -mu_ * s);
    const Part r = edge * (-rest[0] / W_.row(0).dot(edge));
    const Part u = W_ * r + rest;
    return {r, c * u[2] - s * u[1], c * u[1] + s * u[2]};
  }

  /// A root of `across` by Newton's method with differences, or else between sixteen angles.
  std::optional<Part> slipping_in_space(const Part& rest, const Part& before) const {
    const bool known = before[1] != 0 || before[2] != 0;
    double angle = known ? std::atan2(-before[2], -before[1]) : std::atan2(rest[2], rest[1]);
    double other = angle + 1e-4;
    AtAngle x = at(angle, rest), y = at(other, rest);
    for (int i = 0; i < 12 && x.across != y.across; ++i) {
      const double next = angle - x.across * (angle - other) / (x.across - y.across);
      if (!(std::abs(next - angle) < 1)) break;
      other = std::exchange(angle, next);
      y = std::exchange(x, at(angle, rest));
      if (std::abs(angle - other) <= 1e-16 * std::max(1.0, std::abs(angle)) || x.across == 0) break;
    }
    const bool root = std::abs(x.across) <= 1e-13 * (std::abs(x.along) + rest.norm());
    if (root && x.along >= 0 && x.r[0] >= 0) return x.r;
    return between_angles(rest);
  }

  std::optional<Part> between_angles(const Part& rest) const {
    constexpr int pieces = 16;
    for (int i = 0; i < pieces; ++i) {
      double low = 2 * std::numbers::pi * i / pieces, high = 2 * std::numbers::pi * (i + 1) / pieces;
      AtAngle a = at(low, rest), b = at(high, rest);
      if (a.across * b.across > 0 || a.along < 0 || a.r[0] < 0 || b.r[0] < 0) continue;
      for (int halving = 0; halving < 52; ++halving) {
        const double middle = (low + high) / 2;
        const AtAngle m = at(middle, rest);
        (a.across * m.across > 0 ? low : high) = middle;
        (a.across * m.across > 0 ? a : b) = m;
      }
      if (b.along >= 0) return b.r;
    }
    return std::nullopt;
  }

  /// A fixed-point iteration of projections on what the law allows.
  Part iterated(const Part& rest, Part r) const {
    for (int i = 0; i < 40; ++i) {
      const Part next = projected(r - step_ * (W_ * r + rest));
      const double moved = (next - r).template lpNorm<Eigen::Infinity>();
      r = next;
      if (moved <= 1e-16 * r.template lpNorm<Eigen::Infinity>()) break;
    }
    return r;
  }

  Part projected(Part r) const {
    if constexpr (size > 1) {
      if (law_ == FrictionLaw::fixed) {
        r[0] = std::max(r[0], 0.0);
        for (int i = 1; i < size; ++i) {
          const double bound = bounds_[static_cast<std::size_t>(i) - 1];
          r[i] = std::clamp(r[i], -bound, bound);
        }
        return r;
      }
      const double length = tangent_length(r);
      if (law_ == FrictionLaw::associated && length > mu_ * r[0]) r[0] = (r[0] + mu_ * length) / (1 + mu_ * mu_);
      r[0] = std::max(r[0], 0.0);
      const double bound = mu_ * r[0];
      if (length > bound) r.template tail<size - 1>() *= length > 0 ? bound / length : 0;
    } else {
      r[0] = std::max(r[0], 0.0);
    }
    return r;
  }

  Block W_, inverse_;
  double mu_, step_ = 1;
  FrictionLaw law_;
  bool by_law_ = true;
  std::span<const double> bounds_;
};

/// A in blocks, a row of them for each contact.
template <int size>
class Sweeps {
 public:
  using Block = typename OneContact<size>::Block;
  using Part = typename OneContact<size>::Part;
  using Vector = Eigen::VectorXd;

  explicit Sweeps(const MixedProblem& problem) : q_(problem.c.data(), static_cast<Eigen::Index>(problem.c.size())) {
    std::map<std::size_t, Block> row;
    for (std::size_t contact = 0; contact < problem.contacts(); ++contact) {
      row.clear();
      for (int i = 0; i < size; ++i) {
        const std::size_t at = size * contact + static_cast<std::size_t>(i);
        for (std::size_t e = problem.A.starts[at]; e < problem.A.starts[at + 1]; ++e) {
          const std::size_t column = problem.A.column[e];
          Block& block = row.try_emplace(column / size, Block::Zero()).first->second;
          block(i, static_cast<int>(column % size)) += problem.A.value[e];
        }
      }
      const auto own = row.extract(contact);
      contacts_.emplace_back(problem, contact, own ? own.mapped() : Block(Block::Zero()));
      for (const auto& [other, block] : row) neighbours_.push_back({static_cast<Eigen::Index>(other), block});
      starts_.push_back(neighbours_.size());
    }
  }

  void sweep(Vector& r) const {
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const auto first = static_cast<Eigen::Index>(k) * size;
      Part rest = q_.segment<size>(first);
      for (std::size_t e = starts_[k]; e < starts_[k + 1]; ++e) {
        rest.noalias() += neighbours_[e].block * r.segment<size>(neighbours_[e].contact * size);
      }
      r.segment<size>(first) = contacts_[k].solve(rest, r.segment<size>(first));
    }
  }

 private:
  struct Neighbour {
    Eigen::Index contact;
    Block block;
  };

  Eigen::Map<const Vector> q_;
  std::vector<OneContact<size>> contacts_;
  std::vector<Neighbour> neighbours_;
  std::vector<std::size_t> starts_{0};
};

/// Anderson's acceleration: of the combinations, with weights of sum 1, of the last points, the one that sweeps would
/// move least if they were linear.
class Extrapolation {
 public:
  explicit Extrapolation(std::size_t depth) : depth_(depth) {}

  /// A sweep went from `start` to `end`.
  Eigen::VectorXd next(const Eigen::VectorXd& start, const Eigen::VectorXd& end) {
    const Eigen::VectorXd moved = end - start;
    if (last_moved_.size() > 0) {
      if (moves_.size() == depth_) moves_.erase(moves_.begin()), ends_.erase(ends_.begin());
      moves_.push_back(moved - last_moved_);
      ends_.push_back(end - last_end_);
    }
    last_moved_ = moved;
    last_end_ = end;
    const auto n = static_cast<Eigen::Index>(moves_.size());
    if (n == 0) return end;
    Eigen::MatrixXd gram(n, n);
    Eigen::VectorXd against(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      against[i] = moves_[static_cast<std::size_t>(i)].dot(moved);
      for (Eigen::Index j = 0; j <= i; ++j) {
        gram(i, j) = gram(j, i) = moves_[static_cast<std::size_t>(i)].dot(moves_[static_cast<std::size_t>(j)]);
      }
    }
    gram.diagonal() *= 1 + 1e-12;
    const Eigen::VectorXd weights = gram.partialPivLu().solve(against);
    Eigen::VectorXd result = end;
    for (Eigen::Index i = 0; i < n; ++i) result -= weights[i] * ends_[static_cast<std::size_t>(i)];
    return result.allFinite() ? result : end;
  }

 private:
  std::size_t depth_;
  std::vector<Eigen::VectorXd> moves_, ends_;  ///< differences
  Eigen::VectorXd last_moved_, last_end_;
};

/// Where a round of sweeps has come to. Rounds differ in how far back the extrapolation looks, and in how much farther
/// a sweep may move than the best one before extrapolation begins again: which of them gets on depends on the problem.
template <int size>
struct Round {
  static constexpr int length = 400;

  Eigen::VectorXd r;    ///< after the sweep that moved it least
  bool agreed = false;  ///< nothing moved by more than rounding

  Round(const Sweeps<size>& sweeps, Eigen::VectorXd start, std::size_t depth, double farther) : r(start) {
    Extrapolation extrapolation(depth);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < length && !agreed; ++i) {
      stop_if_asked();
      Eigen::VectorXd end = start;
      sweeps.sweep(end);
      const double moved = (end - start).norm();
      if (!std::isfinite(moved)) break;
      if (moved > farther * least) {  // extrapolated too far
        extrapolation = Extrapolation(depth);
        start = r;
        least *= 2;
        continue;
      }
      if (moved < least) least = moved, r = end;
      agreed = moved <= 1e-15 * end.norm();
      start = extrapolation.next(start, end);
    }
  }
};

template <int size>
SweptForces swept_in(const MixedProblem& problem, const std::vector<double>& start, int rounds,
                     std::size_t most_for_newton) {
  const Sweeps<size> sweeps(problem);
  const bool has_newton = problem.is_coulomb() && problem.size() <= most_for_newton;
  std::optional<ContactNewton> newton;  // made where sweeps alone do not suffice
  Eigen::VectorXd r = Eigen::Map<const Eigen::VectorXd>(start.data(), static_cast<Eigen::Index>(start.size()));
  constexpr int most_attempts = 4;
  constexpr std::array<std::size_t, 5> depths{10, 5, 20, 3, 40};
  bool agreed = false;
  for (int i = 0; i < rounds && !agreed; ++i) {
    const Round<size> round(sweeps, r, depths[static_cast<std::size_t>(i) % depths.size()], i % 2 == 0 ? 4 : 1.5);
    r = round.r;
    agreed = round.agreed;
    if (agreed || !has_newton || i >= most_attempts) continue;
    if (!newton) newton.emplace(problem);
    agreed = newton->solve(r, i);
  }
  return {{r.data(), r.data() + r.size()}, agreed};
}

}  // namespace

SweptForces swept(const MixedProblem& problem, const std::vector<double>& r, int rounds, std::size_t newton) {
  switch (problem.dimension) {
    case 1:
      return swept_in<1>(problem, r, rounds, newton);
    case 2:
      return swept_in<2>(problem, r, rounds, newton);
    default:
      return swept_in<3>(problem, r, rounds, newton);
  }
}

}  // namespace slipproof
