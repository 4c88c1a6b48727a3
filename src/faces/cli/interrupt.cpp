#include "faces/cli/interrupt.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>

namespace slipproof::cli {

namespace {

/// The handler writes to the second, the watcher reads from the first.
std::array<int, 2> signal_pipe{-1, -1};

void tell_watcher(char word) {
  while (write(signal_pipe[1], &word, 1) < 0 && errno == EINTR) {
  }
}

constexpr char pressed = 'p', ended = 'e';

void handle(int) {
  const int before = errno;
  tell_watcher(pressed);
  errno = before;
}

bool is_plain(const std::string& word) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
  return !word.empty() && word.find_first_not_of(plain) == std::string::npos;
}

std::string quoted(const std::string& word) {
  if (is_plain(word)) return word;
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string(R"('\'')") : std::string(1, c);
  return result + "'";
}

/// Puts an option with its value in place of the same one, or at the end.
void put(std::vector<std::string>& words, const std::vector<std::string>& option) {
  const auto same = [&](const std::string& word) {
    return word == option.front() || word.starts_with(option.front() + "=");
  };
  const auto found = std::find_if(words.begin(), words.end(), same);
  const auto after =
      found == words.end() ? found : words.erase(found, *found == option.front() ? found + 2 : found + 1);
  words.insert(after, option.begin(), option.end());
}

}  // namespace

Continuation by_checkpoint(const CrewArguments& crew) {
  if (!crew.checkpoint.empty()) return {"every result so far is in " + crew.checkpoint};
  return {"nothing is kept without --checkpoint; with it, a run that is stopped goes on where it was",
          {"--checkpoint", "slipproof.checkpoint"}};
}

std::string command_line(std::vector<std::string> words, const Continuation& continuation) {
  if (!continuation.option.empty()) put(words, continuation.option);
  std::erase(words, continuation.left_out);
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + quoted(word);
  return text;
}

CtrlC::CtrlC() {
  struct sigaction now = {};
  sigaction(SIGINT, nullptr, &now);
  if (now.sa_handler == SIG_IGN || pipe2(signal_pipe.data(), O_CLOEXEC) != 0) return;
  watcher_ = std::thread([this] { wait_for_signal(); });
  struct sigaction action = {};
  action.sa_handler = handle;
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);  // the second one ends the program
  sigaction(SIGINT, &action, nullptr);
}

CtrlC::~CtrlC() {
  if (!watcher_.joinable()) return;
  std::signal(SIGINT, SIG_DFL);
  {
    const std::scoped_lock lock(mutex_);
    has_ended_ = true;
  }
  ended_.notify_one();
  tell_watcher(ended);
  watcher_.join();
  for (const int end : signal_pipe) close(end);
}

void CtrlC::wait_for_signal() {
  char word = ended;
  while (read(signal_pipe[0], &word, 1) < 0 && errno == EINTR) {
  }
  if (word != pressed) return;
  stop_.request_stop();
  std::unique_lock lock(mutex_);
  if (!ended_.wait_for(lock, std::chrono::seconds(1), [this] { return has_ended_; })) {
    std::cerr << "slipproof: stopping where the present step ends; Ctrl-C again ends the program at once\n";
  }
}

void CtrlC::end_program() {
  std::signal(SIGINT, SIG_DFL);
  std::raise(SIGINT);
  std::_Exit(128 + SIGINT);  // where the signal is blocked
}

}  // namespace slipproof::cli
