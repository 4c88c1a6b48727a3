// Small random problems at the edges of what problems may be: forces that depend on each other, contacts that are open
// or that nothing moves, no contact at all; with an answer that was made with them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/number/dice.hpp"
#include "contact/formats/problem_file.hpp"

namespace slipproof::test::degenerate {

struct RandomCase {
  ProblemFile problem;  ///< local, or complementarity; its matrices are filled in
  SolverAnswer answer;  ///< with u = W r + V lambda + q in some cases
  /// W = J J^T: what the coordinates of bodies of mass 1 move at each component. Empty where W is another matrix.
  std::vector<std::vector<double>> J;
};

/// Problem i: any law, dimension 1 to 3, none to four contacts.
RandomCase random_case(std::uint64_t i);

enum class Notation : std::uint8_t { dense, sparse, global };

/// As a line of JSON. Not every case has every notation: null where it has not.
nlohmann::json line_of(const RandomCase& random, Notation notation);

}  // namespace slipproof::test::degenerate
