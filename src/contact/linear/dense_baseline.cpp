#define SLIPPROOF_KERNEL dense_baseline
#define SLIPPROOF_KERNEL_EIGEN slipproof_eigen_baseline
#include "contact/linear/dense_kernels.inc"
