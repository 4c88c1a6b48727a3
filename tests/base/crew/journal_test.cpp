// What is kept is found again, by whoever goes on, and nothing else is.
#include "base/crew/journal.hpp"

#include <doctest/doctest.h>

#include <string>

#include "base/input/diagnostic.hpp"
#include "base/output/output_error.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

const std::string request_text = "a request", result_text("a result\0with a zero", 20);

/// A journal with one result, as bytes.
std::string one_result(const TemporaryFolder& folder) {
  const auto path = folder.path() / "one";
  Journal(path, "work").keep(request_text, result_text);
  return read_file(path);
}

}  // namespace

TEST_CASE("results are found in a later run") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "journal";
  {
    Journal journal(path, "work");
    CHECK(journal.size() == 0);
    CHECK_FALSE(journal.find("x"));
    journal.keep("x", "1");
    journal.keep("y", result_text);
    journal.keep("z", "");
    CHECK(journal.find("y") == result_text);
    CHECK_THROWS_AS(Journal(path, "work"), OutputError);  // one run at a time
  }
  CHECK_FALSE(Journal::is_written(path));
  Journal again(path, "work");
  CHECK(Journal::is_written(path));
  CHECK(again.size() == 3);
  CHECK(again.find("x") == "1");
  CHECK(again.find("y") == result_text);
  CHECK(again.find("z") == "");
  Journal reader(path, "work", Journal::Access::read);
  again.keep("w", "4");
  CHECK(again.find("w") == "4");
  CHECK_FALSE(reader.find("w"));
  reader.refresh();
  CHECK(reader.find("w") == "4");
  CHECK(reader.find("x") == "1");
}

TEST_CASE("another file and other work are refused, and stay as they were") {
  const TemporaryFolder folder;
  const auto text = folder.write("text", "F,mode,a\n1,2,3\nand more, so that it is longer than a journal's first line");
  const std::string before = read_file(text);
  CHECK_THROWS_AS(Journal(text, "work"), InputError);
  CHECK(read_file(text) == before);
  const std::string whole = one_result(folder);
  CHECK_THROWS_AS(Journal(folder.path() / "one", "work of another kind"), InputError);
  CHECK_THROWS_AS(Journal(folder.path() / "one", "wor"), InputError);
  CHECK_THROWS_AS(Journal(folder.path() / "one", "wor", Journal::Access::read), InputError);
  CHECK(read_file(folder.path() / "one") == whole);
  CHECK_THROWS_AS(Journal(folder.path(), "work"), OutputError);
  CHECK_THROWS_AS(Journal(folder.path() / "none" / "journal", "work"), OutputError);
}

TEST_CASE("a journal of an earlier version is called that") {
  const TemporaryFolder folder;
  const auto path =
      folder.write("old", "slipproof-journal 1\nof whatever work, and long enough to have a head of its own");
  CHECK_THROWS_WITH_AS(Journal(path, "work"), doctest::Contains("a checkpoint of an earlier version"), InputError);
}

TEST_CASE("whatever a killed run leaves is a journal, without the result that was being written") {
  const TemporaryFolder folder;
  const std::string whole = one_result(folder);
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    CAPTURE(size);
    const auto path = folder.write("cut", whole.substr(0, size));
    Journal journal(path, "work");
    CHECK(journal.size() == (size == whole.size() ? 1 : 0));
    journal.keep("other", "result");
    CHECK(journal.find("other") == "result");
  }
}

TEST_CASE("no changed byte of a result goes unnoticed") {
  const TemporaryFolder folder;
  const std::string whole = one_result(folder);
  for (std::size_t i = whole.find("work") + 4; i < whole.size(); ++i) {
    CAPTURE(i);
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    CHECK(Journal(folder.write("changed", changed), "work").size() == 0);
  }
}
