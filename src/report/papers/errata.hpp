// What is wrong with a paper: a list that could be sent to its authors, and where an editor can show it.
#pragma once

#include <string>
#include <vector>

#include "claims/verify/verify.hpp"
#include "report/document/document.hpp"

namespace slipproof {

/// How sure a finding is.
enum class Certainty : std::uint8_t {
  proved,   ///< of an error: by an exact counterexample; of a repair: for all parameters
  sampled,  ///< the repair holds at every sample, or what is missing was found at none
};
std::string_view name(Certainty certainty);

/// A part of a claim or definition in which print and repair differ.
struct FindingPart {
  std::string key;        ///< what it is: `where`, `forces`, `claim`, `equation`, `motions`; the symbol of a definition
  Expression expression;  ///< null: `text` is all there is
  std::string text;
  bool defines = false;  ///< `key` is the symbol that `expression` defines
};
using FindingParts = std::vector<FindingPart>;
/// `where: b < b1; forces: ...`, of a definition `b1 = ...`.
std::string to_string(const FindingParts& parts);

/// One thing that is wrong in print.
struct Finding {
  std::string id;  ///< of the claim, or `3.1.b1` of a definition
  std::size_t line = 0;
  Grade grade = Grade::misprint;
  bool graded = true;  ///< the claims file gives the grade: a refuted claim without one is `false` until it does
  std::string statement;
  FindingParts printed;                   ///< empty where the claim is its statement
  std::string wrong;                      ///< what is wrong, with the counterexample
  FindingParts repair;                    ///< empty: there is none
  std::string why;                        ///< why that is meant
  Certainty error = Certainty::proved;    ///< that the print is wrong
  Certainty mended = Certainty::sampled;  ///< that the repair is right
  std::vector<std::string> certificates;  ///< names of those that prove what holds with the repair, or part of it
  std::uint64_t samples = 0;              ///< at which the rest of it holds: 0 where all is proved
  std::vector<std::string> claims;        ///< all claims that it touches
  std::vector<std::string> disproofs;     ///< certificates of what is true instead
  std::vector<std::string> refutations;   ///< names of certificates that prove the error
  std::uint64_t tried = 0;                ///< samples at which an error was looked for, where that is all there is
};

/// The grade, and that none is given where that is so.
std::string grade_text(const Finding& finding);

/// How sure the error is, and how sure the repair: with the certificates' names, or the number of samples.
std::string error_certainty(const Finding& finding);
std::string repair_certainty(const Finding& finding);

/// How the claims of a paper stand as printed: what a list of findings alone does not say.
struct Standing {
  std::size_t judged = 0, proved = 0, held = 0, refuted = 0;  ///< those that hold do not count the proved ones
  std::vector<std::string> undecided, vacuous;                ///< ids
  std::size_t definitions = 0;                                ///< findings about definitions, on which claims rest
  std::size_t shared = 0;   ///< refuted claims that show a finding of another claim, or of a definition
  std::size_t others = 0;   ///< findings about claims that are not refuted
  std::size_t missing = 0;  ///< certificates that the claims file asks for, in whatever reading
};

struct Errata {
  std::vector<Finding> findings;  ///< in the order of the paper's lines
  Standing standing;
};

Errata errata(const ClaimsFile& file, const VerifyResult& result);

/// How many claims were judged, hold, are refuted and are open, and where there is no finding whether that means
/// anything. Whole sentences.
std::string standing_text(const Errata& errata);
/// How the refuted claims come to the findings: whole sentences, empty where there is none of either.
std::string sum_text(const Errata& errata);

/// The document may be written as long as the claims file is there.
Document errata_document(const ClaimsFile& file, const Errata& errata);
/// One finding: where it is and how grave, and the facts about it.
ReportLine finding_heading(const ClaimsFile& file, const Finding& finding);
Document finding_document(const ClaimsFile& file, const Finding& finding);
/// One JSON document, schema slipproof/errata/1.
std::string errata_json(const ClaimsFile& file, const Errata& errata);
/// SARIF 2.1.0, with the lines of the paper's source.
std::string errata_sarif(const ClaimsFile& file, const Errata& errata);

/// A table: every numbered equation of the paper with its claims.
Document coverage_document(const ClaimsFile& file);
/// The numbered equations without a claim.
std::vector<std::string> uncovered_equations(const ClaimsFile& file);

}  // namespace slipproof
