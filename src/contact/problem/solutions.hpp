// Every solution of a contact problem, exactly.
#pragma once

#include <array>

#include "base/algebra/linear_program.hpp"
#include "base/number/effort.hpp"
#include "contact/problem/problem.hpp"
#include "mechanics/kernel/mode_solver.hpp"

namespace slipproof {

/// A solution, with all modes that give it.
struct ContactSolution {
  std::vector<ProblemMode> modes;
  bool strict = false;  ///< every condition of one of its modes holds strictly
  std::vector<Rational> z, w;
};

/// Infinitely many solutions of one mode: z = base + sum of t_i directions[i] wherever all conditions are >= 0.
struct ContactContinuum {
  ProblemMode mode;
  std::vector<Rational> base;
  RationalMatrix directions;
  std::vector<AffineForm> conditions;  ///< conditions on t, with more than one solution

  std::vector<Rational> at(const std::vector<Rational>& t) const;
  /// Two solutions that differ. Throws TooMuchWork.
  std::array<std::vector<Rational>, 2> two(Effort& effort) const;
};

/// The outcome of a mode.
struct ModeOutcome {
  enum class Kind {
    solution,      ///< one solution
    violated,      ///< a condition is broken by all solutions of the equations alike
    inconsistent,  ///< no solution of the equations, or none that satisfies all conditions
    continuum
  };
  Kind kind = Kind::inconsistent;
  std::vector<Rational> z;                     ///< solution
  bool strict = false;                         ///< solution
  std::optional<ViolatedCondition> condition;  ///< violated: the first one
  Rational margin;                             ///< violated: its left-hand side, negative
  std::optional<ContactContinuum> continuum;
};

struct ContactSolutions {
  std::vector<ContactSolution> solutions;  ///< those that no continuum contains
  std::vector<ContactContinuum> continua;

  bool one() const { return solutions.size() == 1 && continua.empty(); }
};

/// Solves the modes of a problem by the kernel of all mechanisms (mechanics/kernel/mode_solver.hpp). The problem is
/// checked by mistake_in() and must outlive it; immutable once made.
class ContactSolver {
 public:
  /// The default effort: one or two seconds.
  static constexpr Work default_effort = 1'500'000'000;

  explicit ContactSolver(const ContactProblem& problem);
  ContactSolver(const ContactSolver&) = delete;
  ContactSolver& operator=(const ContactSolver&) = delete;

  /// Solves one mode. Throws TooMuchWork.
  ModeOutcome solve(const ProblemMode& mode, Effort& effort) const;
  /// All solutions, by trying each mode; nothing if that exceeds the effort.
  std::optional<ContactSolutions> all(Effort& effort) const;
  std::optional<ContactSolutions> all() const;
  /// The one solution of an LCP whose matrix is positive definite (its symmetric part, as W need not be symmetric),
  /// by least-index principal pivoting from a mode. Nothing if it is not, or beyond the effort.
  std::optional<ContactSolution> unique_solution(ProblemMode start, Effort& effort) const;
  std::optional<ContactSolution> unique_solution(ProblemMode start) const;

  /// The number of modes; endless if it is more than that.
  Work modes() const;
  /// The work of all() if few modes are singular.
  Work work_of_all() const;

 private:
  ContactContinuum continuum_of(const ConsistentMode& found) const;
  ContactSolutions try_all(Effort& effort) const;

  const ContactProblem& problem_;
  const FrictionProblem kernel_problem_;
  const ModeSolver kernel_;
};

/// Whether x . W x > 0 for all x but 0. An LCP with such a matrix has one solution for every q.
bool positive_definite(const RationalMatrix& W);

}  // namespace slipproof
