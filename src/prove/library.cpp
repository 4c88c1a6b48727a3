#include "prove/library.hpp"

#include <fstream>
#include <iterator>

namespace slipproof {

ClaimProof find_claim_proof(const ClaimsFile& claims, const Claim& claim, Reading reading,
                            const std::filesystem::path& folder,
                            const std::function<std::string(const std::filesystem::path&)>& rejection) {
  ClaimProof result;
  const std::vector<NamedStatement> statements = claim_statements(claims, claim, reading);
  for (const NamedStatement& statement : statements) {
    const std::filesystem::path certificate = folder / (statement.name + ".cert");
    result.certificates.push_back(certificate);
    std::ifstream file(folder / (statement.name + ".statement"), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file || text != statement.text) {
      result.problems.push_back(statement.name + ": the statement in the folder is not the claim's");
      continue;
    }
    const std::string objection = rejection(certificate);
    if (!objection.empty()) result.problems.push_back(objection);
  }
  result.proved = !statements.empty() && result.problems.empty();
  return result;
}

}  // namespace slipproof
