#include "contact/exact/border.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/number/binary64.hpp"
#include "base/parallel/stop.hpp"
#include "contact/enclosure/dependence.hpp"
#include "contact/enclosure/krawczyk.hpp"
#include "contact/enclosure/residual.hpp"
#include "contact/linear/exact_system.hpp"

namespace slipproof {

namespace {

constexpr std::size_t largest_exact_block = 1000;

/// The solution of a mode's linear equations, exactly.
class LinearMode {
 public:
  LinearMode(const MixedProblem& problem, const ConeMode& mode, std::span<const double> x)
      : problem_(problem), system_(problem, mode), z_(system_.unknowns_at(x)) {}

  /// x; nothing where the equations have no solution with the undetermined forces of the answer. Throws TooMuchWork.
  std::optional<ExactVector> solve(Effort& effort) {
    const std::vector<bool> none(system_.size(), false);
    std::vector<Rational> x(problem_.size());
    for (const SystemBlock& block : blocks_of(system_, z_, none, none)) {
      stop_if_asked();
      if (std::max(block.unknowns.size(), block.equations.size()) > largest_exact_block) return std::nullopt;
      const auto found = solve_block(block, effort);
      if (!found) return std::nullopt;
      for (std::size_t j = 0; j < block.unknowns.size(); ++j) x[system_.place(block.unknowns[j])] = found->at(j);
    }
    return over_one_denominator(x);
  }

  /// Forces that were held in that.
  std::size_t held() const { return held_; }

 private:
  std::optional<ExactVector> solve_block(const SystemBlock& block, Effort& effort) {
    if (block.unknowns.size() == block.equations.size()) {
      if (auto found = solve_square(block.equations, block.unknowns, {}, effort)) return found;
    }
    if (std::max(block.unknowns.size(), block.equations.size()) > largest_dependent) return std::nullopt;
    const DependentPart part = dependent_part(system_, z_, block.equations, block.unknowns);
    if (!part.regular) return std::nullopt;
    held_ += part.unknowns.size();
    std::vector<std::size_t> kept;
    std::set_difference(block.equations.begin(), block.equations.end(), part.equations.begin(), part.equations.end(),
                        std::back_inserter(kept));
    return solve_square(kept, block.unknowns, part.unknowns, effort);
  }

  /// The equations, and z_j = its value in the answer for each pinned unknown j.
  std::optional<ExactVector> solve_square(std::span<const std::size_t> equations, std::span<const std::size_t> unknowns,
                                          std::span<const std::size_t> pinned, Effort& effort) const {
    std::vector<std::uint32_t> place(system_.size(), 0);
    for (std::size_t j = 0; j < unknowns.size(); ++j) place[unknowns[j]] = static_cast<std::uint32_t>(j);
    SparseMatrix A;
    A.rows = A.columns = unknowns.size();
    std::vector<double> c;
    for (const std::size_t e : equations) {
      for (const ModeSystem::Entry& entry : system_.derivative(e, z_)) {
        A.column.push_back(place[entry.unknown]);
        A.value.push_back(entry.value);
      }
      A.starts.push_back(A.value.size());
      const ModeSystem::Equation& equation = system_.equations()[e];
      c.push_back(equation.kind == ModeSystem::Kind::linear ? problem_.c[equation.row] : 0);
    }
    for (const std::size_t j : pinned) {
      A.column.push_back(place[j]);
      A.value.push_back(1);
      A.starts.push_back(A.value.size());
      c.push_back(-z_[j]);
    }
    return exact_solution(A, c, effort);
  }

  const MixedProblem& problem_;
  const ModeSystem system_;
  const std::vector<double> z_;
  std::size_t held_ = 0;
};

/// Whether x solves the problem, in any mode.
class ExactCheck {
 public:
  ExactCheck(const MixedProblem& problem, const ExactVector& x)
      : problem_(problem), x_(x), w_(exact_rows(problem.A, x, problem.c)) {}

  bool passes() const {
    for (std::size_t i = 0; i < problem_.free; ++i) {
      if (w_.sign(i) != 0) return false;
    }
    for (std::size_t k = 0; k < problem_.contacts(); ++k) {
      if (!obeys(k)) return false;
    }
    return true;
  }

 private:
  bool obeys(std::size_t k) const {
    const std::size_t n = problem_.normal(k), end = n + problem_.dimension;
    if (x_.sign(n) < 0 || w_.sign(n) < 0 || x_.sign(n) * w_.sign(n) != 0) return false;
    Integer forces = 0, power = 0;  // |r_T|^2, r_T . u_T
    bool slips = false;
    for (std::size_t t = n + 1; t < end; ++t) {
      forces.add_product(x_.numerators[t], x_.numerators[t]);
      power.add_product(x_.numerators[t], w_.numerators[t]);
      slips = slips || w_.sign(t) != 0;
    }
    const Rational bound = to_rational(problem_.mu[k]) * Rational(x_.numerators[n]);
    const int inside = Rational(bound * bound - Rational(forces)).sign();
    if (inside < 0) return false;
    if (!slips || bound.is_zero()) return true;
    return inside == 0 && power.sign() < 0 && problem_.dimension == 2;  // sliding in space is no linear mode
  }

  const MixedProblem& problem_;
  const ExactVector& x_;
  const ExactVector w_;
};

/// The modes that an answer may be in.
class Border {
 public:
  Border(const MixedProblem& problem, std::span<const double> x)
      : problem_(problem), x_(x), scales_(contact_scales(problem)), looks_like_(guess_mode(problem, x, scales_)) {
    for (std::size_t k = 0; k < problem.contacts(); ++k) {
      std::vector<double> u;
      for (std::size_t i = problem.normal(k); i < problem.normal(k) + problem.dimension; ++i) {
        u.push_back(row_sum(problem, i, x).nearest() / scales_[k]);
        size_ = std::max({size_, std::abs(x[i]), std::abs(problem.c[i]) / scales_[k]});
      }
      motion_.push_back(std::move(u));
    }
  }

  std::vector<ConeMode> candidates() const {
    std::vector<std::size_t> doubtful;
    ConeMode unloaded = looks_like_;
    for (std::size_t k = 0; k < problem_.contacts(); ++k) {
      const bool touches = small(motion_[k][0]), presses = !small(x_[problem_.normal(k)]);
      if (!presses && touches) unloaded[k] = ConeState::open;
      if (touches && (!presses || at_edge(k))) doubtful.push_back(k);
      if (presses && unloaded[k] == ConeState::slide && sticks_nearly(k)) unloaded[k] = ConeState::stick;
    }
    std::vector<ConeMode> result{std::move(unloaded), looks_like_};
    constexpr std::size_t few = 5;
    if (doubtful.size() <= few) enumerate(doubtful, result);
    std::erase_if(result, [](const ConeMode& mode) {
      return std::find(mode.begin(), mode.end(), ConeState::slide) != mode.end();
    });
    return result;
  }

 private:
  bool small(double value) const { return std::abs(value) <= 1e-6 * size_; }

  bool sticks_nearly(std::size_t k) const {
    return std::all_of(motion_[k].begin(), motion_[k].end(), [this](double u) { return small(u); });
  }

  bool at_edge(std::size_t k) const {
    const std::size_t n = problem_.normal(k);
    if (problem_.dimension == 1 || problem_.mu[k] == 0) return false;
    const double T = problem_.dimension == 2 ? std::abs(x_[n + 1]) : std::hypot(x_[n + 1], x_[n + 2]);
    return sticks_nearly(k) && small(T - problem_.mu[k] * x_[n]);
  }

  /// All modes that differ from the first in these contacts only.
  void enumerate(const std::vector<std::size_t>& contacts, std::vector<ConeMode>& result) const {
    std::vector<ConeMode> all{result.front()};
    for (const std::size_t k : contacts) {
      std::vector<ConeState> states{ConeState::open, ConeState::stick};
      if (problem_.dimension == 2 && problem_.mu[k] > 0) {
        states.insert(states.end(), {ConeState::slide_plus, ConeState::slide_minus});
      }
      std::vector<ConeMode> next;
      for (const ConeMode& mode : all) {
        for (const ConeState state : states) {
          next.push_back(mode);
          next.back()[k] = state;
        }
      }
      all = std::move(next);
    }
    result.insert(result.end(), all.begin(), all.end());
  }

  const MixedProblem& problem_;
  std::span<const double> x_;
  const std::vector<double> scales_;
  const ConeMode looks_like_;
  std::vector<std::vector<double>> motion_;  ///< u over the contact's scale: as a force
  double size_ = 0;
};

}  // namespace

std::optional<BorderSolution> solve_at_border(const MixedProblem& problem, std::span<const double> x, Effort& effort) {
  try {
    std::set<ConeMode> tried;
    for (const ConeMode& candidate : Border(problem, x).candidates()) {
      if (!tried.insert(candidate).second) continue;
      LinearMode mode(problem, candidate, x);
      const auto found = mode.solve(effort);
      if (!found || !ExactCheck(problem, *found).passes()) continue;
      BorderSolution solution{{}, mode.held()};
      for (std::size_t i = 0; i < found->size(); ++i) solution.x.push_back(found->at(i));
      return solution;
    }
  } catch (const TooMuchWork&) {
  }
  return std::nullopt;
}

}  // namespace slipproof
