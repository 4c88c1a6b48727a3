// The places on a line of points at which the answer to a question can change; it changes nowhere else.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "base/algebra/real_roots.hpp"
#include "mechanics/family/solved_sample.hpp"
#include "mechanics/lines/line.hpp"
#include "mechanics/lines/question.hpp"

namespace slipproof {

/// The points of a line at which a question is answered.
struct LinePoints {
  std::vector<Rational> values;  ///< values of t, ascending: every rational critical value and one number in every cell
  std::vector<RealRoot> roots;   ///< the critical values; at an irrational one there is no rational point
  LinePart part;                 ///< no point beyond it is in the domain; its ends are critical, too

  /// The open intervals between neighbouring critical values, and those before the first and after the last.
  std::size_t cells() const { return roots.size() + 1; }
  std::size_t irrational() const;
};

/// The critical values of a question along a line, and a number between each two neighbours. Throughout a cell these
/// are the same: the truth of each comparison that counts, the order of the ends of all intervals of forces, and which
/// modes are regular; therefore the answer is the same, too. If a mode is singular along the whole line, its
/// continua are not examined. A comparison whose difference has a degree above 1 in the force has no value anyway; only
/// its coefficients count. The zeros of `beside` are critical, too.
LinePoints points_on(const Line& line, const CompiledFamily& family, const Question& question,
                     const std::set<IntegerPolynomial>& beside = {});

/// Points near the upper end of a parameter, with the other parameters as in `values`: one in the last cell of the
/// line that has any, and the one at the end if it belongs to the domain. The truth of `conditions` is the same
/// throughout the cell. Empty if there are no points; nothing if the end is irrational, where no sample exists.
std::optional<std::vector<std::unique_ptr<SolvedSample>>> last_points(const CompiledFamily& family,
                                                                      const std::vector<const Program*>& conditions,
                                                                      const std::vector<Rational>& values,
                                                                      std::size_t parameter);

}  // namespace slipproof
