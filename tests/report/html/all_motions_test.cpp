// The picture of all motions: a row for each, a disc for each contact; a lifting one is dashed, a slipping one has its
// arrow, and its force opposite on the circle.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <optional>
#include <pugixml.hpp>

#include "contact/formats/read_files.hpp"
#include "report/html/contact_report.hpp"
#include "report/planes/motion_cones.hpp"

using namespace slipproof;

namespace {

pugi::xml_document page_with_all(const char* file) {
  ContactFileOptions options;
  options.judge.all = true;
  options.judge.refine = true;
  const std::string path = std::string(SLIPPROOF_SOURCE_DIR) + "/cases/contact-problems/" + file;
  const std::string html = contact_report(judge_problem_file(file, read_problem_file(path), options), "c");
  pugi::xml_document tree;
  REQUIRE(tree.load_string(html.c_str(), pugi::parse_default | pugi::parse_doctype));
  return tree;
}

std::string words_in(const pugi::xml_node& node) {
  std::string text;
  for (const auto& found : node.select_nodes(".//text()")) text += std::string(found.node().value()) + "|";
  return text;
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

struct Vector2 {
  double x = 0, y = 0;
};
double dot(Vector2 a, Vector2 b) {
  return a.x * b.x + a.y * b.y;
}

/// What is drawn of a contact, in units of its disc.
struct DrawnContact {
  bool dashed = false, ring = false;
  std::optional<Vector2> round, triangle, arrow_tip;
};

DrawnContact drawn_contact(const pugi::xml_node& group) {
  double x0 = 0, y0 = 0, unit = 0, x = 0, y = 0;
  REQUIRE(std::sscanf(group.attribute("data-plot").value(), "%lf %lf %lf", &x0, &y0, &unit) == 3);
  const auto at = [&](double px, double py) { return Vector2{(px - x0) / unit, (y0 - py) / unit}; };
  const auto start_of = [&](const pugi::xml_node& path) {
    REQUIRE(std::sscanf(path.attribute("d").value(), "M%lf,%lf", &x, &y) == 2);
    return at(x, y);
  };
  DrawnContact drawn;
  drawn.dashed = !group.select_nodes("circle[@class='line']").empty();
  drawn.ring = !group.select_nodes("circle[@class='edge']").empty();
  for (const auto& found : group.select_nodes("g[@class='fit-stick']/circle"))
    drawn.round = at(found.node().attribute("cx").as_double(), found.node().attribute("cy").as_double());
  for (const auto& found : group.select_nodes("g[@class='fit-slide']/path")) drawn.triangle = start_of(found.node());
  for (const auto& found : group.select_nodes("g[@class='moves']/path")) drawn.arrow_tip = start_of(found.node());
  return drawn;
}

/// By row and contact.
std::vector<std::vector<DrawnContact>> drawn_rows(const pugi::xml_node& tree) {
  std::vector<std::vector<DrawnContact>> rows;
  for (const auto& row : tree.select_nodes(".//svg[@class='motion-cones']/g[@class='motion-row']")) {
    rows.emplace_back();
    for (const auto& contact : row.node().select_nodes("g[starts-with(@class, 'contact')]"))
      rows.back().push_back(drawn_contact(contact.node()));
  }
  return rows;
}

Range exactly(const Rational& value) {
  return {value, value};
}

FoundSolution motion_with(const std::string& mode, const std::vector<Rational>& r, const std::vector<Rational>& u) {
  FoundSolution solution;
  solution.modes = {mode};
  for (const Rational& value : r) solution.r.push_back(exactly(value));
  for (const Rational& value : u) solution.u.push_back(exactly(value));
  return solution;
}

/// Contacts in space with so much friction, and the motions that are said to be all.
std::optional<MotionCones> cones_of(const std::vector<double>& mu, std::vector<FoundSolution> motions,
                                    std::vector<double> x = {}) {
  MixedProblem problem;
  problem.dimension = 3;
  problem.mu = mu;
  problem.c.resize(3 * mu.size());
  ContactJudgement judgement;
  judgement.x = std::move(x);
  judgement.all.emplace().dimension = 3;
  judgement.all->solutions = std::move(motions);
  return motion_cones(problem, judgement);
}

pugi::xml_document drawing_of(const MotionCones& cones) {
  const ElementTree document("div");
  add_motion_cones(document.root(), cones, "test");
  pugi::xml_document tree;
  REQUIRE(tree.load_string(document.xml().c_str()));
  return tree;
}

}  // namespace

TEST_CASE("a leaning body has three motions: it lifts, sticks, or slips with friction opposite to its arrow") {
  const auto tree = page_with_all("leaning-body.json");
  const auto rows = drawn_rows(tree);
  REQUIRE(rows.size() == 3);
  for (const auto& row : rows) REQUIRE(row.size() == 1);
  const DrawnContact &lift = rows[0][0], &stick = rows[1][0], &slip = rows[2][0];
  CHECK(lift.dashed);
  CHECK_FALSE(lift.ring);
  CHECK_FALSE((lift.round || lift.triangle || lift.arrow_tip));
  // Its forces are -11/14 and -67/162 over 7/4 times 31/56.
  CHECK(stick.ring);
  REQUIRE(stick.round);
  CHECK(stick.round->x == doctest::Approx(-11 / 14.0 / (1.75 * 31 / 56)).epsilon(1e-3));
  CHECK(stick.round->y == doctest::Approx(-67 / 162.0 / (1.75 * 31 / 56)).epsilon(1e-3));
  CHECK_FALSE((stick.triangle || stick.arrow_tip));
  REQUIRE((slip.triangle && slip.arrow_tip));
  CHECK_FALSE(slip.round);
  const double reach = std::sqrt(dot(*slip.arrow_tip, *slip.arrow_tip));
  CHECK(std::sqrt(dot(*slip.triangle, *slip.triangle)) == doctest::Approx(1).epsilon(1e-3));
  CHECK(reach >= 1);
  CHECK(dot(*slip.triangle, *slip.arrow_tip) / reach == doctest::Approx(-1).epsilon(1e-3));
  // u_T = W r + q, with r_N so that u_N = 0: 5/4 r_N + r_T1 + 3/32 = 0, and r_T = 7/4 r_N times the place.
  const double mu = 1.75, normal = -0.09375 / (1.25 + mu * slip.triangle->x);
  const Vector2 u{normal * (1 + 5 * mu * slip.triangle->x) + 3.375, 5.0625 * mu * normal * slip.triangle->y + 2.09375};
  CHECK(dot(u, *slip.arrow_tip) / std::sqrt(dot(u, u)) / reach == doctest::Approx(1).epsilon(1e-3));
}

TEST_CASE("the page says what the picture shows, as a table, too") {
  const auto tree = page_with_all("leaning-body.json");
  const auto figure = tree.select_node("//figure[contains(@class, 'motions-figure')]").node();
  CHECK(words_in(figure.child("h3")) == "All motions, contact by contact|");
  const std::string heads = words_in(figure.select_node(".//svg[@class='motion-cones']").node());
  for (const char* head : {"contact 1|", "1: lift|", "2: stick|", "3: slip|"}) CHECK(says(heads, head));
  CHECK(says(words_in(figure.child("ul")), "lifts"));
  CHECK(figure.select_nodes(".//table/tbody/tr").size() == 3);
  CHECK(says(words_in(figure.select_node(".//table/tbody/tr[1]").node()), "lifts|0|"));
  CHECK(says(words_in(figure.select_node(".//table/tbody/tr[2]").node()), "sticks|0.5536|-0.8111|-0.4269|"));
  const std::string slips = words_in(figure.select_node(".//table/tbody/tr[3]").node());
  CHECK(says(slips, "slips|0.3378|"));
  CHECK(says(slips, "|29.2"));  // atan(0.63317 / 1.13257)
}

TEST_CASE("a block whose forces can be shared differently slides in a continuum") {
  const auto tree = page_with_all("turning-block.json");
  const auto rows = drawn_rows(tree);
  REQUIRE(rows.size() == 1);
  REQUIRE(rows[0].size() == 4);
  const auto figure = tree.select_node("//figure[contains(@class, 'motions-figure')]").node();
  CHECK(says(words_in(figure.select_node(".//svg[@class='motion-cones']").node()), "|continuum|"));
  CHECK(says(words_in(figure.child("figcaption")), "A continuum moves in different ways"));
  CHECK(says(words_in(figure.child("figcaption")), "touches without a force"));
  std::size_t arrows = 0;
  for (const DrawnContact& contact : rows[0]) {
    arrows += contact.arrow_tip.has_value();
    if (contact.arrow_tip && contact.triangle) CHECK(dot(*contact.arrow_tip, *contact.triangle) < -0.99);
  }
  CHECK(arrows >= 3);
}

TEST_CASE("nothing is drawn where not all motions were asked for, in the plane, or without friction") {
  const std::string path = std::string(SLIPPROOF_SOURCE_DIR) + "/cases/contact-problems/leaning-body.json";
  ContactFileOptions options;
  options.judge.refine = true;
  const std::string html = contact_report(judge_problem_file("p", read_problem_file(path), options), "c");
  CHECK_FALSE(says(html, "contact by contact"));
  CHECK_FALSE(cones_of({0}, {motion_with("lift", {0, 0, 0}, {1, 0, 0})}));
  CHECK_FALSE(cones_of({1}, {}));
  CHECK(cones_of({1}, {motion_with("lift", {0, 0, 0}, {1, 0, 0})}));
}

TEST_CASE("contacts without force or friction are rings, with an arrow where they move along") {
  const auto cones = cones_of({1, 1, 0, 1}, {motion_with("lift/lift/slip/lift", {0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0},
                                                         {0, 0, 0, 0, 0, -3, 0, -2, 0, 1, 2, 0})});
  REQUIRE(cones);
  const auto rows = drawn_rows(drawing_of(*cones));
  REQUIRE((rows.size() == 1 && rows[0].size() == 4));
  const DrawnContact &touches = rows[0][0], &along = rows[0][1], &smooth = rows[0][2], &lifts = rows[0][3];
  for (const DrawnContact& contact : rows[0]) CHECK_FALSE((contact.round || contact.triangle));
  CHECK((touches.ring && !touches.arrow_tip));
  REQUIRE((along.arrow_tip && smooth.arrow_tip));
  CHECK(along.arrow_tip->y < -1);
  CHECK(std::abs(along.arrow_tip->x) < 1e-3);
  CHECK(smooth.arrow_tip->x < -1);
  CHECK((lifts.dashed && !lifts.arrow_tip));  // it does not touch where it would slip
}

TEST_CASE("what may be 0 is drawn as 0: a slow slip along an axis, a force without a sideways part") {
  const Rational tiny(1, 1'000'000'000);
  FoundSolution motion = motion_with("slip/stick", {4, -1, 0, 4, 0, 0}, {0, 3, 0, 0, 0, 0});
  for (const std::size_t i : {2U, 4U}) motion.r[i] = {Rational(-tiny), Rational(3 * tiny)};
  for (const std::size_t i : {2U, 4U, 5U}) motion.u[i] = {Rational(-tiny), Rational(3 * tiny)};
  const auto cones = cones_of({0.25, 1}, {motion});
  REQUIRE(cones);
  const ContactMotion &slips = cones->rows[0].contacts[0], &sticks = cones->rows[0].contacts[1];
  REQUIRE((slips.force && slips.slip && sticks.force));
  CHECK((*slips.force)[1] == 0);
  CHECK(degrees_of(*slips.slip) == 0);
  CHECK((*sticks.force)[0] == 0);
  CHECK_FALSE(sticks.slip);
}

TEST_CASE("twelve motions of twelve contacts are drawn, and how many there are is said") {
  std::string mode;
  std::vector<Rational> r, u;
  for (int k = 0; k < 14; ++k) {
    mode += k == 0 ? "stick" : "/stick";
    for (const int value : {1, 0, 0}) r.emplace_back(value), u.emplace_back(0);
  }
  std::vector<FoundSolution> motions(15, motion_with(mode, r, u));
  motions[3].open_directions = 1;
  const auto cones = cones_of(std::vector<double>(14, 0.5), motions);
  REQUIRE(cones);
  CHECK(cones->motions == 15);
  CHECK(cones->contacts == 14);
  const auto tree = drawing_of(*cones);
  const auto rows = drawn_rows(tree);
  REQUIRE(rows.size() == 12);
  for (const auto& row : rows) CHECK(row.size() == 12);
  const std::string text = words_in(tree.select_node("//g[@class='motion-row'][4]").node());
  CHECK(says(text, "…|forces open|"));
  double widest = 0;
  std::sscanf(tree.select_node("//svg").node().attribute("viewBox").value(), "0 0 %lf", &widest);
  CHECK(widest <= 1000);  // the width of the page
}

TEST_CASE("the motion whose forces are nearest to the answer is marked, unless forces are open") {
  std::vector<FoundSolution> motions{motion_with("lift", {0, 0, 0}, {1, 0, 0}),
                                     motion_with("stick", {4, 1, 1}, {0, 0, 0})};
  const auto marked = cones_of({1}, motions, {3, 0, 0});
  REQUIRE(marked);
  CHECK_FALSE(marked->rows[0].nearest);
  CHECK(marked->rows[1].nearest);
  motions[1].open_directions = 1;
  CHECK_FALSE(cones_of({1}, motions, {3, 0, 0})->rows[1].nearest);
}
