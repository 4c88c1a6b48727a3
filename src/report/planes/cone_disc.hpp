// An answer's contacts in their friction cones, all in one picture: r_T / (mu r_N), which the law holds in the unit
// disc.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contact/judge/judge.hpp"

namespace slipproof {

/// How many contacts obey their law in which way, or come nearest to it so.
struct FitCounts {
  std::size_t open = 0, stick = 0, slide = 0;
  std::size_t smooth = 0;  ///< closed, and without friction: mu = 0, or dimension 1
};

struct ConePoint {
  std::size_t contact = 0;     ///< from 0
  std::array<double, 2> at{};  ///< r_T / (mu r_N); in the plane the second one is 0
  double size = 0;             ///< r_N over the largest one of the picture, in (0, 1]
  bool slides = false, marked = false;
};

struct ConeDisc {
  std::size_t dimension = 3, contacts = 0;
  FrictionLaw law = FrictionLaw::cone;
  std::optional<FrictionLaw> right_for;  ///< a pyramid that is drawn beside the law
  FitCounts counts;
  std::size_t placed = 0;             ///< contacts with a place in the disc
  std::vector<ConePoint> points;      ///< of these, the ones that are drawn, in the order of their numbers
  std::vector<std::size_t> unplaced;  ///< worst contacts that have none: they are open, or without friction
};

/// The judgement must have a residual. Its worst contacts are marked, and always drawn; of the others at most `most`,
/// evenly by their numbers.
ConeDisc cone_disc(const MixedProblem& problem, const ContactJudgement& judgement, std::size_t most);

}  // namespace slipproof
