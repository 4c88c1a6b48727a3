// The enumerator of contact modes that everybody writes first: dense LU in double, conditions with a tolerance, the
// first mode that fits.
#include <Eigen/Dense>

#include "scenes.hpp"
#include "support/bicycle/linear_form.hpp"

using namespace slipproof;

namespace {

constexpr double tolerance = 1e-8;

test::SolverAnswer solve(const ForcedScene<double>& s) {
  for (const ContactMode mode : all_modes()) {
    constexpr int n = static_cast<int>(unknown_count);
    Eigen::Matrix<double, n, n> A;
    Eigen::Matrix<double, n, 1> b;
    const auto system = raw_system(s.bicycle, s.road, s.force_kind, mode);
    for (int i = 0; i < n; ++i) {
      const auto& form = system[static_cast<std::size_t>(i)];
      for (int j = 0; j < n; ++j) A(i, j) = form.coefficients[static_cast<std::size_t>(j)];
      b(i) = -form.constant - form.coefficients[unknown_count] * s.F;
    }
    const Eigen::Matrix<double, n, 1> x = A.partialPivLu().solve(b);
    const Unknowns<double> u{x(0), x(1), x(2), x(3), x(4), x(5), x(6), x(7), x(8), x(9), x(10)};
    bool fits = true;
    for (const Wheel w : {Wheel::rear, Wheel::front}) {
      const double N = w == Wheel::rear ? u.N2 : u.N3, S = w == Wheel::rear ? u.S2 : u.S3;
      const double slide = slip(s.bicycle, u, w);
      switch (mode[w]) {
        case WheelState::stick:
          fits = fits && N > -tolerance && std::fabs(S) < s.road.f * N + tolerance;
          break;
        case WheelState::slip_forward:
          fits = fits && N > -tolerance && slide > -tolerance;
          break;
        case WheelState::slip_backward:
          fits = fits && N > -tolerance && slide < tolerance;
          break;
        case WheelState::lift:
          fits = fits && gap(s.bicycle, u, w) > -tolerance;
          break;
        default:
          fits = false;
      }
    }
    if (fits) return {u.a, u.S2, u.S3, u.N2, u.N3, name(mode), 0};
  }
  const double nan = std::nan("");
  return {nan, nan, nan, nan, nan, "", 1};
}

}  // namespace

int main(int argc, char** argv) {
  test::record(std::string(argc > 1 ? argv[1] : ".") + "/plain-enumerator.csv", solve);
}
