#include "proofs/sums/refute.hpp"

#include <algorithm>

#include "proofs/rules/splits.hpp"
#include "proofs/sums/squares_sum.hpp"

namespace slipproof::prove {

namespace {

using sums::Square;
using sums::SumOfSquares;

constexpr unsigned long highest_degree = 12;

/// The square as the facts have it, given the sign of its root by this name: a term, or a multiple of the equation.
void add_square(Identity& identity, const Square& square, const std::string& sign_of_root, int sign) {
  if (sign == 0) {
    identity.equations.emplace_back(sign_of_root, *square.worth.divided_by(square.root));
    return;
  }
  WeightedProduct term{square.coefficient, square.product};
  multiply(term.product, {{sign_of_root, 2}});
  identity.terms.push_back(std::move(term));
}

/// A split on the root of a square, with the square in the same identity in each branch.
Step contradiction_by_square(Context& context, const Identity& rest, const Square& square) {
  Step step;
  step.rule = Step::Rule::split;
  step.name = context.fresh();
  step.polynomial = {square.root};
  for (const int sign : {-1, 0, 1}) {
    Identity identity = rest;
    add_square(identity, square, step.name, sign);
    step.branches.push_back({contradiction(std::move(identity))});
  }
  return step;
}

/// Adds up the squares, one after another: each partial sum is positive, as it would otherwise be a contradiction of
/// the one before and the square. The last one is 0. So the splits lie beside each other, two for each square.
class Telescope {
 public:
  Telescope(Context& context, const SumOfSquares& sum) : context_(context), sum_(sum) {}

  /// `strict` is a square that the sign of its root makes strict, if there has to be one.
  Proof proof(const Square* strict = nullptr, const std::string& sign_of_root = "") {
    Identity start{{}, sum_.equations};
    Polynomial others(context_.ring());
    std::vector<const Square*> squares;
    for (const Square& square : sum_.squares) {
      if (square.root.is_constant()) {
        start.terms.push_back({square.coefficient * pow(square.root.constant(), 2), square.product});
      } else if (&square == strict) {
        add_square(start, square, sign_of_root, 1);
      } else {
        squares.push_back(&square);
        others += square.worth;
      }
    }
    return descend(std::move(start), -others, squares);
  }

 private:
  Proof descend(Identity start, Polynomial partial, const std::vector<const Square*>& squares) {
    if (partial.is_zero()) return {contradiction(std::move(start))};
    Proof proof;
    std::string name = context_.fresh();
    start.terms.push_back({1, {{name, 1}}});
    proof.push_back(have({name, partial, Sign::positive}, {std::move(start)}));
    Proof* branch = &proof;
    for (const Square* square : squares) {
      partial += square->worth;
      Identity before{{{1, {{name, 1}}}}, {}};
      if (partial.is_zero()) {
        branch->push_back(contradiction_by_square(context_, before, *square));
        return proof;
      }
      Step step;
      step.rule = Step::Rule::split;
      step.name = name = context_.fresh();
      step.polynomial = {partial};
      Identity negative = before, zero = before;
      negative.terms.push_back({1, {{name, 1}}});
      zero.equations.emplace_back(name, Polynomial(context_.ring(), -1));
      step.branches = {{contradiction_by_square(context_, negative, *square)},
                       {contradiction_by_square(context_, zero, *square)},
                       {}};
      branch->push_back(std::move(step));
      branch = &branch->back().branches.back();
    }
    return proof;
  }

  Context& context_;
  const SumOfSquares& sum_;
};

/// One after another, the roots of squares that are to be strict: where one is not 0, there is a contradiction.
bool close_roots(Context& context, State& state, const SumOfSquares& sum, std::size_t from, const Close& close) {
  while (from < sum.squares.size() && !sum.squares[from].strict) ++from;
  if (from == sum.squares.size()) return close(state);
  const Square& square = sum.squares[from];
  return close_split(context, state, square.root, [&](State& branch, const Fact& sign) {
    if (sign.sign == Sign::zero) return close_roots(context, branch, sum, from + 1, close);
    Proof proof = Telescope(context, sum).proof(&square, sign.name);
    std::move(proof.begin(), proof.end(), std::back_inserter(branch.steps));
    return true;
  });
}

bool conclude(Context& context, State& state, const SumOfSquares& sum, const Close& close) {
  const bool strict = std::any_of(sum.squares.begin(), sum.squares.end(),
                                  [](const Square& square) { return square.strict && square.root.is_constant(); });
  if (!strict) return close_roots(context, state, sum, 0, close);
  Proof proof = Telescope(context, sum).proof();
  std::move(proof.begin(), proof.end(), std::back_inserter(state.steps));
  return true;
}

bool refute_with(Context& context, State& state, const sums::Shape& shape, const Close& close) {
  auto ansatz = sums::make_ansatz(context, state, shape);
  if (!ansatz || !sums::simplify(context, *ansatz)) return false;
  const auto sum = sums::find_sum_of_squares(context, std::move(*ansatz));
  return sum && conclude(context, state, *sum, close);
}

}  // namespace

bool refute_by_sums_of_squares(Context& context, State& state, const Close& close) {
  unsigned long degree = 0;
  for (const Fact& fact : state.facts) degree = std::max(degree, sums::degree_of(fact.p));
  const unsigned long highest = std::min(highest_degree, degree + degree % 2 + 2);
  for (unsigned long d = 2; d <= highest; d += 2) {
    for (const sums::Shape& shape :
         {sums::Shape{d, false, false}, sums::Shape{d, true, false}, sums::Shape{d, false, true}}) {
      if (refute_with(context, state, shape, close)) return true;
    }
  }
  return false;
}

}  // namespace slipproof::prove
