// The output of `slipproof verify`: the verdict on every claim, and counterexamples that a person can check by hand.
#pragma once

#include <string>
#include <string_view>

#include "claims/verify/verify.hpp"
#include "report/document/document.hpp"
#include "report/papers/explain.hpp"

namespace slipproof {

/// One JSON document, schema slipproof/verify/1, ending in a newline.
std::string verify_json(const ClaimsFile& file, const VerifyResult& result);

/// Whether a claim with many certificates, as one of kind `unique` has, names all of them.
enum class Names : std::uint8_t { few, all };

/// For people. The status begins with `s VERIFIED`, `s REFUTED`, `s UNDECIDED` or `s REJECTED`, with counts; the claims
/// that hold include the proved ones.
Document verify_document(const ClaimsFile& file, const VerifyResult& result, Names names = Names::few);

/// As expected if all verdicts are. Otherwise the first that applies: a certificate is rejected; an unexpected verdict
/// is refuted; an unexpected verdict is undecided, or no claim was judged.
enum class Summary { as_expected, rejected, refuted, undecided };
Summary summary(const ClaimsFile& file, const VerifyResult& result);
std::string_view summary_word(Summary summary);  ///< `VERIFIED`, `REJECTED`, `REFUTED` or `UNDECIDED`

}  // namespace slipproof
