// The line of a record: its error is printed as an upper bound, in two digits.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>

#include "records/certify/certify.hpp"

using namespace slipproof;

namespace {

nlohmann::json line(const RecordJudgement& judgement) {
  std::string text;
  append_line(text, 12345678901234567890U, judgement);
  CHECK(text.back() == '\n');
  return nlohmann::json::parse(text);
}

double printed(double error) {
  RecordJudgement judgement;
  judgement.verdict = RecordVerdict::certified;
  judgement.add_mode(0, "stick/stick");
  judgement.max_error = error;
  return std::strtod(line(judgement).at("max_relative_error").get<std::string>().c_str(), nullptr);
}

}  // namespace

TEST_CASE("the printed error is never below the error, and at most one unit of its second digit above") {
  std::mt19937_64 engine(96);
  for (int i = 0; i < 100000; ++i) {
    const double error = std::pow(10.0, -39 + 43 * static_cast<double>(engine() >> 11) * 0x1p-53);
    const double text = printed(error);
    CHECK(text >= error);
    CHECK(text <= error * (1 + 0x1p-40) + std::pow(10.0, std::floor(std::log10(text) + 1e-9) - 1));
  }
  for (const double error : {1e-320, 1.2349e-300, 9.999e-40, 1e4, 12349.0, 1e300}) {
    CHECK(printed(error) >= error);
    CHECK(printed(error) <= 1.02 * error);
  }
  CHECK(printed(0) == 0);
  for (int exponent = -38; exponent < 4; ++exponent) {
    const double power = std::strtod(("1e" + std::to_string(exponent)).c_str(), nullptr);
    for (const double error : {std::nextafter(power, 0), power, std::nextafter(power, 1e9)}) {
      CHECK(printed(error) >= error);
      CHECK(printed(error) <= 1.11 * error);
    }
  }
}

TEST_CASE("the longest line there is, and what an invalid record leaves out") {
  RecordJudgement judgement;
  judgement.verdict = RecordVerdict::inaccurate;
  for (std::uint16_t i = 0; i < 100; ++i) judgement.add_mode(i, "slip+/slip-/stick");
  judgement.motions = SIZE_MAX;
  judgement.max_error = 1.2345e-300;
  judgement.tier = Tier::exact;
  judgement.details = ",\"found\":\"" + std::string(5000, 'x') + '"';
  const auto json = line(judgement);
  CHECK(json.at("record") == 12345678901234567890U);
  CHECK(json.at("modes").size() == 100);
  CHECK(json.at("motions") == SIZE_MAX);
  CHECK(json.at("max_relative_error") == "1.25e-300");
  CHECK(json.at("tier") == "exact");
  CHECK(json.at("found").get<std::string>().size() == 5000);
  CHECK(line({}) == nlohmann::json{{"record", 12345678901234567890U}, {"verdict", "invalid"}});
}
