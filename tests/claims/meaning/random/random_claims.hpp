// Random claims of all kinds, each made for a bicycle: near the truth there, with literals where something changes.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "claims/meaning/second_judge/claims.hpp"
#include "claims/meaning/second_judge/world.hpp"

namespace slipproof::meaning {

using Values = std::map<std::string, Rational>;

struct Case {
  File file;
  std::vector<Values> bicycles;  ///< the first is the one that the claims were made for
};

/// Choices; the same for a seed on every machine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }
  bool one_in(std::size_t n) { return below(n) == 0; }
  template <class T>
  const T& of(const std::vector<T>& choices) {
    return choices[below(choices.size())];
  }

 private:
  std::mt19937_64 engine_;
};

/// Expressions and conditions over the symbols of a setting.
class RandomTrees {
 public:
  RandomTrees(Dice& dice, const World& world) : dice_(dice), world_(world) {}

  Rational small();
  Rational literal();  ///< a force at which something happens, or any number
  std::string relation();
  Tree parameter_number(int depth);
  Tree region();  ///< most often null, that is true
  Tree forces();
  Tree forces_of(const Mode& mode);  ///< exactly those at this bicycle
  Tree nearly(Tree condition);       ///< the same, or with something changed
  Tree about_motion(const Mode& mode);
  Tree about_parameter(const std::string& parameter);

 private:
  Tree x() const { return symbol(world_.setting().force.empty() ? "k" : world_.setting().force); }
  Tree simple();
  Tree dividing();
  Tree combined(const Tree& left, const Tree& right);

  Dice& dice_;
  const World& world_;
};

class RandomClaims {
 public:
  /// What the domain of the force depends on: most often on nothing; or always on parameters, so that it may be empty,
  /// no interval, or without a value. Then some claims are made to be settled by their regions or as identities.
  enum class Domain { plain, of_parameters };

  /// About bicycles, or about random mechanisms.
  RandomClaims(std::uint64_t seed, bool mechanisms, Domain domain = Domain::plain)
      : dice_(seed), mechanisms_(mechanisms), domain_(domain) {}

  /// The next, about a claim of a kind, with the claims that it needs.
  Case next(const std::string& kind);

 private:
  Setting setting();
  Tree domain_of_parameters(const Tree& x);
  void scene(Setting& setting);
  void mechanism(Setting& setting);
  Values bicycle(const Setting& setting);
  std::unique_ptr<World> world(const Setting& setting, Values& values);

  Dice dice_;
  bool mechanisms_;
  Domain domain_;
};

/// With a random mechanism, and what its symbols are in the setting's.
void add_mechanics(Dice& dice, Setting& setting);

}  // namespace slipproof::meaning
