// Affine forms with coefficients on a tape, with the operations that form_of() and the elimination need.
#pragma once

#include <vector>

#include "floating/tape/tape.hpp"

namespace slipproof {

/// constant + coefficients . x; those of one mechanism have as many coefficients as it has unknowns. The load stands in
/// the constant.
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

/// A form over what linear equations leave free: constant + slopes . t; slopes are literal zeros where a quantity is
/// determined.
struct FreeForm {
  TapeRef constant = TapeBuilder::zero;
  std::vector<TapeRef> slopes;

  bool varies() const {
    for (const TapeRef slope : slopes) {
      if (slope != TapeBuilder::zero) return true;
    }
    return false;
  }
  bool is_zero() const { return constant == TapeBuilder::zero && !varies(); }
  bool operator==(const FreeForm&) const = default;
};

/// The solutions of linear equations at all points at which no pivot is 0: programs for each unknown.
class TapeSolution {
 public:
  /// Cubic in the number of unknowns, or less where forms are sparse.
  TapeSolution(TapeBuilder& tape, std::vector<TapeForm> equations, std::size_t unknowns);

  const std::vector<TapeRef>& pivots() const { return pivots_; }
  /// What has to vanish, or there is no solution: of rows that others determine, except for the constant.
  const std::vector<TapeRef>& residuals() const { return residuals_; }
  std::size_t free() const { return free_.size(); }
  FreeForm on(const TapeForm& form) const;

 private:
  struct Row {
    TapeForm form;
    std::size_t unknown;  ///< which it determines
  };

  void eliminate(std::vector<TapeForm> equations);
  void eliminate_with(const Row& row, std::vector<TapeForm>& equations);
  void substitute_back(std::size_t unknowns);

  TapeBuilder& tape_;
  std::vector<Row> rows_;
  std::vector<TapeRef> pivots_, residuals_;
  std::vector<std::size_t> free_;
  std::vector<FreeForm> values_;  ///< of each unknown
};

}  // namespace slipproof
