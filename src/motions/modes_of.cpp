#include "motions/modes_of.hpp"

#include <algorithm>
#include <utility>

namespace slipproof {

namespace {

/// The tree of modes: a level for each element, a branch for each of its states.
class ModeTree {
 public:
  ModeTree(const FrictionProblem& problem, std::vector<std::vector<ElementState>> states, ForceInterval domain)
      : problem_(problem), states_(std::move(states)), domain_(std::move(domain)) {}

  ModesOf search(const std::optional<Rational>& load) {
    AffineSpace space(problem_.unknowns, problem_.has_load);
    bool solvable = true;
    if (load && problem_.has_load) {
      solvable = space.require(load_minus(*load, problem_.unknowns));
    }
    for (const AffineForm& equation : problem_.equations) solvable = solvable && space.require(equation);
    if (solvable) {
      descend(space);
    } else {
      reject({}, std::nullopt);
    }
    return std::move(result_);
  }

 private:
  void descend(const AffineSpace& space) {
    const std::size_t level = mode_.size();
    if (level == states_.size()) return finish(space);
    const ProblemElement& element = problem_.elements[level];
    for (const ElementState state : states_[level]) {
      mode_.push_back(state);
      const std::size_t outer = conditions_.size();
      AffineSpace inner = space;
      bool solvable = true;
      for (const StateEquation e : equations(element.kind, state)) {
        solvable = solvable && inner.require(form_of(element, state, e));
      }
      for (const StateCondition c : conditions(element.kind, state)) {
        conditions_.push_back(form_of(element, state, c));
        labels_.push_back({level, state, c});
      }
      if (!solvable) {
        reject({}, std::nullopt);
      } else if (!is_hopeless(inner)) {
        descend(inner);
      }
      conditions_.resize(outer);
      labels_.resize(outer);
      mode_.pop_back();
    }
  }

  /// Whether the states so far exclude each other; then all modes that begin with them are rejected. Where few are left
  /// they cost no more than this, and each has a reason of its own.
  bool is_hopeless(const AffineSpace& space) {
    const std::size_t left = states_.size() - mode_.size();
    if (left == 0 || (left == 1 && states_.size() < 4) || !branches()) return false;
    const auto conflict = find_conflict(space, conditions_, domain_);
    if (conflict) reject(because(*conflict), conflict->margin);
    return conflict.has_value();
  }

  /// Whether several modes begin with the states so far.
  bool branches() const {
    return std::any_of(states_.begin() + static_cast<std::ptrdiff_t>(mode_.size()), states_.end(),
                       [](const auto& states) { return states.size() > 1; });
  }

  void finish(const AffineSpace& space) {
    Narrowed narrowed = narrow(space, conditions_, domain_);
    if (const auto* conflict = std::get_if<Conflict>(&narrowed)) return reject(because(*conflict), conflict->margin);
    result_.consistent.push_back(consistent_mode(problem_, mode_, std::move(std::get<Polyhedron>(narrowed))));
  }

  std::vector<ViolatedCondition> because(const Conflict& conflict) const {
    std::vector<ViolatedCondition> result;
    for (const std::size_t i : conflict.conditions) result.push_back(labels_[i]);
    return result;
  }

  /// All modes that begin with the states so far.
  void reject(const std::vector<ViolatedCondition>& reasons, const std::optional<Rational>& margin) {
    const std::size_t level = mode_.size();
    if (level == states_.size()) {
      result_.rejected.push_back({mode_, reasons, margin});
      return;
    }
    for (const ElementState state : states_[level]) {
      mode_.push_back(state);
      reject(reasons, margin);
      mode_.pop_back();
    }
  }

  const FrictionProblem& problem_;
  std::vector<std::vector<ElementState>> states_;
  ForceInterval domain_;
  MechanismMode mode_;
  std::vector<AffineForm> conditions_;
  std::vector<ViolatedCondition> labels_;
  ModesOf result_;
};

/// A form over the free variables of a space, and the load.
AffineForm compressed(const AffineSpace& space, const std::vector<std::size_t>& free, const AffineForm& form) {
  if (form.coefficients.empty()) return form;
  AffineForm whole = space.on(form), result{std::move(whole.constant), {}};
  for (const std::size_t i : free) result.coefficients.push_back(std::move(whole.coefficients[i]));
  result.coefficients.push_back(std::move(whole.coefficients.back()));
  return result;
}

ForceInterval domain_for(const FrictionProblem& problem, const std::optional<Rational>& load) {
  return load || !problem.has_load ? ForceInterval() : problem.load_domain;
}

}  // namespace

ConsistentMode consistent_mode(const FrictionProblem& problem, const MechanismMode& mode, Polyhedron solutions) {
  const bool determined =
      std::all_of(problem.accelerations.begin(), problem.accelerations.end(),
                  [&](const AffineForm& form) { return is_free_of_unknowns(solutions.space.on(form)); });
  return {mode, std::move(solutions), determined};
}

ForceInterval ConsistentMode::strict_loads() const {
  if (!solutions.strict) return ForceInterval::nothing();
  const ForceInterval& loads = solutions.loads;
  if (loads.is_point()) return loads;
  const auto strict_at = [&](const std::optional<Rational>& end, bool closed) {
    return closed && at_load(solutions, *end)->strict;
  };
  return ForceInterval::between(loads.lower(), strict_at(loads.lower(), loads.lower_closed()), loads.upper(),
                                strict_at(loads.upper(), loads.upper_closed()));
}

FrictionProblem without_equations(const FrictionProblem& problem) {
  AffineSpace space(problem.unknowns, problem.has_load);
  for (const AffineForm& equation : problem.equations) {
    if (!space.require(equation)) return problem;
  }
  if (problem.has_load && !space.load_is_free()) return problem;
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < problem.unknowns; ++i) {
    if (space.is_free(i)) free.push_back(i);
  }
  FrictionProblem result = problem;
  result.equations.clear();
  result.unknowns = free.size();
  const auto compress = [&](AffineForm& form) { form = compressed(space, free, form); };
  for (AffineForm& form : result.accelerations) compress(form);
  for (AffineForm& form : result.forces) compress(form);
  for (ProblemElement& e : result.elements) {
    for (AffineForm* form : {&e.gap, &e.normal, &e.slip, &e.tangent, &e.static_limit, &e.kinetic_limit})
      compress(*form);
  }
  return result;
}

ModesOf modes_of(const FrictionProblem& problem, const std::optional<Rational>& load) {
  std::vector<std::vector<ElementState>> all;
  for (const ProblemElement& element : problem.elements) all.push_back(states(element.kind));
  return ModeTree(problem, std::move(all), domain_for(problem, load)).search(load);
}

ModesOf mode_of(const FrictionProblem& problem, const MechanismMode& mode, const std::optional<Rational>& load) {
  std::vector<std::vector<ElementState>> one;
  for (const ElementState state : mode) one.push_back({state});
  return ModeTree(problem, std::move(one), domain_for(problem, load)).search(load);
}

}  // namespace slipproof
