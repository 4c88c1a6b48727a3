// What a kind of claim is: all that the rooms of this wing, and reports, ask of it. Each kind is one file in
// claims/kinds; what it says, with all its quantifiers, is in proofs/MEANING.md under its name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/expression/expression.hpp"
#include "mechanics/elements/element.hpp"

namespace slipproof {

class ClaimChange;
class ClaimJudge;
class ClaimWriter;
class Implications;
struct ClaimBody;
struct Judgement;
struct Settlement;

using Modes = std::vector<MechanismMode>;
/// `=` between what is linear in the unknowns of the mechanism and in the force.
using Equations = std::vector<Expression>;
/// Indices of other claims.
using References = std::vector<std::size_t>;

/// A key that claims of a kind have, of those in claims/reading/read_body.cpp.
struct ClaimField {
  std::string_view key;
  enum class Need : std::uint8_t { required, optional } need = Need::required;
  std::vector<std::string_view> kinds = {};  ///< of references: the kinds of claims that they may be to
  bool not_empty = false;                    ///< of references: there has to be one
};

/// What a claim says in words, piece by piece: a text, a mode or several, claims, a formula, equations.
using ClaimWords = std::vector<std::variant<std::string, Modes, References, Expression, Equations>>;

class ClaimKind {
 public:
  struct Traits {
    std::string_view name;
    std::vector<ClaimField> fields;  ///< beside `region` and `expect`
    bool seeks = false;              ///< a motion, somewhere: one sample is a proof, and none is a refutation
    bool of_all_motions = false;     ///< it speaks of motions in all modes, not only in those that it names
    /// Whether the forces of one mode are compared with those of another.
    enum class Compares : std::uint8_t { no, in_closed_settings, always } compares_modes = Compares::no;
    /// Another region or other forces change what it says of each bicycle, not only of which it speaks.
    bool says_by_region = false;
    /// What a plane of figures judges it for: it states motions at a force; its thresholds are drawn, too.
    enum class InPlanes : std::uint8_t { no, judged, with_thresholds } in_planes = InPlanes::no;
  };

  explicit ClaimKind(Traits traits) : traits_(std::move(traits)) {}
  virtual ~ClaimKind() = default;
  ClaimKind(const ClaimKind&) = delete;
  ClaimKind& operator=(const ClaimKind&) = delete;

  const Traits& traits() const { return traits_; }
  std::string_view name() const { return traits_.name; }
  /// Null: it does not have the key.
  const ClaimField* field(std::string_view key) const;
  bool has(std::string_view key) const { return field(key) != nullptr; }
  /// It is about equations that are linear in the unknowns, not about motions.
  bool is_linear() const { return has("equations"); }
  /// `forces` are those of which it speaks; if not, they are what it says, if it has them.
  bool forces_say_where() const { return has("forces") && field("forces")->need == ClaimField::Need::optional; }

  /// At a sample in its region: a row of the table in proofs/MEANING.md.
  virtual Judgement judge(ClaimJudge& at) const = 0;
  /// The modes whose motions, all of them at a force, it speaks of.
  virtual Modes moving(const ClaimBody& body) const;

  /// The statements that together prove it, and those of its refutation: claims/statements says which.
  virtual void state(ClaimWriter& writer) const = 0;
  virtual void refute(ClaimWriter& writer) const = 0;
  /// Why there are no statements; empty: for no reason of its own.
  virtual std::string why_unstated(const ClaimBody& body) const;

  /// Whether it is what it says, `holds` or equations, of all parameters and forces.
  virtual bool may_be_identity(const ClaimBody& body) const;
  /// Whether it is proved that it says something of no bicycle; the claim is given by its index.
  virtual bool says_nothing(const Implications& logic, std::size_t claim, const ClaimBody& body) const = 0;
  /// What a change of it comes to, by exact arguments; nothing: none was found.
  virtual std::optional<Settlement> settle(const ClaimChange& change) const = 0;

  /// What it says, after its region and the forces of which it speaks; `noun` is what bicycles are called.
  virtual ClaimWords words(const ClaimBody& body, std::string_view noun) const = 0;
  /// How it fails, where only it can say that.
  virtual std::string failing(const ClaimBody& body, const Judgement& judgement, std::string_view noun) const;

 private:
  Traits traits_;
};

}  // namespace slipproof
