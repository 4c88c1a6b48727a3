// Work on many threads, with the caller's number of them, and ended when the caller's call is. With SLIPPROOF_SERIAL,
// for machines without threads, all of it runs on the caller's.
#pragma once

#ifndef SLIPPROOF_SERIAL
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>

#include "base/parallel/stop.hpp"
#include "base/parallel/thread_count.hpp"

namespace slipproof {

#ifdef SLIPPROOF_SERIAL

template <class Work>
auto on_threads(unsigned, const Work& work) {
  return work();
}

template <class Work>
void pieces_in_parallel(std::size_t first, std::size_t last, std::size_t, const Work& work) {
  stop_if_asked();
  if (first < last) work(first, last);
}

#else

/// Calls work(), during which in_parallel() uses `threads` threads (see thread_count()), and returns its result.
template <class Work>
auto on_threads(unsigned threads, const Work& work) {
  tbb::task_arena arena(thread_count(threads));
  return arena.execute([&, token = StopScope::token()] {
    const StopScope scope(token);
    return work();
  });
}

/// work(begin, end) for pieces of first..last that hold about `grain` indices at least.
template <class Work>
void pieces_in_parallel(std::size_t first, std::size_t last, std::size_t grain, const Work& work) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(first, last, grain),
                    [&, token = StopScope::token()](const auto& r) {
                      const StopScope scope(token);
                      stop_if_asked();
                      work(r.begin(), r.end());
                    });
}

#endif

/// work(i) for each index of first..last, in any order.
template <class Work>
void in_parallel(std::size_t first, std::size_t last, const Work& work) {
  pieces_in_parallel(first, last, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i != end; ++i) {
      stop_if_asked();
      work(i);
    }
  });
}

/// The same with one task for each index, for work whose cost varies by orders of magnitude.
template <class Work>
void each_in_parallel(std::size_t first, std::size_t last, const Work& work) {
#ifdef SLIPPROOF_SERIAL
  in_parallel(first, last, work);
#else
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(first, last, 1),
      [&, token = StopScope::token()](const auto& r) {
        const StopScope scope(token);
        for (std::size_t i = r.begin(); i != r.end(); ++i) {
          stop_if_asked();
          work(i);
        }
      },
      tbb::simple_partitioner());
#endif
}

}  // namespace slipproof
