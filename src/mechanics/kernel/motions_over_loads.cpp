#include "mechanics/kernel/motions_over_loads.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "mechanics/kernel/kinematic_modes.hpp"

namespace slipproof {

namespace {

class KernelMotions final : public MotionsOverLoads {
 public:
  KernelMotions(FrictionProblem problem, const std::optional<std::vector<MechanismMode>>& only)
      : problem_(without_equations(problem)), kinds_(kinds_of(problem_)) {
    if (only) {
      consistent_ = consistent_among(*only);
    } else {
      consistent_ = consistent_modes(problem_, std::nullopt);
      all_tried_ = !has_too_many_to_try(problem_);
    }
    for (const ConsistentMode& mode : consistent_) strict_.push_back(strict_loads(mode.solutions));
  }

  std::optional<ModeOverLoads> find(const MechanismMode& mode) const override {
    if (!is_modelled(mode)) return std::nullopt;
    const ConsistentMode* found = consistent(mode);
    if (found == nullptr) return all_tried_ ? ModeOverLoads{&nothing_, &nothing_, false} : find_alone(mode);
    return ModeOverLoads{&found->solutions.loads, &strict_[static_cast<std::size_t>(found - consistent_.data())],
                         !found->determined};
  }

  const ModeForms* forms(const MechanismMode& mode) const override {
    const std::scoped_lock one_at_a_time(mutex_);
    const auto [entry, is_new] = forms_.try_emplace(mode);
    if (is_new) {
      if (const auto space = space_of(mode)) entry->second = FormsOn(problem_, *space).of(mode);
    }
    return entry->second ? &*entry->second : nullptr;
  }

  std::vector<LoadCell> cells(Detail detail, const std::vector<MechanismMode>& named) const override {
    if (all_tried_ || named.empty()) return cells_of(problem_, consistent_, detail);
    std::vector<MechanismMode> more = named;
    std::erase_if(more, [&](const MechanismMode& mode) { return consistent(mode) != nullptr; });
    std::vector<ConsistentMode> modes = consistent_among(std::move(more));
    modes.insert(modes.begin(), consistent_.begin(), consistent_.end());
    return cells_of(problem_, modes, detail);
  }

  bool all_tried() const override { return all_tried_; }

 private:
  /// Those of some modes that are modelled and have solutions, each once.
  std::vector<ConsistentMode> consistent_among(std::vector<MechanismMode> modes) const {
    std::erase_if(modes, [&](const MechanismMode& mode) { return !is_modelled(mode); });
    std::ranges::sort(modes);
    const auto twice = std::ranges::unique(modes);
    modes.erase(twice.begin(), twice.end());
    return ModeSolver(problem_, std::nullopt, states_in(modes, problem_.elements.size())).consistent_among(modes);
  }

  /// Null for a mode that was not found.
  const ConsistentMode* consistent(const MechanismMode& mode) const {
    const auto found = std::ranges::find(consistent_, mode, &ConsistentMode::mode);
    return found == consistent_.end() ? nullptr : &*found;
  }

  /// The solutions of a mode's equations, whatever its conditions; nothing if there are none.
  std::optional<AffineSpace> space_of(const MechanismMode& mode) const {
    if (const ConsistentMode* found = consistent(mode)) {
      const auto& [solved, sides, strict, loads] = found->solutions;
      const bool all_loads = solved.load_is_free() || !problem_.has_load;
      if (strict && all_loads && solved.dimension() == 0) return solved;  // no condition has become an equation
    }
    AffineSpace space(problem_.unknowns, problem_.has_load);
    for (const AffineForm& equation : problem_.equations) {
      if (!space.require(equation)) return std::nullopt;
    }
    for (std::size_t i = 0; i < mode.size(); ++i) {
      const ProblemElement& element = problem_.elements[i];
      for (const StateEquation equation : equations(element.kind, mode[i])) {
        if (!space.require(form_of(element, mode[i], equation))) return std::nullopt;
      }
    }
    return space;
  }

  /// A mode that was not tried; kept, as its intervals are given out.
  struct Alone {
    ForceInterval closed = ForceInterval::nothing(), strict = ForceInterval::nothing();
    bool continuum = false;
  };
  ModeOverLoads find_alone(const MechanismMode& mode) const {
    const std::scoped_lock one_at_a_time(mutex_);
    const auto [entry, is_new] = alone_.try_emplace(mode);
    Alone& alone = entry->second;
    if (is_new) {
      for (const ConsistentMode& c : mode_of(problem_, mode, std::nullopt).consistent) {
        alone = {c.solutions.loads, strict_loads(c.solutions), !c.determined};
      }
    }
    return {&alone.closed, &alone.strict, alone.continuum};
  }

  /// The forms of a problem over what a space leaves free.
  class FormsOn {
   public:
    FormsOn(const FrictionProblem& problem, const AffineSpace& space)
        : problem_(problem), space_(space), free_(space.free_unknowns()) {}

    ModeForms of(const MechanismMode& mode) const {
      ModeForms result;
      result.free = free_.size();
      for (const AffineForm& form : problem_.accelerations) result.accelerations.push_back(on_free(form));
      for (const AffineForm& form : problem_.forces) result.forces.push_back(on_free(form));
      for (std::size_t i = 0; i < mode.size(); ++i) {
        const ProblemElement& element = problem_.elements[i];
        for (const StateCondition condition : conditions(element.kind, mode[i])) {
          result.conditions.push_back(on_free(form_of(element, mode[i], condition)));
        }
      }
      return result;
    }

   private:
    AffineForm on_free(const AffineForm& form) const { return compressed(space_, free_, form); }

    const FrictionProblem& problem_;
    const AffineSpace& space_;
    std::vector<std::size_t> free_;
  };

  bool is_modelled(const MechanismMode& mode) const { return has_mode(kinds_, mode); }

  FrictionProblem problem_;
  std::vector<ElementKind> kinds_;
  std::vector<ConsistentMode> consistent_;
  std::vector<ForceInterval> strict_;
  bool all_tried_ = true;
  mutable std::mutex mutex_;  ///< of what is found on demand
  mutable std::map<MechanismMode, Alone> alone_;
  mutable std::map<MechanismMode, std::optional<ModeForms>> forms_;
  ForceInterval nothing_ = ForceInterval::nothing();
};

}  // namespace

std::unique_ptr<const MotionsOverLoads> motions_over_loads(FrictionProblem problem,
                                                           const std::optional<std::vector<MechanismMode>>& only) {
  return std::make_unique<const KernelMotions>(std::move(problem), only);
}

}  // namespace slipproof
