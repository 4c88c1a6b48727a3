// Whether expressions are the same functions of the parameters and the force.
#pragma once

#include "claims/compiled.hpp"
#include "verify/polynomials.hpp"

namespace slipproof {

/// Of one setting, which must outlive it. Not shared between threads.
class Functions {
 public:
  explicit Functions(const CompiledSetting& setting);

  /// Trees of one shape down to comparisons or to a number, whose sides are the same rational functions, wherever both
  /// have a value. `equation`: the unknowns of the model may occur. False: not shown.
  bool same(const Expression& x, const Expression& y, bool equation = false);

 private:
  std::optional<Fraction> value(const Expression& e, bool equation);

  const CompiledSetting* setting_;
  SymbolicEvaluator symbols_;
};

}  // namespace slipproof
