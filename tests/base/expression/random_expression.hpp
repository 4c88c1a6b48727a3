// Random trees, for round trips and for comparing evaluators. Every draw is a statement of its own: arguments are
// evaluated in an order that the compiler chooses.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "base/expression/expression.hpp"

namespace slipproof::testing {

class RandomExpressions {
 public:
  RandomExpressions(unsigned seed, std::vector<std::string> symbols) : random_(seed), symbols_(std::move(symbols)) {}

  int below(int bound) { return std::uniform_int_distribution<int>(0, bound - 1)(random_); }

  Expression number(int depth) {
    if (depth == 0) {
      const bool symbol = below(2) == 0;
      if (symbol) return make_symbol(symbols_[static_cast<std::size_t>(below(static_cast<int>(symbols_.size())))]);
      const int numerator = below(40);
      return make_number(Rational(numerator, below(2) == 0 ? 1 : 20));
    }
    constexpr Operation binary[] = {Operation::add,    Operation::subtract, Operation::multiply,
                                    Operation::divide, Operation::minimum,  Operation::maximum};
    const int choice = below(10);
    const Expression first = number(depth - 1);
    if (choice == 0) return make(Operation::negate, {first});
    if (choice == 1) return make_power(first, below(7) - 3);
    if (choice == 2) return make(below(2) == 0 ? Operation::absolute : Operation::signum, {first});
    const Expression second = number(below(depth));
    return make(binary[below(6)], {first, second});
  }

  /// numerator / denominator with lowest <= numerator < highest, 1 <= denominator <= largest.
  Rational rational(int lowest, int highest, int largest) {
    const int numerator = lowest + below(highest - lowest);
    return Rational(numerator, 1 + below(largest));
  }

  Expression truth(int depth) {
    if (depth == 0) return make_truth(below(2) == 0);
    const int choice = below(5);
    if (choice >= 3) return comparison(depth);
    const Expression first = truth(depth - 1);
    if (choice == 0) return make(Operation::logical_not, {first});
    const Expression second = truth(below(depth));
    return make(choice == 1 ? Operation::logical_and : Operation::logical_or, {first, second});
  }

 private:
  Expression comparison(int depth) {
    std::vector<Expression> operands{number(depth - 1)};
    std::vector<Relation> relations;
    for (int links = 1 + below(2); links > 0; --links) {
      operands.push_back(number(depth - 1));
      relations.push_back(static_cast<Relation>(below(6)));
    }
    return make_comparison(std::move(operands), std::move(relations));
  }

  std::mt19937 random_;
  std::vector<std::string> symbols_;
};

}  // namespace slipproof::testing
