#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "support/run_program.hpp"

using slipproof::test::last_line;
using slipproof::test::ProgramEnd;
using slipproof::test::read_file;
using slipproof::test::run;
using slipproof::test::TemporaryFolder;
using Json = nlohmann::json;

namespace {

// M = R = h = b = 1, I2 = I3 = 1, I1 = 0, mu = 1, L = 1, g = 10, f = 1, without J. At F = 2: a = 1/2, stick/stick.
const std::string scene_text = R"([bicycle]
R = "1"
h = "1"
b = "1"
M2 = "1"
M3 = "1"
[road]
f = "1"
g = "10"
[force]
kind = "internal"
)";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// A scene, and answers to it as the program itself finds them.
class Bench {
 public:
  Bench() : scene(folder.write("scene.toml", scene_text)) {}

  /// `count` correct answers, with forces 1, 2, ...
  std::string answers(int count) const {
    std::string text = "F,mode,a,S2,S3,N2,N3\n";
    for (int i = 1; i <= count; ++i) text += answer(std::to_string(i));
    return text;
  }
  std::string answer(const std::string& F) const {
    const auto file = folder.write("at.toml", scene_text + "F = \"" + F + "\"\n");
    const ProgramEnd solved = run({"solve", "--json", file});
    REQUIRE(solved.exit_code == 0);
    const Json motion = Json::parse(solved.out)["motions"].at(0);
    const Json& modes = motion["modes"].empty() ? motion["boundary_modes"] : motion["modes"];
    std::string line = F + "," + modes[0].get<std::string>() + "," + motion["accelerations"]["a"].get<std::string>();
    for (const char* force : {"S2", "S3", "N2", "N3"}) line += "," + motion["forces"][force].get<std::string>();
    return line + "\n";
  }
  ProgramEnd certify(const std::string& records, std::vector<std::string> more = {},
                     const std::string& name = "records.csv") const {
    more.insert(more.begin(), {"certify", "--scene", scene, folder.write(name, records)});
    return run(more);
  }

  TemporaryFolder folder;
  std::string scene;
};

}  // namespace

TEST_CASE("correct answers exit with 0, a wrong one with 1; every record has its line") {
  const Bench bench;
  const auto right = bench.certify(bench.answers(4));
  CHECK(right.exit_code == 0);
  CHECK(right.err.empty());
  CHECK(last_line(right.out) == "s CERTIFIED 4/4\n");
  const auto lines = lines_of(right.out);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(Json::parse(lines[i])["record"] == i + 1);
    CHECK(Json::parse(lines[i])["verdict"] == "certified");
  }
  const auto wrong = bench.certify(bench.answers(3) + "2,slip+/stick,1/2,3/2,-1,5,5\n");
  CHECK(wrong.exit_code == 1);
  CHECK(last_line(wrong.out) == "s NOT CERTIFIED 3/4\n");
  const Json line = Json::parse(lines_of(wrong.out)[3]);
  CHECK(line["verdict"] == "wrong");
  CHECK(line["claimed"] == "slip+/stick");
  CHECK(line["violated"].is_string());
  CHECK(line["margin"].get<std::string>().starts_with("-"));
  CHECK(line["found"].size() == 1);
}

TEST_CASE("--json keeps standard output to the records, --quiet to the result, --summary writes the counts") {
  const Bench bench;
  const std::string text = bench.answers(3);
  const auto json = bench.certify(text, {"--json"});
  CHECK(json.exit_code == 0);
  CHECK(lines_of(json.out).size() == 3);
  for (const auto& line : lines_of(json.out)) CHECK(Json::parse(line)["verdict"] == "certified");
  CHECK(last_line(json.err) == "s CERTIFIED 3/3\n");
  const auto quiet = bench.certify(text, {"--quiet"});
  CHECK(quiet.out.find('{') == std::string::npos);
  CHECK(last_line(quiet.out) == "s CERTIFIED 3/3\n");
  const auto both = bench.certify(text, {"--quiet", "--json"});
  CHECK(both.exit_code == 0);
  CHECK(both.out.empty());
  CHECK(both.err.empty());

  const std::string summary = (bench.folder.path() / "summary.json").string();
  CHECK(bench.certify(text + "9,,1,1,1,1,1\n", {"--summary", summary}).exit_code == 1);
  const Json counts = Json::parse(read_file(summary));
  CHECK(counts["schema"] == "slipproof/certify/1");
  CHECK(counts["records"] == 4);
  CHECK(counts["verdicts"]["certified"] == 3);
  CHECK(counts["verdicts"]["wrong"] == 1);
  CHECK(counts["broken"] == 0);
  const auto unwritable = bench.certify(text, {"--summary", summary + "/below-a-file.json"});
  CHECK(unwritable.exit_code == 6);
  CHECK(unwritable.out.empty());
  CHECK(unwritable.err.find("/below-a-file.json: cannot be written") != std::string::npos);
}

TEST_CASE("a run goes on where another stopped, at any number of threads the same bytes") {
  const Bench bench;
  std::string text = bench.answers(4), body = text.substr(text.find('\n') + 1);
  for (int i = 0; i < 300; ++i) text += body;
  const auto all = bench.certify(text, {"--json", "--threads", "1"});
  CHECK(bench.certify(text, {"--json", "--threads", "4"}).out == all.out);
  const auto rest = bench.certify(text, {"--json", "--from", "1001"});
  CHECK(rest.exit_code == 0);
  CHECK(lines_of(rest.out).size() == lines_of(all.out).size() - 1000);
  CHECK(all.out.ends_with(rest.out));
  CHECK(rest.out.starts_with("{\"record\":1001,"));
  // Nothing left to judge is nothing certified.
  const auto nothing = bench.certify(text, {"--from", "100000"});
  CHECK(nothing.exit_code == 4);
  CHECK(last_line(nothing.out) == "s NOT CERTIFIED 0/0\n");
}

TEST_CASE("tolerance and the meaning of decimals can be chosen") {
  const Bench bench;
  const std::string off = "F,a,S2,S3,N2,N3\n" + [&] {
    const auto cells = bench.answer("2");
    return "2" + cells.substr(cells.find(',', 2));
  }();
  CHECK(bench.certify(off).exit_code == 0);
  // F = 2 + 1e-6 moves the motion, and the answer with it, by about that much.
  const std::string moved = off.substr(0, off.find('\n') + 1) + "2.000001" + off.substr(off.find('\n') + 2);
  CHECK(bench.certify(moved).exit_code == 1);
  CHECK(bench.certify(moved, {"--tolerance", "1e-4"}).exit_code == 0);
  const auto rounded = bench.certify(off + "0.2,0,0,0,0,0\n", {"--json"});
  const auto exactly = bench.certify(off + "0.2,0,0,0,0,0\n", {"--json", "--decimal", "exact"});
  const auto a = [](const ProgramEnd& o) {
    return Json::parse(lines_of(o.out)[1])["found"][0]["accelerations"]["a"].get<std::string>();
  };
  CHECK(a(exactly).size() < 10);
  CHECK(a(rounded).size() > 20);
}

TEST_CASE("standard input and JSON Lines are read like files and CSV") {
  const Bench bench;
  const std::string csv = bench.answers(3);
  const auto expected = bench.certify(csv);
  CHECK(run({"certify", "--scene", bench.scene, "-"}, "slipproof", csv).out == expected.out);
  std::string json;
  for (const std::string& line : lines_of(csv.substr(csv.find('\n') + 1))) {
    std::istringstream cells(line);
    Json record;
    for (const char* key : {"F", "mode", "a", "S2", "S3", "N2", "N3"}) {
      std::string cell;
      std::getline(cells, cell, ',');
      record[key] = cell;
    }
    json += record.dump() + "\n";
  }
  CHECK(bench.certify(json, {}, "records.jsonl").out == expected.out);
  CHECK(run({"certify", "--scene", bench.scene, "--format", "jsonl", "-"}, "slipproof", json).out == expected.out);
  CHECK(run({"certify", "--scene", bench.scene, "-"}, "slipproof", json).out == expected.out);
}

TEST_CASE("records that cannot be read are reported with place, found and expected, or end the run") {
  const Bench bench;
  const std::vector<std::pair<std::string, std::string>> rows{
      {"x,,1,1,1,1,1", "line 5, column 1: F: found 'x', expected a digit"},
      {"1,,1,1,1,1", "line 5, column 10: found fewer cells, expected 7 as in the header"},
      {"1,,1,1,1,1,1,1", "line 5, column 12: found more cells, expected 7 as in the header"},
      {"1,stick/stuck,1,1,1,1,1", "line 5, column 3: found the mode 'stick/stuck', expected one like stick/slip+"},
      {"1,,1,,1,1,1", "line 5, column 1: missing S2"},
      {"1,,1,1,1,1,1/0", "line 5, column 14: N3: found a zero denominator, expected a denominator other than 0"},
      {"1,,1,1,1,1,0x", "line 5, column 14: N3: found"},
      {"1,,1,1,1,1,1e", "N3: found"},
      {"\"1,,1,1,1,1,1", "line 5, column 1: F: found"},
      {"1,,1,1,1,1,1 2", "N3: found"}};
  const std::string good = bench.answers(3);
  for (const auto& broken : rows) {
    const auto& [row, message] = broken;
    CAPTURE(broken.first);
    const std::string text = good + row + "\n" + bench.answer("2");
    const auto reported = bench.certify(text);
    CHECK(reported.exit_code == 1);
    CHECK(last_line(reported.out) == "s NOT CERTIFIED 4/5\n");
    const Json line = Json::parse(lines_of(reported.out)[3]);
    CHECK(line["verdict"] == "invalid");
    const std::string reason = line["reason"];
    CAPTURE(reason);
    CHECK(reason.find(message) != std::string::npos);

    const auto stopped = bench.certify(text, {"--broken", "stop"});
    CAPTURE(stopped.err);
    CHECK(stopped.exit_code == 3);
    CHECK(lines_of(stopped.out).size() == 3);  // what was judged before is written
    CHECK(stopped.out.find("invalid") == std::string::npos);
    CHECK(stopped.err.find("records.csv:5:") != std::string::npos);
  }
  // Values that are no numbers, or outside the domain, are read, and invalid: they do not stop a run.
  for (const char* row : {"1,,nan,1,1,1,1", "1,,1,-inf,1,1,1", "inf,,1,1,1,1,1", "1e99999,,1,1,1,1,1"}) {
    const auto outcome = bench.certify(good + row + "\n", {"--broken", "stop"});
    CHECK(outcome.exit_code == 1);
    CHECK(Json::parse(lines_of(outcome.out)[3])["verdict"] == "invalid");
  }
}

TEST_CASE("headers, files and scenes that cannot be used exit with 3, all mistakes at once") {
  const Bench bench;
  const auto header = bench.certify("F,foo,F,a,mode,mode\n");
  CHECK(header.exit_code == 3);
  CHECK(header.out.empty());
  for (const char* message : {"records.csv:1:3: found the column 'foo'", "records.csv:1:7: found the column 'F' twice",
                              "records.csv:1:16: found the column 'mode' twice", "missing S2, S3, N2, N3"}) {
    CAPTURE(message);
    CHECK(header.err.find(message) != std::string::npos);
  }
  CHECK(bench.certify("F,foo,mode,a,S2,S3,N2,N3\n" + std::string(), {"--ignore-unknown"}).exit_code == 4);
  CHECK(bench.certify("").exit_code == 3);
  CHECK(run({"certify", "--scene", bench.scene, "/nonexistent.csv"}).exit_code == 3);
  CHECK(run({"certify", "--scene", bench.scene, bench.folder.path()}).exit_code == 3);
  CHECK(run({"certify", "--scene", "/nonexistent.toml", "-"}).exit_code == 3);
  const auto long_line = bench.certify(bench.answers(1) + std::string(9U << 20U, '1') + "\n");
  CHECK(long_line.exit_code == 3);
  CHECK(long_line.err.find("expected a record") != std::string::npos);
}

TEST_CASE("usage errors of certify exit with 2") {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"certify"},
                                             {"certify", "a", "b"},
                                             {"certify", "--tolerance", "-1", "-"},
                                             {"certify", "--tolerance", "nan", "-"},
                                             {"certify", "--tolerance", "2", "-"},
                                             {"certify", "--decimal", "maybe", "-"},
                                             {"certify", "--format", "xml", "-"},
                                             {"certify", "--broken", "ignore", "-"},
                                             {"certify", "--from", "0", "-"},
                                             {"certify", "--threads", "-1", "-"},
                                             {"certify", "--frobnicate", "-"}}) {
    const auto outcome = run(arguments);
    CAPTURE(arguments.back());
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK_FALSE(outcome.err.empty());
  }
}

TEST_CASE("contact problems need no scene; their exit codes are those of scenes, 4 for what is undecided alone") {
  const TemporaryFolder folder;
  const auto certify = [&](const std::string& text) { return run({"certify", folder.write("problems.jsonl", text)}); };
  const std::string right = R"({"M":[[2,1],[1,2]],"q":[-5,-6],"z":["4/3","7/3"]})"
                            "\n";
  // 20 contacts are too many to try: z = (1, 0, ...) is one solution.
  Json many{{"M", Json::array()}, {"q", Json::array()}, {"z", Json::array()}};
  for (int i = 0; i < 20; ++i) {
    Json row = Json::array();
    for (int j = 0; j < 20; ++j) row.push_back(j <= i ? 1 : 3);
    many["M"].push_back(row);
    many["q"].push_back(-1);
    many["z"].push_back(i == 0 ? 1 : 0);
  }
  const std::string undecided = many.dump() + "\n";
  CHECK(certify(right).exit_code == 0);
  CHECK(last_line(certify(right + right).out) == "s CERTIFIED 2/2\n");
  const auto mixed = certify(right + undecided);
  CHECK(mixed.exit_code == 4);
  CHECK(mixed.out.find("than the effort of 1500000000 allows") != std::string::npos);
  CHECK(mixed.out.find("1 undecided") != std::string::npos);
  CHECK(certify(undecided + R"({"M":[[2]],"q":[-1],"z":[1]})" + "\n").exit_code == 1);
  const auto shipped = run({"certify", SLIPPROOF_SOURCE_DIR "/cases/contact-problems/examples.jsonl"});
  CHECK(shipped.exit_code == 1);
  CHECK(last_line(shipped.out) == "s NOT CERTIFIED 3/10\n");
}

TEST_CASE("standard input is answered line by line, and its format is known by its first byte") {
  const TemporaryFolder folder;
  const std::string questions = (folder.path() / "questions").string(), answers = (folder.path() / "answers").string();
  // The second question is asked only when the first has been answered; the pipe stays open all the time.
  const std::string script = "cd " + slipproof::test::quoted(folder.path().string()) + R"( && mkfifo questions answers
    timeout 60 )" + slipproof::test::quoted(SLIPPROOF_BINARY_DIR "/slipproof") +
                             R"( certify --json - <questions >answers 2>/dev/null &
    exec 3>questions 4<answers
    for record in 1 2 3; do
      echo '{"M":[[2]],"q":[-1],"z":["1/2"]}' >&3
      read -r line <&4 && echo "$line" >>log
    done
    exec 3>&-
    wait $!)";
  CHECK(std::system(script.c_str()) == 0);
  const auto lines = lines_of(read_file(folder.path() / "log"));
  REQUIRE(lines.size() == 3);
  for (const auto& line : lines) CHECK(Json::parse(line)["verdict"] == "certified");
}
