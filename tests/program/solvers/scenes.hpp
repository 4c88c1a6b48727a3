// The scenes that every solver gets: short decimals, forces in each cell of the line of forces and next to its ends.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "support/bicycle/motions.hpp"
#include "support/scenes/bicycle_populations.hpp"

namespace slipproof::test {

struct SolverAnswer {
  double a = 0, S2 = 0, S3 = 0, N2 = 0, N3 = 0;
  std::string mode;  ///< where the solver knows it
  int info = 0;      ///< what the solver says of its success, 0: success
};

/// RandomBicycles with J, kind internal, numbers that are the nearest binary64 of short decimals.
inline std::vector<ForcedScene<double>> solver_scenes() {
  RandomBicycles random(2024);
  std::vector<ForcedScene<double>> scenes;
  const auto shortened = [](double x, int digits) { return std::stod(fmt::format("{:.{}g}", x, digits)); };
  for (int i = 0; i < 24; ++i) {
    auto s = nearest_binary64(random.scene(Population::bicycles));
    s.bicycle.J = random.uniform(5, 30);
    s.force_kind = ForceKind::internal;
    s.bicycle.I1 = 0;  // so that a rigid-body engine without gears can take part
    if (s.bicycle.h <= 0) s.bicycle.h = 0.5;
    if (i % 3 == 0) s.bicycle.b2 = s.bicycle.b3 = s.road.f * s.bicycle.h / 2.2;  // near where thresholds meet
    s = convert<double, double>(s, [&](double x) { return shortened(x, 3); });
    const auto exact = to_rational(s);
    const ModeTable table(exact.bicycle, exact.road, exact.force_kind);
    const auto cells = partition(table);
    for (const Cell& cell : cells) {
      if (cell.forces.is_point()) continue;
      s.F = shortened(nearest_binary64(cell.forces.sample()), 4);
      scenes.push_back(s);
      if (cell.forces.upper() && i % 4 == 0) {  // a threshold, as near as binary64 comes
        s.F = nearest_binary64(*cell.forces.upper());
        scenes.push_back(s);
      }
    }
  }
  return scenes;
}

/// One CSV: the scenes and a solver's answers.
inline void record(const std::string& path, const std::function<SolverAnswer(const ForcedScene<double>&)>& solve) {
  std::FILE* out = std::fopen(path.c_str(), "w");
  if (out == nullptr) throw std::runtime_error("cannot write " + path);
  fmt::print(out, "M,R,h,b2,b3,I1,I2,I3,r1,r2,L,f,g,F,J,mode,a,S2,S3,N2,N3,info\n");
  for (const auto& s : solver_scenes()) {
    convert<double, double>(s, [&](double x) {
      fmt::print(out, "{},", x);
      return x;
    });
    const SolverAnswer x = solve(s);
    fmt::print(out, "{},{},{},{},{},{},{}\n", x.mode, x.a, x.S2, x.S3, x.N2, x.N3, x.info);
  }
  std::fclose(out);
}

}  // namespace slipproof::test
