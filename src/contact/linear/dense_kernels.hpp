// What each instruction set has a version of.
#pragma once

#include <cstddef>

namespace slipproof {

#define SLIPPROOF_DECLARE_KERNELS(set)                                             \
  namespace set {                                                                  \
  void invert(double* matrix, std::ptrdiff_t n);                                   \
  void defect(const double* r, const double* a, double* result, std::ptrdiff_t n); \
  }
SLIPPROOF_DECLARE_KERNELS(dense_baseline)
SLIPPROOF_DECLARE_KERNELS(dense_avx2)
SLIPPROOF_DECLARE_KERNELS(dense_avx512)
#undef SLIPPROOF_DECLARE_KERNELS

}  // namespace slipproof
