// All solutions of a contact problem, for programs: of a record in a line as of a file.
#pragma once

#include "base/output/json.hpp"
#include "contact/judge/all_solutions.hpp"

namespace slipproof {

/// The members `found`, and `continua`, if there are families.
void add_solutions(const AllSolutions& all, Json& to);
/// The members `claimed` or `looks_like`, `violated`, `margin` or `reason`.
void add_own_mode(const OwnMode& own, Json& to);

}  // namespace slipproof
