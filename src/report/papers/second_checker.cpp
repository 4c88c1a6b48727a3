#include "report/papers/second_checker.hpp"

#include "base/number/format.hpp"

namespace slipproof {

std::string in_words(const SecondChecker& checker) {
  const auto are = [](std::size_t count) { return count == 1 ? " is" : " are"; };
  std::string words = counted(checker.accepted, "certificate") + are(checker.accepted) + " accepted by " +
                      checker.name + ", too, a checker that is proved correct";
  if (checker.from_claims == 0) return words;
  return words + "; " + counted(checker.from_claims, "verdict") + are(checker.from_claims) +
         " proved by it from the claim on";
}

std::optional<SecondChecker> second_checker(const std::vector<JudgedPaper>& papers) {
  std::optional<SecondChecker> all;
  for (const JudgedPaper& paper : papers) {
    const auto& one = paper.result.second_checker;
    if (!one) continue;
    if (!all) all = SecondChecker{one->name};
    all->accepted += one->accepted;
    all->from_claims += one->from_claims;
  }
  return all;
}

}  // namespace slipproof
