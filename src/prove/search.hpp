// The search for proofs: refutes a set of sign conditions by linear elimination, factorization, splits on the signs of
// factors, and positivity after substitution by slack variables.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "prove/slack.hpp"

namespace slipproof::prove {

struct Limits {
  int split_depth = 2;       ///< nested splits that no hypothesis asks for
  int split_candidates = 6;  ///< tried at each of them
  int slack_depth = 2;       ///< variables replaced at a time
  int slack_attempts = 400;  ///< for one polynomial
};

/// What a failed search was left with, for a person to read.
struct Leftover {
  std::vector<std::string> facts;
  std::size_t size = 0;
};

class Search {
 public:
  Search(const Statement& statement, const Limits& limits) : statement_(statement), limits_(limits) {}

  /// A proof that the statement holds, or nothing; then leftover() tells where the search got stuck.
  std::optional<Proof> prove();
  const Leftover& leftover() const { return leftover_; }

 private:
  struct Rule;
  struct KnownSign;
  struct State;

  std::string fresh() { return "e" + std::to_string(++counter_); }
  bool add_formula(State& state, const std::string& name, const Formula& formula);
  bool add(State& state, Fact fact);
  bool normalize(State& state, Fact& fact, bool& keep);
  bool eliminate(State& state, std::size_t first = 0);
  void reduce(State& state, const Rule& rule, Fact& fact);
  bool apply_rule(State& state, const Rule& rule);
  std::optional<Rule> find_rule(State& state, std::size_t first);
  const KnownSign* sign_of(State& state, const Polynomial& factor, bool thorough = false);
  bool refute_facts(State& state, bool thorough);
  bool refute_pairs(State& state, std::vector<Polynomial>& candidates, bool thorough);
  void drop_known_cases(State& state);
  bool close(State& state, int depth);
  bool close_cases(State& state, std::size_t which, int depth);
  bool close_split(State& state, const Polynomial& p, int depth);
  std::vector<Polynomial> split_candidates(State& state, const std::vector<Polynomial>& from_pairs);
  bool close_by_witness(State& state);
  bool close_existence(State& state, std::size_t hint);

  const Statement& statement_;
  Limits limits_;
  int counter_ = 0;
  Leftover leftover_;
};

}  // namespace slipproof::prove
