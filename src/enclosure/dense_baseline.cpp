#define SLIPPROOF_KERNEL dense_baseline
#define SLIPPROOF_KERNEL_EIGEN slipproof_eigen_baseline
#include "enclosure/dense_kernels.inc"
