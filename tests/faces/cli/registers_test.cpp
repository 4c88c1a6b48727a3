// The program on a processor with narrower registers: only slower.
#include <doctest/doctest.h>

#include <string>

#include "support/run_program.hpp"

using slipproof::test::ProgramEnd;
using slipproof::test::run;

namespace {

ProgramEnd run_with(const std::string& registers, const std::vector<std::string>& arguments) {
  setenv("SLIPPROOF_REGISTERS", registers.c_str(), 1);
  const ProgramEnd outcome = run(arguments);
  unsetenv("SLIPPROOF_REGISTERS");
  return outcome;
}

}  // namespace

TEST_CASE("in registers of any kind the same bytes") {
  const std::string cases = SLIPPROOF_SOURCE_DIR "/cases/";
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"certify", cases + "solvers/ode.csv", "--ignore-unknown"},
                                             {"certify", cases + "contact-problems/pushed-block.json"},
                                             {"certify", cases + "contact-problems/examples.jsonl"}}) {
    const ProgramEnd widest = run(arguments);
    CHECK(!widest.out.empty());
    for (const std::string& registers : std::vector<std::string>{"sse2", "avx2", "avx512"}) {
      CAPTURE(registers);
      CAPTURE(arguments[1]);
      const ProgramEnd here = run_with(registers, arguments);
      CHECK(here.exit_code == widest.exit_code);
      CHECK(here.out == widest.out);
    }
  }
}

TEST_CASE("registers that nobody knows are an error of usage") {
  const ProgramEnd outcome = run_with("avx3", {"solve", slipproof::test::city_bicycle});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.find("SLIPPROOF_REGISTERS: found \"avx3\", expected sse2, avx2 or avx512") != std::string::npos);
}
