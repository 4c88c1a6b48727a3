// The library as somebody calls it who has doubles: certify an answer, and columns of them.
#include <doctest/doctest.h>

#include <limits>
#include <set>
#include <string_view>
#include <vector>

#include "base/number/binary64.hpp"
#include "records/certify/columns.hpp"
#include "records/record/bicycle_records.hpp"
#include "support/bicycle/motions.hpp"

using namespace slipproof;

namespace {

const ForcedScene<double> typical{.bicycle = {.M = 94,
                                              .R = 0.3,
                                              .h = 0.56,
                                              .b2 = 0.34,
                                              .b3 = 0.68,
                                              .I1 = 0.01,
                                              .I2 = 0.12,
                                              .I3 = 0.2,
                                              .r1 = 0.09,
                                              .r2 = 0.036,
                                              .L = 0.17,
                                              .J = 15.7},
                                  .road = {.f = 0.8, .g = 9.81},
                                  .F = 300};

/// The numbers of a bicycle and of its one motion.
RecordJudge::NamedNumbers right_answer() {
  const MotionsAtForce found = motions_at(typical);
  REQUIRE(found.motions.size() == 1);
  const Bicycle<double>& p = typical.bicycle;
  RecordJudge::NamedNumbers numbers{{"M", p.M},
                                    {"R", p.R},
                                    {"h", p.h},
                                    {"b2", p.b2},
                                    {"b3", p.b3},
                                    {"I1", p.I1},
                                    {"I2", p.I2},
                                    {"I3", p.I3},
                                    {"r1", p.r1},
                                    {"r2", p.r2},
                                    {"L", p.L},
                                    {"J", *p.J},
                                    {"f", typical.road.f},
                                    {"g", typical.road.g},
                                    {"F", typical.F}};
  for (const Quantity q : {Quantity::a, Quantity::S2, Quantity::S3, Quantity::N2, Quantity::N3, Quantity::eps3}) {
    numbers.emplace_back(name(q), nearest_binary64(found.motions[0].values[q]));
  }
  return numbers;
}

}  // namespace

TEST_CASE("an answer in doubles is certified, or told what is wrong with it") {
  const RecordJudge judge(bicycle_records(), {}), loose(bicycle_records(), {.tolerance = 1e-2});
  const RecordFields& fields = judge.fields();
  const Record right = judge.record(right_answer());
  CHECK(judge(right).verdict == RecordVerdict::certified);
  CHECK(judge(right).tier == Tier::filter);
  CHECK(judge(right).mode_names == "\"stick/stick\"");
  Record off = right;
  off.values[*fields.find("eps3")] *= 1.001;
  CHECK(judge(off).verdict == RecordVerdict::inaccurate);
  CHECK(loose(off).verdict == RecordVerdict::certified);
  off.mode = *fields.find_mode("slip+/stick");
  CHECK(judge(off).verdict == RecordVerdict::wrong);
  auto numbers = right_answer();
  numbers[12].second = std::numeric_limits<double>::quiet_NaN();
  CHECK(judge(judge.record(numbers)).verdict == RecordVerdict::invalid);
  numbers.pop_back();
  numbers.erase(numbers.begin());
  CHECK_THROWS_WITH_AS(judge(judge.record(numbers)), doctest::Contains("missing M"), std::invalid_argument);
}

TEST_CASE("the kernel's judgement of a record does not depend on those before it") {
  const RecordJudge judge(bicycle_records(), {});
  const auto changed = [&](std::string_view field, double value) {
    Record record = judge.record(right_answer());
    record.set(*judge.fields().find(field), value);
    return record;
  };
  const std::vector<Record> records{changed("F", 300), changed("a", 9),  changed("a", 3),  changed("F", 3000),
                                    changed("f", -1),  changed("a", 9),  changed("f", 7),  changed("f", 7),
                                    changed("M", 0),   changed("h", 90), changed("F", 300)};
  ExactJudge exact = judge.exact();
  std::set<RecordVerdict> verdicts;
  for (const Record& record : records) {
    const RecordJudgement found = exact(record), alone = judge.exact()(record);
    CHECK(found.verdict == alone.verdict);
    CHECK(found.mode_names == alone.mode_names);
    CHECK(found.motions == alone.motions);
    CHECK(found.distance == alone.distance);
    CHECK(found.details == alone.details);
    verdicts.insert(found.verdict);
  }
  CHECK(verdicts.size() >= 3);
}

TEST_CASE("columns in memory are judged as records one by one") {
  const RecordJudge judge(bicycle_records(), {});
  RecordColumns columns(judge.fields(), 1000);
  const auto numbers = right_answer();
  for (const auto& [name, value] : numbers) columns.number(name) = {&value, 0};
  std::vector<double> accelerations(1000, numbers[15].second);
  for (std::size_t i = 0; i < accelerations.size(); i += 3) accelerations[i] *= 1 + 1e-6 * static_cast<double>(i);
  columns.number("a") = std::span<const double>(accelerations);
  const JudgedColumns found = certify(columns, judge, 2);
  CHECK(found.summary.records == 1000);
  for (std::size_t i = 0; i < accelerations.size(); ++i) {
    auto one = numbers;
    one[15].second = accelerations[i];
    const RecordJudgement alone = judge(judge.record(one));
    CHECK(found.verdicts[i] == alone.verdict);
    CHECK(found.errors[i] == alone.max_error);
    CHECK(found.modes[i] == 1);
  }
  CHECK(found.summary.count(RecordVerdict::certified) == 667);
  const std::uint16_t no_such_mode = 16;
  columns.modes = {&no_such_mode, 0};
  CHECK_THROWS_WITH_AS(certify(columns, judge), doctest::Contains("expected 0 to 15"), std::invalid_argument);
}
