// A file that many ranks certify in pieces: the lines of one.
#include "records/certify/pieces.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <memory>
#include <string>

#include "base/input/diagnostic.hpp"
#include "support/certified.hpp"
#include "support/crew_ranks.hpp"
#include "support/run_program.hpp"

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

FoundInPieces in_pieces(const CertifyOptions& options, int ranks) {
  FoundInPieces found;
  const auto pieces = std::make_unique<RecordPieces>(options);
  by_crew(
      ranks, [&](std::string_view request) { return pieces->answer(request); },
      [&](Crew& crew) {
        try {
          found.summary = to_json(pieces->certify(crew, [&](std::string_view lines) { found.text += lines; }));
        } catch (const InputError& error) {
          found.error = error.what();
        }
      });
  return found;
}

void check_same(const FoundInPieces& x, const FoundInPieces& y) {
  CHECK(x.text == y.text);
  CHECK(x.summary == y.summary);
  CHECK(x.error == y.error);
}

/// Answers of one unknown, right and wrong, with blank lines, both ends of lines, and records that cannot be read: some
/// pieces of them.
std::string problem_lines() {
  std::string text = "\n";
  for (int i = 1; i <= 12'000; ++i) {
    text += R"({"M":[[2]],"q":[-)" + std::to_string(i) + R"(],"z":[")" + std::to_string(i % 5 == 0 ? i + 1 : i) +
            R"(/2"]})" + (i % 7 == 0 ? "\r\n\n" : "\n");
    if (i % 17 == 0) text += "no record " + std::to_string(i) + std::string(i % 3 == 0 ? 400 : 0, '.') + "\n";
  }
  return text + R"({"M":[[2]],"q":[-1],"z":[0]})";  // without an end
}

}  // namespace

TEST_CASE("records in pieces are judged as from one stream") {
  const TemporaryFolder folder;
  CertifyOptions options;
  options.file = folder.write("problems.jsonl", problem_lines()).string();
  const FoundInPieces expected = whole(options);
  REQUIRE(expected.text.size() > 1'000'000);
  for (const int ranks : {1, 2, 3}) check_same(in_pieces(options, ranks), expected);
  options.first_record = 7'000;
  check_same(in_pieces(options, 2), whole(options));
  options.stop_at_broken = true;
  check_same(in_pieces(options, 2), whole(options));
  CHECK_FALSE(whole(options).error.empty());
  CHECK(RecordPieces(options).input() == RecordPieces(options).input());
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
      check_same(in_pieces(options, 2), expected);
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
  const FoundInPieces found = in_pieces(options, 2);
  CHECK(found.error == expected.error);
  CHECK(found.text == expected.text);
}
