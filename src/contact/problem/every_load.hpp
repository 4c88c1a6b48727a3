// Decides whether a contact problem has exactly one solution for every constant q, that is, under every load.
//
// Let a problem be w = W z + q. In each mode, W together with the equations of the mode gives a square matrix: the rows
// of T are replaced by T = -mu N where the mode slips, and those of N and T by N = T = 0 where it lifts. Its
// determinant is the mode determinant. In a linear complementarity problem these are the principal minors of W.
//
// Planar friction, W positive definite, symmetric or not: there is one solution for every q if and only if all mode
// determinants are positive. (A contact without friction has no stick, as its T is 0.) The solutions are the preimages
// of q under a continuous map that is linear on each of the cones into which the modes' conditions cut the space. With
// positive determinants it keeps the orientation on each of them. Its degree is 1, as it is for mu = 0: since z . W z =
// sum of T slip <= 0 has only the solution z = 0 for every mu, no preimage escapes to infinity while mu grows. Hence
// the map is one to one. A negative determinant gives a generic q inside that cone's image three preimages, a zero one
// gives a continuum. (For q in general: S. Scholtes, Introduction to Piecewise Differentiable Equations, section 2.3.)
// proofs/two-wheeler/README.md has the proof with each step.
//
// Linear complementarity: W is a P-matrix or not (Samelson, Thrall, Wesler 1958); it need not be symmetric.
//
// With friction and too many contacts to try their modes: let W = S + K, S symmetric and K skew, t_i the sum of the
// |S_jk| over the tangential columns k in the tangential row j of contact i, and k_ij the |K_jk| in row j and its
// tangential column k. If S is positive definite after mu_i^2 t_i + mu_i (sum of k_ij over j) is subtracted from the
// diagonal entry of each N_i, and the sum of mu_i k_ij over i from that of each row j, the solution is unique for every
// q. Proof: let x be a vector of the N of contacts that slip and the N, T of those that stick, y = P x the force with T
// = 0 and C x that with T = -+mu N where contacts slip, d = (C - P) x. In the norm of S, |d|^2 is at most b, the sum of
// mu_i^2 t_i x_i^2, by Gershgorin. |y . K d| is at most D, half the sum of mu_i k_ij (y_j^2 + x_i^2). The assumption
// says that |y|^2 - 2 D > b for y != 0, so (|y|^2 - D)^2 >= |y|^2 (|y|^2 - 2 D) > |y|^2 b and |y|^2 > D. Then x . P^T W
// C x >= |y|^2 - |y| |d| - D > 0: a matrix with that property has a positive determinant, in every mode.
#pragma once

#include <optional>
#include <string_view>

#include "base/number/effort.hpp"
#include "contact/problem/problem.hpp"

namespace slipproof {

struct EveryLoad {
  enum class Verdict : std::uint8_t {
    unique,       ///< one solution for every q
    at_most_one,  ///< never two w for a q that pushes on the bodies make (every_push.hpp)
    not_unique,   ///< for some q there are several, infinitely many, or no solutions
    undecided     ///< W is not positive definite, or there are too many modes and the bound says nothing
  };
  enum class Reason : std::uint8_t {
    determinants,  ///< by mode determinants: all are positive, or one is not
    bound,         ///< the sufficient test on mu
    definite,      ///< for an LCP beyond the effort: W is positive definite
    no_theorem,    ///< with friction, W is not positive definite
    too_many,      ///< modes
    pairs          ///< of modes have no two solutions that differ, or have them
  };
  Verdict verdict = Verdict::undecided;
  Reason reason = Reason::too_many;
  std::optional<ProblemMode> mode = {};   ///< not_unique: the first one with a determinant that is not positive
  Rational determinant = 0;               ///< of it
  std::optional<ProblemMode> other = {};  ///< not_unique, by pairs: under one q it and `mode` have different w
  std::vector<Rational> q = {};           ///< by pairs: such a q
  std::size_t undetermined = 0;  ///< by pairs: the dimension of the kernel of W, that is, of the undetermined forces
};
std::string_view name(EveryLoad::Verdict verdict);  ///< `unique`, `not unique`, `undecided`
std::string_view name(EveryLoad::Reason reason);    ///< `mode determinants`, `bound on mu`, ...

/// Decides it from W and mu. Requires that mistake_in() is empty. Takes an elimination of W for each mode.
EveryLoad for_every_load(const ContactProblem& problem, Effort& effort);
EveryLoad for_every_load(const ContactProblem& problem);

/// The mode determinant. O(n^3).
Rational mode_determinant(const ContactProblem& problem, const ProblemMode& mode);

/// The sufficient test on mu alone; nothing is said of a problem that it does not hold for. O(n^3).
bool is_unique_by_bound(const ContactProblem& problem);

/// The contacts of a mechanism at a point, at load 0. Nothing unless all elements are contacts from rest that can open,
/// with one coefficient of friction each or without friction, all of one kind, and their forces determine the motion.
std::optional<ContactProblem> contact_problem(const FrictionProblem& problem);

}  // namespace slipproof
