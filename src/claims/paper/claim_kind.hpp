// The interface of a kind of claims: everything that the rooms of this wing, and reports, ask of it. Each kind is one
// file in claims/kinds; its meaning, with all quantifiers, is in proofs/MEANING.md under its name.
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
namespace claims_reader {
struct BodyTable;
}

using Modes = std::vector<MechanismMode>;
/// Equations, `=`, between numbers that are linear in the mechanism's unknowns and the force.
using Equations = std::vector<Expression>;
/// Indices of other claims.
using References = std::vector<std::size_t>;

/// A key that claims of a kind have.
struct ClaimField {
  std::string_view key;
  enum class Need : std::uint8_t { required, optional } need = Need::required;
  std::vector<std::string_view> kinds = {};  ///< for references: the kinds of claims that they may refer to
  bool not_empty = false;                    ///< for references: at least one is required
  /// For a key of this kind alone: what messages expect, and how it is read. Those that kinds share are read in
  /// claims/reading/read_body.cpp.
  std::string_view expected = {};
  void (*read)(const claims_reader::BodyTable& table, std::string_view key) = nullptr;
  bool only_for_proofs = false;  ///< it does not change what is claimed
};

/// The content of a claim in words, piece by piece: texts, modes, claims, formulas, equations.
using ClaimWords = std::vector<std::variant<std::string, Modes, References, Expression, Equations>>;

class ClaimKind {
 public:
  struct Traits {
    std::string_view name;
    std::vector<ClaimField> fields;  ///< in addition to `region` and `expect`
    bool seeks = false;  ///< it asserts that a motion exists: one sample is a proof, and no sample is a refutation
    bool of_all_motions = false;  ///< it is about motions in all modes, not only in those that it names
    /// Whether it compares the forces of one mode with those of another.
    enum class Compares : std::uint8_t { no, in_closed_settings, always } compares_modes = Compares::no;
    /// It says something about a bicycle even if no force is in the domain.
    bool needs_no_force = false;
    /// Changing its region or forces changes what it says about each bicycle, not only which bicycles it is about.
    bool says_by_region = false;
    /// Whether planes of figures judge it, because it states motions at a force, and whether they also draw its
    /// thresholds.
    enum class InPlanes : std::uint8_t { no, judged, with_thresholds } in_planes = InPlanes::no;
  };

  explicit ClaimKind(Traits traits) : traits_(std::move(traits)) {}
  virtual ~ClaimKind() = default;
  ClaimKind(const ClaimKind&) = delete;
  ClaimKind& operator=(const ClaimKind&) = delete;

  const Traits& traits() const { return traits_; }
  std::string_view name() const { return traits_.name; }
  /// Null if the kind does not have the key.
  const ClaimField* field(std::string_view key) const;
  bool has(std::string_view key) const { return field(key) != nullptr; }
  /// The kind is about equations that are linear in the unknowns, not about motions.
  bool is_linear() const { return has("equations"); }
  /// True if `forces` are the forces that the claim is about; false if they are what it states, or if it has none.
  bool forces_say_where() const { return has("forces") && field("forces")->need == ClaimField::Need::optional; }

  /// Judges the claim at a sample in its region: one row of the table in proofs/MEANING.md.
  virtual Judgement judge(ClaimJudge& at) const = 0;
  /// The modes all of whose motions at a force the claim is about.
  virtual Modes moving(const ClaimBody& body) const;

  /// Writes the statements that together prove the claim, and those that refute it; claims/statements lists them.
  virtual void state(ClaimWriter& writer) const = 0;
  virtual void refute(ClaimWriter& writer) const = 0;
  /// Why there are no statements; empty if the kind has no reason of its own.
  virtual std::string why_unstated(const ClaimBody& body) const;

  /// Whether `holds` or the equations may be an identity in all parameters and forces.
  virtual bool may_be_identity(const ClaimBody& body) const;
  /// Whether it is proved that the claim has a value at every bicycle and says nothing there. `claim` is its index; the
  /// force's domain is an interval, and the region has a value, at every bicycle.
  virtual bool says_nothing(const Implications& logic, std::size_t claim, const ClaimBody& body) const = 0;
  /// The effect of a change of the claim, by exact arguments; nothing if none was found.
  virtual std::optional<Settlement> settle(const ClaimChange& change) const = 0;

  /// What the claim says, after its region and the forces that it is about. `noun` is the word for bicycles.
  virtual ClaimWords words(const ClaimBody& body, std::string_view noun) const = 0;
  /// How the claim fails, if only the kind can say that.
  virtual std::string failing(const ClaimBody& body, const Judgement& judgement, std::string_view noun) const;

 private:
  Traits traits_;
};

/// All kinds, in the order in which messages list them; claims/kinds has them.
const std::vector<const ClaimKind*>& claim_kinds();
/// Null if no kind has this name.
const ClaimKind* claim_kind(std::string_view name);

}  // namespace slipproof
