// Requests go to many ranks, here threads, and the results are those of one, in its order, whatever rank is gone.
#include "base/crew/crew.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <string>
#include <thread>

#include "base/parallel/in_parallel.hpp"
#include "support/crew_ranks.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

/// Takes longer for some requests, so that answers come out of order.
std::string slow_square(std::string_view request) {
  const int i = std::stoi(std::string(request));
  std::this_thread::sleep_for(std::chrono::microseconds(i % 7 == 0 ? 3000 : 50));
  return std::to_string(i * i);
}

/// The results of requests 0 to count - 1, one after the other, by a crew or by threads.
std::string results(Crew* crew, std::uint64_t count, const Service& service = slow_square) {
  std::string text;
  share(
      crew, service, count, [](std::uint64_t i) { return std::to_string(i); },
      [&](std::uint64_t i, const std::string& result) { text += std::to_string(i) + ":" + result + ' '; }, true);
  return text;
}

std::string squares(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += std::to_string(i) + ":" + std::to_string(i * i) + ' ';
  return text;
}

}  // namespace

TEST_CASE("the same results in the same order, by threads and by any number of ranks") {
  CHECK(on_threads(2, [] { return results(nullptr, 200); }) == squares(200));
  for (const int ranks : {1, 2, 3, 8}) {
    CAPTURE(ranks);
    by_crew(ranks, slow_square, [&](Crew& crew) {
      for (const int count : {200, 300, 0}) CHECK(results(&crew, static_cast<std::uint64_t>(count)) == squares(count));
    });
  }
}

TEST_CASE("each rank answers its share of a list, and rank 0 that of ranks which are not there") {
  const TemporaryFolder folder, empty;
  const std::string path = folder.path() / "checkpoint";
  by_crew(
      3, slow_square, [&](Crew& crew) { results(&crew, 90); }, folder.path());
  CHECK(Journal(path + ".1", "work", Journal::Access::read).size() == 30);
  CHECK(Journal(path + ".2", "work", Journal::Access::read).find("5") == "25");
  Crew alone({.checkpoint = empty.path() / "checkpoint", .ranks = 3, .threads = 1}, slow_square);
  CHECK(results(&alone, 90) == squares(90));
}

TEST_CASE("what a service throws is thrown in the order of the requests, whichever rank met it first") {
  const Service service = [](std::string_view request) -> std::string {
    const int i = std::stoi(std::string(request));
    if (i == 9) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (i >= 9) throw std::runtime_error("no " + std::to_string(i));
    return {};
  };
  for (const int ranks : {1, 4}) {
    CAPTURE(ranks);
    by_crew(ranks, service, [&](Crew& crew) { CHECK_THROWS_WITH(results(&crew, 30, service), "no 9"); });
  }
}

TEST_CASE("a run that ended anywhere goes on with other ranks, which are asked nothing twice") {
  const TemporaryFolder folder;
  std::atomic<int> calls = 0;
  const Service service = [&](std::string_view request) {
    ++calls;
    return slow_square(request);
  };
  const auto take_until = [](std::uint64_t last) {
    return [last](std::uint64_t i, const std::string&) {
      if (i == last) throw std::runtime_error("killed");
    };
  };
  const auto request = [](std::uint64_t i) { return std::to_string(i); };
  for (const int ranks : {1, 3, 2, 5}) {
    const auto end = take_until(40 * static_cast<unsigned>(ranks));
    by_crew(
        ranks, service, [&](Crew& crew) { CHECK_THROWS(crew.each(500, request, end)); }, folder.path());
  }
  by_crew(
      2, service, [&](Crew& crew) { CHECK(results(&crew, 500, service) == squares(500)); }, folder.path());
  CHECK(calls < 600);  // a few by a rank whose place was taken
}
