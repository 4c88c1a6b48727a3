// The contacts of an answer in their friction cones, all in one picture of r_T / (mu r_N). The friction law keeps this
// in the unit disc.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contact/judge/judge.hpp"

namespace slipproof {

/// How many contacts obey each case of their law, or come nearest to it.
struct FitCounts {
  std::size_t open = 0, stick = 0, slide = 0;
  std::size_t smooth = 0;  ///< closed, and without friction: mu = 0, or dimension 1
};

struct ConePoint {
  std::size_t contact = 0;     ///< counted from 0
  std::array<double, 2> at{};  ///< r_T / (mu r_N); for planar contacts the second number is 0
  double size = 0;             ///< r_N divided by the largest in the picture, in (0, 1]
  bool slides = false, marked = false;
};

struct ConeDisc {
  std::size_t dimension = 3, contacts = 0;
  FrictionLaw law = FrictionLaw::cone;   ///< the cone, or a pyramid: what keeps forces in
  std::optional<FrictionLaw> right_for;  ///< a pyramid that is drawn in addition to the law
  FitCounts counts;
  std::size_t placed = 0;             ///< number of contacts with a place in the disc
  std::vector<ConePoint> points;      ///< those of them that are drawn, by number
  std::vector<std::size_t> unplaced;  ///< worst contacts without a place, because they are open or without friction
};

/// r_T / (mu r_N) of one component. Divides by mu and r_N one after the other, because their product may underflow. A
/// quotient that overflows is far outside the disc, and is replaced by a finite number.
double in_cone(double tangential, double mu, double normal);

/// The judgement must have a residual. Its worst contacts are marked and always drawn; of the others at most `most`
/// are, evenly spaced by number.
ConeDisc cone_disc(const MixedProblem& problem, const ContactJudgement& judgement, std::size_t most);

}  // namespace slipproof
