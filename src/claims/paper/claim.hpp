// Claims as data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "claims/paper/claim_kind.hpp"
#include "claims/paper/paper.hpp"

namespace slipproof {

/// How serious a failing claim is.
enum class Grade : std::uint8_t { misprint, gap, boundary, wrong };
std::string_view name(Grade grade);  ///< `wrong` is written `false`

/// The verdict that a claim is known to get.
enum class Expectation : std::uint8_t { none, holds, refuted, undecided, vacuous };
std::string_view name(Expectation expectation);

/// The parts of a claim that are conditions or equations on parameters, forces and motions.
enum class BodyPart : std::uint8_t { region, forces, holds, equations, assume };
std::string_view name(BodyPart part);

/// The content of a claim in one reading. Parts that its kind does not have keep these defaults.
struct ClaimBody {
  const ClaimKind* kind = nullptr;  ///< null only before it is read
  /// A condition on bicycles: over parameters and definitions, independent of the force.
  Expression region = make_truth(true);
  Expression forces = make_truth(true);  ///< over all symbols except quantities
  Expression holds = make_truth(true);   ///< if there are modes, over the quantities of every motion in them, too
  Modes modes;
  References claims, except, given;
  Equations equations, assume;
  std::string parameter;                  ///< the parameter that grows to the upper end of its domain
  std::map<std::string, Expression> own;  ///< by key: what only its kind reads and understands
  Expectation expect = Expectation::none;

  std::optional<MechanismMode> mode() const { return modes.empty() ? std::nullopt : std::optional(modes.front()); }
  /// The claims that this one refers to.
  References references() const;
  /// For equations: the hypotheses are the model's equations.
  bool from_model() const { return given.empty() && claims.empty(); }
  /// The forces that the claim is about.
  Expression where() const { return kind->forces_say_where() ? forces : make_truth(true); }
};

/// Calls visit(part, index, expression) for every expression of a body, which may be const or not; the index counts
/// equations.
template <class Body, class Visit>
void for_each_part(Body& body, Visit&& visit) {
  visit(BodyPart::region, std::size_t{0}, body.region);
  visit(BodyPart::forces, std::size_t{0}, body.forces);
  visit(BodyPart::holds, std::size_t{0}, body.holds);
  for (std::size_t i = 0; i < body.equations.size(); ++i) visit(BodyPart::equations, i, body.equations[i]);
  for (std::size_t i = 0; i < body.assume.size(); ++i) visit(BodyPart::assume, i, body.assume[i]);
}

/// All conditions and equations of a body.
std::vector<Expression> expressions(const ClaimBody& body);

struct Claim {
  std::string id;
  std::string equation;  ///< number in the paper, or empty
  std::size_t line = 0;
  std::string statement;  ///< in words or as printed
  Origin origin = Origin::printed;
  std::size_t setting = 0;  ///< index
  ClaimBody printed;
  /// Present if the repaired reading differs from the printed one, by the claim's own repair or by that of a definition
  /// that it uses.
  std::optional<ClaimBody> repaired;
  std::string why;  ///< reason for the claim's own repair
  std::string note;
  std::optional<Grade> grade;
  /// Other findings that this claim shows again: ids of graded claims, or `3.1.b1` for a repaired definition.
  std::vector<std::string> part_of;

  const ClaimBody& body(Reading reading) const {
    return reading == Reading::repaired && repaired ? *repaired : printed;
  }
  /// The reading in words: a claim of our own is not printed.
  std::string_view reading_name(Reading reading) const {
    return reading == Reading::printed ? name(origin) : name(reading);
  }
  /// The kind is the same in every reading.
  const ClaimKind& kind() const { return *printed.kind; }
};

}  // namespace slipproof
