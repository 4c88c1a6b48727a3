#include <doctest/doctest.h>

#include <filesystem>
#include <functional>
#include <iostream>
#include <new>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "base/input/diagnostic.hpp"
#include "faces/cli/program.hpp"

namespace {

struct Ended {
  int exit_code = 0;
  std::string said;
};

Ended program_in_which(const std::function<void()>& fail) {
  std::ostringstream said;
  std::streambuf* const before = std::cerr.rdbuf(said.rdbuf());
  const int exit_code = slipproof::cli::exit_code_of([&] { return fail(), 0; });
  std::cerr.rdbuf(before);
  return {exit_code, said.str()};
}

}  // namespace

TEST_CASE("a failure of the program is 70, never the 1 of what is refuted, and says what to report") {
  const Ended failed = program_in_which([] { throw std::domain_error("found NaN"); });
  CHECK(failed.exit_code == 70);
  CHECK(failed.said.starts_with("slipproof: the program failed: found NaN\n"));
  CHECK(failed.said.find("Please report this line, the command, its files, and the version, ") != std::string::npos);
  CHECK(program_in_which([] { throw 1; }).exit_code == 70);
  const Ended full = program_in_which([] { throw std::bad_alloc(); });
  CHECK(full.exit_code == 70);
  CHECK(full.said == "slipproof: there is not enough memory\n");
}

TEST_CASE("what the file system refuses is bad input") {
  const Ended refused = program_in_which([] {
    throw std::filesystem::filesystem_error("status", "a/b", std::make_error_code(std::errc::permission_denied));
  });
  CHECK(refused.exit_code == 3);
  CHECK(refused.said == "a/b: cannot be read: Permission denied\n");
}
