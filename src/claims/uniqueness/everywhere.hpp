// Whether a mechanism has one motion in its whole domain, whatever pushes it, by proof.
//
// Theorem 1 of proofs/two-wheeler: planar contacts from rest that can open, with a matrix W that is positive definite,
// have one motion for every q if and only if all mode determinants are positive (contact/every_load.hpp). Here W and
// the determinants are expressions over the mechanism's parameters, and each condition is a statement
// (proofs/FORMAT.md): in the domain, D > 0. The prover looks for a certificate of each, and the checker reads it.
//
// Example: a block of mass m on the floor has W = diag(1/m, 1/m), and in slip+ and slip- the determinant 1/m; m > 0
// proves all of them.
//
// A static coefficient above the kinetic one adds motions and takes none away. So where the theorem holds for the
// kinetic coefficients, several motions are hysteresis.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// A statement whose certificate the checker has accepted.
struct CheckedStatement {
  std::string name, text, certificate;
};

struct UniqueEverywhere {
  std::size_t modes = 0;
  std::vector<CheckedStatement> statements;  ///< that together say that the theorem applies
};

/// The statements of the mechanism and its domain, with empty certificates; nothing where the theorem is not about its
/// contacts, or where there are more modes or longer determinants than are tried. With hysteresis apart, static
/// coefficients above the kinetic ones are allowed: the theorem then speaks of the latter.
std::optional<UniqueEverywhere> uniqueness_statements(const Mechanism& mechanism, bool hysteresis_apart);

/// The same, each proved and checked, which takes seconds; nothing if that does not succeed, which does not say that
/// motions are not unique.
std::optional<UniqueEverywhere> unique_everywhere(const Mechanism& mechanism, bool hysteresis_apart);

}  // namespace slipproof
