#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/run_program.hpp"

using slipproof::test::ProgramEnd;
using slipproof::test::read_file;
using slipproof::test::run;
using slipproof::test::TemporaryFolder;

namespace {

const std::string scene = SLIPPROOF_SOURCE_DIR "/cases/ambiguous.toml";

/// Answers right and wrong, more than a piece of them.
std::filesystem::path records(const TemporaryFolder& folder) {
  std::string text = "F,a,S2,S3,N2,N3\n";
  for (int i = 0; i < 7'000; ++i) {
    text += i % 3 == 0 ? "3.2,3,3.05,-0.05,9.75,0.06000000000000000000\n" : "3.2,3,3.05,-0.05,9.75,no number at all\n";
  }
  return folder.write("records.csv", text + std::string(1 << 18, '\n') + "3.2,3,3.05,-0.05,9.75,0.06\n");
}

struct Joined {
  TemporaryFolder folder;
  std::vector<std::string> certify{"certify", records(folder).string(), "--scene", scene};
  std::string prefix = (folder.path() / "out").string();

  ProgramEnd certified(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = certify;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
};

}  // namespace

TEST_CASE("join prints what certify would have printed, and ends as that") {
  const Joined test;
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--json"}}) {
    std::vector<std::string> with_parts{"--parts", test.prefix};
    with_parts.insert(with_parts.end(), more.begin(), more.end());
    const ProgramEnd expected = test.certified(more), parts = test.certified(with_parts);
    REQUIRE(expected.exit_code == 1);
    CHECK(parts.exit_code == 1);
    CHECK(parts.err == expected.err);
    CHECK(expected.out.ends_with(parts.out));
    CHECK(parts.out.size() < 300);
    const ProgramEnd joined = run({"join", test.prefix});
    CHECK(joined.exit_code == 1);
    CHECK(joined.out == expected.out);
    CHECK(joined.err == expected.err);
    const auto file = test.folder.path() / "joined";
    const ProgramEnd written = run({"join", test.prefix, "-o", file.string()});
    CHECK(written.exit_code == 1);
    CHECK(written.out.empty());
    CHECK(read_file(file) == expected.out);
  }
}

TEST_CASE("join writes nothing of parts that are not all there") {
  const Joined test;
  // One thread fills a part in order.
  const std::vector<std::string> in_order{"--parts", test.prefix, "--threads", "1"};
  REQUIRE(test.certified(in_order).exit_code == 1);
  const std::string index = test.prefix + ".index", part = test.prefix + ".0.1", whole = read_file(part);
  CHECK(run({"join", test.prefix, "-o", part}).exit_code == 3);
  CHECK(read_file(part) == whole);
  const auto file = test.folder.write("joined", "older");
  std::ofstream(part, std::ios::binary | std::ios::in | std::ios::ate).seekp(100'000) << "?";
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"-o", file.string()}}) {
    std::vector<std::string> join{"join", test.prefix};
    join.insert(join.end(), more.begin(), more.end());
    const ProgramEnd outcome = run(join);
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with(part + ": found other bytes than were written"));
  }
  CHECK(read_file(file) == "older");
  std::filesystem::remove(part);
  CHECK(run({"join", test.prefix}).err.starts_with(part + ": cannot be read"));
  REQUIRE(test.certified(in_order).exit_code == 1);
  CHECK(read_file(part) == whole);
  CHECK(run({"join", test.prefix}).exit_code == 1);
  std::filesystem::remove(index);
  CHECK(run({"join", test.prefix}).err.starts_with(index + ": cannot be read"));
}

TEST_CASE("parts are refused where there are no lines to share out") {
  const Joined test;
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--quiet"}, {"--checkpoint", test.prefix + ".checkpoint"}}) {
    std::vector<std::string> arguments{"--parts", test.prefix};
    arguments.insert(arguments.end(), more.begin(), more.end());
    CHECK(test.certified(arguments).exit_code == 2);
  }
  CHECK(run({"certify", "-", "--scene", scene, "--parts", test.prefix}).exit_code == 2);
  CHECK(test.certified({"--parts", (test.folder.path() / "none" / "out").string()}).exit_code == 6);
  CHECK_FALSE(std::filesystem::exists(test.prefix + ".index"));
}
