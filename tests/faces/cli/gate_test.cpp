// What fails a run of `certify` in continuous integration, and the files that its servers read.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "support/run_program.hpp"

using namespace slipproof::test;

namespace {

const std::string examples = SLIPPROOF_SOURCE_DIR "/cases/contact-problems/examples.jsonl";

}  // namespace

TEST_CASE("--fail-on says which verdicts fail, and without it exit codes are as they were") {
  const TemporaryFolder folder;
  const std::string ambiguous = folder.write("a.jsonl", R"({"M":[[1,2],[2,1]],"q":[-1,-1],"z":[1,0]})"
                                                        "\n"
                                                        R"({"M":[[2,1],[1,2]],"q":[-5,-6],"z":["4/3","7/3"]})"
                                                        "\n");
  CHECK(run({"certify", ambiguous}).exit_code == 1);
  CHECK(run({"certify", ambiguous, "--fail-on", "wrong,inaccurate"}).exit_code == 0);
  CHECK(run({"certify", ambiguous, "--fail-on", "wrong,ambiguous"}).exit_code == 1);
  CHECK(run({"certify", examples, "--fail-on", "undecided"}).exit_code == 0);
  CHECK(run({"certify", examples, "--fail-on", "wrong"}).exit_code == 1);
  const auto mistaken = run({"certify", examples, "--fail-on", "wrong,slow"});
  CHECK(mistaken.exit_code == 2);
  CHECK(mistaken.err.find("found slow, expected ambiguous, inaccurate, eps-solution, wrong, invalid or undecided") !=
        std::string::npos);
  const std::string nan = folder.write("n.jsonl", R"({"M":[[2,1],[1,2]],"q":[-5,-6],"z":["4/3","7/3"]})"
                                                  "\n"
                                                  R"({"M":[[2,1],[1,2]],"q":[-5,-6],"z":[NaN,0]})"
                                                  "\n");
  CHECK(run({"certify", nan, "--fail-on", "wrong"}).exit_code == 1);
  CHECK(run({"certify", folder.write("g.jsonl", "{}\ngarbage\n"), "--fail-on", "wrong"}).exit_code == 1);
  CHECK(run({"certify", folder.write("e.jsonl", ""), "--fail-on", "wrong"}).exit_code != 0);
  CHECK(run({"certify", nan, "--junit", ""}).exit_code == 2);
  const std::string same = folder.path() / "same";
  CHECK(run({"certify", nan, "--junit", same, "--sarif", same}).exit_code == 2);
  const std::string block = SLIPPROOF_SOURCE_DIR "/cases/contact-problems/pushed-block.json";
  CHECK(run({"certify", block, "--fail-on", "wrong"}).exit_code == 0);
  CHECK(run({"certify", block, "--tolerance", "1e-12"}).exit_code == 1);
  CHECK(run({"certify", block, "--tolerance", "1e-12", "--fail-on", "wrong"}).exit_code == 0);
  CHECK(run({"certify", block, "--tolerance", "1e-12", "--fail-on", "inaccurate"}).exit_code == 1);
}

TEST_CASE("eps-solution is a word of its own: what only the residual judges does not fail as inaccurate") {
  const TemporaryFolder folder;
  const std::string diamond =
      R"({"title":"a diamond","dimension":3,"W":[[1,0,0],[0,1,0],[0,0,1]],"q":[-10,6,6],"mu":0.5,"law":"diamond",)";
  const std::string right = diamond + R"("r":[10,-2.5,-2.5]})" + "\n", off = diamond + R"("r":[10,-2.5,-2.4]})" + "\n";
  const std::string lines = folder.write("d.jsonl", right + right), file = folder.write("d.json", right);
  for (const std::string& given : {lines, file}) {
    CHECK(run({"certify", given, "--fail-on", "wrong,inaccurate", "--tolerance", "1e-12"}).exit_code == 0);
    CHECK(run({"certify", given, "--fail-on", "wrong,eps-solution"}).exit_code == 1);
    CHECK(run({"certify", given}).exit_code == 1);
    CHECK(run({"certify", given, "--json"}).out.find(R"("nothing_stronger":true)") != std::string::npos);
  }
  CHECK(run({"certify", lines, "--fail-on", "inaccurate", "--checkpoint", folder.path() / "c"}).exit_code == 0);
  CHECK(run({"certify", lines, "--fail-on", "eps-solution", "--checkpoint", folder.path() / "e"}).exit_code == 1);
  const std::string wrong = folder.write("w.jsonl", right + off), junit = folder.path() / "j.xml";
  const auto failed = run({"certify", wrong, "--fail-on", "wrong,inaccurate", "--junit", junit, "--json"});
  CHECK(failed.exit_code == 1);
  CHECK(failed.err.starts_with("1 of 2 records fail\n"));
  CHECK(failed.out.find("\"violates\":\"|r_1| + |r_2| = mu r_n") != std::string::npos);
  CHECK(read_file(junit).find("name=\"a diamond (record 2)\"") != std::string::npos);
  const std::string sarif = folder.path() / "s.sarif";
  CHECK(run({"certify", lines, "--fail-on", "eps-solution", "--sarif", sarif, "--quiet"}).exit_code == 1);
  const auto results = nlohmann::json::parse(read_file(sarif))["runs"][0]["results"];
  REQUIRE(results.size() == 2);
  CHECK(results[0]["ruleId"] == "eps-solution");
}

TEST_CASE("how many are decided in exact arithmetic, and how many by bounds on rounding") {
  const TemporaryFolder folder;
  const std::string slides = R"({"dimension":3,"W":[[1,0,0],[0,1,0],[0,0,1]],"q":[-10,6,8],"mu":0.5,"r":[10,-3,-4]})"
                             "\n";
  const std::string small = R"({"M":[[2,1],[1,2]],"q":[-5,-6],"z":["4/3","7/3"]})"
                            "\n";
  CHECK(run({"certify", folder.write("m.jsonl", slides + small + small)})
            .out.find("\n2 decided in exact arithmetic, 1 by floating point with proved error bounds") !=
        std::string::npos);
}

TEST_CASE("--fail-on ambiguous fails where uniqueness is not proved, of files and of lines") {
  const TemporaryFolder folder;
  const std::string ball = R"({"dimension":3,"W":[[1,0,0],[0,1,0],[0,0,1]],"q":[-1,0.25,0],"mu":0.5,"r":[1,-0.25,0]})"
                           "\n";
  const std::string definite = R"({"M":[[2,1],[1,2]],"q":[-5,-6],"z":["4/3","7/3"]})"
                               "\n";
  const std::string file = folder.write("ball.json", ball), lines = folder.write("balls.jsonl", ball + definite);
  for (const std::string& given : {file, lines}) {
    CHECK(run({"certify", given}).exit_code == 0);
    CHECK(run({"certify", given, "--fail-on", "wrong,inaccurate,undecided"}).exit_code == 0);
    const std::string sarif = folder.path() / "s.sarif";
    const auto failed = run({"certify", given, "--fail-on", "ambiguous", "--quiet", "--sarif", sarif});
    CHECK(failed.exit_code == 1);
    CHECK(failed.out.find("others ") != std::string::npos);
    const auto results = nlohmann::json::parse(read_file(sarif))["runs"][0]["results"];
    REQUIRE(results.size() == 1);
    CHECK(results[0]["ruleId"] == "ambiguous");
  }
  CHECK(run({"certify", folder.write("d.jsonl", definite), "--fail-on", "ambiguous"}).exit_code == 0);
  CHECK(run({"certify", lines, "--fail-on", "ambiguous", "--checkpoint", folder.path() / "c"}).exit_code == 1);
  CHECK(run({"certify", file})
            .out.find("of the answer in each component, and near it there is no other; others are not "
                      "excluded.") != std::string::npos);
}

TEST_CASE("a log has what fails, the first ten with their reasons, and then the verdict") {
  const auto quiet = run({"certify", examples, "--fail-on", "wrong,inaccurate", "--quiet"});
  CHECK(quiet.out.starts_with("4 of 10 records fail\n  " + examples + ": record "));
  CHECK(quiet.out.find(": record 3: wrong: violates w2 >= 0, margin -7/2\n") != std::string::npos);
  CHECK(quiet.out.find("\ns NOT CERTIFIED") != std::string::npos);
  CHECK(quiet.err.empty());
  const auto json = run({"certify", examples, "--fail-on", "wrong,inaccurate", "--json"});
  CHECK(json.err.starts_with("4 of 10 records fail\n"));
  CHECK(run({"certify", examples, "--quiet"}).out.find("fail") == std::string::npos);
  const TemporaryFolder folder;
  std::string many;
  for (int i = 0; i < 25; ++i)
    many += R"({"M":[[1]],"q":[-1],"z":[2]})"
            "\n";
  const auto log = run({"certify", folder.write("many.jsonl", many), "--fail-on", "wrong", "--quiet"}).out;
  CHECK(log.starts_with("25 of 25 records fail\n"));
  CHECK(log.find(": record 10: wrong") != std::string::npos);
  CHECK(log.find(": record 11: wrong") == std::string::npos);
  CHECK(log.find("  and 15 more\n") != std::string::npos);
}

TEST_CASE("JUnit's XML and SARIF have what fails, and how much does not") {
  const TemporaryFolder folder;
  const std::string junit = folder.path() / "j.xml", sarif = folder.path() / "s.sarif";
  const auto outcome =
      run({"certify", examples, "--fail-on", "wrong,inaccurate", "--junit", junit, "--sarif", sarif, "--quiet"});
  CHECK(outcome.exit_code == 1);
  const std::string xml = read_file(junit);
  CHECK(xml.find("tests=\"5\" failures=\"4\"") != std::string::npos);
  CHECK(xml.find("name=\"6 records of 10 that do not fail\"") != std::string::npos);
  CHECK(xml.find("name=\"record 3\"") != std::string::npos);
  CHECK(xml.find("message=\"wrong: violates w2 >= 0, margin -7/2\"") != std::string::npos);
  const auto document = nlohmann::json::parse(read_file(sarif));
  CHECK(document["version"] == "2.1.0");
  const std::string odd = folder.write("50% #1.jsonl", read_file(examples));
  CHECK(run({"certify", odd, "--sarif", sarif, "--quiet"}).exit_code == 1);
  CHECK(read_file(sarif).find("50%25%20%231.jsonl") != std::string::npos);
  const auto& results = document["runs"][0]["results"];
  REQUIRE(results.size() == 4);
  CHECK(results[1]["ruleId"] == "wrong");
  CHECK(results[1]["properties"]["record"] == 3);
  CHECK(document["runs"][0]["properties"]["records"] == 10);
  // A file of one problem, by its contacts.
  const std::string laws = SLIPPROOF_SOURCE_DIR "/cases/contact-problems/laws.jsonl";
  CHECK(run({"certify", laws, "--fail-on", "wrong", "--sarif", sarif}).exit_code == 1);
  const auto found = nlohmann::json::parse(read_file(sarif))["runs"][0]["results"];
  REQUIRE(found.size() == 1);
  CHECK(found[0]["message"]["text"].get<std::string>().find("record 3: wrong: contact 1 violates u_n = mu |u_t|") == 0);
  // Nothing is written over an input, and nothing beside a checkpoint.
  CHECK(run({"certify", examples, "--junit", examples}).exit_code != 0);
  CHECK(run({"certify", examples, "--junit", junit, "--checkpoint", folder.path() / "c"}).exit_code == 2);
}

TEST_CASE("--law and --within are for lines, too, which are judged as files then") {
  const std::string laws = SLIPPROOF_SOURCE_DIR "/cases/contact-problems/laws.jsonl";
  const auto verdict = [&](const std::vector<std::string>& options, std::size_t line) {
    std::vector<std::string> arguments{"certify", laws, "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    std::istringstream lines(run(arguments).out);
    std::string text;
    for (std::size_t i = 0; i <= line; ++i) std::getline(lines, text);
    return nlohmann::json::parse(text)["verdict"].get<std::string>();
  };
  CHECK(verdict({}, 1) == "unique");
  CHECK(verdict({"--law", "coulomb"}, 1) == "wrong");
  CHECK(verdict({"--law", "coulomb", "--within", "0.3"}, 1) == "no solution within rho");
  CHECK(verdict({"--law", "coulomb", "--within", "0.5"}, 1) == "not converged");
  CHECK(verdict({"--within", "1"}, 2) == "not converged");
  const auto small = run({"certify", examples, "--law", "coulomb", "--json"});
  CHECK(small.out.find(R"("verdict":"unique")") != std::string::npos);
  CHECK(small.out.find(R"("verdict":"certified")") == std::string::npos);
  const TemporaryFolder folder;
  const std::string scene = R"({"F":1,"a":1})"
                            "\n";
  const std::string scenes = folder.write("s.jsonl", scene + scene);
  const auto other =
      run({"certify", scenes, "--scene", SLIPPROOF_SOURCE_DIR "/cases/city-bicycle.toml", "--law", "box"});
  CHECK(other.out.find("expected a contact problem") != std::string::npos);
}
