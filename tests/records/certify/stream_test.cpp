// Records as they come: through a pipe that stays open, and with the words that Python's json writes.
#include <doctest/doctest.h>
#include <unistd.h>

#include <array>
#include <mutex>
#include <thread>

#include "support/certified.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

const std::string half_answer = R"({"M":[[2]],"q":[-1],"z":["1/2"]})";

CertifyOptions json_lines() {
  CertifyOptions options;
  options.format = RecordFormat::json_lines;
  return options;
}

/// What certify says of one contact problem.
nlohmann::json judged_line(const std::string& line) {
  return certified(line + "\n", json_lines()).lines().at(0);
}

}  // namespace

TEST_CASE("each line of a source that is kept open is answered before the next one is there") {
  for (const unsigned threads : {1U, 3U}) {
    CAPTURE(threads);
    std::array<int, 2> questions{}, answers{};
    REQUIRE(::pipe(questions.data()) == 0);
    REQUIRE(::pipe(answers.data()) == 0);
    CertifyOptions options;
    options.threads = threads;
    CertifySummary summary;
    std::thread certifier([&] {
      const ByteSource source = [&](char* buffer, std::size_t size) {
        const ssize_t count = ::read(questions[0], buffer, size);
        return static_cast<std::size_t>(std::max<ssize_t>(count, 0));
      };
      summary = certify(
          source, [&](std::string_view lines) { (void)!::write(answers[1], lines.data(), lines.size()); }, options);
    });
    for (int record = 1; record <= 5; ++record) {
      // A line may come in two pieces.
      const std::string line = half_answer + "\n";
      REQUIRE(::write(questions[1], line.data(), 7) == 7);
      REQUIRE(::write(questions[1], line.data() + 7, line.size() - 7) == static_cast<ssize_t>(line.size() - 7));
      std::array<char, 4096> buffer{};
      const ssize_t count = ::read(answers[0], buffer.data(), buffer.size());  // waits for ever if nobody answers
      REQUIRE(count > 0);
      CHECK(std::string_view(buffer.data(), static_cast<std::size_t>(count))
                .starts_with("{\"record\":" + std::to_string(record) + ",\"verdict\":\"certified\""));
    }
    ::close(questions[1]);
    certifier.join();
    CHECK(summary.records == 5);
    for (const int end : {questions[0], answers[0], answers[1]}) ::close(end);
  }
}

TEST_CASE("the first byte tells JSON Lines from CSV") {
  CHECK(certified(half_answer).lines().at(0)["verdict"] == "certified");
  CHECK(certified("\n \n\xEF\xBB\xBF" + half_answer + "\n" + half_answer).summary.records == 2);
  CHECK_THROWS_AS(certified(""), InputError);
  CHECK_THROWS_AS(certified("M,q,z\n"), InputError);
}

TEST_CASE("NaN and infinities as Python writes them are invalid answers, with line and column") {
  const std::string scene = R"({"R":1,"h":1,"b":1,"M2":1,"M3":1,"L":1,"f":1,"g":10,"F":2,"S2":0,"S3":0,"N2":5,"N3":5,)";
  for (const auto& [line, word] : std::vector<std::pair<std::string, std::string>>{
           {scene + R"("a": NaN})", "NaN"},
           {scene + R"("a": Infinity})", "Infinity"},
           {scene + R"("a":-Infinity})", "-Infinity"},
           {R"({"M":[[2]],"q":[-1],"z":[NaN]})", "NaN"},
           {R"({"M":[[2]],"q":[-1],"z":[ -Infinity ]})", "-Infinity"},
           {R"({"M":[[2]],"q":[-1],"z":[0],"w":[Infinity]})", "Infinity"}}) {
    CAPTURE(line);
    const Certified found = certified("\n" + half_answer + "\n" + line + "\n", json_lines());
    CHECK(found.summary.broken == 0);
    CHECK(found.summary.count(RecordVerdict::invalid) == 1);
    const auto judgement = found.lines().at(1);
    CHECK(judgement["verdict"] == "invalid");
    const std::string reason = judgement["reason"];
    CAPTURE(reason);
    CHECK(reason.starts_with("line 3, column " + std::to_string(line.find(word) + 1) + ": "));
    CHECK(reason.ends_with("expected a finite number"));
  }
  CertifyOptions csv;
  csv.format = RecordFormat::csv;
  const auto cell =
      certified("R,h,b,M2,M3,L,f,g,F,a,S2,S3,N2,N3\n1,1,1,1,1,1,1,10,2,1,NaN,0,5,nan\n", csv).lines().at(0);
  CHECK(cell["reason"] == "line 2, column 22: S2: found NaN, expected a finite number");
}

TEST_CASE("the words are words only outside of texts, and no keys; what is no JSON is broken in its place") {
  CertifyOptions lenient = json_lines();
  lenient.ignore_unknown = true;
  const std::string noted = R"({"M":[[2]],"q":[-1],"z":["1/2"],"note":"NaN \" -Infinity"})";
  CHECK(certified(noted + "\n", lenient).lines().at(0)["verdict"] == "certified");
  CHECK(judged_line(R"({"M":[[2]],"q":[-1],"z":[NaN)")["reason"].get<std::string>().starts_with("line 1, column 29: "));
  CHECK(judged_line(R"({"q":[-1],NaN:1})")["reason"] == "line 1, column 11: found NaN, expected a key");
  CHECK(judged_line(R"({"M":[[NaN]],"q":[-1],"z":[0]})")["reason"] ==
        "line 1, column 8: M[1][1]: found NaN, expected a finite number within binary64's range");
  CHECK(judged_line(R"({"M":[[1]],"q":[-1],"z":[nan]})")["verdict"] == "invalid");
}
