// A scene of a mechanism in space as a contact problem in rationals.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "contact/complete/contacts.hpp"
#include "contact/problem/global_problem.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// A contact that is closed, and can open.
struct SpaceContact {
  std::size_t contact = 0;  ///< among the mechanism's
  Rational mu;              ///< 0 if frictionless
  /// The direction of its sliding velocity along T1 and T2, of length 1; or one of any length, where none of length 1
  /// is rational. Both nothing if it rests.
  std::optional<std::array<Rational, 2>> sliding, toward;

  bool slides() const { return sliding || toward; }
};

/// An acceleration that follows from those of the bodies: coefficients . v + constant.
struct SpaceRow {
  std::vector<std::pair<std::size_t, Rational>> terms;
  Rational constant;
};

struct SpaceProblem {
  /// v: the unknown accelerations; r: N T1 T2 of each of `contacts`; lambda: forces of links and of guides without
  /// friction. mu as if none slides.
  GlobalProblem global;
  std::vector<SpaceContact> contacts;
  std::vector<std::size_t> held;  ///< the forces lambda, among the mechanism's unknowns
  std::vector<SpaceRow> rows;     ///< acceleration_names() beyond the unknowns: gaps and slips
};

/// Throws InputError for an impact by Poisson's law.
void refuse_poisson_in_space(const Mechanism& mechanism);

/// At the scene's load. Throws InputError for what such a problem cannot express: a guide with friction, a static
/// coefficient of its own at rest, a contact whose lift is not modelled, a load without a value, a division by 0, an
/// impact by Poisson's law.
SpaceProblem space_problem(const MechanismScene& scene);

/// Links and accelerations eliminated, exactly: v = V r + v0, lambda = L r + l0. A contact that slides pushes by
/// N - mu N d along its direction d: it is one without friction of a matrix that is not symmetric. If no rational d has
/// the length 1, u_T is in place of the slip acceleration the constant `toward`: to Coulomb's law a contact that slips
/// in this direction, whatever happens.
struct ReducedSpace {
  ExactContacts contacts;  ///< u = W r + q
  RationalMatrix V, L;     ///< a row for each component of v, of lambda
  std::vector<Rational> v0, l0;
  std::vector<bool> determined;  ///< of each component of lambda: false where other links say the same
};

/// Throws InputError, in the file of that name, where links contradict each other, or something moves that neither a
/// mass nor a joint holds.
ReducedSpace reduced(const SpaceProblem& problem, const Mechanism& mechanism);

/// For other programs: the global form, or, where a contact slides, the local one of reduced().
GlobalProblem exported(const SpaceProblem& problem, const Mechanism& mechanism);

}  // namespace slipproof
