// Work by index is done once each, by threads or by a crew.
#include "base/crew/share.hpp"

#include <doctest/doctest.h>

#include <map>
#include <stdexcept>
#include <string>

#include "base/parallel/in_parallel.hpp"
#include "support/run_program.hpp"
#include "support/thread_ranks.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

std::string doubled(std::string_view request) {
  return std::string(request) + std::string(request);
}

/// How often each result was taken.
std::map<std::string, int> taken_by(Crew* crew, std::uint64_t count) {
  std::map<std::string, int> taken;
  on_threads(2, [&] {
    share(
        crew, doubled, count, [](std::uint64_t i) { return std::to_string(i); },
        [&](std::uint64_t i, const std::string& result) {
          CHECK(result == doubled(std::to_string(i)));
          ++taken[result];
        });
  });
  return taken;
}

}  // namespace

TEST_CASE("each result is taken once, whoever answers") {
  std::map<std::string, int> expected;
  for (int i = 0; i < 300; ++i) expected[doubled(std::to_string(i))] = 1;
  CHECK(taken_by(nullptr, 300) == expected);
  for (const int ranks : {1, 3}) {
    by_crew(ranks, doubled, [&](Crew& crew) {
      CHECK(taken_by(&crew, 300) == expected);
      CHECK(taken_by(&crew, 300) == expected);
    });
  }
}

TEST_CASE("results are taken in order where that is asked for") {
  const auto in_order = [](Crew* crew) {
    std::uint64_t taken = 0;
    on_threads(2, [&] {
      share(
          crew, doubled, 500, [](std::uint64_t i) { return std::to_string(i); },
          [&](std::uint64_t i, const std::string& result) {
            CHECK(i == taken++);
            CHECK(result == doubled(std::to_string(i)));
          },
          Taking::in_order);
    });
    CHECK(taken == 500);
  };
  in_order(nullptr);
  by_crew(3, doubled, [&](Crew& crew) { in_order(&crew); });
}

TEST_CASE("results that are there are taken before the first is") {
  const TemporaryFolder folder;
  Journal journal(folder.path() / "journal", "work");
  journal.keep("1", "of an earlier run");
  std::string order;
  const auto lead = [&](Crew& crew) {
    share(
        &crew, doubled, 2, [](std::uint64_t i) { return std::to_string(i); },
        [&](std::uint64_t, const std::string& result) { order += result + ' '; });
  };
  by_crew(1, doubled, lead, &journal);
  CHECK(order == "of an earlier run 00 ");
}

TEST_CASE("what is thrown is thrown on, and tells the first in the order") {
  const Service service = [](std::string_view request) -> std::string {
    if (request >= std::string_view("5")) throw std::runtime_error("no luck with " + std::string(request));
    return {};
  };
  const auto work = [&](Crew* crew) {
    share(
        crew, service, 9, [](std::uint64_t i) { return std::to_string(i); }, [](std::uint64_t, const std::string&) {});
  };
  CHECK_THROWS_AS(work(nullptr), std::runtime_error);
  by_crew(2, service, [&](Crew& crew) { CHECK_THROWS_WITH_AS(work(&crew), "no luck with 5", std::runtime_error); });
}
