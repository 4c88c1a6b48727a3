// What is wrong with a paper: a list that could be sent to its authors, and the places at which an editor can show it.
#pragma once

#include <string>
#include <vector>

#include "claims/verify/verify.hpp"
#include "report/document/document.hpp"
#include "report/papers/claim_counts.hpp"

namespace slipproof {

/// How sure a finding is.
enum class Certainty : std::uint8_t {
  proved,   ///< for an error: by an exact counterexample; for a repair: for all parameters
  sampled,  ///< the repair holds at every sample, or what is missing was found at no sample
};
std::string_view name(Certainty certainty);

/// A part of a claim or definition that differs between print and repair.
struct FindingPart {
  std::string key;        ///< `where`, `forces`, `claim`, `equation`, `motions`; for a definition its symbol
  Expression expression;  ///< null: there is only `text`
  std::string text;
  bool defines = false;  ///< `key` is the symbol that `expression` defines
};
using FindingParts = std::vector<FindingPart>;
/// `where: b < b1; forces: ...`; for a definition `b1 = ...`.
std::string to_string(const FindingParts& parts);

/// One error in the print, or in a claim of our own.
struct Finding {
  std::string id;  ///< of the claim; `3.1.b1` for a definition
  Origin origin = Origin::printed;
  std::size_t line = 0;
  Grade grade = Grade::misprint;
  bool graded = true;  ///< whether the claims file gives the grade; without one, a refuted claim counts as `false`
  std::string statement;
  FindingParts printed;                   ///< empty if the claim is its statement
  std::string wrong;                      ///< what is wrong, with the counterexample
  FindingParts repair;                    ///< empty: there is no repair
  std::string why;                        ///< why the repair is what was meant
  Certainty error = Certainty::proved;    ///< how sure it is that the print is wrong
  Certainty mended = Certainty::sampled;  ///< how sure it is that the repair is right
  std::vector<std::string> certificates;  ///< certificates that prove all or part of what holds with the repair
  std::uint64_t samples = 0;              ///< samples at which the unproved rest holds; 0 if all is proved
  std::vector<std::string> claims;        ///< all claims that the finding affects
  std::vector<std::string> disproofs;     ///< certificates of the statement that is true instead
  std::vector<std::string> refutations;   ///< certificates that prove the error
  std::uint64_t tried = 0;                ///< samples at which an error was looked for, if there is no other evidence
};

/// The grade; says so if none is given.
std::string grade_text(const Finding& finding);

/// How sure the error is, and how sure the repair is, with the names of certificates or the number of samples.
std::string error_certainty(const Finding& finding);
std::string repair_certainty(const Finding& finding);

/// How the claims of a paper stand; the list of findings alone does not show that.
struct Standing {
  CountsByOrigin claims;
  std::size_t definitions = 0;  ///< findings about definitions that claims use
  std::size_t shared = 0;       ///< refuted claims that show a finding about another claim or about a definition
  std::size_t others = 0;       ///< findings about claims that are not refuted
  std::size_t missing = 0;      ///< certificates that the claims file asks for, in any reading
};

struct Errata {
  std::vector<Finding> findings;  ///< in the order of the paper's lines
  Standing standing;
};

Errata errata(const ClaimsFile& file, const VerifyResult& result);

/// How many claims were judged, hold, are refuted and are open; if there is no finding, also whether that means
/// anything. Whole sentences.
std::string standing_text(const Errata& errata);
/// How the number of refuted claims leads to the number of findings, in whole sentences; empty if both are 0.
std::string sum_text(const Errata& errata);

/// What errata_document() and finding_document() return may be written only while the claims file exists.
Document errata_document(const ClaimsFile& file, const Errata& errata);
/// One finding: `source:line: grade [id]`, and the facts about it.
ReportLine finding_heading(const ClaimsFile& file, const Finding& finding);
Document finding_document(const ClaimsFile& file, const Finding& finding);
/// One JSON document, schema slipproof/errata/1.
std::string errata_json(const ClaimsFile& file, const Errata& errata);
/// SARIF 2.1.0, with line numbers of the paper's source.
std::string errata_sarif(const ClaimsFile& file, const Errata& errata);

/// A table: every numbered equation of the paper with its claims.
Document coverage_document(const ClaimsFile& file);
/// The numbered equations without a claim.
std::vector<std::string> uncovered_equations(const ClaimsFile& file);

}  // namespace slipproof
