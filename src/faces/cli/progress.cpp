#include "faces/cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

#include "base/output/terminal.hpp"

namespace slipproof::cli {

std::string duration_text(std::chrono::seconds time) {
  const auto minutes = (time.count() + 59) / 60;
  if (time.count() < 100) return fmt::format("{} s", time.count());
  if (minutes < 100) return fmt::format("{} min", minutes);
  return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

ProgressLine::ProgressLine(bool wanted)
    : shown_(wanted && is_terminal(STDERR_FILENO)), with_output_(is_terminal(STDOUT_FILENO)) {}

void ProgressLine::at(std::uint64_t done, std::uint64_t all, const std::string& note) {
  if (!shown_) return;
  const std::scoped_lock lock(mutex_);
  const auto now = Clock::now();
  if (!start_) start_ = Start{now, done};
  if (all > 0 && done >= all) {
    if (is_there_) std::cerr << "\r\033[K" << std::flush;
    is_there_ = false;
    return;
  }
  if (is_there_ && now - last_ < std::chrono::milliseconds(200)) return;
  last_ = now;
  is_there_ = true;
  std::cerr << '\r' << text(done, all, note) << "\033[K" << std::flush;
}

std::string ProgressLine::text(std::uint64_t done, std::uint64_t all, const std::string& note) const {
  constexpr std::uint64_t width = 30;
  const std::string after = note.empty() ? "" : "  " + note;
  if (all == 0) return note.empty() ? std::to_string(done) : note;
  const auto part = static_cast<std::uint64_t>(static_cast<double>(done) / static_cast<double>(all) * 100);
  const std::string bar(width * part / 100, '#');
  const std::string shown = fmt::format("[{:{}}] {:2} %", bar, width, part);
  const std::chrono::duration<double> elapsed = last_ - start_->time;
  if (done <= start_->done || elapsed < std::chrono::seconds(1)) return shown + after;
  const double left = elapsed.count() * static_cast<double>(all - done) / static_cast<double>(done - start_->done);
  return fmt::format("{}, {} left{}", shown, duration_text(std::chrono::seconds(static_cast<std::int64_t>(left) + 1)),
                     after);
}

void ProgressLine::clear() {
  const std::scoped_lock lock(mutex_);
  if (is_there_) std::cerr << "\r\033[K" << std::flush;
  is_there_ = false;
}

void ProgressLine::make_way() {
  if (with_output_) clear();
}

std::function<void(std::uint64_t, std::uint64_t)> progress_bar(bool wanted) {
  const auto line = std::make_shared<ProgressLine>(wanted);
  if (!line->is_shown()) return {};
  return [line](std::uint64_t done, std::uint64_t all) { line->at(done, all); };
}

}  // namespace slipproof::cli
