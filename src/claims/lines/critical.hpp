// Where on a line of bicycles the answer about a claim can change: nowhere else.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "base/algebra/real_roots.hpp"
#include "claims/lines/line.hpp"
#include "claims/sampling/claim_parts.hpp"
#include "claims/sampling/solved_sample.hpp"

namespace slipproof {

/// What is judged on a line.
struct LinePoints {
  std::vector<Rational> values;  ///< of t, ascending: every rational critical value and a number in every cell
  std::vector<RealRoot> roots;   ///< the critical values; no rational bicycle has those that are irrational
  LinePart part;                 ///< beyond it no bicycle is in the domain; its ends are critical, too

  /// Open intervals between neighbouring critical values, and those beyond the first and the last.
  std::size_t cells() const { return roots.size() + 1; }
  std::size_t irrational() const;
};

/// The critical values of a claim along a line and a number between each two of them. In a cell, the truth of each
/// comparison that counts, the order of the ends of all intervals of forces and which modes are regular are the same
/// throughout, and so is the judgement. Where a mode is singular all along the line, its continua are not looked into;
/// comparisons whose difference is of a higher degree in the force have no value anyway, and only their coefficients
/// count. The zeros of `beside` are critical, too.
LinePoints points_on(const Line& line, const CompiledSetting& compiled, const ClaimParts& parts,
                     const std::set<IntegerPolynomial>& beside = {});

/// The bicycles toward the upper end of a parameter, the others as in `values`: one for the last cell of the line in
/// which there are any, and, where it belongs to the domain, the one at the end. In the cell the truth of `conditions`
/// is the same throughout. Empty if there are no bicycles; nothing if the end is irrational, which no sample can be.
std::optional<std::vector<std::unique_ptr<SolvedSample>>> last_points(const CompiledSetting& compiled,
                                                                      const std::vector<const Program*>& conditions,
                                                                      const std::vector<Rational>& values,
                                                                      std::size_t parameter);

}  // namespace slipproof
