// Points of a mechanism's domain, to try things at.
#pragma once

#include <cstdint>
#include <vector>

#include "mechanics/points/problem.hpp"

namespace slipproof {

/// Up to `count` points with small numbers in the domain, with all of [assume], every optional parameter given: fewer
/// where it is hard to find any. The same for the same seed.
std::vector<MechanismValues> sample_values(const Mechanism& mechanism, const ProblemMaker& maker, std::size_t count,
                                           std::uint64_t seed);

/// Which values a text names.
struct ShownValues {
  std::vector<bool> parameters, angles;
};
/// `m = 1, b = 1/2, theta: cos 3/5, sin 4/5`; all that are given, if left out.
std::string values_text(const Mechanism& mechanism, const MechanismValues& values, const ShownValues& shown);
std::string values_text(const Mechanism& mechanism, const MechanismValues& values);

}  // namespace slipproof
