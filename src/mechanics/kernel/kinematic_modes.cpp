#include "mechanics/kernel/kinematic_modes.hpp"

#include <algorithm>
#include <iterator>

#include "base/parallel/stop.hpp"

namespace slipproof {

namespace {

bool has_one_limit(const ProblemElement& e) {
  return e.static_limit.coefficients == e.kinetic_limit.coefficients &&
         e.static_limit.constant == e.kinetic_limit.constant;
}

/// Of accelerations: in a face of the arrangement it is not 0. Where what slips by 0 would not stick, as its limits
/// differ, both are tried.
bool is_kinematic(const ProblemElement& e, StateCondition condition) {
  return condition == StateCondition::opens ||
         ((condition == StateCondition::slips_forward || condition == StateCondition::slips_backward) &&
          has_one_limit(e));
}

/// What must be >= 0, and what must be > 0.
struct FaceConditions {
  std::vector<AffineForm> closed, open;
};

/// Accelerations and forces, and the load behind them.
using Solution = std::vector<Rational>;

Rational at_solution(const AffineForm& form, const Solution& place) {
  Rational sum = form.constant;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (!form.coefficients[i].is_zero()) sum += form.coefficients[i] * place[i];
  }
  return sum;
}

class KinematicTree {
 public:
  KinematicTree(const FrictionProblem& problem, const std::optional<Rational>& load, Effort& effort)
      : problem_(problem), kinds_(kinds_of(problem)), effort_(effort) {
    for (const ProblemElement& e : problem.elements) all_states_have_.push_back(shared_by_states(e));
    if (problem.has_load && !load) add_domain(problem.load_domain);
  }

  std::vector<MechanismMode> search(const std::optional<Rational>& load) {
    AffineSpace space(problem_.unknowns, problem_.has_load);
    bool solvable = !problem_.has_load || !load || space.require(load_minus(*load, problem_.unknowns));
    for (const AffineForm& equation : problem_.equations) solvable = solvable && space.require(equation);
    if (solvable) descend(space, domain_, std::nullopt);
    return std::move(found_);
  }

 private:
  void add_domain(const ForceInterval& domain) {
    const auto end = [&](const std::optional<Rational>& at, int side, bool closed) {
      if (!at) return;
      AffineForm form = load_minus(*at, problem_.unknowns);
      (closed ? domain_.closed : domain_.open).push_back(side > 0 ? form : -form);
    };
    end(domain.lower(), 1, domain.lower_closed());
    end(domain.upper(), -1, domain.upper_closed());
  }

  /// Valid in each state of an element that rests.
  static std::vector<AffineForm> shared_by_states(const ProblemElement& e) {
    std::vector<AffineForm> result;
    if (e.kind.start == ElementKind::Start::open || e.kind.bilateral) return result;
    if (e.kind.law != ElementKind::Law::limited) {
      result.push_back(e.normal);
      result.push_back(e.gap);
    }
    if (e.kind.law != ElementKind::Law::frictionless && has_one_limit(e)) {
      result.push_back(e.static_limit - e.tangent);
      result.push_back(e.static_limit + e.tangent);
    }
    return result;
  }

  void descend(const AffineSpace& space, const FaceConditions& conditions, const std::optional<Solution>& known) {
    stop_if_asked();
    const std::size_t level = mode_.size();
    std::optional<Solution> place = known;
    if (!place && !(place = find_solution(space, conditions))) return;
    if (level == problem_.elements.size()) {
      found_.push_back(mode_);
      return;
    }
    for (const ElementState state : states(kinds_[level])) {
      mode_.push_back(state);
      if (go_together(kinds_, mode_)) enter(space, conditions, state, *place);
      mode_.pop_back();
    }
  }

  /// A place of the branch before is one of this branch if it meets what the state adds.
  void enter(AffineSpace space, FaceConditions conditions, ElementState state, const Solution& before) {
    const ProblemElement& e = problem_.elements[mode_.size() - 1];
    bool here = true;
    for (const StateEquation equation : equations(e.kind, state)) {
      const AffineForm form = form_of(e, state, equation);
      here = here && at_solution(form, before).is_zero();
      if (!space.require(form)) return;
    }
    for (const StateCondition condition : slipproof::conditions(e.kind, state)) {
      AffineForm form = form_of(e, state, condition);
      const int sign = at_solution(form, before).sign();
      here = here && (is_kinematic(e, condition) ? sign > 0 : sign >= 0);
      (is_kinematic(e, condition) ? conditions.open : conditions.closed).push_back(std::move(form));
    }
    descend(space, conditions, here ? std::optional(before) : std::nullopt);
  }

  /// A place in the space that meets the conditions, and what the elements to come always have: where the least of the
  /// open ones is largest.
  std::optional<Solution> find_solution(const AffineSpace& space, const FaceConditions& conditions) {
    std::vector<std::size_t> free = space.free_unknowns();
    const bool load_is_free = problem_.has_load && space.load_is_free();
    std::vector<AffineForm> constraints;
    bool possible = true;
    const auto add = [&](const AffineForm& form, bool open) {
      AffineForm on = compressed(space, free, form);
      if (!load_is_free) on.coefficients.pop_back();
      if (std::ranges::all_of(on.coefficients, [](const Rational& x) { return x.is_zero(); })) {
        possible = possible && (open ? on.constant.sign() > 0 : on.constant.sign() >= 0);
        return;
      }
      on.coefficients.emplace_back(open ? -1 : 0);
      constraints.push_back(std::move(on));
    };
    for (const AffineForm& form : conditions.closed) add(form, false);
    for (const AffineForm& form : conditions.open) add(form, true);
    for (std::size_t i = mode_.size(); i < all_states_have_.size(); ++i) {
      for (const AffineForm& form : all_states_have_[i]) add(form, false);
    }
    if (!possible) return std::nullopt;
    AffineForm objective{0, std::vector<Rational>(free.size() + (load_is_free ? 1 : 0) + 1)};
    objective.coefficients.back() = -1;
    AffineForm at_most_one = objective;
    at_most_one.constant = 1;
    constraints.push_back(std::move(at_most_one));
    const LinearOptimum best = minimize(objective, constraints, effort_);
    if (best.kind != LinearOptimum::Kind::attained || best.value.sign() >= 0) return std::nullopt;
    return solution_of(space, free, best.x);
  }

  Solution solution_of(const AffineSpace& space, const std::vector<std::size_t>& free,
                       const std::vector<Rational>& x) const {
    Solution at_free(problem_.unknowns + 1);
    for (std::size_t i = 0; i < free.size(); ++i) at_free[free[i]] = x[i];
    if (problem_.has_load) at_free.back() = space.load_is_free() ? x[free.size()] : space.load();
    Solution place = at_free;
    for (std::size_t i = 0; i < problem_.unknowns; ++i) {
      if (!space.is_free(i)) place[i] = at_solution(space.fixed(i), at_free);
    }
    return place;
  }

  const FrictionProblem& problem_;
  const std::vector<ElementKind> kinds_;
  Effort& effort_;
  FaceConditions domain_;
  std::vector<std::vector<AffineForm>> all_states_have_;
  MechanismMode mode_;
  std::vector<MechanismMode> found_;
};

}  // namespace

std::vector<ConsistentMode> kinematic_modes(const FrictionProblem& problem, const std::optional<Rational>& load,
                                            Effort& effort) {
  std::vector<ConsistentMode> result;
  for (const MechanismMode& mode : KinematicTree(problem, load, effort).search(load)) {
    std::ranges::move(mode_of(problem, mode, load).consistent, std::back_inserter(result));
  }
  return result;
}

bool has_too_many_to_try(const FrictionProblem& problem) {
  return mode_count(kinds_of(problem)) > max_tried;
}

std::optional<ModesOf> every_mode(const FrictionProblem& problem, const std::optional<Rational>& load) {
  if (!has_too_many_to_try(problem)) return modes_of(problem, load);
  const bool over_loads = problem.has_load && !load;
  if (mode_count(kinds_of(problem)) > (over_loads ? max_listed_over_loads : max_listed)) return std::nullopt;
  try {
    Effort effort(kinematic_effort);
    return ModeSolver(problem, load).all(&effort);
  } catch (const TooMuchWork&) {
    return std::nullopt;
  }
}

std::vector<ConsistentMode> consistent_modes(const FrictionProblem& problem, const std::optional<Rational>& load) {
  if (!has_too_many_to_try(problem)) return ModeSolver(problem, load).consistent();
  Effort effort(kinematic_effort);
  return kinematic_modes(problem, load, effort);
}

}  // namespace slipproof
