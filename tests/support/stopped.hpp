// Long calls that are asked to end.
#pragma once

#include <chrono>
#include <functional>
#include <stop_token>
#include <thread>

#include "base/parallel/stop.hpp"

namespace slipproof::test {

/// Made where GCC 12 does not look into the header's code: it sees what is not initialized there, falsely.
[[gnu::noinline]] inline std::stop_source new_stop_source() {
  return std::stop_source();
}

/// Whether a call ends with Stopped, once another thread asks for it a moment later.
inline bool is_stopped(const std::function<void()>& call) {
  std::stop_source stop = new_stop_source();
  const std::jthread asking([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stop.request_stop();
  });
  const StopScope scope(stop.get_token());
  try {
    call();
  } catch (const Stopped&) {
    return true;
  }
  return false;
}

}  // namespace slipproof::test
