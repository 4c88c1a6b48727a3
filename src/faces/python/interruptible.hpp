// Calls that may take long: other Python threads continue, and Ctrl-C ends the call.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace slipproof::python {

/// Whether the work owns everything that it uses, or reads arrays that belong to Python.
enum class Uses : std::uint8_t { its_own, arrays };

/// The data shared by a call and the thread that does its work.
class Call {
 public:
  std::stop_source stop;

  /// Called by the work to report its progress.
  void at(std::uint64_t done, std::uint64_t all) {
    all_.store(all, std::memory_order_relaxed);
    done_.store(done, std::memory_order_relaxed);
  }

 private:
  friend void wait_for(const std::shared_ptr<Call>&, std::function<void()>, const pybind11::object&, Uses);
  void finish(std::exception_ptr error);
  bool ended_within(std::chrono::milliseconds time);
  void tell(const pybind11::object& progress);

  std::atomic<std::uint64_t> done_ = 0, all_ = 0;
  std::uint64_t told_ = 0;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool has_ended_ = false;
  std::exception_ptr error_;
};

/// Runs `work` in a thread of its own and waits without holding the interpreter's lock. Every 20 ms checks for signals
/// and calls `progress(done, all)` unless that is None. Rethrows exceptions of these and of the work. After an
/// exception it asks the work to stop, which takes milliseconds. Work that owns everything that it uses and does not
/// end within 100 ms is left running.
void wait_for(const std::shared_ptr<Call>& call, std::function<void()> work, const pybind11::object& progress,
              Uses uses);

/// Throws KeyboardInterrupt, or what another signal's handler raises. In a thread that is not the main thread, throws
/// KeyboardInterrupt if Ctrl-C was pressed after `since`, a value of interrupts().
void check_signals(std::uint64_t since);
/// How often Ctrl-C was pressed while Python's own handler was installed. The first call starts counting.
std::uint64_t interrupts();

/// Runs work(call) as wait_for() does, and returns its result.
template <class Work>
auto interruptible(const Work& work, const pybind11::object& progress = pybind11::none(), Uses uses = Uses::its_own) {
  using Result = decltype(work(std::declval<Call&>()));
  const auto call = std::make_shared<Call>();
  const auto result = std::make_shared<std::optional<Result>>();
  wait_for(
      call, [call, result, work] { result->emplace(work(*call)); }, progress, uses);
  return std::move(**result);
}

/// For short work: releases the interpreter's lock while it runs. Unlike pybind11's guard it also works when the
/// interpreter has ended meanwhile: a daemon thread that returns then cannot continue, and waits forever.
class WithoutInterpreter {
 public:
  WithoutInterpreter() : state_(PyEval_SaveThread()) {}
  ~WithoutInterpreter() noexcept(false);
  WithoutInterpreter(const WithoutInterpreter&) = delete;
  WithoutInterpreter& operator=(const WithoutInterpreter&) = delete;

 private:
  PyThreadState* state_;
};

}  // namespace slipproof::python
