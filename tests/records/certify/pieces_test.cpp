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

/// The lines that certify(sink) writes, then its summary or its error.
template <class Certify>
std::string outcome(const Certify& certify) {
  std::string text;
  try {
    text += to_json(certify([&](std::string_view lines) { text += lines; }));
  } catch (const InputError& error) {
    text += error.what();
  }
  return text;
}

std::string whole(const CertifyOptions& options) {
  std::ifstream input(options.file, std::ios::binary);
  return outcome([&](const LineSink& sink) { return certify(input, sink, options); });
}

std::string in_pieces(const CertifyOptions& options, int ranks) {
  return outcome([&](const LineSink& sink) {
    const RecordPieces pieces(options);
    CertifySummary summary;
    by_crew(
        ranks, [&](std::string_view request) { return pieces.answer(request); },
        [&](Crew& crew) { summary = pieces.certify(crew, sink); });
    return summary;
  });
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
  REQUIRE(whole(options).size() > 1'000'000);
  for (const int ranks : {1, 2, 3}) CHECK(in_pieces(options, ranks) == whole(options));
  options.first_record = 7'000;
  CHECK(in_pieces(options, 2) == whole(options));
  options.stop_at_broken = true;
  CHECK(in_pieces(options, 2) == whole(options));
  CHECK(whole(options).find(options.file + ":") != std::string::npos);
  CHECK(RecordPieces(options).input() == RecordPieces(options).input());
}

TEST_CASE("a header is read once, its mistakes are told once, and a line beyond the limit ends the work") {
  const TemporaryFolder folder;
  CertifyOptions options;
  const std::string header = "\nR,h,b,M2,M3,L,f,g,F,mode,a,S2,S3,N2,N3\n", row = "1,1,1,1,1,1,1,10,2,,0,0,0,5,5\n",
                    line = R"({"M":[[2]],"q":[-1],"z":["1/2"]})"
                           "\n",
                    too_long = line + line + std::string(max_record_line + (1U << 19U), ' ') + "\n" + line;
  for (const std::string& text :
       {header, header + row, header + row + row + "\n1,2\n" + row, "x,y\n1,2\n" + row, too_long}) {
    options.file = folder.write("records", text).string();
    CHECK(in_pieces(options, 2) == whole(options));
  }
}
