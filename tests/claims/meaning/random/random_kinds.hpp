// A random claim of each kind.
#pragma once

#include <string>
#include <vector>

#include "claims/meaning/random/random_claims.hpp"

namespace slipproof::meaning {

inline const std::vector<std::string> kinds = {"interval", "impossible", "formula",     "motions",
                                               "unique",   "cover",      "force-cover", "equivalence",
                                               "limit",    "exists",     "consequence", "system"};

/// Adds claims to a file, near what is true at a bicycle.
class RandomKinds {
 public:
  RandomKinds(Dice& dice, const World& world, File& file)
      : dice_(dice), world_(world), file_(file), trees_(dice, world) {}

  /// With the claims that it refers to.
  void add(const std::string& kind);
  /// Gives a claim a region that contradicts itself, or the domain of the force, perhaps without a value somewhere; or
  /// makes it an identity that divides by something.
  void settle(Claim& claim);

 private:
  std::size_t add_interval(const Mode& mode);
  std::size_t add_equations();
  void interval(Claim& claim);
  void impossible(Claim& claim);
  void formula(Claim& claim);
  void motions(Claim& claim);
  void unique(Claim& claim);
  void cover(Claim& claim);
  void force_cover(Claim& claim);
  void limit(Claim& claim);
  void exists(Claim& claim);
  void consequence(Claim& claim);
  void system(Claim& claim);

  Mode mode();  ///< most often one that has motions
  std::vector<Mode> modes_at(const Rational& x, bool strict);
  Tree where_motions_are_as_at(const Rational& x, bool strict);
  Tree true_equation();
  std::vector<Mode> mode_of_equations();
  std::string unknown();
  Tree random_equation();
  Tree combination(const std::vector<Tree>& equations);
  std::string new_id() { return "c" + std::to_string(file_.claims.size() + 1); }

  Dice& dice_;
  const World& world_;
  File& file_;
  RandomTrees trees_;
};

}  // namespace slipproof::meaning
