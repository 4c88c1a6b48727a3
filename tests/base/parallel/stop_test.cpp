// Calls that take long end when they are asked to.
#include "base/parallel/stop.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <stop_token>
#include <thread>

#include "base/parallel/in_parallel.hpp"
#include "support/stopped.hpp"

using namespace slipproof;
using test::is_stopped;
using test::new_stop_source;

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
