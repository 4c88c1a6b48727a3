#include "floating/trade/trade.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "floating/trade/workload.hpp"
#include "report/scenes/trade_report.hpp"

using namespace slipproof;

namespace {

const Trade& measured() {
  static const Trade trade = measure_trade({.scenes = 20, .seed = 3, .seconds = 0});
  return trade;
}

const TradeRow& row(const std::string& workload, const std::string& type) {
  for (const TradeRow& r : measured().rows) {
    if (r.workload == workload && r.type == type) return r;
  }
  throw std::runtime_error("no row " + workload + ", " + type);
}

std::uint64_t decided_by(Tier tier, const TradeRow& row) {
  return row.tiers[static_cast<std::size_t>(tier)];
}

const std::vector<std::string> plain_types{"binary32",       "binary64",        "long double",    "binary128",
                                           "MPFR 50 digits", "MPFR 100 digits", "MPFR 200 digits"};

}  // namespace

TEST_CASE("the filter is never wrong, and each plain type is, once the threshold is nearer than its digits") {
  for (const TradeRow& r : measured().rows) {
    if (r.type == "filter" || r.type == "exact") CHECK(r.wrong == 0);
    CHECK(r.scenes == 20);
    CHECK(r.scenes_per_second > 0);
    CHECK(r.judged + r.wrong <= r.scenes);
  }
  CHECK(measured().sound());
  for (const std::string& type : plain_types) {
    CAPTURE(type);
    CHECK(row("typical", type).wrong == 0);
    CHECK(row("typical", type).undecided == 0);
    CHECK(row("typical, wheels may lift", type).wrong == 0);
    CHECK(row("threshold exactly", type).wrong > 0);
    CHECK((row("threshold 2^-200", type).wrong > 0) == (type != "MPFR 100 digits" && type != "MPFR 200 digits"));
  }
  CHECK(row("threshold 2^-40", "binary32").wrong > 0);
  CHECK(row("threshold 2^-40", "binary64").wrong == 0);
  CHECK(row("threshold 2^-60", "binary64").wrong > 0);
  CHECK(row("threshold 2^-100", "binary128").wrong == 0);
  CHECK(row("threshold 2^-120", "binary128").wrong > 0);
}

TEST_CASE("a filter that is wrong is not sound") {
  Trade trade = measured();
  for (TradeRow& r : trade.rows) {
    if (r.type == "filter") r.wrong = 1;
  }
  CHECK_FALSE(trade.sound());
}

TEST_CASE("what a type cannot hold is undecided or wrong, and the tiers of the filter add up") {
  CHECK(row("mass ratio 1e-300 to 1e300", "binary32").undecided > 0);
  CHECK(row("mass ratio 1e-300 to 1e300", "MPFR 200 digits").undecided <
        row("mass ratio 1e-300 to 1e300", "binary32").undecided);
  CHECK(row("subnormals", "binary32").undecided > 0);
  CHECK(row("subnormals", "long double").worst_acceleration < 1e-15);
  CHECK(row("subnormals", "long double").undecided == 0);
  CHECK(decided_by(Tier::filter, row("typical", "filter")) == 20);
  CHECK(decided_by(Tier::filter, row("threshold 2^-30", "filter")) == 20);
  CHECK(decided_by(Tier::exact, row("threshold 2^-60", "filter")) == 20);
  CHECK(decided_by(Tier::exact, row("threshold exactly", "filter")) == 20);
  for (const TradeRow& r : measured().rows) {
    if (r.type != "filter") continue;
    CHECK(decided_by(Tier::filter, r) + decided_by(Tier::exact, r) == 20);
    CHECK(r.undecided == decided_by(Tier::exact, r));
    CHECK(r.judged == row(r.workload, "exact").judged);
  }
}

TEST_CASE("errors are those of the type's digits times the condition number, no more and no less") {
  for (const auto& type : measured().types) {
    if (type.bits == 0) continue;
    CAPTURE(type.name);
    // A conversion that lost digits on the way, or a condition number too small, breaks the bound of 42 roundings.
    for (const auto& workload :
         {"typical", "threshold 2^-10", "threshold 2^-30", "eta near 0", "b near b1, q near 0"}) {
      const TradeRow& r = row(workload, type.name);
      CAPTURE(workload);
      CHECK(r.digits_lost <= std::log10(r.condition) + std::log10(42));
    }
    const TradeRow& typical = row("typical", type.name);
    CHECK(typical.judged > 10);
    CHECK(std::max(typical.worst_acceleration, typical.worst_force) > std::ldexp(1, -type.bits - 3));
    CHECK(row("threshold 2^-20", type.name).digits_lost > typical.digits_lost);
  }
  double worst = 0;
  for (const auto& workload : {"eta near 0", "b near b1, q near 0", "2 eta near f (1 + 2 M2) R"}) {
    worst = std::max(worst, row(workload, "binary64").condition);
  }
  CHECK(worst > 1e4);
  CHECK(row("threshold 2^-200", "exact").worst_force == 0);
}

TEST_CASE("digits lost follow the condition number, decade by decade") {
  std::size_t curves = 0;
  for (const Cancellation& c : measured().cancellations) {
    CHECK(c.decade >= 0);
    CHECK(c.decade <= 40);
    CHECK(c.quantities > 0);
    CHECK(c.mean_digits_lost <= c.digits_lost);
    if (c.type == "MPFR 200 digits") {  // holds every workload
      ++curves;
      CHECK(c.digits_lost <= c.decade + 1 + std::log10(42));
    }
    if (c.type == "exact") CHECK(c.digits_lost == 0);
  }
  CHECK(curves > 10);
}

TEST_CASE("scenes depend on the seed and their number alone, and the JSON carries every row") {
  const Workloads one{3, 5}, same{3, 5}, other{3, 6};
  REQUIRE(one.size() == 30);
  std::size_t thresholds = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const auto scenes = one.make(i), again = same.make(i), others = other.make(i);
    thresholds += scenes.threshold_bits ? 1 : 0;
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(scenes.scenes[k] == again.scenes[k]);
      CHECK(scenes.scenes[k].back() != others.scenes[k].back());
    }
  }
  CHECK(thresholds == 20);

  const auto json = nlohmann::json::parse(trade_json(measured()));
  CHECK(json["schema"] == "slipproof/trade/1");
  CHECK(json["rows"].size() == 30 * json["types"].size());
  CHECK(json["rows"].size() == measured().rows.size());
  CHECK(json["workloads"].size() == 30);
  CHECK(json["workloads"][2] == nlohmann::json{{"name", "threshold 2^-10"}, {"threshold_bits", 10}});
  CHECK(json["cancellation"].size() == measured().cancellations.size());
  CHECK(json["machine"]["flags"].get<std::string>().find("-ffp-contract=off") != std::string::npos);
  CHECK(!json["machine"]["processor"].get<std::string>().empty());
  const std::string text = text_of(trade_document(measured()));
  for (const auto& workload : measured().workloads) CHECK(text.find("\n" + workload.name + " ") != std::string::npos);
}
