// Ctrl-C: ends the work within milliseconds, and says what is kept and which command line goes on from there.
#pragma once

#include <condition_variable>
#include <exception>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/parallel/stop.hpp"
#include "faces/cli/crew_run.hpp"

namespace slipproof::cli {

/// What a stopped run leaves, and how its command line has to change to go on from there.
struct Continuation {
  std::string kept;
  std::vector<std::string> option = {};  ///< an option with its value, added or put in place of the same one
  std::string left_out = {};             ///< a flag
};

/// The work was stopped by Ctrl-C.
class Interrupted : public std::exception {
 public:
  explicit Interrupted(Continuation continuation) : continuation_(std::move(continuation)) {}
  const char* what() const noexcept override { return "stopped by Ctrl-C"; }
  const Continuation& continuation() const { return continuation_; }

 private:
  Continuation continuation_;
};

/// The result of work(). Throws Interrupted with the Continuation of left() if Ctrl-C stops it.
template <class Work, class Left>
int stoppable(const Work& work, const Left& left) {
  try {
    return work();
  } catch (const Stopped&) {
    throw Interrupted(left());
  }
}

/// For work that a crew can do: the checkpoint is kept, or there should have been one.
Continuation by_checkpoint(const CrewArguments& crew);

/// The shell's words for a command line with such a change.
std::string command_line(std::vector<std::string> words, const Continuation& continuation);

/// While it lives, the first Ctrl-C asks the calls of this thread to stop, and a second one ends the program. Where the
/// signal is ignored, as by nohup, it stays so. One at a time.
class CtrlC {
 public:
  CtrlC();
  ~CtrlC();
  CtrlC(const CtrlC&) = delete;
  CtrlC& operator=(const CtrlC&) = delete;

  std::stop_token token() const { return stop_.get_token(); }
  /// Ends the program as the signal does without a handler, so that a shell or a script stops, too.
  [[noreturn]] static void end_program();

 private:
  void wait_for_signal();

  std::stop_source stop_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool has_ended_ = false;
  std::thread watcher_;  ///< a handler may not do what stop_ does
};

}  // namespace slipproof::cli
