// Whether expressions are the same functions of the parameters and the force.
#pragma once

#include "claims/identity/symbolic.hpp"
#include "claims/paper/compiled.hpp"

namespace slipproof {

/// For one setting, which must outlive it. Not shared between threads.
class Functions {
 public:
  explicit Functions(const CompiledSetting& setting);

  /// True if the expressions are trees of the same shape down to comparisons or a number, whose sides are the same
  /// rational functions wherever both have a value. False if that was not shown.
  bool same(const Expression& x, const Expression& y);

 private:
  std::optional<ReducedFraction> value(const Expression& e);

  const CompiledSetting* setting_;
  std::unique_ptr<const PolynomialRing> ring_;
  SymbolicEvaluator symbols_;
};

}  // namespace slipproof
