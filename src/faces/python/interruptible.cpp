#include "faces/python/interruptible.hpp"

#include <cxxabi.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <set>
#include <thread>

#include "base/number/flint_memory.hpp"
#include "base/parallel/stop.hpp"
#include "faces/python/bind.hpp"

namespace slipproof::python {

namespace {

namespace py = pybind11;
using namespace std::chrono_literals;

// A signal belongs to the process, and so does its counter. Python informs only the main thread of Ctrl-C; the other
// threads learn of it here.
std::atomic<std::uint64_t> interrupt_count = 0;
std::atomic<void (*)(int)> handler_of_python = nullptr;
static_assert(std::atomic<std::uint64_t>::is_always_lock_free, "a signal handler uses it");

extern "C" void count_interrupt(int signal) {
  interrupt_count.fetch_add(1, std::memory_order_relaxed);
  if (const auto next = handler_of_python.load()) next(signal);
}

/// Installs count_interrupt in front of Python's handler if that is the default one, which raises KeyboardInterrupt. If
/// a program handles Ctrl-C in another way, changes nothing.
void count_interrupts() {
  struct sigaction now {};
  if (sigaction(SIGINT, nullptr, &now) != 0 || (now.sa_flags & SA_SIGINFO) != 0) return;
  if (now.sa_handler == count_interrupt || now.sa_handler == SIG_DFL || now.sa_handler == SIG_IGN) return;
  const py::module_ signal = py::module_::import("signal");
  if (!signal.attr("getsignal")(SIGINT).is(signal.attr("default_int_handler"))) return;
  handler_of_python = now.sa_handler;
  now.sa_handler = count_interrupt;
  sigaction(SIGINT, &now, nullptr);
}

bool interpreter_is_gone() {
#if PY_VERSION_HEX >= 0x030D0000
  return Py_IsFinalizing() != 0;
#else
  return _Py_IsFinalizing() != 0;
#endif
}

/// The running calls. At the end of the program they are stopped: otherwise they would use objects that no longer
/// exist.
class Running {
 public:
  void add(const std::shared_ptr<Call>& call) {
    const std::lock_guard lock(mutex_);
    calls_.insert(call);
  }
  void remove(const std::shared_ptr<Call>& call) {
    const std::lock_guard lock(mutex_);
    calls_.erase(call);
    fewer_.notify_all();
  }
  void end() {
    std::unique_lock lock(mutex_);
    for (const auto& call : calls_) call->stop.request_stop();
    fewer_.wait_for(lock, 1s, [this] { return calls_.empty(); });
  }

 private:
  std::mutex mutex_;
  std::condition_variable fewer_;
  std::set<std::shared_ptr<Call>> calls_;
};

Running& running() {
  static auto* const calls = new Running;  // never destroyed, because a call may end after everything else
  return *calls;
}

}  // namespace

WithoutInterpreter::~WithoutInterpreter() noexcept(false) {
  while (interpreter_is_gone()) pause();
  try {
    PyEval_RestoreThread(state_);
  } catch (abi::__forced_unwind&) {
    // The interpreter has ended while this thread waited for its lock, and now unwinds the thread. Unwinding would
    // destroy objects without that lock, so the thread stays here.
    for (;;) pause();
  }
}

std::uint64_t interrupts() {
  count_interrupts();
  return interrupt_count.load();
}

void check_signals(std::uint64_t since) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (interrupt_count.load() == since) return;
  const py::module_ threading = py::module_::import("threading");
  if (threading.attr("current_thread")().is(threading.attr("main_thread")())) return;  // Python has informed it
  PyErr_SetNone(PyExc_KeyboardInterrupt);
  throw py::error_already_set();
}

void Call::finish(std::exception_ptr error) {
  const std::lock_guard lock(mutex_);
  error_ = std::move(error);
  has_ended_ = true;
  ended_.notify_all();
}

bool Call::ended_within(std::chrono::milliseconds time) {
  const WithoutInterpreter released;
  std::unique_lock lock(mutex_);
  return ended_.wait_for(lock, time, [this] { return has_ended_; });
}

void Call::tell(const py::object& progress) {
  const std::uint64_t done = done_.load(), all = all_.load();
  if (progress.is_none() || all == 0 || done == told_) return;
  told_ = done;
  progress(done, all);
}

void wait_for(const std::shared_ptr<Call>& call, std::function<void()> work, const py::object& progress, Uses uses) {
  const std::uint64_t since = interrupts();
  running().add(call);
  std::thread worker([call, work = std::move(work)]() mutable {
    give_back_flint_memory_at_end();  // the work computes with FLINT
    std::exception_ptr error;
    try {
      const StopScope scope(call->stop.get_token());
      work();
    } catch (...) {
      error = std::current_exception();
    }
    work = nullptr;
    running().remove(call);
    call->finish(error);
  });
  try {
    while (!call->ended_within(20ms)) {
      check_signals(since);
      call->tell(progress);
    }
  } catch (...) {
    call->stop.request_stop();
    while (!call->ended_within(100ms) && uses == Uses::arrays) {
    }
    worker.detach();
    throw;
  }
  worker.join();
  if (call->error_) std::rethrow_exception(call->error_);
  call->tell(progress);
}

void bind_calls(py::module_& module) {
  py::module_::import("atexit").attr("register")(py::cpp_function([] {
    const WithoutInterpreter released;
    running().end();
  }));
  static_cast<void>(module);
}

}  // namespace slipproof::python
