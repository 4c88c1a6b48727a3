// The modes of a problem, one by one: which of them have solutions, for one load or for all, and why the others have
// none.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mechanics/kernel/mode_filter.hpp"
#include "mechanics/kernel/motion.hpp"
#include "mechanics/kernel/regular_modes.hpp"

namespace slipproof {

/// A mode with its solutions; says whether they are one motion for each load.
ConsistentMode consistent_mode(const FrictionProblem& problem, const MechanismMode& mode, Polyhedron solutions);

/// More modes are not tried.
inline constexpr std::uint64_t max_modes = 65'536;

/// Solves the modes of a problem, which must outlive it: at one load, also outside the domain, or for all loads of the
/// domain. Immutable once constructed.
class ModeSolver {
 public:
  ModeSolver(const FrictionProblem& problem, const std::optional<Rational>& load);
  /// For modes of these states only.
  ModeSolver(const FrictionProblem& problem, const std::optional<Rational>& load, StatesOfElements states);

  /// All modes; their number must be at most max_modes. Takes one elimination in integers for each. Those whose
  /// equations leave something open are then tried state by state, with a few linear programs each: what already
  /// contradicts itself for the first elements is not gone into. Throws TooMuchWork beyond an effort.
  ModesOf all(Effort* effort = nullptr) const;
  /// Only the consistent modes, without reasons for the others. Unless an effort is given, binary64 excludes most of
  /// the others.
  std::vector<ConsistentMode> consistent(Effort* effort = nullptr) const;
  /// Those of some modes, with a state for each element, in the order in which they are given.
  std::vector<ConsistentMode> consistent_among(const std::vector<MechanismMode>& modes) const;
  /// One mode, with a state for each element. A rejected one has a single condition with its margin if one fails for
  /// all forces; if not, no fewer of the conditions exclude each other.
  ModesOf one(const MechanismMode& mode, Effort* effort = nullptr) const;

  /// Of a mode that leaves so many unknowns to elimination; without linear programs.
  Work work_of(std::size_t unknowns) const { return regular_.work_of(unknowns); }

 private:
  enum class Rejected { reported, left_out };
  /// What the filter excludes is rejected without a reason.
  ModesOf among(const StatesOfElements& states, Rejected rejected, Effort* effort,
                const ModeFilter* filter = nullptr) const;
  ModeFilter filter() const { return {problem_, load_, domain_, states_}; }

  const FrictionProblem& problem_;
  std::optional<Rational> load_;
  ForceInterval domain_;
  StatesOfElements states_;
  RegularModes regular_;
};

/// The states that so many elements have in some modes.
StatesOfElements states_in(const std::vector<MechanismMode>& modes, std::size_t elements);

/// By a solver for this once.
ModesOf modes_of(const FrictionProblem& problem, const std::optional<Rational>& load);
ModesOf mode_of(const FrictionProblem& problem, const MechanismMode& mode, const std::optional<Rational>& load);

/// The same problem with the equations solved: only what they leave free is unknown.
FrictionProblem without_equations(const FrictionProblem& problem);

}  // namespace slipproof
