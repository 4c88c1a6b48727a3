// Modes and values of a mechanism as JSON.
#pragma once

#include "mechanics/points/problem.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof {

inline Json names_json(const std::vector<MechanismMode>& modes) {
  Json names = Json::array();
  for (const MechanismMode& mode : modes) names.push_back(name(mode));
  return names;
}

/// Parameters that are given, and angles, by name.
inline Json values_json(const Mechanism& mechanism, const MechanismValues& values) {
  Json object = Json::object();
  for (std::size_t i = 0; i < values.parameters.size(); ++i) {
    if (values.given[i]) object[mechanism.parameters[i].symbol] = to_json(values.parameters[i]);
  }
  for (std::size_t i = 0; i < values.angles.size(); ++i) {
    object[mechanism.angles[i].name] = {{"cos", to_json(values.angles[i].cosine)},
                                        {"sin", to_json(values.angles[i].sine)}};
  }
  return object;
}

}  // namespace slipproof
