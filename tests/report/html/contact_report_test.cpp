// The page about a contact problem: well-formed, everything in it escaped, what was found is in it, thousands of
// contacts are not.
#include "report/html/contact_report.hpp"

#include <doctest/doctest.h>

#include <cstdio>
#include <limits>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "base/number/format.hpp"
#include "report/scenes/contact_words.hpp"
#include "support/scattered_contacts.hpp"

using namespace slipproof;

namespace {

const std::string hostile_text = "</script><script>alert(1)</script><b onmouseover=x>\"'&amp;\xE2\x80\xAE\x01";

ProblemFile point_of_mass_1(std::vector<double> q, double mu) {
  ProblemFile p;
  p.W = from_dense(3, 3, std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1});
  p.q = std::move(q);
  p.mu = {mu};
  return p;
}

JudgedProblem judged(const ProblemFile& problem, const std::vector<std::vector<double>>& answers,
                     const std::string& file = "problem.json") {
  ReadProblem read{problem, {}};
  for (const auto& r : answers) {
    SolverAnswer answer;
    answer.origin = "/guesses/" + std::to_string(read.answers.size() + 1);
    answer.r = r;
    read.answers.push_back(answer);
  }
  return judge_problem_file(file, std::move(read), {});
}

std::string page(const ProblemFile& problem, const std::vector<std::vector<double>>& answers) {
  return contact_report(judged(problem, answers), "slipproof certify problem.json --report page.html", "1.0");
}

pugi::xml_document tree_of(const std::string& html) {
  pugi::xml_document tree;
  const auto result = tree.load_string(html.c_str(), pugi::parse_default | pugi::parse_doctype | pugi::parse_ws_pcdata);
  INFO(result.description() << " at " << result.offset);
  REQUIRE(result);
  return tree;
}

/// All text in an element, in its order.
std::string text_in(const pugi::xml_node& node) {
  std::string text;
  for (const auto& found : node.select_nodes(".//text()")) text += found.node().value();
  return text;
}

std::string text_at(const pugi::xml_document& tree, const char* path) {
  return text_in(tree.select_node(path).node());
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

/// Every link and every name that is referred to is there, once; nothing comes from elsewhere, and nothing runs.
void check_references(const pugi::xml_document& tree) {
  std::set<std::string> ids;
  for (const auto& found : tree.select_nodes("//*[@id]")) {
    CHECK(ids.insert(found.node().attribute("id").value()).second);
  }
  for (const auto& found : tree.select_nodes("//a[@href]")) {
    const std::string href = found.node().attribute("href").value();
    CAPTURE(href);
    REQUIRE(href.starts_with("#"));
    CHECK(ids.contains(href.substr(1)));
  }
  for (const auto& found : tree.select_nodes("//svg[@role='img']")) {
    std::istringstream names(found.node().attribute("aria-labelledby").value());
    int count = 0;
    for (std::string name; names >> name; ++count) CHECK(ids.contains(name));
    CHECK(count == 2);
  }
  CHECK(tree.select_nodes("//*[@src]").empty());
  CHECK(tree.select_nodes("//script").empty());
  CHECK(tree.select_nodes("//link[not(starts-with(@href, 'data:'))]").empty());
  for (const auto& table : tree.select_nodes("//table")) {
    CHECK(table.node().select_nodes("thead/tr/th[@scope='col']").size() >= 3);
    CHECK(table.node().select_nodes("tbody/tr[not(th[@scope='row'])]").empty());
  }
}

}  // namespace

TEST_CASE("the page of a point that slides: its verdict, its numbers, its place on the circle") {
  ProblemFile problem = point_of_mass_1({-10, 3, 4}, 0.25);
  problem.title = "A point on a floor";
  const std::string html = page(problem, {{10, -1.5, -2}});
  CHECK(html.starts_with("<!DOCTYPE html>"));
  CHECK(page(problem, {{10, -1.5, -2}}) == html);
  const auto tree = tree_of(html);
  check_references(tree);
  CHECK(text_at(tree, "//h1") == "A point on a floor");
  CHECK(has(text_at(tree, "//section[@id='overview']"), "1 contact in dimension 3"));
  CHECK(has(text_at(tree, "//p[starts-with(@class, 'ruling')]"), "solution within rho"));
  CHECK(has(text_at(tree, "//dl[@class='bounds']"), "near it there is no other"));
  CHECK(has(text_at(tree, "//section[@id='reproduce']//code"), "slipproof certify problem.json --report page.html"));
  double x0 = 0, y0 = 0, unit = 0, x = 0, y = 0;
  REQUIRE(std::sscanf(tree.select_node("//svg[@class='cone-disc']").node().attribute("data-plot").value(),
                      "%lf %lf %lf", &x0, &y0, &unit) == 3);
  const auto shapes = tree.select_nodes("//g[@class='points fit-slide']/path");
  REQUIRE(shapes.size() == 1);
  REQUIRE(std::sscanf(shapes.first().node().attribute("d").value(), "M%lf,%lf", &x, &y) == 2);
  CHECK((x - x0) / unit == doctest::Approx(-1.5 / (0.25 * 10)).epsilon(1e-4));
  CHECK((y0 - y) / unit == doctest::Approx(-2 / (0.25 * 10)).epsilon(1e-4));
}

TEST_CASE("each answer has its section, the bounds are those of its judgement, the worst stand first") {
  const JudgedProblem problem = judged(point_of_mass_1({-10, 3, 4}, 0.25), {{10, -1.5, -2}, {10, -3, -4}, {1, 2}});
  const auto tree = tree_of(contact_report(problem, "c"));
  check_references(tree);
  CHECK(tree.select_nodes("//section[@id='overview']/ol/li").size() == 3);
  const auto& wrong = problem.answers[1].judgement;
  const std::string text = text_at(tree, "//section[@id='answer-2']");
  CHECK(has(text, "wrong"));
  CHECK(has(text, verdict_words(wrong)));
  CHECK(has(text, at_most(wrong.residual->backward_error())));
  CHECK(has(text, at_most(wrong.residual->change)));
  CHECK(has(text, at_least(wrong.exclusion->radius)));
  const auto rows = tree.select_nodes("//section[@id='answer-2']//table[@class='worst']/tbody/tr");
  REQUIRE(rows.size() == wrong.residual->worst.size());
  const std::string first = text_in(rows.first().node());
  CHECK(has(first, "contact 1"));
  CHECK(has(first, wrong.residual->worst.front().condition));
  CHECK(has(first, at_most(wrong.residual->worst.front().amount)));
  const std::string invalid = text_at(tree, "//section[@id='answer-3']");
  CHECK(has(invalid, "invalid"));
  CHECK(has(invalid, "found 2 numbers in r, expected 3"));
  CHECK(tree.select_nodes("//section[@id='answer-3']//svg").empty());
}

TEST_CASE("a pyramid is told, why nothing stronger is proved too, with the contacts") {
  const auto box = tree_of(page(point_of_mass_1({-10, 9, 9}, 0.5), {{10, -5, -5}}));
  check_references(box);
  CHECK(has(text_at(box, "//section[@id='answer-1']"), "It is right for the box pyramid"));
  CHECK(box.select_nodes("//svg[@class='cone-disc']/rect").size() == 1);
  // The first contact slides, the second is at the edge between sticking and sliding: 2.5 just holds (1.5, 2).
  ProblemFile two = point_of_mass_1({-10, 3, 4, -10, 1.5, 2}, 0.25);
  std::vector<double> identity(36);
  for (std::size_t i = 0; i < 6; ++i) identity[7 * i] = 1;
  two.W = from_dense(6, 6, identity);
  two.mu = {0.25, 0.25};
  const JudgedProblem problem = judged(two, {{10, -1.5, -2, 10, -1.5, -2 - 1e-12}});
  REQUIRE(problem.first().judgement.verdict == ContactVerdict::eps_solution);
  const std::string text = text_at(tree_of(contact_report(problem, "c")), "//section[@id='answer-1']");
  CHECK(has(text, "Nothing stronger: " + problem.first().judgement.reason + " (contact 2)."));
}

TEST_CASE("velocities that are not those of the forces are what is wrong, not the forces") {
  ReadProblem read{point_of_mass_1({-10, 3, 4}, 1), {}};
  SolverAnswer answer;
  answer.r = {10, -3, -4};
  answer.u = {0, 0.5, 0};
  read.answers = {answer};
  const auto tree = tree_of(contact_report(judge_problem_file("problem.json", read, {}), "c"));
  const std::string text = text_at(tree, "//section[@id='answer-1']");
  CHECK(has(text, "The answer is wrong: the velocities are not those of the forces."));
  CHECK(has(text, "by up to 5.00e-01"));
  CHECK_FALSE(has(text, "no solution is within"));
}

TEST_CASE("names, titles, remarks and commands are text, whatever they look like") {
  ProblemFile problem = point_of_mass_1({-10, 3, 4}, 0.25);
  problem.title = hostile_text;
  problem.remarks = {hostile_text};
  ReadProblem read{problem, {}};
  SolverAnswer answer;
  answer.origin = hostile_text;
  answer.r = {10, -1.5, -2};
  read.answers = {answer, answer};
  const auto tree = tree_of(contact_report(judge_problem_file(hostile_text, read, {}), hostile_text, hostile_text));
  check_references(tree);
  CHECK(tree.select_nodes("//script | //b[@onmouseover]").empty());
  for (const char* place : {"//h1", "//section[@id='overview']/dl", "//section[@id='answer-1']/h2",
                            "//section[@id='overview']/ol", "//section[@id='remarks']", "//pre"}) {
    CAPTURE(place);
    CHECK(has(text_at(tree, place), "<script>alert(1)</script><b onmouseover=x>\"'&amp;"));
  }
}

TEST_CASE("problems with nothing in them, and answers that are not finite, have a page without a picture") {
  const auto nothing = tree_of(page({}, {}));
  check_references(nothing);
  CHECK(has(text_at(nothing, "//section[@id='answer-1']"), "no answer is given"));
  const auto empty = tree_of(page({}, {{}}));
  check_references(empty);
  CHECK(empty.select_nodes("//svg[@class='cone-disc']").empty());
  const auto infinite =
      tree_of(page(point_of_mass_1({-10, 3, 4}, 0.25), {{std::numeric_limits<double>::infinity(), 0, 0}}));
  CHECK(has(text_at(infinite, "//section[@id='answer-1']"), "not finite"));
  CHECK(infinite.select_nodes("//svg").empty());
}

TEST_CASE("a complementarity problem has a bar of what is open and what is closed") {
  ProblemFile problem;
  problem.form = ProblemForm::complementarity;
  problem.dimension = 1;
  problem.W = from_dense(3, 3, std::vector<double>{2, 0, 0, 0, 2, 0, 0, 0, 2});
  problem.q = {-2, -4, 5};
  const auto tree = tree_of(page(problem, {{1, 2, 0}}));
  check_references(tree);
  CHECK(tree.select_nodes("//svg[@class='cone-disc']").empty());
  const auto closed = tree.select_node("//svg[@class='bar']/rect[@class='fit-smooth']").node();
  const auto open = tree.select_node("//svg[@class='bar']/rect[@class='fit-open']").node();
  CHECK(closed.attribute("width").as_double() == doctest::Approx(2 * open.attribute("width").as_double()));
  const std::string text = text_at(tree, "//ul[@class='legend']");
  CHECK(has(text, "2closed"));
  CHECK(has(text, "1open"));
}

TEST_CASE("ten thousand contacts: a file of bounded size that says what it leaves out, and how many are open") {
  const test::ScatteredContacts made = test::scattered_contacts(10'000, 3);
  auto r = made.r;
  std::size_t spoiled = 4321;
  while (r[3 * spoiled] == 0 || made.problem.mu[spoiled] == 0) ++spoiled;
  r[3 * spoiled] += 500;
  const JudgedProblem problem = judged(made.problem, {r});
  const std::string html = contact_report(problem, "c");
  CHECK(html.size() < 400'000);
  const auto tree = tree_of(html);
  check_references(tree);
  const std::size_t drawn = tree.select_nodes("//g[starts-with(@class, 'points')]/*").size();
  CHECK(drawn >= 5000);
  CHECK(drawn <= 5010);
  std::size_t open = 0, placed = 0;
  for (std::size_t k = 0; k < 10'000; ++k) {
    open += r[3 * k] == 0;
    placed += r[3 * k] > 0 && made.problem.mu[k] > 0;
  }
  const std::string caption = text_at(tree, "//figcaption");
  CHECK(
      has(caption, "Of " + std::to_string(placed) + " contacts with a place " + std::to_string(drawn) + " are drawn"));
  CHECK(has(caption, std::to_string(open) + " open contacts"));
  bool marked = false;
  for (const auto& text : tree.select_nodes("//g[@class='marks']/text")) {
    marked = marked || text_in(text.node()) == std::to_string(spoiled + 1);
  }
  CHECK(marked);
}
