// The contact problems in cases/contact-problems get the verdicts that cases/CERTIFYING.md tells.
#include <fstream>
#include <sstream>

#include "contact/simulation/loaded_contacts.hpp"
#include "mechanics/scene/scene.hpp"
#include "records/certify/judged_problems.hpp"
#include "records/problems/problem_reader.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

/// Verdicts in the table of a page under a heading, by the numbers of lines.
std::vector<std::string> verdicts_in_table(const std::string& page, const std::string& heading) {
  std::ifstream file(page);
  std::vector<std::string> expected;
  bool here = false;
  for (std::string row; std::getline(file, row);) {
    if (row.starts_with("#")) here = row.ends_with(heading);
    const std::size_t first = row.find("| "), second = row.find(" | ", first + 1), third = row.find(" | ", second + 1);
    if (!here || first != 0 || third == std::string::npos) continue;
    if (row.substr(2, second - 2) == std::to_string(expected.size() + 1)) {
      expected.push_back(row.substr(second + 3, third - second - 3));
    }
  }
  return expected;
}

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("each law's shipped line gets the verdict that its table tells") {
  const std::string folder = std::string(SLIPPROOF_SOURCE_DIR) + "/cases/contact-problems/";
  const auto expected = verdicts_in_table(folder + "../CERTIFYING.md", "laws.jsonl");
  const auto lines = problems(text_of(folder + "laws.jsonl")).lines();
  REQUIRE(lines.size() == 10);
  REQUIRE(expected.size() == lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) CHECK(lines[i]["verdict"] == expected[i]);
  CHECK(lines[2]["coulomb"]["verdict"] == "solution within rho");
  CHECK(lines[3]["coulomb"]["verdict"] == "wrong");
  CHECK(lines[3]["law"] == "associated law");
}

TEST_CASE("steps with an impact get the verdicts that their table tells, and their energies") {
  const std::string folder = std::string(SLIPPROOF_SOURCE_DIR) + "/cases/contact-problems/";
  const auto expected = verdicts_in_table(folder + "../CERTIFYING.md", "impacts.jsonl");
  const auto lines = problems(text_of(folder + "impacts.jsonl")).lines();
  REQUIRE(lines.size() == 8);
  REQUIRE(expected.size() == lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) CHECK(lines[i]["verdict"] == expected[i]);
  // m = 1: from (2, 3) to (1, 3/2), 13/2 J to 13/8 J
  CHECK(lines[0]["energy"] == nlohmann::json{{"before", nullptr}, {"work", -4.875}, {"gains", false}});
  CHECK(lines[3]["energy"] == nlohmann::json{{"before", 20.0}, {"work", 7.5}, {"gains", true}});
  CHECK(lines[3]["impact"] == "newton");
  CHECK(lines[4]["energy"]["gains"] == nullptr);
  CHECK(lines[5]["energy"]["work"].get<double>() == doctest::Approx(6.0 * 25 / 27));  // 6 J become 6 * 52/27
}

TEST_CASE("the shipped examples get the verdicts that their table tells, and the bicycle is the one of the scene") {
  const std::string folder = std::string(SLIPPROOF_SOURCE_DIR) + "/cases/";
  const auto expected = verdicts_in_table(folder + "CERTIFYING.md", "examples.jsonl");
  const std::string all = text_of(folder + "contact-problems/examples.jsonl");
  const auto lines = problems(all).lines();
  REQUIRE(lines.size() == 10);
  REQUIRE(expected.size() == lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) CHECK(lines[i]["verdict"] == expected[i]);
  CHECK(lines[3]["solutions"] == 3);
  CHECK(lines[7]["solutions"] == 3);
  CHECK(lines[9]["solutions"] == 3);

  const ContactProblem problem = loaded_contacts(read_scene(folder + "ambiguous.toml")).problem;
  const std::size_t last = all.rfind("{");
  const std::string line = all.substr(last, all.find('\n', last) - last);
  const auto record = read_problem(JsonProblem(line, "examples.jsonl"), line, false, false);
  CHECK(record.problem.W == problem.W);
  CHECK(record.problem.q == problem.q);
  CHECK(record.problem.mu == problem.mu);
}
