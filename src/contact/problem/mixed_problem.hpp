// One form for all contact problems at real size: a square linear system with free unknowns and contacts.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/algebra/sparse_matrix.hpp"
#include "base/number/rational.hpp"
#include "base/rounding/exact_sum.hpp"
#include "contact/formats/problem_file.hpp"
#include "contact/problem/problem.hpp"

namespace slipproof {

/// w = A x + c. The first `free` components of x may have any sign, and those of w are 0: bodies' velocities, bilateral
/// impulses, their balance. The rest come in groups of `dimension`, one for each contact: in x its impulse or force r,
/// in w its velocity or acceleration u, the normal part first. A contact obeys
///   u_N >= 0, r_N >= 0, u_N r_N = 0                                        (Signorini; all of the law in dimension 1)
///   |r_T| <= mu r_N, |u_T| r_T = -mu r_N u_T                               (Coulomb; |.| is Euclidean)
/// and with mu = 0 or r_N = 0 r_T = 0, u_T being anything; or, where `law` says so, another law (formats/LAWS.md).
struct MixedProblem {
  std::size_t free = 0, dimension = 3;
  SparseMatrix A;
  std::vector<double> c;
  std::vector<double> mu;  ///< by contact; zeros in dimension 1
  ContactLaw law;

  /// True for Coulomb's law, and for laws that are equivalent here: all laws without friction, pyramids in the plane.
  bool is_coulomb() const {
    const bool pyramid = law.kind == FrictionLaw::box || law.kind == FrictionLaw::diamond;
    return law.kind == FrictionLaw::cone || dimension == 1 || (dimension == 2 && pyramid);
  }
  std::size_t size() const { return c.size(); }
  std::size_t contacts() const { return mu.size(); }
  /// The index of the normal part of contact k in x and w.
  std::size_t normal(std::size_t k) const { return free + dimension * k; }
};

/// A problem as files hold it: free unknowns are lambda, or (v, lambda). With the solver's law, compliance and bias,
/// and with what a law of impact restores. Linear.
MixedProblem mixed_problem(const ProblemFile& file);
/// The problem with Coulomb's law, rigid and without bias; a law of impact stays.
MixedProblem coulomb_problem(ProblemFile file);

/// A problem without free unknowns in dimension 1 or 2, exactly as it is. Throws NumberError for NaN and infinities.
ContactProblem contact_problem(const MixedProblem& problem);

/// A problem in dimension 1 or 2 without its free unknowns, which follow from the forces: x_free = X r + y.
struct EliminatedProblem {
  ContactProblem problem;
  RationalMatrix X;
  std::vector<Rational> y;

  /// The complete x, with the free unknowns for contact forces r.
  std::vector<Rational> with_free(std::vector<Rational> r) const;
};

/// Exact, and cubic in the number of free unknowns. Nothing where their rows have not exactly one solution. Throws
/// NumberError for NaN and infinities.
std::optional<EliminatedProblem> eliminated(const MixedProblem& problem);

/// Row i of A x + c, exactly. Linear in its entries.
ExactSum row_sum(const MixedProblem& problem, std::size_t row, std::span<const double> x);
Rational exact_row(const MixedProblem& problem, std::size_t row, std::span<const double> x);
Rational exact_row(const MixedProblem& problem, std::size_t row, const std::vector<Rational>& x);

/// All rows of A x + c, exactly.
std::vector<Rational> exact_rows(const MixedProblem& problem, std::span<const double> x);

}  // namespace slipproof
