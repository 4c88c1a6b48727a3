#include "report/papers/second_checker.hpp"

#include "base/number/format.hpp"

namespace slipproof {

std::string in_words(const SecondChecker& checker) {
  return counted(checker.accepted, "certificate") + (checker.accepted == 1 ? " is" : " are") + " accepted by " +
         checker.name + ", too, a checker that is proved correct";
}

std::optional<SecondChecker> second_checker(const std::vector<JudgedPaper>& papers) {
  std::optional<SecondChecker> all;
  for (const JudgedPaper& paper : papers) {
    const auto& one = paper.result.second_checker;
    if (one) all = SecondChecker{one->name, one->accepted + (all ? all->accepted : 0)};
  }
  return all;
}

}  // namespace slipproof
