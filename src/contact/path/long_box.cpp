#include "contact/path/long_box.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"
#include "base/parallel/stop.hpp"
#include "contact/enclosure/dependence.hpp"
#include "contact/path/long_test.hpp"

namespace slipproof {

namespace {

/// The unknowns of a mode near the end of a path.
std::vector<Rational> unknowns_of(const ModeSystem& system, const PathEnd& end) {
  std::vector<Rational> z(system.size());
  for (std::size_t j = 0; j < system.size(); ++j) {
    if (system.place(j) != ModeSystem::none) z[j] = end.x[system.place(j)];
  }
  for (std::size_t k = 0; k < end.mode.size(); ++k) {
    if (system.slip(k) != ModeSystem::none) z[system.slip(k)] = end.slip[k];
  }
  return z;
}

class LongEnclosure {
  static constexpr std::size_t few = 40;  ///< equations, for an exact inverse

 public:
  LongEnclosure(const MixedProblem& problem, const PathEnd& end)
      : problem_(problem),
        box_{ModeSystem(problem, end.mode), {}, {}, {}, {}, {}, true},
        z_(unknowns_of(box_.system, end)),
        pinned_(z_.size(), false),
        dropped_(z_.size(), false),
        radius_(z_.size(), 0) {}

  std::optional<Enclosure> run(Effort& effort) {
    std::vector<double> near;
    for (const Rational& z : z_) near.push_back(nearest_binary64(z));
    for (const SystemBlock& block : blocks_of(box_.system, near, pinned_, dropped_)) {
      const Work n = std::max(block.unknowns.size(), block.equations.size());
      effort.spend(times(times(n, n), 12 * n));
      if (!make_regular(block)) return std::nullopt;
    }
    for (const SystemBlock& block : blocks_of(box_.system, near, pinned_, dropped_)) {
      stop_if_asked();
      if (block.unknowns.size() != block.equations.size() || !test(block)) return std::nullopt;
    }
    for (std::size_t j = 0; j < z_.size(); ++j) {
      if (pinned_[j]) box_.pinned.push_back(j);
    }
    box_.locally_unique = box_.locally_unique && box_.pinned.empty();
    if (!conditions_hold()) return std::nullopt;
    return finished();
  }

  /// After run(): the end with that contact sliding which sticks farthest outside of its cone; nothing if none does.
  std::optional<PathEnd> with_slide(PathEnd end) const {
    double farthest = 1;
    std::optional<std::size_t> which;
    for (std::size_t k = 0; k < problem_.contacts(); ++k) {
      const std::size_t n = problem_.normal(k);
      if (box_.system.mode()[k] != ConeState::stick || !(problem_.mu[k] > 0) || problem_.dimension == 1) continue;
      const double bound = problem_.mu[k] * near(n);
      const double T = std::hypot(near(n + 1), problem_.dimension == 3 ? near(n + 2) : 0);
      if (bound > 0 && T > farthest * bound) farthest = T / bound, which = k;
    }
    if (!which) return std::nullopt;
    const std::size_t n = problem_.normal(*which);
    const bool in_space = problem_.dimension == 3;
    const double T1 = near(n + 1), T2 = in_space ? near(n + 2) : 0, T = std::hypot(T1, T2);
    const Rational bound = to_rational(problem_.mu[*which]) * end.x[n];
    end.x[n + 1] = bound * to_rational(T1 / T);
    if (in_space) end.x[n + 2] = bound * to_rational(T2 / T);
    end.mode[*which] = in_space ? ConeState::slide : T1 < 0 ? ConeState::slide_plus : ConeState::slide_minus;
    end.slip[*which] = 0;
    return end;
  }

 private:
  bool make_regular(const SystemBlock& block) {
    const DependentPart part = dependent_in_long_numbers(box_.system, block, z_);
    std::vector<DroppedEquation> dropped;
    for (const std::size_t e : part.equations) dropped.push_back({e, {}});
    // Not exactly dependent: few equations may still be regular, in more digits.
    if (!combine(problem_, box_.system, block.equations, dropped)) return block.equations.size() <= few;
    for (const std::size_t j : part.unknowns) {
      pinned_[j] = true;
      z_[j] = to_rational(nearest_binary64(z_[j]));
    }
    for (DroppedEquation& d : dropped) {
      dropped_[d.equation] = true;
      box_.dropped.push_back(std::move(d));
    }
    return true;
  }

  bool test(const SystemBlock& block) {
    const std::vector<Rational> before = z_;
    if (test(block, LongTest::Inverse::rough)) return true;
    z_ = before;
    return block.unknowns.size() <= few && test(block, LongTest::Inverse::exact);
  }

  bool test(const SystemBlock& block, LongTest::Inverse inverse) {
    LongTest test(box_.system, block, z_, inverse);
    const auto found = test.run();
    if (!found) return false;
    for (std::size_t j = 0; j < block.unknowns.size(); ++j) radius_[block.unknowns[j]] = found->radius[j];
    box_.locally_unique = box_.locally_unique && found->unique;
    for (std::size_t j = 0; j < block.unknowns.size(); ++j) {
      for (std::size_t i = 0; i < block.equations.size(); ++i) {
        Rational entry = test.inverse(j, i);
        if (!entry.is_zero()) inverse_.push_back({block.unknowns[j], block.equations[i], std::move(entry)});
      }
    }
    return true;
  }

  /// Least and greatest value of something in the box.
  struct Range {
    Rational least, greatest;
    Rational size() const { return std::max(abs(least), abs(greatest)); }
  };
  Range unknown(std::size_t j) const {
    const Rational radius = to_rational(radius_[j]);
    return {z_[j] - radius, z_[j] + radius};
  }
  Range row(std::size_t i) const {
    Rational center = to_rational(problem_.c[i]), radius = 0;
    const auto columns = problem_.A.columns_of(i);
    for (std::size_t e = 0; e < columns.size(); ++e) {
      const std::size_t j = box_.system.unknown(columns[e]);
      if (j == ModeSystem::none) continue;
      const Rational a = to_rational(problem_.A.values_of(i)[e]);
      center += a * z_[j];
      radius += abs(a) * to_rational(radius_[j]);
    }
    return {center - radius, center + radius};
  }

  /// The sign of what is least of all that is not to be negative at a contact: 0 where it may be 0.
  int least_sign(std::size_t k) const {
    const std::size_t n = problem_.normal(k);
    const ConeState state = box_.system.mode()[k];
    if (state == ConeState::open) return row(n).least.sign();
    const Rational N = unknown(box_.system.unknown(n)).least;
    if (N.sign() < 0 || problem_.mu[k] == 0) return N.sign();
    if (state == ConeState::slide) return std::min(N.sign(), unknown(box_.system.slip(k)).least.sign());
    const Rational mu = to_rational(problem_.mu[k]);
    if (state == ConeState::stick) {
      Rational square = 0;
      for (std::size_t i = 1; i < problem_.dimension; ++i) {
        const Rational T = unknown(box_.system.unknown(n + i)).size();
        square += T * T;
      }
      return Rational(mu * mu * N * N - square).sign();
    }
    const Range u = row(n + 1);
    return std::min(N.sign(), state == ConeState::slide_plus ? u.least.sign() : -u.greatest.sign());
  }

  double near(std::size_t component) const { return nearest_binary64(z_[box_.system.unknown(component)]); }

  bool conditions_hold() {
    for (std::size_t k = 0; k < problem_.contacts(); ++k) {
      const int sign = least_sign(k);
      if (sign < 0) return false;
      box_.locally_unique = box_.locally_unique && sign > 0;
    }
    return true;
  }

  Enclosure finished() {
    auto proof = std::make_shared<LongProof>();
    std::vector<std::size_t> unknown(z_.size()), equation(z_.size());
    std::size_t unknowns = 0, equations = 0;
    for (std::size_t i = 0; i < z_.size(); ++i) {
      unknown[i] = pinned_[i] ? ModeSystem::none : unknowns++;
      equation[i] = dropped_[i] ? ModeSystem::none : equations++;
    }
    for (LongProof::Entry& e : inverse_) {
      proof->inverse.push_back({unknown[e.unknown], equation[e.equation], std::move(e.value)});
    }
    proof->radius = radius_;
    for (const std::size_t j : box_.pinned) proof->radius[j] = 1;
    for (std::size_t j = 0; j < z_.size(); ++j) {
      box_.center.push_back(nearest_binary64(z_[j]));
      const Rational apart = abs(z_[j] - to_rational(box_.center[j]));
      box_.radius.push_back(enclose(apart + to_rational(radius_[j])).upper);
    }
    proof->center = std::move(z_);
    box_.proof = std::move(proof);
    return std::move(box_);
  }

  const MixedProblem& problem_;
  Enclosure box_;
  std::vector<Rational> z_;
  std::vector<bool> pinned_, dropped_;
  std::vector<double> radius_;
  std::vector<LongProof::Entry> inverse_;  ///< with unknowns and equations of the whole system
};

}  // namespace

std::optional<Enclosure> enclose_in_long_numbers(const MixedProblem& problem, PathEnd end, Effort& effort) {
  constexpr std::size_t small = 120;  // components, to try other modes
  const int most_slides = problem.size() <= small ? 4 : 0;
  for (int slides = 0;; ++slides) {
    LongEnclosure enclosure(problem, end);
    if (auto box = enclosure.run(effort)) return box;
    auto next = slides < most_slides ? enclosure.with_slide(std::move(end)) : std::nullopt;
    if (!next) return std::nullopt;
    end = *std::move(next);
  }
}

}  // namespace slipproof
