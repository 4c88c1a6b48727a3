// The kinds of claims: what each of them consists of. What each says, with all its quantifiers, is in
// proofs/MEANING.md under the kind's name; whoever judges, writes or shows claims visits the variant, so that the
// compiler names a kind that was forgotten.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "base/expression/expression.hpp"
#include "mechanics/elements/element.hpp"

namespace slipproof {

using Modes = std::vector<MechanismMode>;
/// `=` between what is linear in the unknowns of the mechanism and in the force.
using Equations = std::vector<Expression>;
/// Indices of other claims.
using References = std::vector<std::size_t>;

enum class Need : std::uint8_t { required, optional };

// Every kind lists its fields once, by their keys in a claims file: fields(kind, visit) calls
// visit(key, field, need). A claim of each kind has a region besides. Conditions on forces are over everything but
// quantities, and `true` where none are given.

/// In the region, the forces with a motion in the mode are exactly those of `forces`.
struct Interval {
  static constexpr std::string_view name = "interval";
  MechanismMode mode;
  Expression forces = make_truth(true);

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("mode", self.mode, Need::required);
    visit("forces", self.forces, Need::required);
  }
};

/// None of the forces gives a motion in one of the modes.
struct Impossible {
  static constexpr std::string_view name = "impossible";
  Modes modes;
  Expression forces = make_truth(true);

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("modes", self.modes, Need::required);
    visit("forces", self.forces, Need::optional);
  }
};

/// At all of the forces, `holds`; with modes, of the quantities of every motion in them.
struct Formula {
  static constexpr std::string_view name = "formula";
  Modes modes;
  Expression forces = make_truth(true), holds = make_truth(true);

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("mode", self.modes, Need::optional);
    visit("modes", self.modes, Need::optional);
    visit("forces", self.forces, Need::optional);
    visit("holds", self.holds, Need::required);
  }
};

/// At each of the forces there is one motion in each of the modes, and no other.
struct Motions {
  static constexpr std::string_view name = "motions";
  Modes modes;
  Expression forces = make_truth(true);

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("modes", self.modes, Need::required);
    visit("forces", self.forces, Need::optional);
  }
};

/// But where a claim of `except` stands, there is one motion: as one of `claims` states, or in one of the modes.
struct Unique {
  static constexpr std::string_view name = "unique";
  References claims, except;
  Modes modes;
  Expression forces = make_truth(true);

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("claims", self.claims, Need::required);
    visit("except", self.except, Need::optional);
    visit("modes", self.modes, Need::optional);
    visit("forces", self.forces, Need::optional);
  }
};

/// Every bicycle is in the region of one of the claims.
struct Cover {
  static constexpr std::string_view name = "cover";
  References claims;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("claims", self.claims, Need::required);
  }
};

/// Each of the forces is one of those that one of the claims states: its region and its forces are true.
struct ForceCover {
  static constexpr std::string_view name = "force-cover";
  References claims;
  Expression forces = make_truth(true);

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("claims", self.claims, Need::required);
    visit("forces", self.forces, Need::optional);
  }
};

/// `forces` and `holds` are true of the same forces.
struct Equivalence {
  static constexpr std::string_view name = "equivalence";
  Expression forces = make_truth(true), holds = make_truth(true);

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("forces", self.forces, Need::required);
    visit("holds", self.holds, Need::required);
  }
};

/// As the parameter goes to the upper end of its domain, `holds` from some value on.
struct Limit {
  static constexpr std::string_view name = "limit";
  std::string parameter;
  Expression holds = make_truth(true);
  Expression from;  ///< where proofs let it begin, independent of the parameter; null: there is no proof

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("parameter", self.parameter, Need::required);
    visit("holds", self.holds, Need::required);
    visit("from", self.from, Need::optional);
  }
};

/// Somewhere in the region, one of the forces gives a motion in each of the modes.
struct Exists {
  static constexpr std::string_view name = "exists";
  Modes modes;
  Expression forces = make_truth(true);

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("modes", self.modes, Need::required);
    visit("forces", self.forces, Need::optional);
  }
};

/// What `consequence` and `system` are made of.
struct LinearEquations {
  Equations equations;
  References given, claims;
  Equations assume;  ///< added to those of `given`
  std::optional<MechanismMode> mode;

  /// Neither `given` nor `claims`: the hypotheses are the model's equations.
  bool from_model() const { return given.empty() && claims.empty(); }

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("equations", self.equations, Need::required);
    visit("given", self.given, Need::optional);
    visit("assume", self.assume, Need::optional);
    visit("claims", self.claims, Need::optional);
    visit("mode", self.mode, Need::optional);
  }
};

/// Every equation follows from those of `given`, `assume` and `claims`, or from the model's.
struct Consequence : LinearEquations {
  static constexpr std::string_view name = "consequence";
};

/// Under `given`, the equations say of their unknowns what the others say.
struct System : LinearEquations {
  static constexpr std::string_view name = "system";
};

/// In the order in which messages list them.
using ClaimKind = std::variant<Interval, Impossible, Formula, Motions, Unique, Cover, ForceCover, Equivalence, Limit,
                               Exists, Consequence, System>;

/// The parts of a claim that are conditions or equations about parameters, forces and motions.
enum class BodyPart : std::uint8_t { region, forces, holds, equations, assume };
std::string_view name(BodyPart part);

std::string_view name(const ClaimKind& kind);
/// An empty claim of the kind with this name.
std::optional<ClaimKind> parse_kind(std::string_view name);
std::vector<std::string_view> kind_names();

/// One function for each alternative: std::visit(Cases{[](const Interval&) {...}, ...}, kind).
template <class... Functions>
struct Cases : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Cases(Functions...) -> Cases<Functions...>;

/// visit(key, field, need) for every field of a claim's kind, const or not.
template <class Kind, class Visit>
void for_each_field(Kind& kind, Visit&& visit) {
  std::visit([&](auto& one) { std::decay_t<decltype(one)>::fields(one, visit); }, kind);
}

/// visit(part, index, expression) for every expression of a claim's body; the index counts equations.
template <class Body, class Visit>
void for_each_part(Body& body, Visit&& visit) {
  visit(BodyPart::region, std::size_t{0}, body.region);
  for_each_field(body.says, [&](std::string_view key, auto& field, Need) {
    using Field = std::decay_t<decltype(field)>;
    if constexpr (std::is_same_v<Field, Expression>) {
      if (key == "forces") visit(BodyPart::forces, std::size_t{0}, field);
      if (key == "holds") visit(BodyPart::holds, std::size_t{0}, field);
    } else if constexpr (std::is_same_v<Field, Equations>) {
      for (std::size_t i = 0; i < field.size(); ++i) {
        visit(key == "assume" ? BodyPart::assume : BodyPart::equations, i, field[i]);
      }
    }
  });
}

/// All of a part's expressions, const or not: none where the kind does not have it.
template <class Body>
auto parts(Body& body, BodyPart which) {
  std::vector<std::remove_reference_t<decltype((body.region))>*> found;
  for_each_part(body, [&](BodyPart part, std::size_t, auto& expression) {
    if (part == which) found.push_back(&expression);
  });
  return found;
}

/// The modes that a claim names.
Modes modes(const ClaimKind& kind);
/// The claims that it refers to.
References references(const ClaimKind& kind);

}  // namespace slipproof
