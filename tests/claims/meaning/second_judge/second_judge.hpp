// Judges a claim at one bicycle by proofs/MEANING.md alone: slow, and point by point. It has the
// equations of the bicycle from tests/support/bicycle, and uses nothing of the product that reads, evaluates or judges
// claims.
#pragma once

#include <functional>
#include <string_view>

#include "claims/meaning/second_judge/linear.hpp"
#include "claims/meaning/second_judge/world.hpp"

namespace slipproof::meaning {

enum class Says { nothing, no_value, right, wrong };
std::string_view name(Says says);

class SecondJudge {
 public:
  /// The file must outlive the judge. `world` is a bicycle of its setting.
  SecondJudge(const File& file, const World& world) : file_(file), world_(world) {}

  /// Throws OutOfReach.
  Says judge(std::size_t claim) const;

  // What those need who test whether a statement says the same as a claim.
  /// Forces, in the domain or not, between which neither the motions nor anything in the claim changes.
  std::vector<Rational> places(std::size_t claim) const;
  /// Of a continuum: what changes at which values of its parameter with a claim's `holds`.
  std::vector<Plane> planes(const Claim& claim, const Solutions& solutions) const;
  struct Equations {
    bool fine = true;  ///< defined and linear, all of them
    Rows rows;
    std::set<std::string> symbols;  ///< in their texts
  };
  /// Of a limit: values of the parameter at which, and between which, something changes.
  std::vector<Rational> values_of_parameter(const Claim& claim) const;
  Equations hypotheses(const Claim& claim) const;
  Equations right_side(const Claim& claim) const;

 private:
  Says interval(const Claim& claim) const;
  Says impossible(const Claim& claim) const;
  Says formula(const Claim& claim) const;
  Says formula_of_motions(const Claim& claim) const;
  Says motions(const Claim& claim) const;
  Says unique(const Claim& claim) const;
  Says force_cover(const Claim& claim) const;
  Says equivalence(const Claim& claim) const;
  Says exists(const Claim& claim) const;
  Says consequence(const Claim& claim) const;
  Says system(const Claim& claim) const;
  Says cover(const Claim& claim) const;
  Says limit(const Claim& claim) const;
  std::vector<Names> last_bicycles(const Claim& claim) const;

  std::optional<std::vector<Tree>> conditions_on_forces(const Claim& claim) const;
  bool states(std::size_t claim, const Rational& x) const;
  bool near_one_of(const std::vector<std::size_t>& claims, const Rational& x) const;
  bool exactly_one_in(const Motions& found, const std::vector<Mode>& modes) const;

  /// "Judged force by force": at an x where `forces` is true as `at_force` says.
  Says force_by_force(const Claim& claim, const std::vector<Rational>& forces,
                      const std::function<Says(const Rational&)>& at_force) const;
  /// All forces x, or enough of them: where the motions, the domain and these conditions can change, and between.
  std::vector<Rational> forces(const std::vector<Tree>& conditions, std::set<Rational> more = {}) const;
  bool domain_is_an_interval() const;
  std::set<Rational> changes(const std::vector<Tree>& conditions) const;
  std::set<Rational> changes_of_motion(const Tree& holds, const Solutions& solutions) const;
  std::vector<Polynomial> critical_of_motion(const Tree& holds, const Solutions& solutions) const;
  Truth holds_of_motion(const Tree& holds, const Motion& motion, const Rational& x) const;
  /// Whether quantities are multiplied, or divided by, as it stands.
  bool multiplies(const Tree& tree) const;
  /// What `holds` is, of the motions in a mode at a force: those that are found.
  std::vector<Truth> truths_of_mode(const Claim& claim, const Mode& mode, const Rational& x) const;

  Truth at(const Tree& condition, const Rational& x) const;
  bool always_defined(const Tree& condition, const std::vector<Rational>& forces) const;
  bool all_modelled(const std::vector<Mode>& modes) const;
  bool everything_modelled() const { return world_.everything_modelled(); }
  Motions motions_at(const Rational& x) const { return world_.motions(x, world_.setting().strict); }

  void add(Equations& equations, const std::vector<Tree>& trees) const;
  void add(Equations& equations, const std::vector<std::size_t>& claims) const;

  const File& file_;
  const World& world_;
};

/// "The first of wrong, no value, right, nothing that it is at some x."
Says first_of(Says x, Says y);

/// The condition on forces with its ends: "closure".
Tree closure(const Tree& condition, bool negated = false);

}  // namespace slipproof::meaning
