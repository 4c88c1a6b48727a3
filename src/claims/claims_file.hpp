// What a paper states, as data: its symbols, its definitions, and its claims about the model, read from a file
// `slipproof/claims/1`. proofs/CLAIMS.md describes the file for those who write one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "claims/claim_kinds.hpp"
#include "expression/expression.hpp"
#include "model/bicycle.hpp"

namespace slipproof {

/// What stands in print; and, where the print is plainly a misprint, what was meant.
enum class Reading : std::uint8_t { printed, repaired };
inline constexpr std::array<Reading, 2> all_readings{Reading::printed, Reading::repaired};
std::string_view name(Reading reading);

struct Paper {
  std::string title;
  std::vector<std::string> authors;
  std::string reference;  ///< where it is published; may be empty
  std::string source;     ///< file name of the text that line numbers refer to
  struct Equation {
    std::string number;
    std::size_t line = 0;
  };
  std::vector<Equation> equations;  ///< all that the paper numbers, in its order
  /// `Section 3`, `Assertion 5`: what a reader of the printed paper finds, and on which line it begins.
  std::map<std::size_t, std::string> headings;

  /// Where a line is for who has the paper and not its source: `Section 4.2, after (4.3)`; empty without headings.
  std::string place(std::size_t line) const;
  /// The same with the line: `Section 4.2, (4.3) (line 265)`; `Line 265` without headings.
  std::string where(std::size_t line) const;
};

/// A statement that no calculation can judge.
struct Unchecked {
  std::string id;
  std::size_t line = 0;
  std::string statement;
  std::string why;
};

/// A symbol of the paper that may take any value in its domain.
struct Parameter {
  std::string symbol;
  Expression domain;  ///< over parameters
  std::string meaning;
  std::size_t line = 0;  ///< of the source; 0 if the paper does not have it

  bool is_positive() const;  ///< its domain says just that, in whatever order
};

/// The paper's variable for the force, the only one that a sample leaves open.
struct ForceVariable {
  std::string symbol;
  Expression domain;  ///< where the paper stands, over parameters and the force
  std::size_t line = 0;
};

/// A parameter set to the value at which something changes: `b = b1`.
struct Boundary {
  std::string symbol;
  Expression value;  ///< over parameters and definitions, independent of the symbol and of the force
};

/// Something that one could build has to meet.
struct Realisable {
  std::string name;
  Expression condition;  ///< over parameters and definitions, these as repaired; independent of the force
};

/// A symbol defined by the paper.
struct Definition {
  std::string symbol;
  std::string equation;  ///< number in the paper, `3.1`
  std::size_t line = 0;
  Expression printed;
  Expression repaired;  ///< null: as printed
  std::string why;      ///< why the print must be a misprint

  const Expression& value(Reading reading) const {
    return reading == Reading::repaired && repaired ? repaired : printed;
  }
  /// The paper uses the symbol and does not say what it is; it stands in the file as a quotient by 0.
  bool is_nowhere(Reading reading) const;
};

/// What a definition is called in references and lists: `3.1.b1`, or its symbol where the paper gives it no number.
std::string id(const Definition& definition);

/// Expressions for what a scene file holds, over parameters; `F` also over the force.
inline constexpr std::array<std::string_view, 15> scene_symbols{"M",  "R",  "h", "b2", "b3", "I1", "I2", "I3",
                                                                "r1", "r2", "L", "J",  "f",  "g",  "F"};

/// One way in which the paper looks at the model: which symbols are free and what they are in a scene.
struct Setting {
  std::string id;
  std::string statement;
  std::size_t line = 0;
  ForceKind force_kind = ForceKind::internal;
  bool strict = true;  ///< the paper's motions satisfy their conditions strictly
  std::vector<Parameter> parameters;
  ForceVariable force;
  std::map<std::string, Expression, std::less<>> scene;  ///< by scene symbol; all but J must be there
  std::vector<Definition> definitions;                   ///< each uses only symbols that do not lead back to it
  std::vector<Boundary> boundaries;
  std::vector<Realisable> realisable;  ///< none: nothing is said about what can be built

  /// What makes the scene a bicycle of the model (model/domain.hpp) and the force a polynomial of degree 1 at most, as
  /// numbers that have to be positive, not negative, and different from 0. The scene must be complete.
  struct BicycleConditions {
    std::vector<Expression> positive, not_negative, defined;
    Expression slope;  ///< of the pedal force in the force variable; null if that is not linear as it stands
  };
  BicycleConditions bicycle_conditions() const;

  /// Of a symbol that is a parameter.
  std::size_t parameter_index(std::string_view symbol) const;
};

/// How a claim fails, if it does.
enum class Grade : std::uint8_t { misprint, gap, boundary, wrong };
std::string_view name(Grade grade);  ///< `wrong` is written `false`

/// What a claim is known to get.
enum class Expectation : std::uint8_t { none, holds, refuted, undecided, vacuous };
std::string_view name(Expectation expectation);

/// What one reading of a claim says.
struct ClaimBody {
  Expression region = make_truth(true);  ///< bicycles: over parameters and definitions, independent of the force
  ClaimKind says;
  Expectation expect = Expectation::none;
};

/// All conditions and equations of a body.
std::vector<Expression> expressions(const ClaimBody& body);

struct Claim {
  std::string id;
  std::string equation;  ///< number in the paper, or empty
  std::size_t line = 0;
  std::string statement;    ///< in words or as printed
  std::size_t setting = 0;  ///< index
  ClaimBody printed;
  /// There if the repaired reading is another one: the claim's own repair, or that of a definition that it uses.
  std::optional<ClaimBody> repaired;
  std::string why;  ///< of the claim's own repair
  std::string note;
  std::optional<Grade> grade;
  /// Findings of others that it shows once more: ids of graded claims, or `3.1.b1` of a repaired definition.
  std::vector<std::string> part_of;

  const ClaimBody& body(Reading reading) const {
    return reading == Reading::repaired && repaired ? *repaired : printed;
  }
  /// The same in every reading.
  template <class Kind>
  bool is() const {
    return std::holds_alternative<Kind>(printed.says);
  }
};

struct ClaimsFile {
  std::string file;
  Paper paper;
  std::vector<Setting> settings;
  std::vector<Claim> claims;
  std::vector<Unchecked> unchecked;

  const Claim* find(std::string_view id) const;
};

/// Reads a claims file. Throws InputError with every mistake of the file, in the order of their places.
ClaimsFile read_claims(const std::filesystem::path& path);

/// The same from a text; `file` is how messages call it.
ClaimsFile parse_claims(std::string_view text, const std::string& file);

}  // namespace slipproof
