#define SLIPPROOF_KERNEL dense_avx2
#define SLIPPROOF_KERNEL_EIGEN slipproof_eigen_avx2
#include "contact/linear/dense_kernels.inc"
