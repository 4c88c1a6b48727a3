// What `slipproof verify` says: every claim's verdict, and counterexamples that a person can check by hand.
#pragma once

#include <string>
#include <string_view>

#include "claims/verify/verify.hpp"
#include "report/document/document.hpp"
#include "report/papers/explain.hpp"

namespace slipproof {

/// One JSON document, schema slipproof/verify/1, ending in a newline.
std::string verify_json(const ClaimsFile& file, const VerifyResult& result);

/// For people; the status begins with `s VERIFIED`, `s REFUTED`, `s UNDECIDED` or `s REJECTED`, with counts; those that
/// hold include the proved ones.
Document verify_document(const ClaimsFile& file, const VerifyResult& result);

/// All verdicts as expected; or the first of: a certificate rejected, something else refuted, something else undecided,
/// which it also is where no claim was judged.
enum class Summary { as_expected, rejected, refuted, undecided };
Summary summary(const ClaimsFile& file, const VerifyResult& result);
std::string_view summary_word(Summary summary);  ///< `VERIFIED`, `REJECTED`, `REFUTED` or `UNDECIDED`

}  // namespace slipproof
