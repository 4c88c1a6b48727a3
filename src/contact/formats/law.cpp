#include "contact/formats/law.hpp"

#include <algorithm>
#include <array>

namespace slipproof {

namespace {

struct LawNames {
  std::string_view word, name;
};

constexpr std::array<LawNames, 6> laws{{{"cone", "friction cone"},
                                        {"box", "box pyramid |t1| <= mu n, |t2| <= mu n"},
                                        {"diamond", "diamond pyramid |t1| + |t2| <= mu n"},
                                        {"fixed", "law of fixed bounds"},
                                        {"associated", "associated law"},
                                        {"regularised", "regularised law"}}};

constexpr std::array<std::string_view, 2> functions{"linear", "soft"};

}  // namespace

std::string_view name(FrictionLaw law) {
  return laws[static_cast<std::size_t>(law)].name;
}

std::string_view word(FrictionLaw law) {
  return laws[static_cast<std::size_t>(law)].word;
}

std::string_view word(Regularisation function) {
  return functions[static_cast<std::size_t>(function)];
}

std::optional<FrictionLaw> law_called(std::string_view word) {
  if (word == "coulomb") return FrictionLaw::cone;
  const auto found = std::ranges::find(laws, word, &LawNames::word);
  if (found == laws.end()) return std::nullopt;
  return static_cast<FrictionLaw>(found - laws.begin());
}

std::optional<Regularisation> regularisation_called(std::string_view word) {
  const auto found = std::ranges::find(functions, word);
  if (found == functions.end()) return std::nullopt;
  return static_cast<Regularisation>(found - functions.begin());
}

std::string law_words() {
  std::string text = "coulomb";
  for (const LawNames& law : laws) text += ", " + std::string(law.word);
  return text;
}

}  // namespace slipproof
