#include "base/parallel/thread_count.hpp"

#include <tbb/info.h>

namespace slipproof {

int thread_count(unsigned wanted) {
  const int cores = tbb::info::default_concurrency();
  return wanted == 0 || wanted > static_cast<unsigned>(cores) ? cores : static_cast<int>(wanted);
}

}  // namespace slipproof
