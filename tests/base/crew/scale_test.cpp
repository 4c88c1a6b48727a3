// A played crew takes as long as what can be counted by hand.
#include "base/crew/scale.hpp"

#include <doctest/doctest.h>

using namespace slipproof;

namespace {

MeasuredWork equal_requests(std::uint64_t count, double seconds) {
  return {.requests = {seconds}, .latency = 0, .count = count};
}

}  // namespace

TEST_CASE("one core takes the sum, and many take their share of it") {
  MeasuredWork work = equal_requests(1000, 0.5);
  CHECK(predict(work, 1).seconds == doctest::Approx(500));
  CHECK(predict(work, 1).efficiency == doctest::Approx(1));
  CHECK(predict(work, 10).seconds == doctest::Approx(50));
  CHECK(predict(work, 10).bottleneck == Bottleneck::none);
  CHECK(predict(work, 101).seconds == doctest::Approx(5));  // rank 0 of many only hands out
  work.alone = 7;
  CHECK(predict(work, 10).seconds == doctest::Approx(57));
}

TEST_CASE("rank 0 bounds what many small requests take") {
  MeasuredWork work = equal_requests(10'000, 0.01);
  work.handling = 0.001;
  work.bytes = 1000;
  work.seconds_a_byte = 1e-6;
  const PredictedRun run = predict(work, 1001);
  CHECK(run.seconds == doctest::Approx(10'000 * 0.002 + 0.01));
  CHECK(run.bottleneck == Bottleneck::rank_0);
}

TEST_CASE("a request that takes long bounds the work") {
  MeasuredWork work{.requests = {0.001, 5}, .latency = 0, .count = 100};
  const PredictedRun run = predict(work, 10'001);
  CHECK(run.bottleneck == Bottleneck::longest);
  CHECK(run.seconds == doctest::Approx(5));
  work.requests = {0.001};
  work.alone = 2;
  CHECK(predict(work, 10'001).bottleneck == Bottleneck::alone);
}

TEST_CASE("a prediction is the same each time, and does not depend on how many cores are idle") {
  const MeasuredWork work{.requests = {0.1, 0.2, 0.7, 1.9}, .count = 500};
  CHECK(predict(work, 64).seconds == predict(work, 64).seconds);
  CHECK(predict(work, 64, 2).seconds != predict(work, 64).seconds);
  CHECK(predict(work, 501).seconds == predict(work, 5001).seconds);
}
