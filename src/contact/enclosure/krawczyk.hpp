// A box around an approximate zero of a mode's equations that is proved to contain a zero.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contact/enclosure/mode_system.hpp"
#include "contact/linear/dense.hpp"

namespace slipproof {

struct SparseInverse;  // ball.hpp

/// Unknowns and equations that belong together: no other equation contains these unknowns, except pinned ones. There
/// are as many equations as unknowns.
struct SystemBlock {
  std::vector<std::size_t> unknowns, equations;
  DenseMatrix inverse;  ///< approximate, of the derivative: rows for the unknowns, columns for the equations
  std::shared_ptr<const SparseInverse> sparse = {};  ///< replaces the inverse of a large sparse block
};

/// The connected parts of a system, without the `pinned` unknowns and the `dropped` equations. Some may not be square.
std::vector<SystemBlock> blocks_of(const ModeSystem& system, std::span<const double> z, const std::vector<bool>& pinned,
                                   const std::vector<bool>& dropped);

/// Bound on the rounding error of an entry of a derivative.
struct DerivativeError {
  std::size_t equation, unknown;  ///< counted in the block
  double amount;
};

/// The derivative of a block's equations by its unknowns; where `errors` is given it gets those that are not 0.
DenseMatrix block_derivative(const ModeSystem& system, const SystemBlock& block, std::span<const double> z,
                             std::vector<DerivativeError>* errors = nullptr);

/// One step of Newton's method with the block's inverse: returns the correction to subtract from z, in the order of the
/// block's unknowns.
std::vector<double> newton_step(const ModeSystem& system, const SystemBlock& block, std::span<const double> z,
                                std::span<const double> x);

struct KrawczykBox {
  std::vector<double> radius;  ///< of the block's unknowns
  bool unique = false;         ///< the zero is the only one in the box
};

/// Krawczyk's test in components, contact/MATHEMATICS.md: nothing where it fails, which says nothing about zeros.
/// Rounding to nearest is all that is assumed of the machine. 2 n^3 operations.
std::optional<KrawczykBox> krawczyk(const ModeSystem& system, const SystemBlock& block, std::span<const double> z);

}  // namespace slipproof
