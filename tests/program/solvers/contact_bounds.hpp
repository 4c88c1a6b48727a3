// Contact problems as game engines pose them: each tangential force in a range of its own, |r_t| <= mu r_n, a pyramid
// instead of the cone.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "contact/formats/problem_file.hpp"

namespace slipproof::test {

/// A x = b + w, lo <= x <= hi, where the bounds of row i count times x[depends[i]], if that is not -1. As in the
/// engines, all normal forces come first.
struct BoundedProblem {
  const SparseMatrix& W;
  std::vector<int> place;  ///< of the problem's components in x
  std::vector<double> b, lo, hi;
  std::vector<int> depends;

  explicit BoundedProblem(const ProblemFile& problem) : W(problem.W) {
    const std::size_t n = problem.components(), contacts = problem.contacts(), dimension = problem.dimension;
    b.resize(n);
    lo.resize(n);
    hi.resize(n);
    depends.resize(n);
    for (std::size_t row = 0; row < n; ++row) {
      const std::size_t contact = row / dimension, part = row % dimension;
      const bool normal = part == 0;
      const std::size_t i = normal ? contact : contacts + contact * (dimension - 1) + part - 1;
      place.push_back(static_cast<int>(i));
      b[i] = -problem.q[row];
      hi[i] = normal ? std::numeric_limits<double>::infinity() : problem.mu[contact];
      lo[i] = normal ? 0 : -hi[i];
      depends[i] = normal ? -1 : static_cast<int>(contact);
    }
  }

  /// Calls put(row, column, value) for the entries of A that are not zero.
  template <class Put>
  void each_entry(const Put& put) const {
    for (std::size_t row = 0; row < W.rows; ++row) {
      for (std::size_t e = W.starts[row]; e < W.starts[row + 1]; ++e) put(place[row], place[W.column[e]], W.value[e]);
    }
  }

  /// The forces in the order of the problem's components.
  template <class Vector>
  std::vector<double> forces(const Vector& x) const {
    std::vector<double> r;
    for (const int i : place) r.push_back(static_cast<double>(x[i]));
    return r;
  }
};

/// Whether engines can be given it.
inline bool suits_engines(const ProblemFile& problem) {
  const bool local = problem.form == ProblemForm::local && problem.dimension == 3;
  return (local || problem.form == ProblemForm::complementarity) && problem.V.entries() == 0;
}

/// Enough to converge, and not more than a few seconds of sweeps over so many entries of A.
inline int most_sweeps(std::size_t entries, std::size_t components) {
  return static_cast<int>(std::clamp(2e9 / static_cast<double>(entries + 10 * components), 100.0, 200'000.0));
}

}  // namespace slipproof::test
