// Proves that a mechanism has one motion in its whole domain, whatever pushes it.
//
// Theorem 1 of proofs/two-wheeler: planar contacts that start from rest and can open, with a positive definite matrix
// W, have one motion for every q if and only if all mode determinants are positive (contact/problem/every_load.hpp).
// Here W and the determinants are expressions over the mechanism's parameters, and each condition is a statement
// (proofs/FORMAT.md): in the domain, D > 0. The prover looks for a certificate of each, and the checker verifies it.
//
// Example: a block of mass m on the floor has W = diag(1/m, 1/m), and the determinant 1/m in slip+ and slip-; m > 0
// proves all conditions.
//
// A static coefficient above the kinetic one adds motions and removes none. So if the theorem holds for the kinetic
// coefficients, several motions are hysteresis.
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
  std::vector<CheckedStatement> statements;  ///< together they say that the theorem applies
};

/// The statements for the mechanism and its domain, with empty certificates. Nothing if the theorem does not apply to
/// its contacts, or if there are more modes or longer determinants than are tried. With `hysteresis_apart`, static
/// coefficients above the kinetic ones are allowed; the theorem is then about the kinetic ones.
std::optional<UniqueEverywhere> uniqueness_statements(const Mechanism& mechanism, bool hysteresis_apart);

/// The same, with each statement proved and checked, which takes seconds. Nothing if a proof is not found; motions may
/// still be unique.
std::optional<UniqueEverywhere> unique_everywhere(const Mechanism& mechanism, bool hysteresis_apart);

}  // namespace slipproof
