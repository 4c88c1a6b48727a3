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

/// The largest number of modes that are tried.
inline constexpr std::uint64_t max_modes = 65'536;

/// Solves the modes of a problem, which must outlive it: at one load, also outside the domain, or for all loads of the
/// domain. Immutable once constructed.
class ModeSolver {
 public:
  ModeSolver(const FrictionProblem& problem, const std::optional<Rational>& load);
  /// A solver for modes with these states only.
  ModeSolver(const FrictionProblem& problem, const std::optional<Rational>& load, StatesOfElements states);

  /// All modes; there must be at most max_modes. Takes one elimination in integers for each mode. Modes whose equations
  /// are underdetermined are then tried state by state, with a few linear programs each, and cut as soon as the first
  /// elements contradict each other. Throws TooMuchWork beyond the effort.
  ModesOf all(Effort* effort = nullptr) const;
  /// The consistent modes, without reasons for the others. Without an effort, a filter in binary64 excludes most of the
  /// others.
  std::vector<ConsistentMode> consistent(Effort* effort = nullptr) const;
  /// The consistent ones among some modes, with a state for each element, in the given order.
  std::vector<ConsistentMode> consistent_among(const std::vector<MechanismMode>& modes) const;
  /// One mode, with a state for each element. If it is rejected, reports a single condition with its margin if one
  /// fails for all forces, otherwise a minimal set of conditions that exclude each other.
  ModesOf one(const MechanismMode& mode, Effort* effort = nullptr) const;

  /// The work of a mode that leaves this number of unknowns to elimination, without linear programs.
  Work work_of(std::size_t unknowns) const { return regular_.work_of(unknowns); }

 private:
  enum class Rejected { reported, left_out };
  /// Finds the modes with these states. Gives no reason for those that the filter excludes.
  ModesOf among(const StatesOfElements& states, Rejected rejected, Effort* effort,
                const ModeFilter* filter = nullptr) const;
  ModeFilter filter() const { return {problem_, load_, domain_, states_}; }

  const FrictionProblem& problem_;
  std::optional<Rational> load_;
  ForceInterval domain_;
  StatesOfElements states_;
  RegularModes regular_;
};

/// For each of `elements` elements, the states that it has in some of the modes.
StatesOfElements states_in(const std::vector<MechanismMode>& modes, std::size_t elements);

/// Finds the modes with a solver that is used once.
ModesOf modes_of(const FrictionProblem& problem, const std::optional<Rational>& load);
ModesOf mode_of(const FrictionProblem& problem, const MechanismMode& mode, const std::optional<Rational>& load);

/// The problem with its equations solved: only their free unknowns remain.
FrictionProblem without_equations(const FrictionProblem& problem);

}  // namespace slipproof
