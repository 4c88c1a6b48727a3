// Sampled verdicts and certificates, brought together: which claims are proved for all parameters, and by what.
#pragma once

#include <filesystem>

#include "verify/verify.hpp"

namespace slipproof {

/// Looks in `folder` (certificates_folder() of the claims file) for the certificates of every claim of `result` and
/// checks them. A claim that holds at every sample and whose statements, the same bytes as the claims file gives now,
/// all have accepted certificates becomes `proved`, and its certificates are named; of a refuted claim, that of its
/// refutation; and a claim that holds at every sample is refuted, too, where that is accepted. Certificates that are
/// there and are not accepted stand in `rejections`; so does a contradiction of samples and certificates.
void find_certificates(const ClaimsFile& file, VerifyResult& result, const std::filesystem::path& folder);

}  // namespace slipproof
