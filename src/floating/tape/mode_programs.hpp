// All modes of a mechanism as programs. They are made once and hold for all values of its parameters, angles and load.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/expression/evaluate.hpp"
#include "floating/program/tape_form.hpp"
#include "mechanics/checks/kinds.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// One mode: its conditions and quantities as forms, with its equations solved up to a core of at most two.
struct ModeProgram {
  /// The other members are valid where none of these is 0 and the determinant of the core is not 0.
  std::vector<TapeRef> pivots;
  std::vector<TapeRef> residuals;      ///< there is no solution where one is not 0
  std::vector<SolvedForm> core;        ///< equations, as many as unknowns
  std::vector<SolvedForm> conditions;  ///< numbers that must be >= 0, without those that are 0 at all points
  bool never_strict = false;           ///< a condition was left out because it is 0 at all points
  std::size_t free = 0;                ///< the number of forces or accelerations that are left free
  bool determined = false;             ///< no acceleration depends on the free numbers
  /// Modes with the same number have the same accelerations at each point at which all their equations have a solution
  /// and none of their pivots is 0.
  std::size_t motion = 0;
  std::vector<SolvedForm> accelerations, forces;  ///< in the order of acceleration_names() and force_names()
};

/// A condition of the domain as a tree, children before parents.
struct TruthProgram {
  struct Step {
    Operation operation = Operation::truth;  ///< truth, compare, or a logical operation
    bool truth = false;
    Relation relation = Relation::equal;  ///< between the difference and 0
    TapeRef difference = 0;
    std::size_t first = 0, second = 0;  ///< operands
  };
  std::vector<Step> steps;
};

struct ModePrograms {
  explicit ModePrograms(const Mechanism& mechanism) : kinds(mechanism) {}

  std::vector<MechanismMode> modes;   ///< in the order of enumeration: the last element fastest
  std::vector<ModeProgram> programs;  ///< one for each
  std::vector<TruthProgram> domain;   ///< conditions on parameters and angles, and [assume]; all must hold
  std::vector<TruthProgram> loads;    ///< the load's domain
  std::vector<TapeRef> divisors;      ///< in the file's expressions: where one is 0, some expression has no value
  std::vector<bool> given;            ///< by parameter: whether it has a value
  MechanismKinds kinds;
  std::vector<TapeRef> line_constants;  ///< for each line of the kinds
  /// For each quotient in the kinds' inertias and levers, the coefficients in its denominator.
  std::vector<std::vector<TapeRef>> inertias, levers;
  std::size_t parameters = 0, angles = 0;

  std::vector<TapeNode> nodes;
  std::vector<Rational> constants;

  /// The number of inputs of the tape: parameters, cosine and sine of each angle, the load.
  std::size_t inputs() const { return parameters + 2 * angles + 1; }
  std::size_t cosine(std::size_t angle) const { return parameters + 2 * angle; }
  std::size_t load() const { return inputs() - 1; }
};

/// Mechanisms with more modes or longer tapes are left to the exact kernel.
inline constexpr double max_program_modes = 1024;
inline constexpr std::size_t max_tape_length = 400'000;

/// `starts`: the states before the motion; `given`: for each parameter, whether it has a value. Returns nothing for a
/// mechanism that batches cannot handle: with too many modes, with coefficients that contain min, max, abs or sign, or
/// with the literal 0 as a divisor. Takes milliseconds for two contacts, seconds for a hundred modes.
std::optional<ModePrograms> mode_programs(const Mechanism& mechanism, const std::vector<ElementKind::Start>& starts,
                                          const std::vector<bool>& given);

}  // namespace slipproof
