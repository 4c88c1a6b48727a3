// Several solvers of Siconos on the same scenes.
#include "support/siconos.hpp"

#include "scenes.hpp"

using namespace slipproof;

namespace {

test::SolverAnswer answer(const ForcedScene<double>& s, const test::SiconosAnswer& found) {
  const auto& lambda = found.lambda;
  const double external = s.force_kind == ForceKind::external ? s.F : 0;
  return {(lambda[1] + lambda[3] - external) / s.bicycle.M, lambda[1], lambda[3], lambda[0], lambda[2], "", found.info};
}

template <class Problem>
test::SolverAnswer solve(const ForcedScene<double>& s, int solver) {
  return answer(s, Problem(test::ContactProblem(s)).solve(test::siconos_options(solver).get()));
}

}  // namespace

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? argv[1] : ".";
  const std::pair<const char*, int> lcp[] = {{"lcp-enum", SICONOS_LCP_ENUM},
                                             {"lcp-lemke", SICONOS_LCP_LEMKE},
                                             {"lcp-newton-min", SICONOS_LCP_NEWTONMIN},
                                             {"lcp-bard", SICONOS_LCP_BARD},
                                             {"lcp-murty", SICONOS_LCP_MURTY},
                                             {"lcp-pivot", SICONOS_LCP_PIVOT},
                                             {"lcp-newton-fb", SICONOS_LCP_NEWTON_FB_FBLSA}};
  for (const auto& [name, id] : lcp) {
    test::record(folder + "/siconos-" + name + ".csv",
                 [id = id](const auto& s) { return solve<test::ContactLcp>(s, id); });
  }
  const std::pair<const char*, int> friction[] = {{"fc2d-nsgs", SICONOS_FRICTION_2D_NSGS},
                                                  {"fc2d-lemke", SICONOS_FRICTION_2D_LEMKE},
                                                  {"fc2d-enum", SICONOS_FRICTION_2D_ENUM}};
  for (const auto& [name, id] : friction) {
    test::record(folder + "/siconos-" + name + ".csv",
                 [id = id](const auto& s) { return solve<test::PlanarFriction>(s, id); });
  }
}
