// The functions V of proofs/rest-on-slope, as its README prints them, and random motions along which they are followed.
#pragma once

#include <functional>
#include <string>

#include "mechanics/rest_on_slope/body.hpp"

namespace slipproof::test::rest_on_slope {

struct Numbers {
  double K1 = 0, K2 = 0, K3 = 0, B1 = 0, B2 = 0, E = 0;
};

/// A function of the state that falls at least as fast as `rate` times |x'| + |z1'| + |z2'|.
struct Falling {
  std::function<double(const State&)> value;
  double rate = 0;
};

/// With six numbers and kappa.
Falling falling(const Body& body, const Numbers& numbers, double kappa);
/// For the body beyond the six numbers, on slopes up to 1/10.
Falling falling_beyond();

/// What was seen along a motion.
struct Seen {
  int stretches = 0, hits = 0;  ///< between impacts, and parts of impacts
  bool rests = false;           ///< it came to rest, or V below 1e-8 of that of the beginning
  double way = 0;               ///< the integral of |x'| + |z1'| + |z2'|
  double slack = 0;             ///< the most by which V rose, or fell too slowly, in a step, as a part of V
  std::string rise;             ///< where V rose or fell too slowly by more than rounding, or was not positive
};

/// Follows a random motion until it rests, V rises, or there were `limit` steps.
Seen follow(const Body& body, const Falling& falling, State state, Dice& dice, int limit);

}  // namespace slipproof::test::rest_on_slope
