#include "report/papers/second_checker.hpp"

#include "base/number/format.hpp"

namespace slipproof {
namespace {
constexpr std::size_t most_names = 8;
}

std::string in_words(const SecondChecker& checker) {
  const auto are = [](std::size_t count) { return count == 1 ? " is" : " are"; };
  std::string words = counted(checker.accepted, "certificate") + are(checker.accepted) + " accepted by " +
                      checker.name + ", too, a checker that is proved correct";
  if (checker.from_claims == 0) return words;
  words +=
      "; " + counted(checker.from_claims, "verdict") + are(checker.from_claims) + " proved by it from the claim on";
  if (checker.from_statements.empty()) return words;
  words += ", " + std::to_string(checker.from_statements.size()) + " from statements only";
  for (std::size_t i = 0; i < checker.from_statements.size(); ++i) {
    if (i == most_names) return words + ", ...";
    words += (i == 0 ? ": " : ", ") + checker.from_statements[i];
  }
  return words;
}

std::optional<SecondChecker> second_checker(const std::vector<JudgedPaper>& papers) {
  std::optional<SecondChecker> all;
  for (const JudgedPaper& paper : papers) {
    const auto& one = paper.result.second_checker;
    if (!one) continue;
    if (!all) all = SecondChecker{one->name};
    all->accepted += one->accepted;
    all->from_claims += one->from_claims;
    if (one->from_claims == 0) continue;
    for (const std::string& claim : one->from_statements)
      all->from_statements.push_back(papers.size() == 1 ? claim : paper.name + " " + claim);
  }
  return all;
}

}  // namespace slipproof
