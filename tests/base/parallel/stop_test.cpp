// Calls that take long end when they are asked to. Each of these would go on for minutes.
#include "base/parallel/stop.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "base/parallel/in_parallel.hpp"
#include "floating/batch/bicycle_batch.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/search/search.hpp"
#include "records/certify/certify.hpp"
#include "support/stopped.hpp"

using namespace slipproof;
using test::is_stopped;
using test::new_stop_source;

namespace {

const std::filesystem::path source = SLIPPROOF_SOURCE_DIR;

/// A CSV without end.
ByteSource endless_records() {
  const std::string header = "R,h,b2,b3,I1,I2,I3,r1,r2,L,M,J,f,g,F,a,S2,S3,N2,N3\n";
  const std::string record = "0.34,1,0.5,0.5,0.01,0.1,0.1,0.1,0.05,0.17,85,12,0.8,9.81,100,1,1,1,400,430\n";
  return [=, at_head = true](char* to, std::size_t size) mutable -> std::size_t {
    const std::string& text = at_head ? header : record;
    at_head = false;
    REQUIRE(size >= text.size());
    std::copy(text.begin(), text.end(), to);
    return text.size();
  };
}

}  // namespace

TEST_CASE("a call that was asked to end before it began does nothing") {
  std::stop_source stop = new_stop_source();
  stop.request_stop();
  const StopScope scope(stop.get_token());
  CHECK_THROWS_AS(stop_if_asked(), Stopped);
  int done = 0;
  CHECK_THROWS_AS(on_threads(1, [&] { in_parallel(0, 10, [&](std::size_t) { ++done; }); }), Stopped);
  CHECK(done == 0);
}

TEST_CASE("the innermost scope counts, and outside of scopes nobody asks") {
  std::stop_source outer = new_stop_source(), inner = new_stop_source();
  outer.request_stop();
  CHECK_NOTHROW(stop_if_asked());
  {
    const StopScope scope(outer.get_token());
    CHECK(StopScope::asked());
    {
      const StopScope other(inner.get_token());
      CHECK(!StopScope::asked());
    }
    CHECK(StopScope::asked());
    std::thread([] { CHECK(!StopScope::asked()); }).join();
  }
  CHECK_NOTHROW(stop_if_asked());
}

TEST_CASE("what is handed to other threads ends, too, and calls beside it go on") {
  for (const unsigned threads : {1U, 0U}) {
    std::atomic<bool> end = false;
    std::jthread beside([&] {
      on_threads(0, [&] {
        in_parallel(0, 8, [&](std::size_t) {
          while (!end) stop_if_asked();
        });
      });
    });
    CHECK(is_stopped([&] {
      on_threads(threads, [] {
        in_parallel(0, 8, [](std::size_t) {
          for (;;) stop_if_asked();
        });
      });
    }));
    end = true;
  }
}

TEST_CASE("searching a mechanism ends when it is asked to") {
  const Mechanism mechanism = read_mechanism(source / "cases/mechanisms/three-axles.toml");
  SearchOptions options;
  options.samples = 100'000'000;
  CHECK(is_stopped([&] { search_motions(mechanism, options); }));
}

TEST_CASE("certifying and deciding modes end when they are asked to") {
  for (const unsigned threads : {1U, 0U}) {
    CertifyOptions options;
    options.threads = threads;
    CHECK(is_stopped([&] {
      certify(
          endless_records(), [](std::string_view) {}, options);
    }));
    const std::vector<double> forces(100'000, 300);
    BicycleColumns bicycles{.numbers = {85, 0.34, 1, 0.5, 0.5, 0.01, 0.1, 0.1, 0.1, 0.05, 0.17, 12, 0.8, 9.81},
                            .F = forces};
    CHECK(is_stopped([&] {
      for (;;) consistent_modes(bicycles, threads);
    }));
  }
}
