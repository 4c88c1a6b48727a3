// The search for proofs: refutes a set of sign conditions by linear elimination (elimination.cpp), factorization and
// rewriting (rewriting.cpp), positivity after substitution by slack variables (slack.cpp, single.cpp, signs.cpp),
// Fourier-Motzkin elimination (pairs.cpp), case splits (splits.cpp), and, where all that is not enough, linear
// programming over products of hypotheses (products.cpp) and squares (squares.cpp); existence.cpp finds witnesses.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "polynomial/budget.hpp"
#include "prove/slack.hpp"

namespace slipproof::prove {

struct Limits {
  int split_depth = 3;       ///< nested splits that no hypothesis asks for
  int split_candidates = 6;  ///< tried at each of them
  int slack_depth = 2;       ///< variables replaced at a time
  int slack_attempts = 400;  ///< for one polynomial
  /// In a linear program over products of hypotheses; 0: none. Products of 2, then of 3, where all else fails.
  std::size_t products = 400;
  int instances = 4000;  ///< attempts to find numbers for a statement about some bicycle
  /// Attempts to find numbers at which a statement is false, before and after the search for a proof; with none of the
  /// latter it is not asked either whether the assumptions of what is proved contradict each other.
  int quick_samples = 16, samples = 400;
  /// For one statement, in steps of polynomial arithmetic: the same on every machine, as time is not.
  std::uint64_t steps = 100'000'000;
  /// Called every million steps or so with their number; a sign of life.
  std::function<void(std::uint64_t steps)> tick = {};
};

/// What a failed search was left with, for a person to read.
struct Leftover {
  std::vector<std::string> facts;
  bool exhausted = false;  ///< no step was left
};

/// numerator / denominator, for a value of an unknown.
struct Quotient {
  Polynomial numerator, denominator;

  std::string text() const;
};

class Search {
 public:
  Search(const Statement& statement, const Limits& limits);

  /// A proof that the statement holds, or nothing; then leftover() tells where the search got stuck.
  std::optional<Proof> prove();
  const Leftover& leftover() const { return leftover_; }
  std::uint64_t steps() const { return budget_.spent(); }

 private:
  struct Rule;
  struct KnownSign;
  struct State;
  using Close = std::function<bool(State& branch)>;  ///< closes a branch of a case split
  using CloseSigned = std::function<bool(State& branch, const Fact& sign)>;

  std::string fresh();                          ///< a name for a hypothesis
  std::string unused(const std::string& name);  ///< this one, unless an assumption has it
  bool add_formula(State& state, const std::string& name, const Formula& formula);
  bool add(State& state, Fact fact);
  bool divide_out(State& state, const Polynomial& factor);
  bool normalize(State& state, Fact& fact, bool& keep);
  bool eliminate(State& state, std::size_t first = 0);
  void reduce(State& state, const Rule& rule, Fact& fact);
  bool apply_rule(State& state, const Rule& rule);
  std::optional<Rule> find_rule(State& state, std::size_t first);
  const Factorization& factored(const Polynomial& p);
  const SignPattern& signs_at_samples(const Polynomial& p);
  SampleSet fails(const Fact& fact);
  const KnownSign* sign_of(State& state, const Polynomial& factor, bool thorough = false);
  std::optional<WeightedProduct> as_known_product(State& state, const Polynomial& p);
  bool refute_multiples(State& state);
  bool refute_facts(State& state, bool thorough);
  bool refute_pairs(State& state, std::vector<Polynomial>& candidates, bool thorough);
  bool refute_products(State& state);
  bool implied(State& state, const Formula& formula, const SampleSet& excluded);
  void drop_known_cases(State& state);
  bool close(State& state, int depth);
  bool close_cases(State& state, std::size_t which, const Close& close);
  bool close_split(State& state, const Polynomial& p, const Close& close);
  bool close_split(State& state, const Polynomial& p, const CloseSigned& close);
  bool close_even_factors(State& state, const Fact& fact, const Close& close);
  bool close_square(State& state, const Fact& fact, std::size_t variable, const Close& close);
  bool close_squares(State& state, const Close& close);
  std::vector<Polynomial> plain_candidates(State& state);
  std::vector<Polynomial> split_candidates(State& state, const std::vector<Polynomial>& from_pairs);
  struct Solution {
    std::vector<Quotient> quotients;                 ///< of each unknown, in the unknowns that are left free
    std::optional<std::vector<std::string>> values;  ///< with 0 for those, where that is defined
    std::optional<Polynomial> open_pivot;            ///< a factor of unknown sign that stood in the way
  };
  void cancel(Quotient& value);
  Solution solve_conclusion(const State& state, std::size_t alternative = 0);
  bool add_witness(State& state, const std::string& name, const std::vector<std::string>& values,
                   std::size_t alternative);
  bool close_by_witness(State& state, const std::vector<std::string>& values);
  bool close_by_alternatives(State& state, int splits);
  struct Bounds;
  Bounds bounds_of(State& state, std::size_t free, const std::vector<Quotient>& values);
  bool close_by_bounds(State& state, int splits);
  bool close_existence(State& state, std::size_t hint);

  bool refuted_by_rules(State& state, const Formula& formula);
  bool hopeless(const State& state);
  void keep_leftover(const State& state);
  std::optional<Proof> search();
  bool search_deeper(const State& start, State& closed);

  const Statement& statement_;
  Limits limits_;
  Samples samples_;
  std::map<std::string, SignPattern> patterns_;  ///< by the text of a polynomial, as what follows
  std::map<std::string, Factorization> factorizations_;
  Budget& budget_;  ///< of the ring
  unsigned product_degree_ = 0;
  int counter_ = 0;
  Leftover leftover_;
};

}  // namespace slipproof::prove
