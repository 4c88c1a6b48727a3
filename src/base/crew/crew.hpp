// Work by index: by the threads of this process, or by a crew of many ranks, the processes of one run, which share
// nothing but files. Rank 0 writes lists of requests into its journal, as the work goes on. Rank r answers the requests
// r, r + N, r + 2 N, ... of each list of N ranks, and keeps the results in a journal of its own. Rank 0 takes them from
// all journals, in the order of the list; what a rank that is gone has not answered, it answers itself.
//
// Requests 0 to 5 of 2 ranks: rank 0 answers 0, 2, 4, and rank 1 answers 1, 3, 5. If rank 1 is killed while it works on
// 3, rank 0 does 3 and 5 when it has done 4. If rank 0 is killed, rank 1 ends with the list; the same command goes on
// with whatever the journals have, also with another number of ranks.
#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/crew/journal.hpp"

namespace slipproof {

/// Answers a request, from many threads at once, on whichever rank: the same bytes everywhere.
using Service = std::function<std::string(std::string_view request)>;

struct CrewOptions {
  std::filesystem::path checkpoint;  ///< the journal of rank 0; rank r has CHECKPOINT.r
  std::string work = {};             ///< as for Journal
  int rank = 0, ranks = 1;
  unsigned threads = 0;  ///< of this rank; 0: all its cores
};

/// One rank of a run. Where serve() returns false, each() may be called as often as is wanted, from one thread.
class Crew {
 public:
  /// Throws as Journal does.
  Crew(CrewOptions options, Service service);

  /// On rank 0 false, at once. On the others true, when they have answered their share of each list and rank 0 is gone.
  /// Says nothing of what fails: rank 0 meets it again.
  bool serve();

  /// Whether this rank, or another of this run or of an earlier one, has answered the request.
  bool has(std::string_view request) const;

  /// On rank 0: calls take(i, result) for each request(i), i = 0, 1, ... count - 1, in this order. Results wait in the
  /// journals, not in memory. Throws what the service throws for the first request that has no result; Stopped; and
  /// whatever take() throws.
  void each(std::uint64_t count, const std::function<std::string(std::uint64_t)>& request,
            const std::function<void(std::uint64_t, std::string)>& take);

 private:
  std::filesystem::path journal_of(int rank) const;
  Journal& own() { return journals_.at(options_.rank); }
  void refresh();
  std::optional<std::string> find(std::string_view request) const;
  std::exception_ptr failure_of(std::string_view request) const;
  void answer_one(std::string_view request);
  void answer(const std::vector<std::string_view>& requests, const std::function<void()>& after_each);

  CrewOptions options_;
  Service service_;
  std::map<int, Journal> journals_;                                  ///< by rank, also of earlier runs with more ranks
  std::uint64_t lists_ = 0;                                          ///< handed out, or answered
  std::map<std::string, std::exception_ptr, std::less<>> failures_;  ///< of the service, by request
  mutable std::mutex mutex_;                                         ///< of journals and failures
  std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

/// take(i, answer to request(i)) for i = 0, 1, ... count - 1, one at a time. Without a crew `service` answers, on the
/// threads of the caller's on_threads(), and results are taken as they come unless `in_order`; with one, whose service
/// it must be, they are taken in order. What is thrown is as of Crew::each(); without a crew what any of them throws.
void share(Crew* crew, const Service& service, std::uint64_t count,
           const std::function<std::string(std::uint64_t)>& request,
           const std::function<void(std::uint64_t, std::string)>& take, bool in_order = false);

}  // namespace slipproof
