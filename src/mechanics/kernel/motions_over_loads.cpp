#include "mechanics/kernel/motions_over_loads.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include "mechanics/kernel/kinematic_modes.hpp"

namespace slipproof {

namespace {

/// Friction in cones, T1^2 + T2^2 <= L^2, beside the linear conditions of a mode, in a problem without a load.
class InCones {
 public:
  enum class Exists : std::uint8_t { yes, on_boundary, no, unknown };

  InCones(const FrictionProblem& problem, const ConsistentMode& mode)
      : solutions_(mode.solutions), strict_(mode.solutions.strict) {
    for (std::size_t i = 0; i < mode.mode.size(); ++i) {
      const ProblemElement& e = problem.elements[i];
      if (!holds_in_cone(e.kind, mode.mode[i])) continue;
      const AffineSpace& space = solutions_.space;
      Cone cone{space.on(e.tangent), space.on(e.second_tangent), space.on(e.static_limit)};
      cone.is_determined() ? add_determined(cone) : open_.push_back(std::move(cone));
    }
  }

  /// Where forces are not determined, a motion exists if it does with friction in polygons in the circles, and none
  /// exists if it does not with friction in polygons around them.
  Exists exists() const {
    if (outside_) return Exists::no;
    if (open_.empty()) return strict_ ? Exists::yes : Exists::on_boundary;
    for (int steps = 2; steps <= 32; steps *= 4) {
      const auto inside = within(polygons(steps, &InCones::chord));
      if (inside && (inside->strict || !strict_)) return strict_ ? Exists::yes : Exists::on_boundary;
      const auto around = within(polygons(steps, &InCones::tangent));
      if (!around) return Exists::no;
      if (inside && !around->strict) return Exists::on_boundary;
    }
    return Exists::unknown;
  }

 private:
  struct Cone {
    AffineForm first, second, limit;
    bool is_determined() const { return is_constant(first) && is_constant(second) && is_constant(limit); }
  };
  struct Corner {
    Rational x, y;
  };

  void add_determined(const Cone& cone) {
    const Rational &x = cone.first.constant, &y = cone.second.constant, &limit = cone.limit.constant;
    const int room = sign(Rational(limit * limit - x * x - y * y));
    outside_ = outside_ || room < 0;
    strict_ = strict_ && room > 0;
  }

  /// Rational points of the circle, counterclockwise: a quarter of it has so many steps of the tangent of half the
  /// angle.
  static std::vector<Corner> corners(int steps) {
    std::vector<Corner> result;
    for (int k = 0; k < steps; ++k) {
      const Rational t = Rational(k) / steps, whole = 1 + t * t;
      result.push_back({Rational((1 - t * t) / whole), Rational(2 * t / whole)});
    }
    for (int k = 0; k < 3 * steps; ++k) {
      const Corner before = result[result.size() - static_cast<std::size_t>(steps)];
      result.push_back({-before.y, before.x});
    }
    return result;
  }

  /// at_limit * limit - x * first - y * second
  static AffineForm side(const Cone& cone, const Rational& at_limit, const Rational& x, const Rational& y) {
    AffineForm form = cone.limit;
    const auto entry = [&](Rational& to, const Rational& first, const Rational& second) {
      to = at_limit * to - x * first - y * second;
    };
    entry(form.constant, cone.first.constant, cone.second.constant);
    for (std::size_t i = 0; i < form.coefficients.size(); ++i)
      entry(form.coefficients[i], cone.first.coefficients[i], cone.second.coefficients[i]);
    return form;
  }
  static AffineForm tangent(const Cone& cone, const Corner& at, const Corner&) { return side(cone, 1, at.x, at.y); }
  static AffineForm chord(const Cone& cone, const Corner& from, const Corner& to) {
    const Rational x = to.y - from.y, y = from.x - to.x;
    return side(cone, x * from.x + y * from.y, x, y);
  }

  template <class Side>
  std::vector<AffineForm> polygons(int steps, const Side& side_of) const {
    const std::vector<Corner> all = corners(steps);
    std::vector<AffineForm> sides;
    for (const Cone& cone : open_) {
      for (std::size_t k = 0; k < all.size(); ++k) sides.push_back(side_of(cone, all[k], all[(k + 1) % all.size()]));
    }
    return sides;
  }
  std::optional<Polyhedron> within(std::vector<AffineForm> sides) const {
    sides.insert(sides.end(), solutions_.sides.begin(), solutions_.sides.end());
    Narrowed narrowed = narrow(solutions_.space, sides, ForceInterval());
    auto* result = std::get_if<Polyhedron>(&narrowed);
    return result == nullptr ? std::nullopt : std::optional(std::move(*result));
  }

  const Polyhedron& solutions_;
  bool strict_, outside_ = false;
  std::vector<Cone> open_;
};

class KernelMotions final : public MotionsOverLoads {
 public:
  KernelMotions(FrictionProblem problem, const std::optional<std::vector<MechanismMode>>& only)
      : problem_(without_equations(problem)), kinds_(kinds_of(problem_)) {
    if (only) {
      consistent_ = consistent_among(*only);
    } else if (has_cones()) {  // kinematics does not know them
      consistent_ = in_cones(ModeSolver(problem_, std::nullopt).consistent());
    } else {
      consistent_ = consistent_modes(problem_, std::nullopt);
      all_tried_ = !has_too_many_to_try(problem_);
    }
    for (const ConsistentMode& mode : consistent_) strict_.push_back(strict_loads(mode.solutions));
  }

  std::optional<ModeOverLoads> find(const MechanismMode& mode) const override {
    if (!is_modelled(mode) || unknown_.contains(mode)) return std::nullopt;
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
    modes.erase(std::unique(modes.begin(), modes.end()), modes.end());
    return in_cones(
        ModeSolver(problem_, std::nullopt, states_in(modes, problem_.elements.size())).consistent_among(modes));
  }

  bool has_cones() const {
    return std::ranges::any_of(kinds_, [](const ElementKind& kind) { return kind.law == ElementKind::Law::cone; });
  }
  /// Those that have a motion with friction in its cones.
  std::vector<ConsistentMode> in_cones(std::vector<ConsistentMode> modes) const {
    if (!has_cones()) return modes;
    std::erase_if(modes, [&](ConsistentMode& mode) {
      using Exists = InCones::Exists;
      const Exists exists = InCones(problem_, mode).exists();
      if (exists == Exists::on_boundary) mode.solutions.strict = false;
      if (exists == Exists::unknown) unknown_.insert(mode.mode);
      return exists == Exists::no || exists == Exists::unknown;
    });
    return modes;
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
        if (!holds_in_cone(element.kind, mode[i])) continue;
        for (const AffineForm* form : {&element.tangent, &element.second_tangent, &element.static_limit})
          result.with_cones = result.with_cones || !is_free_of_unknowns(on_free(*form));
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
  mutable std::set<MechanismMode> unknown_;  ///< filled before the modes are asked for
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
