// What is measured in pieces is what is measured at once.
#include "floating/trade/accuracy.hpp"

#include <doctest/doctest.h>

#include "base/crew/bytes.hpp"
#include "floating/trade/arithmetic.hpp"
#include "report/scenes/trade_report.hpp"
#include "support/crew_ranks.hpp"

using namespace slipproof;

namespace {

void check_same(const TradeRow& found, const TradeRow& expected) {
  CHECK(found.scenes == expected.scenes);
  CHECK(found.wrong == expected.wrong);
  CHECK(found.undecided == expected.undecided);
  CHECK(found.tiers == expected.tiers);
  CHECK(found.judged == expected.judged);
  CHECK(found.worst_acceleration == expected.worst_acceleration);
  CHECK(found.worst_force == expected.worst_force);
  CHECK(found.digits_lost == expected.digits_lost);
  CHECK(found.condition == expected.condition);
}

std::vector<Cancellation> cancellations(const Accuracy& accuracy) {
  std::vector<Cancellation> all;
  accuracy.tell_cancellations("type", all);
  return all;
}

/// Without speeds.
std::string document(Trade trade) {
  for (TradeRow& row : trade.rows) row.scenes_per_second = 0;
  return trade_json(trade);
}

}  // namespace

TEST_CASE("halves add up to the whole, also as bytes") {
  const Workloads workloads{24, 5};
  for (const std::size_t index : {std::size_t{0}, std::size_t{5}, std::size_t{26}, std::size_t{29}}) {
    CAPTURE(index);
    const Workload whole = workloads.make(index);
    Workload first = whole, second = whole;
    first.scenes.resize(9);
    second.scenes.erase(second.scenes.begin(), second.scenes.begin() + 9);
    const auto expected = judge_accuracy(whole);
    std::vector<Accuracy> sum;
    for (const Workload* half : {&first, &second}) add_accuracy(accuracy_bytes(judge_accuracy(*half)), sum);
    REQUIRE(sum.size() == expected.size());
    for (std::size_t t = 0; t < sum.size(); ++t) {
      CAPTURE(t);
      check_same(sum[t].row, expected[t].row);
      const auto found = cancellations(sum[t]), once = cancellations(expected[t]);
      REQUIRE(found.size() == once.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        CHECK(found[i].decade == once[i].decade);
        CHECK(found[i].quantities == once[i].quantities);
        CHECK(found[i].digits_lost == once[i].digits_lost);
        CHECK(found[i].mean_digits_lost == doctest::Approx(once[i].mean_digits_lost));
      }
    }
  }
}

TEST_CASE("bytes that are no accuracies are told") {
  const std::string bytes = accuracy_bytes(judge_accuracy(Workloads{2, 1}.make(0)));
  for (const std::string& broken : {std::string(), bytes.substr(0, bytes.size() - 1), bytes + "x"}) {
    std::vector<Accuracy> types;
    CHECK_THROWS_AS(add_accuracy(broken, types), BrokenBytes);
  }
}

TEST_CASE("pieces have the scenes that are asked for, each its own") {
  const Workloads two{Workloads::piece_size + 1, 1}, one{Workloads::piece_size, 1};
  REQUIRE(two.pieces() == 2);
  REQUIRE(one.pieces() == 1);
  const auto first = two.make(0, 0).scenes, second = two.make(0, 1).scenes;
  CHECK(first.size() == Workloads::piece_size);
  REQUIRE(second.size() == 1);
  for (const auto& scene : first) CHECK(scene.back() != second[0].back());
  CHECK(one.make(0).scenes.back() == first.back());
}

TEST_CASE("ranks measure what one machine does") {
  const TradeOptions options{.scenes = 3, .seed = 2, .seconds = 0, .threads = 1};
  const std::string expected = document(measure_trade(options));
  const Service service = [&](std::string_view request) { return trade_answer(options, request); };
  for (const int ranks : {1, 3}) {
    test::by_crew(ranks, service, [&](Crew& crew) { CHECK(document(measure_trade(options, {}, &crew)) == expected); });
  }
}
