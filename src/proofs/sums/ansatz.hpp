// What a proof by sums of squares may consist of: sums of squares with unknown coefficients, each times a product of
// facts, and equations times unknown polynomials, that are to add up to zero.
#pragma once

#include <string>
#include <vector>

#include "proofs/branch/context.hpp"
#include "proofs/branch/state.hpp"

namespace slipproof::prove::sums {

/// multiplier * basis^T X basis with a symmetric matrix X that has no negative eigenvalue.
struct Block {
  Product product = {};   ///< of facts
  Polynomial multiplier;  ///< what they come to, times `scale`
  Rational scale = 1;
  bool strict = false;  ///< of the strict ones X must not be 0 in all; their facts are strict
  std::vector<Polynomial> basis;
};

/// An equation p = 0 times an unknown polynomial in these monomials.
struct Multiple {
  std::string name;
  Polynomial p;
  std::vector<Polynomial> monomials;
};

struct Ansatz {
  std::vector<Block> blocks;
  std::vector<Multiple> multiples;
};

/// The sizes of the parts.
struct Shape {
  unsigned long degree = 2;  ///< degree of all parts, even
  int factors = 1;           ///< facts in a product, at most
  /// Products are strict also times a sum of squares of forms, which is so where these are not all 0.
  bool lifted = false;
};

/// Makes an ansatz; nothing if it would be too large.
std::optional<Ansatz> make_ansatz(Context& context, const State& state, const Shape& shape);

/// Removes monomials that cannot occur, because nothing else cancels their squares. If all facts are even in some
/// variables, then splits each block by the parities of its monomials in these. Returns false if no strict part is
/// left. Requires bases of monomials.
bool simplify(Context& context, Ansatz& ansatz);

unsigned long degree_of(const Polynomial& p);

}  // namespace slipproof::prove::sums
