// Requests go to many ranks, here threads, and the results are those of one, in its order.
#include "base/crew/crew.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <string>
#include <thread>

#include "base/input/diagnostic.hpp"
#include "support/thread_ranks.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

/// Takes longer for some requests, so that answers come out of order.
std::string slow_square(std::string_view request) {
  const int i = std::stoi(std::string(request));
  std::this_thread::sleep_for(std::chrono::microseconds(i % 7 == 0 ? 3000 : 50));
  return std::to_string(i * i);
}

/// The results of requests 0..count-1, one after the other.
std::string results_by(int ranks, unsigned threads, std::uint64_t count, const Service& service,
                       CrewOptions options = {}) {
  std::string text;
  ThreadRanks all(ranks);
  options.threads = threads;
  all.run(
      [&](Transport& transport) {
        Crew crew(transport, options, service);
        for (int stage = 0; stage < 2; ++stage) {
          crew.each(
              count, [](std::uint64_t i) { return std::to_string(i); },
              [&](std::uint64_t i, const std::string& result) { text += std::to_string(i) + ":" + result + ' '; });
        }
      },
      [&](Transport& transport) { Crew(transport, {.threads = threads}, service).serve(); });
  return text;
}

}  // namespace

TEST_CASE("the same results in the same order, by any number of ranks and threads") {
  std::string expected;
  for (int stage = 0; stage < 2; ++stage) {
    for (int i = 0; i < 200; ++i) expected += std::to_string(i) + ":" + std::to_string(i * i) + ' ';
  }
  for (const int ranks : {1, 2, 3, 8}) {
    for (const unsigned threads : {1U, 2U}) {
      CAPTURE(ranks);
      CAPTURE(threads);
      CHECK(results_by(ranks, threads, 200, slow_square) == expected);
    }
  }
  CHECK(results_by(3, 1, 0, slow_square).empty());
}

TEST_CASE("more than one rank works") {
  std::mutex mutex;
  std::set<std::thread::id> workers;
  results_by(3, 1, 60, [&](std::string_view request) {
    {
      const std::scoped_lock lock(mutex);
      workers.insert(std::this_thread::get_id());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return std::string(request);
  });
  CHECK(workers.size() == 3);
}

TEST_CASE("what a service throws is thrown in the order of the requests, whoever met it first") {
  for (const int ranks : {1, 4}) {
    CAPTURE(ranks);
    std::atomic<int> taken = 0;
    ThreadRanks all(ranks);
    const Service service = [](std::string_view request) -> std::string {
      const int i = std::stoi(std::string(request));
      if (i == 9) std::this_thread::sleep_for(std::chrono::milliseconds(20));
      if (i >= 9) throw InputError({{"file", 3, static_cast<std::size_t>(i), "found x, expected y"}});
      return {};
    };
    all.run(
        [&](Transport& transport) {
          Crew crew(transport, {.threads = 1}, service);
          CHECK_THROWS_WITH_AS(crew.each(
                                   30, [](std::uint64_t i) { return std::to_string(i); },
                                   [&](std::uint64_t, const std::string&) { ++taken; }),
                               "file:3:9: found x, expected y", InputError);
        },
        [&](Transport& transport) { Crew(transport, {.threads = 1}, service).serve(); });
    CHECK(taken == 9);
  }
  CHECK_THROWS_WITH_AS(
      results_by(2, 1, 5, [](std::string_view) -> std::string { throw std::runtime_error("no luck"); }), "no luck",
      std::runtime_error);
}

TEST_CASE("a stop ends the work, and says what is missing") {
  int asked = 0;
  CHECK_THROWS_AS(results_by(2, 1, 100'000, slow_square, {.stop_asked = [&] { return ++asked > 20; }}), Unfinished);
  std::string text;
  try {
    results_by(1, 1, 5, slow_square, {.stop_asked = [] { return true; }});
  } catch (const Unfinished& unfinished) {
    text = unfinished.what();
  }
  CHECK(text.starts_with("stopped on request: "));
  CHECK(text.ends_with("5"));
}

TEST_CASE("ranges are told shortly") {
  CHECK(ranges_text({}) == "");
  CHECK(ranges_text({3}) == "3");
  CHECK(ranges_text({1, 2, 3, 7, 9, 10}) == "1-3, 7, 9-10");
  std::vector<std::uint64_t> odd;
  for (std::uint64_t i = 0; i < 15; ++i) odd.push_back(2 * i + 1);
  CHECK(ranges_text(odd) == "1, 3, 5, 7, 9, 11, 13, 15, 17, 19 and 5 more");
}
