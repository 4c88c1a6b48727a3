// Affine forms with coefficients on a tape, and the operations that form_of() and the elimination need.
#pragma once

#include <algorithm>
#include <vector>

#include "floating/program/tape.hpp"

namespace slipproof {

/// constant + coefficients . x. All forms of a mechanism have as many coefficients as it has unknowns. The load is part
/// of the constant.
struct TapeForm {
  TapeBuilder* tape = nullptr;
  std::vector<TapeRef> coefficients;
  TapeRef constant = TapeBuilder::zero;
};

inline TapeForm operator-(TapeForm x) {
  for (TapeRef& c : x.coefficients) c = x.tape->negate(c);
  x.constant = x.tape->negate(x.constant);
  return x;
}
inline TapeForm operator+(TapeForm x, const TapeForm& y) {
  for (std::size_t i = 0; i < x.coefficients.size(); ++i) {
    x.coefficients[i] = x.tape->add(x.coefficients[i], y.coefficients[i]);
  }
  x.constant = x.tape->add(x.constant, y.constant);
  return x;
}
inline TapeForm operator-(TapeForm x, const TapeForm& y) {
  for (std::size_t i = 0; i < x.coefficients.size(); ++i) {
    x.coefficients[i] = x.tape->subtract(x.coefficients[i], y.coefficients[i]);
  }
  x.constant = x.tape->subtract(x.constant, y.constant);
  return x;
}

/// A form on the solutions of equations: constant + core . x + free . t. The unknowns x of the core are determined by
/// at most two equations; the unknowns t are free.
struct SolvedForm {
  TapeRef constant = TapeBuilder::zero;
  std::vector<TapeRef> core, free;
  /// With x determined by t: whether the constant part is 0 at all points; and the same for the part of each t.
  bool no_constant = false;
  std::vector<bool> no_slope;

  bool varies() const { return std::find(no_slope.begin(), no_slope.end(), false) != no_slope.end(); }
  bool is_zero() const { return no_constant && !varies(); }
};

/// Equations some of which have determined unknowns: form = 0, with the coefficient 1 for its own unknown.
class TapeElimination {
 public:
  explicit TapeElimination(TapeBuilder& tape) : tape_(&tape) {}

  /// Removes equations that have an entry at most this doubtful, and their unknown from the others. Quadratic in the
  /// number of equations for each unknown.
  void eliminate(std::vector<TapeForm>& equations, TapeBuilder::Doubt most);
  /// The same for one equation; false if there is no such entry.
  bool eliminate_one(std::vector<TapeForm>& equations, TapeBuilder::Doubt most);

  /// The form without the unknowns that are determined.
  TapeForm reduced(TapeForm form) const;
  bool is_determined(std::size_t unknown) const;
  TapeBuilder& tape() const { return *tape_; }
  /// The divisors that may be 0.
  const std::vector<TapeRef>& pivots() const { return pivots_; }

 private:
  struct Row {
    TapeForm form;
    std::size_t unknown;
  };
  void replace(TapeForm& form, const Row& row) const;

  TapeBuilder* tape_;
  std::vector<Row> rows_;
  std::vector<TapeRef> pivots_;
};

/// The solutions of linear equations at all points at which no pivot is 0.
class TapeSolution {
 public:
  /// `known`: equations that are already eliminated. Cubic in the number of unknowns; less if forms are sparse.
  TapeSolution(TapeElimination known, std::vector<TapeForm> equations, std::size_t unknowns);

  /// The equations of the core (each form is 0): as many as the core has unknowns.
  const std::vector<SolvedForm>& core() const { return equations_; }
  /// Their determinant. It must not be 0 either.
  TapeRef divisor() const { return divisor_; }
  const std::vector<TapeRef>& pivots() const { return pivots_; }
  /// Numbers that must be 0 if there is a solution: constants of rows whose other entries follow from other rows.
  const std::vector<TapeRef>& residuals() const { return residuals_; }
  std::size_t free() const { return free_.size(); }
  SolvedForm on(const TapeForm& form) const;
  /// The determined part of the form, times the divisor.
  TapeRef numerator(const SolvedForm& form) const;

 private:
  bool find_core(const std::vector<TapeForm>& equations);
  void choose_core(const std::vector<const TapeForm*>& rows);
  bool is_better(TapeRef divisor, TapeBuilder::Doubt& doubt) const;
  TapeRef minor(TapeRef a, TapeRef b, TapeRef c, TapeRef d) const;
  std::vector<TapeRef> solved(const std::vector<TapeRef>& side) const;
  TapeRef at_solution(const SolvedForm& form, TapeRef own, const std::vector<TapeRef>& values) const;
  SolvedForm by_core(const TapeForm& form) const;

  TapeBuilder& tape_;
  TapeElimination rows_;
  std::size_t unknowns_;
  TapeRef divisor_ = TapeBuilder::one;
  std::vector<TapeRef> pivots_, residuals_;
  std::vector<std::size_t> core_, free_;
  std::vector<SolvedForm> equations_;
  std::vector<TapeRef> values_;               ///< of the core with the free unknowns 0, times the divisor
  std::vector<std::vector<TapeRef>> slopes_;  ///< by free unknown
};

}  // namespace slipproof
