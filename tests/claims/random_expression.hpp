// Random trees, for round trips and for comparing evaluators.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "claims/expression.hpp"

namespace slipproof::testing {

class RandomExpressions {
 public:
  RandomExpressions(unsigned seed, std::vector<std::string> symbols) : random_(seed), symbols_(std::move(symbols)) {}

  int below(int bound) { return std::uniform_int_distribution<int>(0, bound - 1)(random_); }

  Expression number(int depth) {
    if (depth == 0) {
      if (below(2) == 0)
        return make_symbol(symbols_[static_cast<std::size_t>(below(static_cast<int>(symbols_.size())))]);
      return make_number(Rational(below(40), below(2) == 0 ? 1 : 20));
    }
    constexpr Operation binary[] = {Operation::add,    Operation::subtract, Operation::multiply,
                                    Operation::divide, Operation::minimum,  Operation::maximum};
    switch (below(10)) {
      case 0:
        return make(Operation::negate, {number(depth - 1)});
      case 1:
        return make_power(number(depth - 1), below(7) - 3);
      case 2:
        return make(below(2) == 0 ? Operation::absolute : Operation::signum, {number(depth - 1)});
      default:
        return make(binary[below(6)], {number(depth - 1), number(below(depth))});
    }
  }

  Expression truth(int depth) {
    if (depth == 0) return make_truth(below(2) == 0);
    switch (below(5)) {
      case 0:
        return make(Operation::logical_not, {truth(depth - 1)});
      case 1:
        return make(Operation::logical_and, {truth(depth - 1), truth(below(depth))});
      case 2:
        return make(Operation::logical_or, {truth(depth - 1), truth(below(depth))});
      default: {
        std::vector<Expression> operands{number(depth - 1)};
        std::vector<Relation> relations;
        for (int links = 1 + below(2); links > 0; --links) {
          operands.push_back(number(depth - 1));
          relations.push_back(static_cast<Relation>(below(6)));
        }
        return make_comparison(std::move(operands), std::move(relations));
      }
    }
  }

 private:
  std::mt19937 random_;
  std::vector<std::string> symbols_;
};

}  // namespace slipproof::testing
