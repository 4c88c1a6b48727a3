// Work by index: by the threads of this process, or by a crew of many ranks, the processes of one run, which share
// nothing but files. Rank 0 writes lists of requests into its journal, as the work goes on. Rank r answers the requests
// r, r + N, r + 2 N, ... of each list of N ranks, and keeps the results in a journal of its own. Rank 0 takes them from
// all journals, in the order of the list, and answers the requests of ranks that have died.
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

/// Answers a request. Called from several threads at once, on any rank; must return the same bytes on each.
using Service = std::function<std::string(std::string_view request)>;

struct CrewOptions {
  std::filesystem::path checkpoint;  ///< the journal of rank 0; rank r has CHECKPOINT.r
  std::string work = {};             ///< see Journal
  int rank = 0, ranks = 1;
  unsigned threads = 0;  ///< of this rank; 0 means one for each core
};

/// One rank of a run. If serve() returns false, one thread may call each() any number of times.
class Crew {
 public:
  /// Opens the journals. Throws like Journal.
  Crew(CrewOptions options, Service service);

  /// On rank 0, returns false at once. On the other ranks, answers this rank's share of each list and returns true when
  /// rank 0 ends. Ignores failures, since rank 0 repeats such requests and reports them.
  bool serve();

  /// Whether this rank, or another of this run or of an earlier one, has answered the request.
  bool has(std::string_view request) const;

  /// Calls take(i, result) for each request(i), i = 0, 1, ... count - 1, in this order; only for rank 0. Keeps waiting
  /// results in the journals, not in memory. Throws the exception of the service for the first request without a
  /// result, exceptions of take(), and Stopped.
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
  std::map<int, Journal> journals_;                                  ///< by rank, including ranks of earlier runs
  std::uint64_t lists_ = 0;                                          ///< number of lists handed out or answered
  std::map<std::string, std::exception_ptr, std::less<>> failures_;  ///< of the service, by request
  mutable std::mutex mutex_;                                         ///< guards journals and failures
  std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

/// Calls take(i, answer to request(i)) for i = 0, 1, ... count - 1, one at a time. Without a crew, `service` answers on
/// the threads of the caller's on_threads(), and results are taken in order of completion unless `in_order`. With a
/// crew, which must have the same service, they are taken in order. Throws like Crew::each(); without a crew, passes on
/// any exception.
void share(Crew* crew, const Service& service, std::uint64_t count,
           const std::function<std::string(std::uint64_t)>& request,
           const std::function<void(std::uint64_t, std::string)>& take, bool in_order = false);

}  // namespace slipproof
