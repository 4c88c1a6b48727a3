// What `slipproof solve` says of a scene: every motion at its force, or every mode's interval of forces.
#pragma once

#include <string>

#include "contact/problem/every_load.hpp"
#include "mechanics/bicycle_modes/motions.hpp"

namespace slipproof {

/// The exact answer to a scene. Solving and writing are apart so that one answer can be written in both forms.
struct SolvedScene {
  Scene scene;
  ModeTable table;
  std::optional<MotionsAtForce> at_force;  ///< when the scene gives F
  std::vector<Cell> cells;                 ///< the partition of the line of forces, when it does not
  std::optional<EveryLoad> for_every_q;    ///< nothing without J, or where W is infinite

  explicit SolvedScene(Scene scene);
};

struct SolveReportOptions {
  bool chain = false;  ///< also the sprocket's acceleration eps1 and the chain tension T
  int digits = 6;      ///< significant digits of the decimals beside exact numbers in text
};

/// One JSON document, schema slipproof/solve/1 (interface: see the README), ending in a newline.
std::string solve_json(const SolvedScene& solved, const SolveReportOptions& options = {});

/// For people; the last line begins with `s SOLVED`.
std::string solve_text(const SolvedScene& solved, const SolveReportOptions& options = {});

}  // namespace slipproof
