// The equations of a block in long numbers: dependent ones, and Krawczyk's test without rounding.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/enclosure/dependence.hpp"
#include "contact/enclosure/krawczyk.hpp"

namespace slipproof {

/// Equations and unknowns to leave out so that the others are independent to a precision of 106 bits. Prefers to keep
/// nonlinear equations.
DependentPart dependent_in_long_numbers(const ModeSystem& system, const SystemBlock& block,
                                        std::span<const Rational> z);

/// The test of contact/MATHEMATICS.md, (E1). All that depends on A and the point is computed exactly and rounded up
/// once. A rough inverse has 106 bits. An exact one, cut off after 320 bits, is for few unknowns: their derivative may
/// have a condition of 10^80.
class LongTest {
 public:
  enum class Inverse : std::uint8_t { rough, exact };

  /// `z` has all unknowns of the system, and is improved by run(). Both must outlive it.
  LongTest(const ModeSystem& system, const SystemBlock& block, std::vector<Rational>& z, Inverse inverse);

  /// Newton's method, then the test; nothing where one of them fails.
  std::optional<KrawczykBox> run();
  /// An entry of the inverse: rows for the unknowns, columns for the equations.
  Rational inverse(std::size_t unknown, std::size_t equation) const;

  struct ScaledDerivative;

 private:
  bool invert();
  bool invert_exactly(const ScaledDerivative& J);
  bool invert_roughly(const ScaledDerivative& J);
  std::vector<Rational> newton_step() const;
  bool improve();
  struct Derivative;
  Derivative derivative() const;
  std::vector<Integer> defect_row(std::size_t j, const Derivative& J) const;
  void refine_inverse(const Derivative& J);
  void measure();
  std::vector<double> bound_with(double order) const;
  bool inside(const std::vector<double>& bound) const;
  Rational scaled_value(std::size_t equation) const;

  const ModeSystem& system_;
  const SystemBlock& block_;
  std::vector<Rational>& z_;
  const bool is_exact_;
  const std::size_t n_;
  std::vector<int> rows_, columns_;            ///< exponents that bring the derivative's rows and columns near 1
  std::vector<std::vector<Integer>> inverse_;  ///< of the scaled derivative, times 2^digits_
  int digits_ = 0;
  std::vector<double> step_, radius_;  ///< upper bounds on |R F|, in scaled unknowns as all that follows
  DenseMatrix defect_, size_;          ///< of |I - R J| and |R|
};

}  // namespace slipproof
