// The laws of contact as they are defined, in exact numbers: whether some forces solve a problem.
#pragma once

#include <string>
#include <vector>

#include "base/number/rational.hpp"
#include "contact/formats/problem_file.hpp"

namespace slipproof::test::degenerate {

/// Whether r and lambda solve a problem of the local or complementarity form without an error.
bool solves(const ProblemFile& problem, const std::vector<Rational>& r, const std::vector<Rational>& lambda);

/// Whether they solve it roughly: each condition up to `error` of the size of its kind. For Coulomb's law.
bool solves_roughly(const ProblemFile& problem, const std::vector<double>& r, double error);

}  // namespace slipproof::test::degenerate
