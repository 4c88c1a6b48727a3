#define SLIPPROOF_KERNEL dense_avx512
#define SLIPPROOF_KERNEL_EIGEN slipproof_eigen_avx512
#include "contact/linear/dense_kernels.inc"
