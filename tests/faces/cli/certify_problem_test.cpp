#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "support/replaced.hpp"
#include "support/run_program.hpp"

using slipproof::test::last_line;
using slipproof::test::ProgramEnd;
using slipproof::test::read_file;
using slipproof::test::replaced;
using slipproof::test::run;
using slipproof::test::run_shell;
using slipproof::test::TemporaryFolder;
using Json = nlohmann::json;

namespace {

// A point of mass 1 pressed on with 10 and pulled by (3, 4): with mu = 1/4 friction of 2.5 lets it slide.
std::string point(const std::string& answer, const std::string& mu = "0.25") {
  return R"({"dimension": 3, "W": [[1,0,0],[0,1,0],[0,0,1]], "q": [-10, 3, 4], "mu": )" + mu +
         (answer.empty() ? "" : ", \"r\": " + answer) + "}";
}

Json line_of(const ProgramEnd& outcome) {
  return Json::parse(outcome.out.substr(0, outcome.out.find('\n')));
}

}  // namespace

TEST_CASE("an answer to a contact problem is certified, in JSON and in words") {
  const TemporaryFolder folder;
  const auto outcome = run({"certify", folder.write("p.json", point("[10, -1.5, -2]"))});
  CHECK(outcome.exit_code == 0);
  const Json line = line_of(outcome);
  CHECK(line["verdict"] == "solution within rho");
  CHECK(line["contacts"] == 1);
  CHECK(line["dimension"] == 3);
  CHECK(line["unique"] == "locally");
  CHECK(std::stod(line["rho"].get<std::string>()) < 1e-14);
  CHECK(outcome.out.find("An exact solution is within") != std::string::npos);
  CHECK(last_line(outcome.out) == "s CERTIFIED 1/1\n");
}

TEST_CASE("exit codes of contact problems") {
  const TemporaryFolder folder;
  CHECK(run({"certify", folder.write("w.json", point("[10, -3, -4]"))}).exit_code == 1);
  CHECK(run({"certify", folder.write("n.json", point("[10, -1.5]"))}).exit_code == 3);
  const auto none = run({"certify", folder.write("u.json", point(""))});
  CHECK(none.exit_code == 4);
  CHECK(last_line(none.out) == "s UNDECIDED 0/1\n");
  CHECK(run({"certify", folder.write("r.json", point("")), "--refine"}).exit_code == 0);
  CHECK(run({"certify", folder.write("m.json", point("[10, -1.5, -2]", "-1"))}).exit_code == 3);
  CHECK(run({"certify", folder.write("x.json", point("[10, -1.5, -2]")), "--within", "-1"}).exit_code == 2);
  const auto excluded = run({"certify", folder.write("i.json", point("[10, -3, -4]")), "--within", "0.5"});
  CHECK(excluded.exit_code == 1);
  CHECK(line_of(excluded)["verdict"] == "no solution within rho");
}

TEST_CASE("what is looked for beyond a judgement does not end it") {
  // Looking for a second solution, Newton's method met a NaN: no record, and the exit code of what is refuted.
  const char* given = std::getenv("SLIPPROOF_SHARED");
  const std::filesystem::path shared = given != nullptr ? given : SLIPPROOF_SOURCE_DIR "/../shared/data";
  const std::filesystem::path problem = shared / "siconos/Confeti-ex13-Fc3D-SBM.dat";
  if (!std::filesystem::exists(problem)) return;
  const auto outcome = run({"certify", problem, "--answer", shared / "siconos/Confeti-ex13-Fc3D-SBM.nsgs-1e-12.json"});
  CHECK(outcome.exit_code == 0);
  CHECK(line_of(outcome)["verdict"] == "solution within rho");
  CHECK(outcome.err.empty());
}

TEST_CASE("a pyramid's answer is told as that, and is right for its own law") {
  const TemporaryFolder folder;
  const auto file = folder.write("p.json", R"({"dimension": 3, "W": [[1,0,0],[0,1,0],[0,0,1]], "q": [-10, 9, 9],
    "mu": 0.5, "r": [10, -5, -5]})");
  const auto cone = run({"certify", file});
  CHECK(cone.exit_code == 1);
  CHECK(line_of(cone)["right_for"] == "box pyramid |t1| <= mu n, |t2| <= mu n");
  const auto box = run({"certify", file, "--law", "box"});
  CHECK(box.exit_code == 0);
  CHECK(line_of(box)["verdict"] == "solution within rho");
  CHECK(line_of(box)["coulomb"]["verdict"] == "wrong");
  const auto fixed = run({"certify", file, "--law", "fixed"});
  CHECK(fixed.exit_code == 3);
  CHECK(fixed.err.find("bounds: found 0 numbers, expected 2") != std::string::npos);
}

TEST_CASE("an answer of its own file, an improved answer, a certificate and a report") {
  const TemporaryFolder folder;
  const auto problem = folder.write("p.json", point(""));
  const auto answer = folder.write("a.txt", "10 -1.5000001 -2\n");
  const auto refined = (folder.path() / "better.json").string(), cert = (folder.path() / "p.cert").string(),
             page = (folder.path() / "p.html").string();
  const auto outcome = run(
      {"certify", problem, "--answer", answer, "--refine", refined, "--certificate", cert, "--report", page, "--json"});
  CHECK(outcome.exit_code == 0);
  CHECK(line_of(outcome)["answer"] == answer.string());
  const Json better = Json::parse(read_file(refined));
  CHECK(better["r"][1].get<double>() == doctest::Approx(-1.5).epsilon(1e-15));
  CHECK(better["radius"][1].get<double>() < 1e-14);
  CHECK(run({"certify", problem, "--answer", refined}).exit_code == 0);
  CHECK(read_file(cert).starts_with("slipproof-contact 1\n"));
  CHECK(read_file(page).find("<svg") != std::string::npos);
  // Nothing is lost: neither the problem nor the answer can be an output.
  CHECK(run({"certify", problem, "--answer", answer, "--certificate", answer}).exit_code == 3);
  CHECK(read_file(answer) == "10 -1.5000001 -2\n");
}

TEST_CASE("a certificate is told when it is about another problem") {
  const TemporaryFolder folder;
  const std::string shipped = SLIPPROOF_SOURCE_DIR "/cases/contact-problems/pushed-block",
                    text = read_file(shipped + ".json"), certificate = shipped + ".cert";
  const auto checked = [&](const std::string& problem, const std::string& file) {
    return run({"certify", problem, "--check-certificate", file});
  };
  const auto good = checked(shipped + ".json", certificate);
  CHECK(good.exit_code == 0);
  CHECK(good.out.starts_with("accepted\na solution within "));
  CHECK(last_line(good.out) == "s ACCEPTED 1 accepted, 0 rejected, 0 missing, 0 undecided, 0 unreadable\n");
  const std::string other = replaced(text, "\"mu\": 0.5", "\"mu\": 0.6");
  const auto bad = checked(folder.write("other.json", other), certificate);
  CHECK(bad.exit_code == 5);
  CHECK(bad.out.starts_with("rejected: it is about another problem, "));
  // What was made now, and what was made before certificates named their problem.
  const std::string made = folder.path() / "made.cert";
  CHECK(run({"certify", shipped + ".json", "--certificate", made}).exit_code == 0);
  CHECK(checked(shipped + ".json", made).exit_code == 0);
  std::string old = read_file(made);
  old.erase(old.find("problem "), 64 + 9);
  const auto text_of_old =
      run({"certify", shipped + ".json", "--json", "--check-certificate", folder.write("old.cert", old)});
  const Json json = Json::parse(text_of_old.out);
  CHECK(json["schema"] == "slipproof/check-contact/1");
  CHECK(json["verdict"] == "accepted");
  CHECK(json["message"].get<std::string>().ends_with(", names no problem, has the numbers of " +
                                                     json["name"].get<std::string>()));
  CHECK(checked(shipped + ".json", folder.path() / "none.cert").exit_code == 3);
  CHECK(run({"certify", shipped + ".json", "--check-certificate", made, "--report", folder.path() / "r"}).exit_code ==
        2);
}

TEST_CASE("planar contacts with one solution for every constant say so") {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& mu) {
    const std::string text = R"({"dimension": 2, "W": [[1,0.5],[0.5,1]], "q": [1,0], "mu": )" + mu + ", \"r\": [0,0]}";
    return run({"certify", folder.write("p.json", text), "--certificate", folder.path() / ("mu" + mu)});
  };
  CHECK(line_of(said("0.75"))["unique_by"] == "bound on mu");
  CHECK(said("1.5").out.find("There is one solution for every constant, too (mode determinants).") !=
        std::string::npos);
  CHECK(line_of(said("2.5"))["verdict"] == "unique");
  CHECK_FALSE(line_of(said("2.5")).contains("unique_by"));
  const auto checked = [&](const std::string& mu) {
    return run({folder.path() / ("mu" + mu)}, "slipproof-check-contact").out;
  };
  CHECK(checked("0.75").find("one solution, whatever the constant, by a bound on mu, 1 contacts") != std::string::npos);
  CHECK(checked("1.5").find("one solution, whatever the constant, by the mode determinants") != std::string::npos);
  CHECK(checked("2.5").find("whatever the constant") == std::string::npos);
  const auto lines = folder.write("p.jsonl", R"({"W": [[1,0.5],[0.5,1]], "q": [1,0], "mu": 1, "z": [0,0]})");
  CHECK(line_of(run({"certify", lines, "--every-q"}))["every_q"]["verdict"] == "unique");
}

TEST_CASE("problems at which the search for all solutions once failed") {
  // The first five ended the process; three were left open; two were called unique, and the last two wrong.
  const std::string file = SLIPPROOF_SOURCE_DIR "/tests/faces/cli/once_failed.jsonl";
  std::istringstream out(run({"certify", file, "--all", "--effort", "1000000000", "--json"}).out);
  std::vector<std::string> verdicts;
  std::vector<int> solutions;
  for (std::string line; std::getline(out, line);) {
    const Json json = Json::parse(line);
    verdicts.push_back(json["verdict"]);
    solutions.push_back(json.contains("all") ? json["all"]["solutions"].get<int>() : -1);
  }
  REQUIRE(verdicts.size() == 22);
  for (std::size_t i = 0; i < 5; ++i) CHECK(verdicts[i] == "wrong");
  CHECK(solutions[5] == 3);
  CHECK(solutions[7] == 9);
  for (const std::size_t i : {8U, 9U, 11U, 12U}) CHECK(verdicts[i] == "solution within rho");
  for (std::size_t i = 13; i < 22; ++i) CHECK(solutions[i] >= 0);
}

TEST_CASE("problems as JSON Lines, in space and in the plane, get a line each") {
  const TemporaryFolder folder;
  const std::string planar = R"({"dimension": 2, "W": [[1,0],[0,1]], "q": [-1, 0.75], "mu": 0.5, "z": [1, -0.5]})";
  const auto file = folder.write("p.jsonl", point("[10, -1.5, -2]") + "\n" + planar + "\n\n" + point("[10, -3, -4]") +
                                                "\n" + point("[10, -1.5]") + "\n" + point("[10, NaN, -2]") + "\n");
  const auto outcome = run({"certify", file, "--json"});
  CHECK(outcome.exit_code == 1);
  CHECK(last_line(outcome.err) == "s NOT CERTIFIED 2/5\n");
  CHECK(outcome.err.find("largest rho of 1 certified contact problem: ") != std::string::npos);
  std::istringstream out(outcome.out);
  std::vector<Json> lines;
  for (std::string line; std::getline(out, line);) lines.push_back(Json::parse(line));
  REQUIRE(lines.size() == 5);
  for (std::size_t i = 0; i < lines.size(); ++i) CHECK(lines[i]["record"] == i + 1);
  CHECK(lines[0]["verdict"] == "solution within rho");
  CHECK(lines[1]["verdict"] == "certified");
  CHECK(lines[2]["verdict"] == "wrong");
  CHECK(lines[3]["verdict"] == "invalid");
  CHECK(lines[3]["reason"].get<std::string>().find("line 5: r, u: r: found 2 numbers, expected 3") == 0);
  CHECK(lines[4]["verdict"] == "invalid");
  // The same problem alone says the same.
  Json alone = line_of(run({"certify", folder.write("p.json", point("[10, -3, -4]"))}));
  alone["record"] = 3;
  alone["problem"] = file;
  CHECK(alone == lines[2]);
  CHECK(run({"certify", file, "--threads", "1", "--json"}).out == outcome.out);
  CHECK(run({"certify", "-", "--json"}, "slipproof", read_file(file)).exit_code == 1);
  CHECK(run({"certify", file, "--broken", "stop"}).err.find("p.jsonl:5: ") != std::string::npos);
  // What is for one problem is refused, and not passed over.
  CHECK(run({"certify", "-", "--law", "box"}, "slipproof", planar).exit_code == 0);
  CHECK(run({"certify", file, "--decimal", "exact"}).exit_code == 1);
}

TEST_CASE("the page's command gives the same verdict and the same page") {
  const TemporaryFolder folder;
  const auto problem = folder.write("it's a point.json", point("")), answer = folder.write("a.txt", "10 -1.5 -2.01\n");
  const std::string page = (folder.path() / "a page.html").string();
  const auto outcome = run({"certify", problem, "--answer", answer, "--tolerance", "0.0123", "--report", page});
  CHECK(line_of(outcome)["verdict"] == "solution within rho");
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--tolerance", "0.0123"},
                                                  {"--within", "1e-3"},
                                                  {"--refine"},
                                                  {"--law", "box"},
                                                  {"--effort", "1000"}}) {
    std::vector<std::string> arguments{"certify", problem, "--answer", answer, "--report", page, "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto first = run(arguments);
    const std::string html = read_file(page);
    CHECK(html.find("<bdi>it's a point.json</bdi>") != std::string::npos);
    CHECK(html.find(options[0]) != std::string::npos);
    const std::size_t start = html.find("<code>slipproof ", html.find("id=\"reproduce\""));
    REQUIRE(start != std::string::npos);
    const std::string command = html.substr(start + 16, html.find("</code>", start) - start - 16);
    const auto again = run_shell(command + " --json");
    CHECK(again.exit_code == first.exit_code);
    CHECK(again.out == first.out);
    CHECK(read_file(page) == html);
  }
}

TEST_CASE("the shipped block on four corners has one force that nothing determines") {
  const auto outcome = run({"certify", SLIPPROOF_SOURCE_DIR "/cases/contact-problems/pushed-block.json"});
  CHECK(outcome.exit_code == 0);
  CHECK(line_of(outcome)["undetermined_forces"] == 1);
}
