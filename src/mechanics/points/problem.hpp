// A mechanism at values of its parameters, as input of the kernel.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "mechanics/elements/friction_problem.hpp"
#include "mechanics/mechanism/compiled.hpp"

namespace slipproof {

/// One point of a mechanism, apart from its load.
struct MechanismValues {
  struct Circle {
    Rational cosine = 1, sine = 0;  ///< on the unit circle
    bool operator==(const Circle&) const = default;
  };
  std::vector<Rational> parameters;
  std::vector<bool> given;  ///< whether each has a value; those without one are 0
  std::vector<Circle> angles;
  std::vector<ElementKind::Start> starts;  ///< of each element, before the motion

  bool operator==(const MechanismValues&) const = default;
};
/// All parameters 0 and given, all angles 0, and the file's states.
MechanismValues default_values(const Mechanism& mechanism);

/// A coefficient that has no value, because it divides by zero.
class NoValue : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Problems of one mechanism at many points.
class ProblemMaker {
 public:
  /// The mechanism must outlive the maker.
  explicit ProblemMaker(const Mechanism& mechanism) : mechanism_(&mechanism), compiled_(mechanism) {}
  const CompiledMechanism& compiled() const { return compiled_; }

  /// Unknowns in the order of the mechanism's; accelerations and forces as acceleration_names() and force_names() name
  /// them; elements: contacts, then friction elements. Throws NoValue, naming what has none.
  FrictionProblem problem(const MechanismValues& values) const;
  /// The loads that the domain admits; nothing() where a bound has no value. The whole line without a load.
  ForceInterval load_domain(const MechanismValues& values) const;
  /// An evaluator with the values set, apart from the load.
  Evaluator<Rational> at(const MechanismValues& values) const;
  /// The conditions that do not hold: domains of parameters that are given and of angles, then those of [assume].
  /// Each with the place of the condition in the mechanism's file.
  struct Broken {
    enum class What { parameter, angle, assumption } what;
    std::size_t index;
    const PlacedExpression* condition;
  };
  std::vector<Broken> broken(const MechanismValues& values) const;

 private:
  const Mechanism* mechanism_;
  CompiledMechanism compiled_;
};

/// What is said where the motions among so many modes were not found within the effort.
std::string too_many_modes(double modes);
/// Throws InputError if there are more modes than are tried (max_modes), before any work, where each is needed; `kinds`
/// as element_kinds() gives them.
void refuse_too_many_modes(const Mechanism& mechanism, const std::vector<ElementKind>& kinds);

/// The problem of one point; ProblemMaker is faster for several. Throws NoValue.
FrictionProblem friction_problem(const Mechanism& mechanism, const MechanismValues& values);

}  // namespace slipproof
