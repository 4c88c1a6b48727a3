// Values of a freed symbol, and the motions there by their modes, as JSON.
#pragma once

#include "mechanics/planes/phase_diagram.hpp"
#include "mechanics/points/degrees.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof {

/// A number; of an angle its cosine and sine.
inline Json across_json(const Axis& axis, const Rational& x) {
  if (!axis.is_angle) return to_json(x);
  const MechanismValues::Circle point = point_of_tan_half(x);
  return {{"cos", to_json(point.cosine)}, {"sin", to_json(point.sine)}};
}

/// `inside` the domain or not, and there `complete`, `motions` and `continua`.
inline Json set_json(const std::optional<MotionSet>& set) {
  if (!set) return {{"inside", false}};
  Json motions = Json::array(), continua = Json::array();
  for (const auto& modes : set->motions) motions.push_back(mode_name(*set, modes.front()));
  for (const MechanismMode& mode : set->continua) continua.push_back(mode_name(*set, mode));
  return {{"inside", true}, {"complete", set->complete}, {"motions", motions}, {"continua", continua}};
}

}  // namespace slipproof
