// The laws of contact and friction that solvers solve, one of which is Coulomb's (LAWS.md).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slipproof {

enum class FrictionLaw : std::uint8_t {
  cone,        ///< Coulomb: |r_T| <= mu r_N, Euclidean; u_T opposes r_T if that is an equality
  box,         ///< |r_T1| <= mu r_N and |r_T2| <= mu r_N, each direction for itself
  diamond,     ///< |r_T1| + |r_T2| <= mu r_N, with the largest dissipation
  fixed,       ///< |r_Ti| <= a bound given by the problem, for each direction, independent of r_N
  associated,  ///< r in the cone, u in its dual cone, r . u = 0: convex; what slides also opens
  regularised  ///< r_T = -mu r_N f(|u_T| / v_s) u_T / |u_T|: no sticking, only creeping
};

/// f of the regularised law.
enum class Regularisation : std::uint8_t {
  linear,  ///< min(s, 1)
  soft     ///< s / sqrt(1 + s^2): |u_T| is replaced by sqrt(u_T^2 + v_s^2)
};

/// A law with what it needs to be stated.
struct ContactLaw {
  FrictionLaw kind = FrictionLaw::cone;
  std::vector<double> bounds;  ///< fixed: >= 0, of each tangential component, by contacts
  double slip_speed = 0;       ///< regularised: v_s > 0
  Regularisation function = Regularisation::linear;
};

/// Names of a law: in options, files and certificates, and in sentences. And whether the law has bounds.
struct LawFacts {
  std::string_view word, name;
  bool bounded = false;
};
inline constexpr std::array<LawFacts, 6> law_facts{{{"cone", "friction cone"},
                                                    {"box", "box pyramid |t1| <= mu n, |t2| <= mu n"},
                                                    {"diamond", "diamond pyramid |t1| + |t2| <= mu n"},
                                                    {"fixed", "law of fixed bounds", true},
                                                    {"associated", "associated law"},
                                                    {"regularised", "regularised law"}}};
inline constexpr std::array<std::string_view, 2> regularisation_words{"linear", "soft"};

constexpr std::string_view name(FrictionLaw law) {
  return law_facts[static_cast<std::size_t>(law)].name;
}
constexpr std::string_view word(FrictionLaw law) {
  return law_facts[static_cast<std::size_t>(law)].word;
}
/// Whether friction has bounds that do not depend on mu and r_N (ContactLaw::bounds).
constexpr bool is_bounded(FrictionLaw law) {
  return law_facts[static_cast<std::size_t>(law)].bounded;
}
/// How many such bounds a contact has.
constexpr std::size_t bounds_of_contact(FrictionLaw, std::size_t dimension) {
  return dimension - 1;
}
constexpr std::string_view word(Regularisation function) {
  return regularisation_words[static_cast<std::size_t>(function)];
}

/// All names that are accepted for laws; `coulomb` is another name of `cone`.
inline std::vector<std::string> law_words() {
  std::vector<std::string> words{"coulomb"};
  for (const LawFacts& law : law_facts) words.emplace_back(law.word);
  return words;
}

inline std::optional<FrictionLaw> law_called(std::string_view word) {
  if (word == "coulomb") return FrictionLaw::cone;
  const auto found = std::ranges::find(law_facts, word, &LawFacts::word);
  if (found == law_facts.end()) return std::nullopt;
  return static_cast<FrictionLaw>(found - law_facts.begin());
}

inline std::optional<Regularisation> regularisation_called(std::string_view word) {
  const auto found = std::ranges::find(regularisation_words, word);
  if (found == regularisation_words.end()) return std::nullopt;
  return static_cast<Regularisation>(found - regularisation_words.begin());
}

}  // namespace slipproof
