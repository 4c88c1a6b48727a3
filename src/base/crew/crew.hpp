// Many ranks at one work: rank 0 hands out requests as the others are free, computes too, and has the results in order.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/crew/journal.hpp"
#include "base/crew/pool.hpp"
#include "base/crew/transport.hpp"

namespace slipproof {

struct CrewOptions {
  unsigned threads = 0;        ///< of this rank; 0: all its cores
  Journal* journal = nullptr;  ///< of rank 0: what is in it is not asked again
  /// Of rank 0: whether what the journal has of a request still counts; without it all does.
  std::function<bool(std::string_view request, std::string_view result)> still_counts = {};
  std::function<bool()> stop_asked = {};  ///< of rank 0, looked at every few milliseconds: a signal came
  std::chrono::seconds flush_after{60};   ///< the journal is flushed that often
};

/// The order in which results are taken.
enum class Taking : std::uint8_t { in_order, as_they_come };

/// The work was asked to stop: some requests have no result yet.
class Unfinished : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// With more ranks than this, rank 0 only coordinates and computes nothing itself.
inline constexpr int most_ranks_helped = 32;

/// The other ranks end: they wait for rank 0, also where it fails before it has a crew. Of rank 0, once.
void dismiss_others(Transport& transport);

/// Ranks that answer requests with the same service. On rank 0 each() may be called as often as is wanted; on the
/// others serve() returns when the crew of rank 0 is gone. Used from one thread.
class Crew {
 public:
  Crew(Transport& transport, CrewOptions options, Service service);
  /// Of rank 0: dismisses the others.
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  bool leads() const { return transport_.rank() == 0; }

  /// On the other ranks: answers requests until rank 0 dismisses them.
  void serve();

  /// On rank 0: calls take(i, result) for each request(i), i = 0, 1, ... count - 1, by default in this order, whatever
  /// rank answers first. request() may be called twice for the same number. Memory holds a bounded number of results.
  /// Throws InputError, OutputError and std::runtime_error as the service did, for the first request in the order that
  /// has no result; Unfinished, which names the missing requests, if a stop is asked for; Stopped; and whatever take()
  /// throws. After a throw each() must not be called again.
  void each(std::uint64_t count, const std::function<std::string(std::uint64_t)>& request,
            const std::function<void(std::uint64_t, std::string)>& take, Taking taking = Taking::in_order);

  /// Of rank 0: throws Unfinished where a stop is asked for, while it works without the others.
  void stop_if_asked() const;

 private:
  class Stage;
  void hand_out(Stage& stage);
  void collect(Stage& stage);
  void heard(Stage& stage, const Message& message);
  void answered(Stage& stage, Reply answer);
  std::optional<std::string> kept(std::string_view request) const;
  void look_after(const Stage& stage);

  Transport& transport_;
  CrewOptions options_;
  Service service_;
  std::vector<std::size_t> slots_;  ///< by rank: requests it can have at once
  std::vector<std::size_t> free_;   ///< and of them those that it has not
  std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
  Pool pool_;
};

/// "3-17, 20": increasing numbers from 1, for people; at most ten ranges, then how many more.
std::string ranges_text(const std::vector<std::uint64_t>& numbers);

}  // namespace slipproof
