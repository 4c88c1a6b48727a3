// A straight line through the parameters of a setting.
#pragma once

#include <cstdint>
#include <vector>

#include "claims/paper/compiled.hpp"

namespace slipproof {

/// The bicycles origin + t direction, for all t; those outside of the domain are on the line, too.
struct Line {
  std::vector<Rational> origin, direction;  ///< by parameter
  Rational inside;                          ///< a t of which the bicycle is in the domain, if that is known of one

  std::vector<Rational> at(const Rational& t) const;
};

/// One parameter runs, t is its value; all others stay.
Line along_parameter(const std::vector<Rational>& values, std::size_t parameter);
/// Through both, at t = 0 and t = 1.
Line through(const std::vector<Rational>& first, const std::vector<Rational>& second);
/// The chosen parameters are multiplied by t; all others stay.
Line scaling(const std::vector<Rational>& values, const std::vector<bool>& chosen);

/// What else parameters may matter for.
enum class Beside : std::uint8_t { nothing, the_bicycle };

/// The parameters on which the truth of programs of a setting depends, definitions included, and what is beside them:
/// everything that the bicycle does.
std::vector<bool> parameters_of(const CompiledSetting& setting, const std::vector<const Program*>& programs,
                                Beside beside);

/// Line number `k` for a claim that speaks at `bases`, all of them inside of the domain. The lines take turns: along
/// each of the parameters that matter, through two bases, and scalings; each takes another base. It depends on `seed`
/// and `k` alone. At least one base, and one parameter that matters.
Line line_number(std::uint64_t k, std::uint64_t seed, const std::vector<std::vector<Rational>>& bases,
                 const std::vector<bool>& matters);

}  // namespace slipproof
