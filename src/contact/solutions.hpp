// Every solution of a contact problem, exactly.
#pragma once

#include <memory>

#include "contact/problem.hpp"
#include "number/linear_program.hpp"

namespace slipproof {

/// One solution, with every mode that gives it.
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
  std::vector<AffineForm> conditions;  ///< of t; they have solutions, more than one

  std::vector<Rational> at(const std::vector<Rational>& t) const;
};

/// What one mode gives.
struct ModeOutcome {
  enum class Kind {
    solution,      ///< one solution
    violated,      ///< one solution of the equations, which breaks a condition
    inconsistent,  ///< no solution of the equations, or none that keeps the conditions
    continuum
  };
  Kind kind = Kind::inconsistent;
  std::vector<Rational> z;                    ///< solution, violated
  bool strict = false;                        ///< solution
  std::optional<ProblemCondition> condition;  ///< violated: the first one
  Rational margin;                            ///< violated: its left-hand side, negative
  std::optional<ContactContinuum> continuum;
};

struct ContactSolutions {
  std::vector<ContactSolution> solutions;  ///< those that no continuum contains
  std::vector<ContactContinuum> continua;

  bool one() const { return solutions.size() == 1 && continua.empty(); }
};

/// Problems with more modes than this are not enumerated: 12 components, 6 contacts with friction.
inline constexpr std::size_t max_enumerated_modes = 4096;

/// Solves the modes of a problem. The problem is checked by mistake_in() and must outlive it; immutable once made.
class ContactSolver {
 public:
  explicit ContactSolver(const ContactProblem& problem);
  ~ContactSolver();

  /// Solves the equations of a mode by fraction-free elimination.
  ModeOutcome solve(const ProblemMode& mode) const;
  /// All solutions, by trying each mode; nothing if there are too many modes, or their numbers too long.
  std::optional<ContactSolutions> all() const;
  /// The one solution of an LCP whose matrix is positive definite (its symmetric part, as W need not be symmetric),
  /// by least-index principal pivoting from a mode. Nothing if it is not, or it takes too many steps.
  std::optional<ContactSolution> only(ProblemMode start) const;
  /// The numbers have so many digits that even one mode takes more than a moment.
  bool too_long() const;

 private:
  struct Scaled;
  const ContactProblem& problem_;
  std::unique_ptr<const Scaled> scaled_;
};

/// Whether x . W x > 0 for all x but 0. An LCP with such a matrix has one solution for every q.
bool positive_definite(const RationalMatrix& W);

/// What is wrong with the shape or the domain of a problem; empty if nothing is.
std::string mistake_in(const ContactProblem& problem);
inline constexpr std::size_t max_problem_size = 64;

}  // namespace slipproof
