#include "contact/linear/dense.hpp"

#include "base/os/registers.hpp"
#include "contact/linear/dense_kernels.hpp"

namespace slipproof {

namespace {

struct DenseKernels {
  void (*invert)(double*, std::ptrdiff_t);
  void (*defect)(const double*, const double*, double*, std::ptrdiff_t);
};

DenseKernels kernels_of_this_machine() {
#ifdef SLIPPROOF_X86_KERNELS
  switch (machine_registers()) {
    case Registers::eight:
      return {dense_avx512::invert, dense_avx512::defect};
    case Registers::four:
      return {dense_avx2::invert, dense_avx2::defect};
    case Registers::two:
      break;
  }
#endif
  return {dense_baseline::invert, dense_baseline::defect};
}

}  // namespace

DenseMatrix approximate_inverse(DenseMatrix matrix) {
  kernels_of_this_machine().invert(matrix.value.data(), static_cast<std::ptrdiff_t>(matrix.size));
  return matrix;
}

DenseMatrix absolute_defect(const DenseMatrix& R, const DenseMatrix& A) {
  DenseMatrix result(A.size);
  kernels_of_this_machine().defect(R.value.data(), A.value.data(), result.value.data(),
                                   static_cast<std::ptrdiff_t>(A.size));
  return result;
}

}  // namespace slipproof
