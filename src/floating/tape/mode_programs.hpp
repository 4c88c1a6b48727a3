// All modes of a mechanism as programs: made once, good for all values of its parameters, angles and load.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/expression/evaluate.hpp"
#include "floating/program/tape_form.hpp"
#include "mechanics/checks/kinds.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// One mode: its equations solved but for a core of at most two, its conditions and quantities as forms.
struct ModeProgram {
  /// Where none of them is 0, nor the determinant of the core, the rest means what it says.
  std::vector<TapeRef> pivots;
  std::vector<TapeRef> residuals;      ///< where one is not 0 there is no solution
  std::vector<SolvedForm> core;        ///< equations, as many as unknowns
  std::vector<SolvedForm> conditions;  ///< what must be >= 0; those that are 0 at all points are left out
  bool never_strict = false;           ///< one was left out
  std::size_t free = 0;                ///< how many forces, or accelerations, are left free
  bool determined = false;             ///< no acceleration varies with them
  /// Modes with the same number have the same accelerations wherever all of them have a solution of their equations and
  /// no pivot of any is 0.
  std::size_t motion = 0;
  std::vector<SolvedForm> accelerations, forces;  ///< as acceleration_names() and force_names() name them
};

/// A condition of the domain: a tree, children before parents.
struct TruthProgram {
  struct Step {
    Operation operation = Operation::truth;  ///< truth, compare, or one of logic
    bool truth = false;
    Relation relation = Relation::equal;  ///< of the difference to 0
    TapeRef difference = 0;
    std::size_t first = 0, second = 0;  ///< operands
  };
  std::vector<Step> steps;
};

struct ModePrograms {
  explicit ModePrograms(const Mechanism& mechanism) : kinds(mechanism) {}

  std::vector<MechanismMode> modes;   ///< in the order of enumeration: the last element fastest
  std::vector<ModeProgram> programs;  ///< one for each
  std::vector<TruthProgram> domain;   ///< parameters, angles, [assume]; all must hold
  std::vector<TruthProgram> loads;    ///< the load's domain
  std::vector<TapeRef> divisors;      ///< of the file's expressions: where one is 0 something has no value
  std::vector<bool> given;            ///< parameters that have a value
  MechanismKinds kinds;
  std::vector<TapeRef> line_constants;  ///< of each line of the kinds
  /// Of each of the kinds' inertias and levers the coefficients, by what they are divided.
  std::vector<std::vector<TapeRef>> inertias, levers;
  std::size_t parameters = 0, angles = 0;

  std::vector<TapeNode> nodes;
  std::vector<Rational> constants;

  /// Inputs of the tape: parameters, cosine and sine of each angle, the load.
  std::size_t inputs() const { return parameters + 2 * angles + 1; }
  std::size_t cosine(std::size_t angle) const { return parameters + 2 * angle; }
  std::size_t load() const { return inputs() - 1; }
};

/// More modes, and longer tapes, are left to the exact kernel.
inline constexpr double max_program_modes = 1024;
inline constexpr std::size_t max_tape_length = 400'000;

/// With these states before the motion, and `given`, for each parameter, whether it has a value. Nothing for a
/// mechanism that the batch does not do: too many modes, coefficients with min, max, abs or sign in them, a literal 0
/// as a divisor. Takes milliseconds for a mechanism of two contacts, seconds for one of a hundred modes.
std::optional<ModePrograms> mode_programs(const Mechanism& mechanism, const std::vector<ElementKind::Start>& starts,
                                          const std::vector<bool>& given);

}  // namespace slipproof
