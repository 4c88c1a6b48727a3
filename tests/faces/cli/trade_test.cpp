#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "support/run_program.hpp"

using slipproof::test::run;
using Json = nlohmann::json;

namespace {

/// Without what depends on the machine.
Json without_speeds(const std::string& out) {
  Json document = Json::parse(out);
  document.erase("machine");
  for (Json& row : document["rows"]) row.erase("scenes_per_second");
  return document;
}

const std::vector<std::string> few{"trade", "--scenes", "3", "--seconds", "0"};

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

}  // namespace

TEST_CASE("trade prints a table that names the machine, or one JSON document") {
  const auto text = run(few);
  CHECK(text.exit_code == 0);
  CHECK(text.err.empty());
  for (const char* expected : {" cores\n", "-ffp-contract=off", "threshold 2^-200", "binary128", "MPFR 200 digits"}) {
    CAPTURE(expected);
    CHECK(text.out.find(expected) != std::string::npos);
  }
  CHECK(text.out.ends_with("\ns MEASURED workloads 30 types 9 scenes 90\n"));
  CHECK(run(with(few, {"--quiet"})).out == "s MEASURED workloads 30 types 9 scenes 90\n");

  const auto json = run(with(few, {"--json"}));
  CHECK(json.exit_code == 0);
  const Json document = without_speeds(json.out);
  CHECK(document["schema"] == "slipproof/trade/1");
  CHECK(document["scenes"] == 3);
  CHECK(without_speeds(run(with(few, {"--json", "--threads", "2"})).out) == document);
  CHECK(without_speeds(run(with(few, {"--json", "--seed", "2"})).out) != document);
}

TEST_CASE("usage errors of trade exit with 2") {
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{{"--scenes", "0"},
                                                                                    {"--scenes", "-3"},
                                                                                    {"--scenes", "1000001"},
                                                                                    {"--scenes", "few"},
                                                                                    {"--seconds", "-1"},
                                                                                    {"--seconds", "nan"},
                                                                                    {"--quick", "--scenes", "5"},
                                                                                    {"file"},
                                                                                    {"--frobnicate"}}) {
    const auto outcome = run(with({"trade"}, more));
    CAPTURE(more.front());
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK_FALSE(outcome.err.empty());
  }
}
