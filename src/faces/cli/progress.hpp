// How far a run is and how long it will still take: a line on standard error, only where that is a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace slipproof::cli {

/// `40 s`, `3 min`, `2 h 5 min`: rounded up, so that it does not promise too much.
std::string duration_text(std::chrono::seconds time);

/// Progress of long work. Members may be called from any thread.
class ProgressLine {
 public:
  /// Shows nothing unless it is wanted and standard error is a terminal.
  explicit ProgressLine(bool wanted);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  bool is_shown() const { return shown_; }
  /// `done` of `all` pieces of work, 0 if nobody knows how many, and a note to show after them. Shows them at most five
  /// times a second, and takes the line away when all are done. The time left is that of the pieces since the first
  /// call, so that what a checkpoint had does not count.
  void at(std::uint64_t done, std::uint64_t all, const std::string& note = {});
  /// Takes the line away.
  void clear();
  /// The same before output, where that goes to a terminal, too.
  void make_way();

 private:
  using Clock = std::chrono::steady_clock;
  struct Start {
    Clock::time_point time;
    std::uint64_t done;
  };
  std::string text(std::uint64_t done, std::uint64_t all, const std::string& note) const;

  bool shown_;
  bool with_output_ = false;  ///< standard output is a terminal
  std::mutex mutex_;
  std::optional<Start> start_;
  Clock::time_point last_;
  bool is_there_ = false;  ///< something is on the line
};

/// A line as a function (done, all); empty if nothing would be shown.
std::function<void(std::uint64_t, std::uint64_t)> progress_bar(bool wanted);

}  // namespace slipproof::cli
