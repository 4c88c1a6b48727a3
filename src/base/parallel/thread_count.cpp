#include "base/parallel/thread_count.hpp"

#ifndef SLIPPROOF_SERIAL
#include <tbb/info.h>
#endif

namespace slipproof {

int thread_count(unsigned wanted) {
#ifdef SLIPPROOF_SERIAL
  const int cores = 1;
#else
  const int cores = tbb::info::default_concurrency();
#endif
  return wanted == 0 || wanted > static_cast<unsigned>(cores) ? cores : static_cast<int>(wanted);
}

}  // namespace slipproof
