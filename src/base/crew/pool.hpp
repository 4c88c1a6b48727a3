// The threads of one rank: requests in, answers out in any order.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "base/input/diagnostic.hpp"

namespace slipproof {

/// Answers a request, from many threads at once, on whichever rank: the same bytes everywhere.
using Service = std::function<std::string(std::string_view request)>;

/// The outcome of a request: bytes, or why there are none.
struct Reply {
  enum class Kind : std::uint8_t { result, bad_input, not_written, failure };

  std::uint64_t number = 0;  ///< of the request, in the numbering of its sender
  Kind kind = Kind::result;
  std::string bytes = {};                    ///< the result, or the message of a failure
  std::vector<Diagnostic> diagnostics = {};  ///< of bad input

  std::string to_bytes() const;
  static Reply from_bytes(std::string_view bytes);
  /// The result. If there is none, throws InputError, OutputError, or std::runtime_error.
  std::string result() &&;
};

/// Asks the service, and catches what it throws, except Stopped.
Reply reply_to(std::uint64_t number, std::string_view request, const Service& service);

class Pool {
 public:
  /// As thread_count() has it. The service must outlive the pool.
  Pool(unsigned threads, const Service& service);
  /// Drops what is not begun, and asks what is to stop.
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// So many requests keep all threads busy while their answers are on the way.
  std::size_t slots() const { return 2 * threads_.size(); }
  void ask(std::uint64_t number, std::string request);
  /// An answer; nothing where none comes within the time.
  std::optional<Reply> answer(std::chrono::milliseconds patience);

 private:
  void work(const std::stop_token& stop);

  const Service& service_;
  std::mutex mutex_;
  std::condition_variable_any asked_, answered_;
  std::deque<std::pair<std::uint64_t, std::string>> requests_;
  std::deque<Reply> answers_;
  std::vector<std::jthread> threads_;  ///< last: they end before the rest goes
};

}  // namespace slipproof
