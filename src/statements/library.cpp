#include "statements/library.hpp"

#include <fstream>
#include <iterator>

namespace slipproof {

std::filesystem::path certificates_folder(const std::filesystem::path& claims) {
  return claims.parent_path() / "certificates";
}

ClaimProof find_proof(const std::vector<NamedStatement>& statements, const std::filesystem::path& folder,
                      const CertificateJudge& rejection) {
  ClaimProof result;
  for (const NamedStatement& statement : statements) {
    const std::filesystem::path certificate = folder / (statement.name + ".cert");
    result.certificates.push_back(certificate);
    std::ifstream file(folder / (statement.name + ".statement"), std::ios::binary);
    if (!file) {
      result.problems.push_back(statement.name + ": no such statement in the folder");
      continue;
    }
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (text != statement.text) {
      result.outdated.push_back(statement.name + ": the statement in the folder is not the claim's");
      continue;
    }
    std::error_code error;
    if (!std::filesystem::exists(certificate, error)) {
      result.problems.push_back(statement.name + ": no certificate");
      continue;
    }
    const std::string objection = rejection(certificate);
    if (!objection.empty()) result.rejections.push_back(objection);
  }
  for (const auto* some : {&result.outdated, &result.rejections}) {
    result.problems.insert(result.problems.end(), some->begin(), some->end());
  }
  result.proved = !statements.empty() && result.problems.empty();
  return result;
}

ClaimProof find_claim_proof(const ClaimsFile& claims, const Claim& claim, Reading reading,
                            const std::filesystem::path& folder, const CertificateJudge& rejection) {
  return find_proof(claim_statements(claims, claim, reading), folder, rejection);
}

}  // namespace slipproof
