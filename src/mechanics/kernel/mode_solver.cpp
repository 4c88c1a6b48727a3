#include "mechanics/kernel/mode_solver.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "base/parallel/stop.hpp"

namespace slipproof {

namespace {

/// The modes that elements with these states have, by their numbers in the order of enumeration.
class ModeNumbers {
 public:
  explicit ModeNumbers(const StatesOfElements& states) : states_(states) {
    below_.assign(states.size() + 1, 1);
    for (std::size_t i = states.size(); i > 0; --i) below_[i - 1] = below_[i] * states[i - 1].size();
  }

  std::uint64_t count() const { return below_.front(); }
  /// How many modes begin with the same states of so many elements.
  std::uint64_t that_share(std::size_t elements) const { return below_[elements]; }
  MechanismMode mode(std::uint64_t number) const {
    MechanismMode result;
    for (std::size_t i = 0; i < states_.size(); ++i) {
      result.push_back(states_[i][number / below_[i + 1]]);
      number %= below_[i + 1];
    }
    return result;
  }

 private:
  const StatesOfElements& states_;
  std::vector<std::uint64_t> below_;
};

/// The conditions of the states of some elements, and their kinds.
struct ModeConditions {
  std::vector<AffineForm> forms;
  std::vector<ViolatedCondition> labels;

  void add(const FrictionProblem& problem, std::size_t element, ElementState state) {
    const ProblemElement& e = problem.elements[element];
    for (const StateCondition c : conditions(e.kind, state)) {
      forms.push_back(form_of(e, state, c));
      labels.push_back({element, state, c});
    }
  }
  void resize(std::size_t count) {
    forms.resize(count);
    labels.resize(count);
  }
};

std::vector<ViolatedCondition> because(const Conflict& conflict, const std::vector<ViolatedCondition>& labels) {
  std::vector<ViolatedCondition> result;
  for (const std::size_t i : conflict.conditions) result.push_back(labels[i]);
  return result;
}

/// What is found, by the numbers of the modes.
struct NumberedModes {
  std::map<std::uint64_t, ConsistentMode> consistent;
  std::map<std::uint64_t, RejectedMode> rejected;
  bool tells_rejected;

  /// What is left of a mode's solutions.
  void add(const FrictionProblem& problem, std::uint64_t number, const MechanismMode& mode, Narrowed narrowed,
           const std::vector<ViolatedCondition>& labels) {
    if (auto* solutions = std::get_if<Polyhedron>(&narrowed)) {
      consistent.emplace(number, consistent_mode(problem, mode, std::move(*solutions)));
    } else {
      auto& conflict = std::get<Conflict>(narrowed);
      reject(number, {mode, because(conflict, labels), std::move(conflict.margin)});
    }
  }

  void reject(std::uint64_t number, RejectedMode mode) {
    if (tells_rejected) rejected.emplace(number, std::move(mode));
  }

  ModesOf in_order() && {
    ModesOf result;
    for (auto& [number, mode] : consistent) result.consistent.push_back(std::move(mode));
    for (auto& [number, mode] : rejected) result.rejected.push_back(std::move(mode));
    return result;
  }
};

/// The tree of the modes that are left to elimination: a level for each element, a branch for each of its states.
class ModeTree {
 public:
  using Numbers = std::vector<std::uint64_t>;

  ModeTree(const FrictionProblem& problem, const StatesOfElements& states, const ModeNumbers& numbers,
           const ForceInterval& domain, Effort* effort, NumberedModes& result)
      : problem_(problem), states_(states), numbers_(numbers), domain_(domain), effort_(effort), result_(result) {}

  /// `left` are the modes to try, in order.
  void search(const std::optional<Rational>& load, const Numbers& left) {
    if (left.empty()) return;
    AffineSpace space(problem_.unknowns, problem_.has_load);
    bool solvable = true;
    if (load && problem_.has_load) {
      solvable = space.require(load_minus(*load, problem_.unknowns));
    }
    for (const AffineForm& equation : problem_.equations) solvable = solvable && space.require(equation);
    const Branch all{left.begin(), left.end(), 0};
    if (solvable) {
      descend(space, all);
    } else {
      reject(all, {}, std::nullopt);
    }
  }

 private:
  /// Modes that begin alike: those to try, and the number of the first there is.
  struct Branch {
    Numbers::const_iterator begin, end;
    std::uint64_t first;
    std::size_t size() const { return static_cast<std::size_t>(end - begin); }
  };

  void descend(const AffineSpace& space, const Branch& branch) {
    const std::size_t level = mode_.size();
    if (level == states_.size()) return finish(space, *branch.begin);
    const ProblemElement& element = problem_.elements[level];
    Branch inner = branch;
    for (const ElementState state : states_[level]) {
      stop_if_asked();
      const std::uint64_t beyond = inner.first + numbers_.that_share(level + 1);
      inner.end = std::lower_bound(inner.begin, branch.end, beyond);
      if (inner.size() > 0) go_into(space, element, state, inner);
      inner = {inner.end, branch.end, beyond};
    }
  }

  void go_into(AffineSpace space, const ProblemElement& element, ElementState state, const Branch& branch) {
    const std::size_t outer = conditions_.forms.size(), level = mode_.size();
    mode_.push_back(state);
    bool solvable = true;
    for (const StateEquation e : equations(element.kind, state)) {
      solvable = solvable && space.require(form_of(element, state, e));
    }
    conditions_.add(problem_, level, state);
    if (!solvable) {
      reject(branch, {}, std::nullopt);
    } else if (!is_hopeless(space, branch)) {
      descend(space, branch);
    }
    conditions_.resize(outer);
    mode_.pop_back();
  }

  /// Whether the states so far exclude each other; then all modes that begin with them are rejected. Where few are left
  /// they cost no more than this, and each has a reason of its own.
  bool is_hopeless(const AffineSpace& space, const Branch& branch) {
    const std::size_t left = states_.size() - mode_.size();
    if (left == 0 || (left == 1 && states_.size() < 4) || branch.size() == 1) return false;
    const auto conflict = find_conflict(space, conditions_.forms, domain_, effort_);
    if (conflict) reject(branch, because(*conflict, conditions_.labels), conflict->margin);
    return conflict.has_value();
  }

  void finish(const AffineSpace& space, std::uint64_t number) {
    result_.add(problem_, number, mode_, narrow(space, conditions_.forms, domain_, effort_), conditions_.labels);
  }

  void reject(const Branch& branch, const std::vector<ViolatedCondition>& reasons,
              const std::optional<Rational>& margin) {
    for (auto number = branch.begin; number != branch.end; ++number) {
      result_.reject(*number, {numbers_.mode(*number), reasons, margin});
    }
  }

  const FrictionProblem& problem_;
  const StatesOfElements& states_;
  const ModeNumbers& numbers_;
  const ForceInterval& domain_;
  Effort* effort_;
  NumberedModes& result_;
  MechanismMode mode_;
  ModeConditions conditions_;
};

StatesOfElements only(const MechanismMode& mode) {
  StatesOfElements states;
  for (const ElementState state : mode) states.push_back({state});
  return states;
}

StatesOfElements all_states(const FrictionProblem& problem) {
  StatesOfElements all;
  for (const ProblemElement& element : problem.elements) all.push_back(states(element.kind));
  return all;
}

ForceInterval domain_for(const FrictionProblem& problem, const std::optional<Rational>& load) {
  return load || !problem.has_load ? ForceInterval() : problem.load_domain;
}

}  // namespace

ConsistentMode consistent_mode(const FrictionProblem& problem, const MechanismMode& mode, Polyhedron solutions) {
  const bool determined =
      solutions.space.dimension() == 0 ||
      std::all_of(problem.accelerations.begin(), problem.accelerations.end(),
                  [&](const AffineForm& form) { return is_free_of_unknowns(solutions.space.on(form)); });
  return {mode, std::move(solutions), determined};
}

FrictionProblem without_equations(const FrictionProblem& problem) {
  AffineSpace space(problem.unknowns, problem.has_load);
  for (const AffineForm& equation : problem.equations) {
    if (!space.require(equation)) return problem;
  }
  if (problem.has_load && !space.load_is_free()) return problem;
  const std::vector<std::size_t> free = space.free_unknowns();
  FrictionProblem result = problem;
  result.equations.clear();
  result.unknowns = free.size();
  const auto compress = [&](AffineForm& form) {
    if (!form.coefficients.empty()) form = compressed(space, free, form);  // of what an element does not have: empty
  };
  for (AffineForm& form : result.accelerations) compress(form);
  for (AffineForm& form : result.forces) compress(form);
  for (ProblemElement& e : result.elements) visit_forms(e, compress);
  return result;
}

StatesOfElements states_in(const std::vector<MechanismMode>& modes, std::size_t elements) {
  StatesOfElements found(elements);
  for (const MechanismMode& mode : modes) {
    for (std::size_t i = 0; i < elements; ++i) {
      if (std::find(found[i].begin(), found[i].end(), mode[i]) == found[i].end()) found[i].push_back(mode[i]);
    }
  }
  return found;
}

ModeSolver::ModeSolver(const FrictionProblem& problem, const std::optional<Rational>& load)
    : ModeSolver(problem, load, all_states(problem)) {}

ModeSolver::ModeSolver(const FrictionProblem& problem, const std::optional<Rational>& load, StatesOfElements states)
    : problem_(problem),
      load_(load),
      domain_(domain_for(problem, load)),
      states_(std::move(states)),
      regular_(problem, load, states_) {}

ModesOf ModeSolver::among(const StatesOfElements& states, Rejected rejected, Effort* effort,
                          const ModeFilter* filter) const {
  using Kind = RegularModes::Outcome::Kind;
  const ModeNumbers numbers(states);
  const std::vector<ElementKind> kinds = kinds_of(problem_);
  NumberedModes result{{}, {}, rejected == Rejected::reported};
  ModeTree::Numbers singular;
  for (std::uint64_t number = 0; number < numbers.count(); ++number) {
    stop_if_asked();
    const MechanismMode mode = numbers.mode(number);
    if (!go_together(kinds, mode)) continue;
    if (filter != nullptr && filter->excludes(mode)) continue;
    RegularModes::Outcome outcome = regular_.solve(mode, effort);
    if (outcome.kind == Kind::singular) {
      singular.push_back(number);
    } else if (outcome.kind == Kind::inconsistent) {
      result.reject(number, {mode, {}, std::nullopt});
    } else if (outcome.kind == Kind::violated) {
      result.reject(number, {mode, {outcome.violation->condition}, std::move(outcome.violation->margin)});
    } else {
      ModeConditions conditions;
      for (std::size_t i = 0; i < mode.size(); ++i) conditions.add(problem_, i, mode[i]);
      result.add(problem_, number, mode,
                 narrow(std::move(*outcome.space), conditions.forms, domain_, effort, std::move(outcome.conditions)),
                 conditions.labels);
    }
  }
  ModeTree(problem_, states, numbers, domain_, effort, result).search(load_, singular);
  return std::move(result).in_order();
}

ModesOf ModeSolver::all(Effort* effort) const {
  return among(states_, Rejected::reported, effort);
}

std::vector<ConsistentMode> ModeSolver::consistent(Effort* effort) const {
  if (effort != nullptr) return among(states_, Rejected::left_out, effort).consistent;
  const ModeFilter sure = filter();
  return among(states_, Rejected::left_out, nullptr, &sure).consistent;
}

std::vector<ConsistentMode> ModeSolver::consistent_among(const std::vector<MechanismMode>& modes) const {
  const ModeFilter sure = filter();
  std::vector<ConsistentMode> result;
  for (const MechanismMode& mode : modes) {
    std::ranges::move(among(only(mode), Rejected::left_out, nullptr, &sure).consistent, std::back_inserter(result));
  }
  return result;
}

ModesOf ModeSolver::one(const MechanismMode& mode, Effort* effort) const {
  return among(only(mode), Rejected::reported, effort);
}

ModesOf modes_of(const FrictionProblem& problem, const std::optional<Rational>& load) {
  return ModeSolver(problem, load).all();
}

ModesOf mode_of(const FrictionProblem& problem, const MechanismMode& mode, const std::optional<Rational>& load) {
  return ModeSolver(problem, load, only(mode)).one(mode);
}

}  // namespace slipproof
