#include "proofs/sums/refute.hpp"

#include <algorithm>

#include "proofs/rules/splits.hpp"
#include "proofs/sums/squares_sum.hpp"

namespace slipproof::prove {

namespace {

using sums::Square;
using sums::SumOfSquares;

constexpr unsigned long highest_degree = 12;
constexpr int most_factors = 3;

void add_term(Identity& identity, WeightedProduct term) {
  for (WeightedProduct& other : identity.terms) {
    if (other.product != term.product) continue;
    other.coefficient += term.coefficient;
    return;
  }
  identity.terms.push_back(std::move(term));
}

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

using Squares = std::vector<const Square*>;

/// A proof that a sum is impossible: the lines of `start`, with a strict one, come to minus the squares. It adds up the
/// squares, one after another: each partial sum is positive, as it would otherwise contradict the one before and the
/// square. The last one is 0. So the splits lie beside each other, two for each square.
Proof add_up(Context& context, Identity start, const Squares& squares) {
  Polynomial partial(context.ring());
  for (const Square* square : squares) partial -= square->worth;
  if (partial.is_zero()) return {contradiction(std::move(start))};
  Proof proof;
  std::string name = context.fresh();
  start.terms.push_back({1, {{name, 1}}});
  proof.push_back(have({name, partial, Sign::positive}, {std::move(start)}));
  Proof* branch = &proof;
  for (const Square* square : squares) {
    partial += square->worth;
    const Identity before{{{1, {{name, 1}}}}, {}};
    if (partial.is_zero()) {
      branch->push_back(contradiction_by_square(context, before, *square));
      break;
    }
    Step step;
    step.rule = Step::Rule::split;
    step.name = name = context.fresh();
    step.polynomial = {partial};
    Identity negative = before, zero = before;
    negative.terms.push_back({1, {{name, 1}}});
    zero.equations.emplace_back(name, Polynomial(context.ring(), -1));
    step.branches = {
        {contradiction_by_square(context, negative, *square)}, {contradiction_by_square(context, zero, *square)}, {}};
    branch->push_back(std::move(step));
    branch = &branch->back().branches.back();
  }
  return proof;
}

bool append(State& state, Proof proof) {
  std::move(proof.begin(), proof.end(), std::back_inserter(state.steps));
  return true;
}

/// Strict squares with the same facts: contradictory where `sum`, that of the squares alone, is positive. Otherwise all
/// roots are 0.
struct StrictSquares {
  Product product;
  std::vector<Square> squares;  ///< without the facts
  Polynomial sum;
};

std::vector<StrictSquares> strict_squares(const SumOfSquares& sum) {
  std::vector<StrictSquares> groups;
  for (const Square& square : sum.squares) {
    if (!square.strict) continue;
    Square alone{square.coefficient, {}, true, square.root, (square.root * square.root).scaled(square.coefficient)};
    if (groups.empty() || groups.back().product != square.product) {
      groups.push_back({square.product, {}, Polynomial(square.root.ring())});
    }
    groups.back().sum += alone.worth;
    groups.back().squares.push_back(std::move(alone));
  }
  return groups;
}

/// Contradicts all squares but those of the group, whose sum is positive by the fact of this name.
Proof contradict_others(Context& context, const SumOfSquares& sum, const StrictSquares* group = nullptr,
                        const std::string& positive = "") {
  Identity start{{}, sum.equations};
  Squares others;
  if (group != nullptr) {
    start.terms.push_back({1, group->product});
    multiply(start.terms.back().product, {{positive, 1}});
  }
  for (const Square& square : sum.squares) {
    if (group != nullptr && square.strict && square.product == group->product) continue;
    if (square.root.is_constant()) {
      add_term(start, {square.coefficient * pow(square.root.constant(), 2), square.product});
    } else {
      others.push_back(&square);
    }
  }
  return add_up(context, std::move(start), others);
}

Squares all_but(const std::vector<Square>& squares, std::size_t left_out) {
  Squares result;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    if (i != left_out) result.push_back(&squares[i]);
  }
  return result;
}

/// Where the sum of the squares is 0, by the equation of this name, so are all roots, from `next` on.
bool close_roots(Context& context, State& state, const StrictSquares& group, const std::string& equation,
                 std::size_t next, const Close& close) {
  if (next == group.squares.size()) return close(state);
  const Square& square = group.squares[next];
  return close_split(context, state, square.root, [&](State& branch, const Fact& sign) {
    if (sign.sign == Sign::zero) return close_roots(context, branch, group, equation, next + 1, close);
    Identity start{{}, {{equation, Polynomial(context.ring(), -1)}}};
    add_square(start, square, sign.name, 1);
    return append(branch, add_up(context, std::move(start), all_but(group.squares, next)));
  });
}

/// Group after group, from `next` on: where its sum is not 0, there is a contradiction.
bool close_groups(Context& context, State& state, const SumOfSquares& sum, const std::vector<StrictSquares>& groups,
                  std::size_t next, const Close& close) {
  if (next == groups.size()) return close(state);
  const StrictSquares& group = groups[next];
  return close_split(context, state, group.sum, [&](State& branch, const Fact& sign) {
    if (sign.sign == Sign::zero) {
      return close_roots(context, branch, group, sign.name, 0,
                         [&](State& zero) { return close_groups(context, zero, sum, groups, next + 1, close); });
    }
    if (sign.p == group.sum) return append(branch, contradict_others(context, sum, &group, sign.name));
    return append(branch, add_up(context, {{{1, {{sign.name, 1}}}}, {}}, all_but(group.squares, group.squares.size())));
  });
}

bool refute_with(Context& context, State& state, const sums::Shape& shape, const Close& close) {
  auto ansatz = sums::make_ansatz(context, state, shape);
  if (!ansatz || !sums::simplify(context, *ansatz)) return false;
  const auto sum = sums::find_sum_of_squares(context, *ansatz);
  if (!sum) return false;
  const bool strict = std::any_of(sum->squares.begin(), sum->squares.end(),
                                  [](const Square& square) { return square.strict && square.root.is_constant(); });
  return strict ? append(state, contradict_others(context, *sum))
                : close_groups(context, state, *sum, strict_squares(*sum), 0, close);
}

}  // namespace

bool refute_by_sums_of_squares(Context& context, State& state, const Close& close) {
  unsigned long degree = 0;
  for (const Fact& fact : state.facts) degree = std::max(degree, sums::degree_of(fact.p));
  const unsigned long highest = std::min(highest_degree, degree + degree % 2 + 2);
  for (unsigned long d = 2; d <= highest; d += 2) {
    for (int factors = 1; factors <= most_factors; ++factors) {
      if (refute_with(context, state, {d, factors, false}, close)) return true;
    }
    if (refute_with(context, state, {d, 1, true}, close)) return true;
  }
  return false;
}

}  // namespace slipproof::prove
