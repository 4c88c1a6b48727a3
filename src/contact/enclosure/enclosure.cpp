#include "contact/enclosure/enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/number/binary64.hpp"
#include "base/parallel/stop.hpp"
#include "contact/enclosure/ball.hpp"
#include "contact/enclosure/conditions.hpp"
#include "contact/enclosure/dependence.hpp"
#include "contact/enclosure/residual.hpp"
#include "contact/linear/rounding.hpp"

namespace slipproof {

namespace {

bool all_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

/// Contacts whose unknowns are in a block.
std::vector<std::size_t> contacts_of(const MixedProblem& problem, const ModeSystem& system,
                                     std::span<const std::size_t> unknowns) {
  std::vector<std::size_t> contacts;
  for (const std::size_t j : unknowns) {
    const std::size_t place = system.place(j);
    if (place == ModeSystem::none || place < problem.free) continue;
    contacts.push_back((place - problem.free) / problem.dimension);
  }
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
  return contacts;
}

class EnclosureSearch {
 public:
  EnclosureSearch(const MixedProblem& problem, const EnclosureOptions& options)
      : problem_(problem),
        options_(options),
        factored_from_(std::min<std::size_t>(40, options.sparse_from)),
        scales_(contact_scales(problem)) {}

  std::variant<Enclosure, NoEnclosure> run(std::span<const double> answer) {
    std::vector<double> x(answer.begin(), answer.end());
    enter(guess_mode(problem_, x, scales_), x);
    for (int attempt = 0; attempt < options_.modes; ++attempt) {
      if (auto failure = prepare()) return std::move(*failure);
      const bool converged = improve();
      if (!all_finite(z_)) return NoEnclosure{"Newton's method runs away from the answer", {}};
      x = system_->x_at(z_);
      ConeMode next = guess_mode(problem_, x, scales_);
      if (next != system_->mode()) {
        enter(std::move(next), x);
      } else if (converged) {
        return test();
      }
    }
    return NoEnclosure{"Newton's method finds no mode that fits its own point", {}};
  }

  std::optional<Enclosure> run_in(ConeMode mode, std::span<const double> answer) {
    enter(std::move(mode), std::vector<double>(answer.begin(), answer.end()));
    if (prepare() || !improve() || !all_finite(z_)) return std::nullopt;
    auto result = test();
    auto* box = std::get_if<Enclosure>(&result);
    return box != nullptr ? std::optional(std::move(*box)) : std::nullopt;
  }

 private:
  /// Starts with the equations of a mode, with unknowns near x.
  void enter(ConeMode mode, std::vector<double> x) {
    put_on_cones(mode, x);
    system_.emplace(problem_, std::move(mode));
    z_ = system_->unknowns_at(x);
    pinned_.assign(system_->size(), false);
    for (std::size_t j = 0; j < system_->size(); ++j) {
      const std::size_t place = system_->place(j);
      pinned_[j] = place != ModeSystem::none && system_->is_zero(place);
    }
    dropped_.assign(system_->size(), false);
    combinations_.clear();
  }

  /// Forces of sliding contacts that are not near their cones start where the projection of r - u / scale points to:
  /// without a direction the equations of sliding are singular.
  void put_on_cones(const ConeMode& mode, std::vector<double>& x) const {
    const std::vector<double> before = x;
    for (std::size_t k = 0; k < problem_.contacts(); ++k) {
      if (mode[k] != ConeState::slide) continue;
      const std::size_t n = problem_.normal(k);
      const auto projected = [&](std::size_t part) { return before_projection(problem_, before, k, part, scales_[k]); };
      const double bound = problem_.mu[k] * before[n], length = std::hypot(before[n + 1], before[n + 2]);
      if (before[n] > 0 && std::abs(length - bound) <= 1e-3 * bound) continue;
      if (before[n] <= 0) x[n] = projected(0);
      const double T1 = projected(1), T2 = projected(2), T = std::hypot(T1, T2);
      x[n + 1] = problem_.mu[k] * x[n] * (T1 / T);
      x[n + 2] = problem_.mu[k] * x[n] * (T2 / T);
    }
  }

  /// The blocks with their inverses; dependent ones made regular by pinning and dropping.
  std::optional<NoEnclosure> prepare() {
    if (!combinations_.empty()) {  // what is dependent has been found in this mode
      for (SystemBlock& block : blocks_) {
        const bool can_step = invert(block, factored_from_) || block.inverse.size == block.unknowns.size();
        if (!can_step) return too_large(block);
      }
      return std::nullopt;
    }
    blocks_ = blocks_of(*system_, z_, pinned_, dropped_);
    std::vector<SystemBlock*> dependent;
    for (SystemBlock& block : blocks_) {
      stop_if_asked();
      if (block.unknowns.size() == block.equations.size()) {
        if (factor(block)) continue;
        if (block.unknowns.size() > options_.largest_block) return too_large(block);
      }
      dependent.push_back(&block);
    }
    if (dependent.empty()) return std::nullopt;
    if (++dependent_modes_ > options_.dependent_modes)
      return NoEnclosure{"too many modes have dependent equations", {}};
    return make_regular(dependent);
  }

  NoEnclosure too_large(const SystemBlock& block) const {
    return {"a block of " + std::to_string(block.unknowns.size()) + " unknowns is above the limit of " +
                std::to_string(options_.largest_block) + ", and has no sparse factors",
            {}};
  }

  /// Finds the inverse of the derivative at the point, by factors from this number of unknowns; false where it has
  /// none, or is too large for a dense one.
  bool invert(SystemBlock& block, std::size_t sparse_from) const {
    block.sparse.reset();
    if (is_large_and_sparse(*system_, block, z_, sparse_from)) block.sparse = sparse_inverse(*system_, block, z_);
    return block.sparse || invert_densely(block);
  }

  /// The same for Newton's method, which tries many modes, and needs no inverse where there are factors: false where
  /// these say that the equations are dependent.
  bool factor(SystemBlock& block) const {
    block.sparse.reset();
    if (!is_large_and_sparse(*system_, block, z_, factored_from_)) return invert_densely(block);
    block.sparse = sparse_inverse(*system_, block, z_);
    return block.sparse != nullptr;
  }

  bool invert_densely(SystemBlock& block) const {
    block.sparse.reset();
    if (block.unknowns.size() > options_.largest_block) return false;
    const DenseMatrix J = block_derivative(*system_, block, z_);
    block.inverse = approximate_inverse(J);
    return all_finite(block.inverse.value) && well_conditioned(J, block.inverse);
  }

  /// Whether the inverse is one at all: with dependent equations it is noise. Whatever rows and columns are scaled by
  /// leaves the diagonal of |R| |J| as it is.
  static bool well_conditioned(const DenseMatrix& J, const DenseMatrix& inverse) {
    std::vector<double> diagonal(J.size, 0);
    for (std::size_t i = 0; i < J.size; ++i) {
      for (std::size_t j = 0; j < J.size; ++j) diagonal[j] += std::abs(inverse.row(j)[i] * J.row(i)[j]);
    }
    return std::all_of(diagonal.begin(), diagonal.end(), [](double x) { return x < 0.05 / unit_roundoff; });
  }

  std::optional<NoEnclosure> make_regular(const std::vector<SystemBlock*>& dependent) {
    for (SystemBlock* block : dependent) {
      DependenceResult found = exact_dependence(problem_, *system_, z_, block->equations, block->unknowns);
      if (!found.reason.empty() && block->unknowns.size() == block->equations.size() && invert_densely(*block))
        continue;
      if (!found.reason.empty()) return NoEnclosure{found.reason, contacts_of(problem_, *system_, found.unknowns)};
      for (const std::size_t j : found.unknowns) pinned_[j] = true;
      for (DroppedEquation& d : found.dropped) {
        dropped_[d.equation] = true;
        combinations_.push_back(std::move(d));
      }
    }
    blocks_ = blocks_of(*system_, z_, pinned_, dropped_);
    for (SystemBlock& block : blocks_) {
      if (block.unknowns.size() == block.equations.size() && invert(block, factored_from_)) continue;
      return NoEnclosure{"the forces of these contacts depend on each other, not exactly, but up to rounding",
                         contacts_of(problem_, *system_, block.unknowns)};
    }
    return std::nullopt;
  }

  /// Newton's method with the current inverse, while it converges; true if it converged, so that only rounding is left.
  bool improve() {
    double last = std::numeric_limits<double>::infinity(), size = 0;
    for (int step = 0; step < 20; ++step) {
      const std::vector<double> x = system_->x_at(z_);
      std::vector<double> next = z_;
      double largest = 0;
      for (const SystemBlock& block : blocks_) {
        const std::vector<double> d = newton_step(*system_, block, z_, x);
        for (std::size_t j = 0; j < d.size(); ++j) {
          next[block.unknowns[j]] -= d[j];
          largest = std::max(largest, std::abs(d[j]));
        }
      }
      if (!all_finite(next)) {  // no comparison would notice this
        z_ = std::move(next);
        return false;
      }
      for (const double z : next) size = std::max(size, std::abs(z));
      if (!(largest < 0.7 * last)) {  // the inverse is of another place, or rounding is all that moves
        if (step < 2) z_ = std::move(next);
        return largest <= 1e-6 * size;
      }
      z_ = std::move(next);
      last = largest;
    }
    return last <= 1e-6 * size;
  }

  /// Whether it has what the test of a block of its size takes.
  bool has_inverse(const SystemBlock& block) const {
    return !block.sparse || block.unknowns.size() >= options_.sparse_from;
  }

  std::optional<KrawczykBox> test(const SystemBlock& block) const {
    return block.sparse ? enclose_in_ball(*system_, block, z_) : krawczyk(*system_, block, z_);
  }

  std::variant<Enclosure, NoEnclosure> test() {
    Enclosure result{*system_, z_, std::vector<double>(z_.size(), 0), {}, combinations_, {}, true};
    for (std::size_t j = 0; j < pinned_.size(); ++j) {
      if (pinned_[j]) result.pinned.push_back(j);
    }
    for (SystemBlock& block : blocks_) {
      std::optional<KrawczykBox> box = has_inverse(block) ? test(block) : std::nullopt;
      if (!box && invert(block, options_.sparse_from)) box = test(block);  // the point has moved: its own inverse
      if (!box && block.sparse && invert_densely(block)) box = test(block);
      if (!box) {
        return NoEnclosure{"the equations of these contacts are too close to dependent for binary64",
                           contacts_of(problem_, *system_, block.unknowns)};
      }
      for (std::size_t j = 0; j < block.unknowns.size(); ++j) result.radius[block.unknowns[j]] = box->radius[j];
      result.locally_unique = result.locally_unique && box->unique;
    }
    result.blocks = std::move(blocks_);
    result.locally_unique = result.locally_unique && result.pinned.empty();
    std::vector<std::size_t> border = check_conditions(problem_, result);
    if (border.empty()) return result;
    return NoEnclosure{"these contacts are at a border between modes, closer than rounding can tell", std::move(border),
                       true};
  }

  const MixedProblem& problem_;
  const EnclosureOptions& options_;
  const std::size_t factored_from_;  ///< unknowns of a block from which sparse factors cost less than an inverse
  const std::vector<double> scales_;
  std::optional<ModeSystem> system_;
  std::vector<double> z_;
  std::vector<bool> pinned_, dropped_;
  std::vector<DroppedEquation> combinations_;
  std::vector<SystemBlock> blocks_;
  int dependent_modes_ = 0;
};

}  // namespace

std::variant<Enclosure, NoEnclosure> enclose_solution(const MixedProblem& problem, std::span<const double> x,
                                                      const EnclosureOptions& options) {
  return EnclosureSearch(problem, options).run(x);
}

std::optional<Enclosure> enclose_in_mode(const MixedProblem& problem, std::span<const double> x, ConeMode mode,
                                         const EnclosureOptions& options) {
  return EnclosureSearch(problem, options).run_in(std::move(mode), x);
}

std::optional<Enclosure> enclose_touching(const MixedProblem& problem, std::span<const double> x,
                                          std::span<const std::size_t> contacts, const EnclosureOptions& options) {
  double largest = 0;
  for (std::size_t i = problem.free; i < x.size(); ++i) largest = std::max(largest, std::abs(x[i]));
  const auto pressed = [&](std::size_t k) { return std::abs(x[problem.normal(k)]) > 1e-6 * largest; };
  const bool leans = problem.law.kind == FrictionLaw::associated && problem.dimension > 1;
  if (contacts.empty() || leans || std::ranges::any_of(contacts, pressed)) return std::nullopt;
  ConeMode mode = guess_mode(problem, x, contact_scales(problem));
  for (const std::size_t k : contacts) mode[k] = ConeState::touch;
  return enclose_in_mode(problem, x, std::move(mode), options);
}

std::size_t Enclosure::undetermined() const {
  return static_cast<std::size_t>(std::ranges::count_if(pinned, [this](std::size_t j) {
    const std::size_t place = system.place(j);
    return place == ModeSystem::none || !system.is_zero(place);
  }));
}

std::vector<double> center_of(const Enclosure& enclosure) {
  return enclosure.system.x_at(enclosure.center);
}

double row_radius(const MixedProblem& problem, const Enclosure& box, std::size_t row) {
  double sum = 0;
  const auto columns = problem.A.columns_of(row);
  for (std::size_t e = 0; e < columns.size(); ++e) {
    const std::size_t j = box.system.unknown(columns[e]);
    if (j != ModeSystem::none) sum += std::abs(problem.A.values_of(row)[e]) * box.radius[j];
  }
  return sum > 0 ? rounded_up(sum, columns.size()) + underflow_of(columns.size()) : 0;
}

double distance_from(const Enclosure& enclosure, std::span<const double> x) {
  double distance = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t j = enclosure.system.unknown(i);
    const double center = j == ModeSystem::none ? 0 : enclosure.center[j];
    const double radius = j == ModeSystem::none ? 0 : enclosure.radius[j];
    distance = std::max(distance, (std::abs(x[i] - center) + radius) * (1 + 8 * unit_roundoff));
  }
  return distance;
}

double distance_from(const std::vector<Rational>& solution, std::span<const double> x) {
  double distance = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    distance = std::max(distance, enclose(abs(to_rational(x[i]) - solution[i])).upper);
  }
  return distance;
}

}  // namespace slipproof
