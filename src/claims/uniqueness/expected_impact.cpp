#include "claims/uniqueness/expected_impact.hpp"

#include "contact/impact/solve_impact.hpp"

namespace slipproof {

ExpectedImpact expected_impact(const std::filesystem::path& file, const std::string& id) {
  const auto by = [&](std::optional<ImpactLaw> law) {
    return solve_impact(read_scene(file, {Dimensions::any, ImpactRequest{law}}));
  };
  ExpectedImpact result{id, {by(std::nullopt)}};
  const ImpactLaw own = result.scene().mechanism.impact->law;
  for (const ImpactLaw law : {ImpactLaw::newton, ImpactLaw::moreau, ImpactLaw::poisson}) {
    if (law != own) result.laws.push_back(by(law));
  }
  return result;
}

}  // namespace slipproof
