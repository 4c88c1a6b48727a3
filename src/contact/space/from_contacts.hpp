// What the velocities of contacts say of other velocities.
#pragma once

#include <optional>
#include <vector>

#include "contact/complete/contacts.hpp"
#include "mechanics/kernel/polyhedron.hpp"

namespace slipproof {

/// constant + the sum of weights[i] * ranges[i], without an end where a range has none.
Range weighted(const std::vector<Rational>& weights, const std::vector<Range>& ranges, const Rational& constant);

/// Of each row of A r + a, its range as a combination of these rows of u = W r + q, whose ranges are `u`; nothing where
/// it is none. Whatever r is, the same u gives the same value: where rows of u are known exactly, so is this.
std::vector<std::optional<Range>> from_contacts(const ExactContacts& contacts, const std::vector<std::size_t>& rows,
                                                const std::vector<Range>& u, const RationalMatrix& A,
                                                const std::vector<Rational>& a);

}  // namespace slipproof
