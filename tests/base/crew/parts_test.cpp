// What stands in parts is put together again, or it is told which part is not as it was written.
#include "base/crew/parts.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "base/output/output_error.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

std::string joined(const std::string& prefix, const PartsEnd& end) {
  std::string text;
  read_parts(prefix, end, [&](std::string_view bytes) { text += bytes; });
  return text;
}

/// Three ranges in two parts, in an order that is not that of writing.
PartsEnd some_parts(const std::string& prefix) {
  PartWriter first(prefix, 0), second(prefix, 7);
  PartsEnd end{.out = "the end\n", .exit_code = 1};
  end.ranges = {second.add("one "), first.add("two "), second.add("three ")};
  return end;
}

std::string error_of(const std::string& prefix, const PartsEnd& end) {
  try {
    joined(prefix, end);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("ranges stand where they say, in their own order") {
  const TemporaryFolder folder;
  const std::string prefix = (folder.path() / "out").string();
  const PartsEnd end = some_parts(prefix);
  CHECK(joined(prefix, end) == "one two three ");
  CHECK(read_file(prefix + ".0.1") == "two ");
  CHECK(read_file(prefix + ".7.1") == "one three ");
  for (const PartRange& range : end.ranges) {
    CHECK(PartSizes(prefix).hold(range));
    CHECK(PartRange::from_bytes(range.to_bytes()).to_bytes() == range.to_bytes());
  }
  CHECK_FALSE(PartSizes(prefix + "other").hold(end.ranges[0]));
  CHECK_FALSE(PartSizes((folder.path() / "none" / "out").string()).hold(end.ranges[0]));
}

TEST_CASE("threads share a part, and a later run makes one of its own") {
  const TemporaryFolder folder;
  const std::string prefix = (folder.path() / "out").string();
  PartsEnd end;
  end.ranges.resize(400);
  {
    PartWriter part(prefix, 3);
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < 4; ++t) {
      threads.emplace_back([&, t] {
        for (std::size_t i = t; i < end.ranges.size(); i += 4) end.ranges[i] = part.add(std::to_string(i) + ' ');
      });
    }
  }
  std::string expected;
  for (std::size_t i = 0; i < end.ranges.size(); ++i) expected += std::to_string(i) + ' ';
  CHECK(PartWriter(prefix, 3).add("later").part == ".3.2");
  CHECK(joined(prefix, end) == expected);
  CHECK_THROWS_AS(PartWriter((folder.path() / "none" / "out").string(), 0).add("x"), OutputError);
}

TEST_CASE("no changed byte of a part goes unnoticed, and each part that is not right is named") {
  const TemporaryFolder folder;
  const std::string prefix = (folder.path() / "out").string();
  const PartsEnd end = some_parts(prefix);
  const std::string whole = read_file(prefix + ".7.1");
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    folder.write("out.7.1", changed);
    CHECK(error_of(prefix, end).find(prefix + ".7.1: found other bytes") == 0);
  }
  folder.write("out.7.1", whole.substr(0, whole.size() - 2));
  CHECK(error_of(prefix, end).find(prefix + ".7.1: found 2 bytes fewer, expected 6 bytes") == 0);
  CHECK_FALSE(PartSizes(prefix).hold(end.ranges[2]));
  CHECK(PartSizes(prefix).hold(end.ranges[0]));
  folder.write("out.7.1", whole + "what a killed run was writing");
  CHECK(joined(prefix, end) == "one two three ");
  std::filesystem::rename(prefix + ".7.1", prefix + ".0.1");
  const std::string error = error_of(prefix, end);
  CHECK(error.find(prefix + ".0.1: found other bytes") != std::string::npos);
  CHECK(error.find(prefix + ".7.1: cannot be read") != std::string::npos);
}

TEST_CASE("the index has the end of a run, once there is one") {
  const TemporaryFolder folder;
  const std::string prefix = (folder.path() / "out").string();
  CHECK_THROWS_WITH_AS(read_end(prefix), doctest::Contains("out.index: cannot be read"), InputError);
  {
    Journal index(parts_index(prefix), "work");
    index.keep("request", "result");
    CHECK_THROWS_WITH_AS(read_end(prefix), doctest::Contains("found a run that is still writing it"), InputError);
  }
  CHECK_THROWS_WITH_AS(read_end(prefix), doctest::Contains("found an unfinished run"), InputError);
  const PartsEnd end = some_parts(prefix);
  {
    Journal index(parts_index(prefix), "work");
    keep_end(index, end);
  }
  const PartsEnd found = read_end(prefix);
  CHECK(joined(prefix, found) == "one two three ");
  CHECK(found.out == end.out);
  CHECK(found.exit_code == 1);
  const std::string whole = read_file(prefix + ".index");
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (i >= 28 && i < 32) continue;  // what the work was counts for who goes on, not here
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    folder.write("out.index", changed);
    CAPTURE(i);
    CHECK_THROWS_AS(read_end(prefix), InputError);
    folder.write("out.index", whole.substr(0, i));
    CHECK_THROWS_AS(read_end(prefix), InputError);
  }
}
