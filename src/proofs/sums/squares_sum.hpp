// From an ansatz to an exact sum of squares: solved in binary64, rounded, made exact, and checked.
#pragma once

#include <optional>

#include "proofs/sums/ansatz.hpp"

namespace slipproof::prove::sums {

/// coefficient * product * root^2, where `worth` is what it comes to.
struct Square {
  Rational coefficient;
  Product product;
  bool strict = false;  ///< true if all facts of the product are strict
  Polynomial root;
  Polynomial worth;
};

/// The sum of all squares, and of the equations times their multipliers, is 0; there is a strict square, or one that is
/// strict where its root is not 0.
struct SumOfSquares {
  std::vector<Square> squares;
  std::vector<std::pair<std::string, Polynomial>> equations;
};

/// Finds a sum of squares. Call it after simplify(), which must have returned true.
std::optional<SumOfSquares> find_sum_of_squares(Context& context, const Ansatz& ansatz);

}  // namespace slipproof::prove::sums
