// Proofs as the prover builds them, and their text (proofs/FORMAT.md).
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "proofs/statement/statement.hpp"

namespace slipproof::prove {

/// A product of hypotheses: name -> exponent.
using Product = std::map<std::string, unsigned>;

void multiply(Product& product, const Product& other, unsigned exponent = 1);

/// coefficient * product, coefficient > 0.
struct WeightedProduct {
  Rational coefficient;
  Product product;
};

/// Terms and multiples of equations that add up to zero, with a strict term.
struct Identity {
  std::vector<WeightedProduct> terms;
  std::vector<std::pair<std::string, Polynomial>> equations;
};

struct Step;
using Proof = std::vector<Step>;

struct Step {
  enum class Rule { have, contradiction, split, cases, witness };
  Rule rule = Rule::contradiction;
  std::string name;
  std::vector<Polynomial> polynomial;  ///< one for `have` and `split`
  Sign sign = Sign::zero;              ///< sign that `have` claims
  std::vector<Identity> identities;    ///< two where `have` claims an equation
  std::vector<Proof> branches;
  std::vector<std::pair<std::string, std::string>> values;  ///< values of `witness`
};

/// Removes what the proof does not use: derived facts, and splits with a branch that needs no split. Clears
/// denominators.
void prune(Proof& proof);

std::string certificate_text(const Statement& statement, const Proof& proof);

}  // namespace slipproof::prove
