// What is wrong with a paper: a list that could be sent to its authors, and where an editor can show it.
#pragma once

#include <string>
#include <vector>

#include "verify/verify.hpp"

namespace slipproof {

/// How sure a finding is.
enum class Certainty : std::uint8_t {
  proved,   ///< of an error: by an exact counterexample; of a repair: for all parameters
  sampled,  ///< the repair holds at every sample, or what is missing was found at none
};
std::string_view name(Certainty certainty);

/// One thing that is wrong in print.
struct Finding {
  std::string id;  ///< of the claim, or `3.1.b1` of a definition
  std::size_t line = 0;
  Grade grade = Grade::misprint;
  std::string statement;
  std::string printed;                    ///< as an expression; empty where the claim is its statement
  std::string wrong;                      ///< what is wrong, with the counterexample
  std::string repair;                     ///< empty: there is none
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

/// How sure the error is, and how sure the repair: with the certificates' names, or the number of samples.
std::string error_certainty(const Finding& finding);
std::string repair_certainty(const Finding& finding);

/// The findings of a verification, in the order of the paper's lines.
std::vector<Finding> errata(const ClaimsFile& file, const VerifyResult& result);

std::string errata_text(const ClaimsFile& file, const std::vector<Finding>& findings);
std::string errata_markdown(const ClaimsFile& file, const std::vector<Finding>& findings);
/// One JSON document, schema slipproof/errata/1.
std::string errata_json(const ClaimsFile& file, const std::vector<Finding>& findings);
/// SARIF 2.1.0, with the lines of the paper's source.
std::string errata_sarif(const ClaimsFile& file, const std::vector<Finding>& findings);

/// A table in Markdown: every numbered equation of the paper with its claims.
std::string coverage_markdown(const ClaimsFile& file);
/// The numbered equations without a claim.
std::vector<std::string> uncovered_equations(const ClaimsFile& file);

}  // namespace slipproof
