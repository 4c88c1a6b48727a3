// A contact problem in rationals, in its global form: M v = H r + f, u = H^T v + w, with rows that hold always, M v = H
// r
// + G lambda + f, G^T v + b = 0; or in the local one, u = W r + q. What `certify` and other solvers read.
#pragma once

#include <string>
#include <vector>

#include "base/algebra/elimination.hpp"

namespace slipproof {

struct GlobalProblem {
  std::string title;
  int dimension = 3;    ///< 2: a normal and a tangent for each contact; 3: two tangents
  RationalMatrix M;     ///< symmetric
  RationalMatrix H, G;  ///< a row for each component of v; G may have no columns
  std::vector<Rational> f, w, b, mu;
  RationalMatrix W;  ///< matrix of the local form, with q; then M, H, G, f, w, b are empty
  std::vector<Rational> q;
  std::vector<std::string> contacts;  ///< their names
};

/// JSON as described in contact/formats/FORMATS.md, one line for each row.
std::string to_json(const GlobalProblem& problem);

}  // namespace slipproof
