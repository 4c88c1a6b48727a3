// A straight line through the parameters of a family.
#pragma once

#include <cstdint>
#include <vector>

#include "mechanics/family/compiled_family.hpp"

namespace slipproof {

/// The points origin + t direction for all t, also those outside the domain.
struct Line {
  std::vector<Rational> origin, direction;  ///< by parameter
  Rational inside;                          ///< a t at which the point is in the domain, if one is known

  std::vector<Rational> at(const Rational& t) const;
};

/// Varies one parameter, whose value is t; all others stay the same.
Line along_parameter(const std::vector<Rational>& values, std::size_t parameter);
/// Goes through both points, at t = 0 and t = 1.
Line through(const std::vector<Rational>& first, const std::vector<Rational>& second);
/// Multiplies the chosen parameters by t; all others stay the same.
Line scaling(const std::vector<Rational>& values, const std::vector<bool>& chosen);

/// What parameters may matter for apart from the programs.
enum class Beside : std::uint8_t { nothing, the_scene };

/// The parameters on which the truth of a family's programs depends, also through definitions, and those on which
/// `beside` depends: everything that the scene does.
std::vector<bool> parameters_of(const CompiledFamily& family, const std::vector<const Program*>& programs,
                                Beside beside);

/// Line number `k` through `bases`, which are all inside the domain. The lines alternate
/// between single parameters that matter, lines through two bases, and scalings; each uses another base. Depends only
/// on `seed` and `k`. Requires at least one base and one parameter that matters.
Line line_number(std::uint64_t k, std::uint64_t seed, const std::vector<std::vector<Rational>>& bases,
                 const std::vector<bool>& matters);

}  // namespace slipproof
