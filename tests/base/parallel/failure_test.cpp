#include "base/parallel/failure.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace slipproof;

TEST_CASE("what fails comes back as a text; a request to stop and a lack of memory do not") {
  CHECK(failure_of([] {}).empty());
  CHECK(failure_of([] { throw std::domain_error("found NaN"); }) == "found NaN");
  CHECK_THROWS_AS(failure_of([] { throw std::bad_alloc(); }), std::bad_alloc);
  CHECK_THROWS_AS(failure_of([] { throw Stopped(); }), Stopped);
}
