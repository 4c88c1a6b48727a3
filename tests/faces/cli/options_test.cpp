#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "support/run_program.hpp"

using slipproof::test::city_bicycle;
using slipproof::test::run;
using slipproof::test::TemporaryFolder;

namespace {

struct Numeric {
  std::vector<std::string> command;
  std::string option, range;
};

}  // namespace

TEST_CASE("numeric options take numbers in their range, and nothing that merely begins like one") {
  const std::string up_to_64_bits = "18446744073709551615";
  const std::vector<std::string> wrong_numbers{
      "-1", "18446744073709551616", "99999999999999999999", "nan", "1e400", "", "0x10", " 5", "5 ", "five"};
  const std::vector<Numeric> options{
      {{"solve", city_bicycle}, "--seed", "from 0 to " + up_to_64_bits},
      {{"solve", city_bicycle}, "--threads", "from 0 to 4096"},
      {{"solve", city_bicycle}, "--digits", "from 1 to 1000"},
      {{"map", city_bicycle}, "--columns", "from 2 to 10000"},
      {{"certify", "-"}, "--from", "from 1 to " + up_to_64_bits},
      {{"certify", "-"}, "--effort", "from 1 to " + up_to_64_bits},
      {{"certify", "-"}, "--tolerance", "from 0 to 1"},
      {{"verify"}, "--samples", "from 1 to 1000000000"},
      {{"verify"}, "--lines", "from 0 to 1000000"},
      {{"verify", "--mutants"}, "--every", "from 1 to 1000000000"},
      {{"report", "--out", "/dev/null"}, "--samples", "from 1 to 1000000000"},
      {{"report", "--out", "/dev/null"}, "--lines", "from 0 to 1000000"},
      {{"trade"}, "--scenes", "from 1 to 1000000"},
      {{"trade"}, "--seconds", "from 0 to 60"},
      {{"check", "x.cert"}, "--seed", "from 0 to " + up_to_64_bits},
      {{"prove", "x.statement"}, "--threads", "from 0 to 4096"},
  };
  for (const auto& [command, option, range] : options) {
    // One way reads them all: the first, and the one with a fraction, get all that may go wrong.
    const bool all = option == "--seed" || option == "--tolerance";
    for (const std::string& value : all ? wrong_numbers : std::vector<std::string>{"five"}) {
      std::vector<std::string> arguments = command;
      arguments.push_back(option + "=" + value);
      CAPTURE(arguments);
      const auto outcome = run(arguments);
      CHECK(outcome.exit_code == 2);
      CHECK(outcome.out.empty());
      CHECK(outcome.err.size() < 400);
      if (!value.empty()) CHECK(outcome.err.find("expected a") != std::string::npos);
      if (!value.empty()) CHECK(outcome.err.find(range) != std::string::npos);
    }
  }
  CHECK(run({"certify", "--from", "0", "-"}).err.find("found '0', expected a whole number from 1 to") !=
        std::string::npos);
  CHECK(run({"solve", city_bicycle, "--seed", up_to_64_bits}).exit_code == 0);
  CHECK(run({"solve", city_bicycle, "--digits", "010"}).exit_code == 2);  // eight or ten?
}

TEST_CASE("for an unknown command the nearest one is proposed") {
  const auto near = run({"slove", city_bicycle});
  CHECK(near.exit_code == 2);
  CHECK(near.out.empty());
  CHECK(near.err.find("unknown command 'slove': did you mean 'solve'? expected one of solve, rest, ") !=
        std::string::npos);
  CHECK(run({"frobnicate"}).err.find("unknown command 'frobnicate': expected one of solve, rest, impact, show, ") !=
        std::string::npos);
  CHECK(run({}).exit_code == 2);
  CHECK(run({"--version"}).exit_code == 0);
}

TEST_CASE("ranges of a map take exact numbers, and nothing that merely begins like one") {
  for (const std::string value : {"nan", "1e99999", "", " 5", "5x", "inf", "1/0"}) {
    CAPTURE(value);
    const auto outcome = run({"map", city_bicycle, "--columns", "2", "--x-range", "0", value});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find("expected") != std::string::npos);
  }
  CHECK(run({"map", city_bicycle, "--columns", "2", "--x-range", "1/3", "0x10"}).exit_code == 0);
  CHECK(run({"map", city_bicycle, "--columns", "2", "--y", "F"}).exit_code == 0);
  CHECK(run({"map", "--help"}).out.find("--y ") != std::string::npos);  // of a mechanism it chooses the load
}

TEST_CASE("of unknown options, papers, claims and parameters the known ones are listed") {
  const auto refused = [](const std::vector<std::string>& arguments, int code, const std::string& message) {
    CAPTURE(message);
    const auto end = run(arguments);
    CHECK(end.exit_code == code);
    CHECK(end.out.empty());
    CHECK(end.err.find(message) != std::string::npos);
  };
  refused({"solve", city_bicycle, "--lod", "3"}, 2,
          "unknown option '--lod', did you mean '--load'? expected one of --digits, ");
  refused({"certify", "-", "--anser", "x"}, 2, "unknown option '--anser', did you mean '--answer'?");  // in a group
  refused({"verify", "lader"}, 3, "unknown paper 'lader', did you mean 'ladder'? expected one of block-on-incline, ");
  refused({"verify", "ladder", "--only", "Z"}, 3, "unknown claim 'Z', expected one of ");
  refused({"critical", city_bicycle, "--x", "foo"}, 3,
          "unknown parameter of the scene 'foo', expected one of M, R, h, ");
  CHECK(run({"verify", "ladder", "--only", "Q1", "--samples", "5", "--lines", "0"}).exit_code == 0);
}
