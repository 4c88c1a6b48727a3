// A file that many ranks certify in pieces: the lines of one, wherever the pieces are cut.
#include "records/certify/pieces.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/input/diagnostic.hpp"
#include "support/certified.hpp"
#include "support/run_program.hpp"
#include "support/thread_ranks.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

struct FoundInPieces {
  std::string text, summary, error;
};

FoundInPieces whole(const CertifyOptions& options) {
  FoundInPieces found;
  std::ifstream input(options.file, std::ios::binary);
  try {
    found.summary = to_json(certify(
        input, [&](std::string_view lines) { found.text += lines; }, options));
  } catch (const InputError& error) {
    found.error = error.what();
  }
  return found;
}

/// The same, put together from parts.
FoundInPieces in_parts(const CertifyOptions& options, std::uint64_t size, int ranks, Journal& index,
                       const std::string& prefix) {
  FoundInPieces found;
  ThreadRanks all(ranks);
  PartsEnd end;
  all.run(
      [&](Transport& transport) {
        const RecordPieces pieces(options, size);
        PartWriter part(prefix, 0);
        CrewOptions crew_options{.threads = 1, .journal = &index};
        crew_options.still_counts = [parts = PartSizes(prefix)](std::string_view request, std::string_view result) {
          return RecordPieces::stands(request, result, parts);
        };
        Crew crew(transport, crew_options, [&](std::string_view request) { return pieces.answer(request, &part); });
        found.summary = to_json(
            pieces.certify(crew, [&](std::string_view range) { end.ranges.push_back(PartRange::from_bytes(range)); }));
      },
      [&](Transport& transport) {
        const RecordPieces pieces(options, size);
        PartWriter part(prefix, transport.rank());
        Crew(transport, {.threads = 1}, [&](std::string_view request) {
          return pieces.answer(request, &part);
        }).serve();
      });
  read_parts(prefix, end, [&](std::string_view lines) { found.text += lines; });
  return found;
}

FoundInPieces in_pieces(const CertifyOptions& options, std::uint64_t size, int ranks, Journal* journal = nullptr) {
  FoundInPieces found;
  ThreadRanks all(ranks);
  all.run(
      [&](Transport& transport) {
        try {
          const RecordPieces pieces(options, size);
          Crew crew(transport, {.threads = 1, .journal = journal},
                    [&](std::string_view request) { return pieces.answer(request); });
          found.summary = to_json(pieces.certify(crew, [&](std::string_view lines) { found.text += lines; }));
        } catch (const InputError& error) {
          found.error = error.what();
        }
      },
      [&](Transport& transport) {
        const RecordPieces pieces(options, size);
        Crew(transport, {.threads = 1}, [&](std::string_view request) { return pieces.answer(request); }).serve();
      });
  return found;
}

void check_same(const FoundInPieces& x, const FoundInPieces& y) {
  CHECK(x.text == y.text);
  CHECK(x.summary == y.summary);
  CHECK(x.error == y.error);
}

/// Answers of one unknown, right and wrong, with blank lines, both ends of lines, and records that cannot be read.
std::string problem_lines() {
  std::string text = "\n";
  for (int i = 1; i <= 60; ++i) {
    text += R"({"M":[[2]],"q":[-)" + std::to_string(i) + R"(],"z":[")" + std::to_string(i % 5 == 0 ? i + 1 : i) +
            R"(/2"]})" + (i % 7 == 0 ? "\r\n\n" : "\n");
    if (i % 17 == 0) text += "no record " + std::to_string(i) + "\n";
  }
  return text + R"({"M":[[2]],"q":[-1],"z":[0]})";  // without an end
}

}  // namespace

TEST_CASE("lines in parts are the lines of one stream, and those of a lost part are judged again") {
  const TemporaryFolder folder;
  CertifyOptions options;
  options.file = folder.write("problems.jsonl", problem_lines()).string();
  const FoundInPieces expected = whole(options);
  const std::string prefix = (folder.path() / "out").string();
  Journal index(parts_index(prefix), "work");
  check_same(in_parts(options, 70, 3, index, prefix), expected);
  const auto kept = index.size();
  check_same(in_parts(options, 70, 2, index, prefix), expected);
  CHECK_FALSE(std::filesystem::exists(prefix + ".0.2"));  // nothing was asked again
  int lost = 0;
  for (const char* part : {".0.1", ".1.1", ".2.1"}) lost += std::filesystem::remove(prefix + part) ? 1 : 0;
  CHECK(lost > 0);
  check_same(in_parts(options, 70, 4, index, prefix), expected);
  CHECK(index.size() == kept);
}

TEST_CASE("records in pieces of any size are judged as from one stream") {
  const TemporaryFolder folder;
  CertifyOptions options;
  options.file = folder.write("problems.jsonl", problem_lines()).string();
  const FoundInPieces expected = whole(options);
  REQUIRE(expected.text.size() > 1000);
  for (const std::uint64_t size : {1U, 7U, 33U, 34U, 35U, 500U, 100'000U}) {
    CAPTURE(size);
    check_same(in_pieces(options, size, 1), expected);
  }
  for (const int ranks : {2, 3, 8}) check_same(in_pieces(options, 100, ranks), expected);
  options.first_record = 23;
  check_same(in_pieces(options, 100, 2), whole(options));
  options.stop_at_broken = true;
  check_same(in_pieces(options, 100, 2), whole(options));
  CHECK_FALSE(whole(options).error.empty());
}

TEST_CASE("a header is read once, and its mistakes are told once") {
  const TemporaryFolder folder;
  CertifyOptions options;
  const std::string header = "\nR,h,b,M2,M3,L,f,g,F,mode,a,S2,S3,N2,N3\n", row = "1,1,1,1,1,1,1,10,2,,0,0,0,5,5\n";
  for (const std::string& text : {header, header + row, header + row + row + "\n1,2\n" + row, "x,y\n1,2\n" + row}) {
    CAPTURE(text);
    options.file = folder.write("records.csv", text).string();
    const FoundInPieces expected = whole(options);
    if (expected.error.empty()) {
      check_same(in_pieces(options, 20, 2), expected);
    } else {
      CHECK_THROWS_WITH_AS(RecordPieces{options}, expected.error.c_str(), InputError);
    }
  }
}

TEST_CASE("a line beyond the limit ends the work where it stands") {
  const TemporaryFolder folder;
  CertifyOptions options;
  const std::string line = R"({"M":[[2]],"q":[-1],"z":["1/2"]})"
                           "\n";
  options.file =
      folder.write("long.jsonl", line + line + std::string(max_record_line + (1U << 19U), ' ') + "\n" + line).string();
  const FoundInPieces expected = whole(options);
  REQUIRE_FALSE(expected.error.empty());
  const FoundInPieces found = in_pieces(options, 1U << 16U, 2);
  CHECK(found.error == expected.error);
  CHECK(found.text.starts_with(expected.text));
}

TEST_CASE("what a checkpoint has is not judged again") {
  const TemporaryFolder folder;
  CertifyOptions options;
  options.file = folder.write("problems.jsonl", problem_lines()).string();
  const FoundInPieces expected = whole(options);
  Journal journal(folder.path() / "journal", "work");
  check_same(in_pieces(options, 100, 3, &journal), expected);
  const std::size_t kept = journal.size();
  check_same(in_pieces(options, 100, 2, &journal), expected);
  CHECK(journal.size() == kept);
  CHECK(RecordPieces(options).input() == RecordPieces(options).input());
}
