// Contacts stand in the picture of their cones where r_T / (mu r_N) says, and the worst ones are marked.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <pugixml.hpp>
#include <set>

#include "report/planes/cone_svg.hpp"
#include "support/scattered_contacts.hpp"

using namespace slipproof;

namespace {

MixedProblem points_on_floor(std::size_t dimension, const std::vector<double>& mu, std::vector<double> q) {
  MixedProblem p;
  p.dimension = dimension;
  std::vector<MatrixEntry> entries, twice;
  for (std::uint32_t i = 0; i < q.size(); ++i) entries.push_back({i, i, 1});
  p.A = sparse_matrix(q.size(), q.size(), entries, twice);
  p.c = std::move(q);
  p.mu = mu;
  return p;
}

ConeDisc disc_of(const MixedProblem& problem, std::vector<double> x, ContactJudgeOptions options = {}) {
  return cone_disc(problem, judge_contacts(problem, std::move(x), {}, options), 5000);
}

pugi::xml_document drawn(const ConeDisc& disc) {
  const ElementTree document("div");
  add_cone_disc(document.root(), disc, "test");
  pugi::xml_document tree;
  REQUIRE(tree.load_string(document.xml().c_str()));
  return tree;
}

struct Drawn {
  double x = 0, y = 0;
};

/// The places of all points of one kind, in units of the picture's data-plot.
std::vector<Drawn> places(const pugi::xml_document& tree, const std::string& kind) {
  double x0 = 0, y0 = 0, unit = 0;
  REQUIRE(std::sscanf(tree.select_node("//svg").node().attribute("data-plot").value(), "%lf %lf %lf", &x0, &y0,
                      &unit) == 3);
  std::vector<Drawn> all;
  for (const auto& found : tree.select_nodes(("//g[@class='points " + kind + "']/*").c_str())) {
    Drawn at{found.node().attribute("cx").as_double(), found.node().attribute("cy").as_double()};
    if (std::string(found.node().name()) == "path")
      REQUIRE(std::sscanf(found.node().attribute("d").value(), "M%lf,%lf", &at.x, &at.y) == 2);
    all.push_back({(at.x - x0) / unit, (y0 - at.y) / unit});
  }
  return all;
}

std::size_t how_many(const pugi::xml_document& tree, const char* path) {
  return tree.select_nodes(path).size();
}

}  // namespace

TEST_CASE("the point of mass 1 slides on the circle, opposite to the force") {
  const ConeDisc disc = disc_of(points_on_floor(3, {0.25}, {-10, 3, 4}), {10, -1.5, -2});
  CHECK(disc.counts.slide == 1);
  const auto tree = drawn(disc);
  const auto slides = places(tree, "fit-slide");
  REQUIRE(slides.size() == 1);
  CHECK(std::abs(slides[0].x + 0.6) < 1e-4);
  CHECK(std::abs(slides[0].y + 0.8) < 1e-4);
  CHECK(places(tree, "fit-stick").empty());
}

TEST_CASE("each point stands at r_T / (mu r_N), round where it sticks, a triangle where it slides") {
  const test::ScatteredContacts made = test::scattered_contacts(300, 3);
  const MixedProblem problem = mixed_problem(made.problem);
  const ConeDisc disc = disc_of(problem, made.r);
  const auto tree = drawn(disc);
  std::vector<Drawn> expected_stick, expected_slide;
  std::size_t open = 0, smooth = 0;
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    const double N = made.r[3 * k], mu = problem.mu[k];
    if (N == 0) {
      ++open;
    } else if (mu == 0) {
      ++smooth;
    } else {
      const Drawn at{made.r[3 * k + 1] / (mu * N), made.r[3 * k + 2] / (mu * N)};
      (made.slides[k] ? expected_slide : expected_stick).push_back(at);
    }
  }
  CHECK(open > 10);
  CHECK(smooth > 3);
  CHECK(disc.counts.open == open);
  CHECK(disc.counts.smooth == smooth);
  for (const auto& [kind, expected] :
       {std::pair<std::string, std::vector<Drawn>>{"fit-stick", expected_stick}, {"fit-slide", expected_slide}}) {
    const auto found = places(tree, kind);
    CHECK(expected.size() > 30);
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      CHECK(std::abs(found[i].x - expected[i].x) < 1e-4);
      CHECK(std::abs(found[i].y - expected[i].y) < 1e-4);
    }
  }
  CHECK(how_many(tree, "//g[@class='points fit-stick']/path") == 0);
  CHECK(how_many(tree, "//g[@class='points fit-slide']/circle") == 0);
}

TEST_CASE("the worst are marked with their numbers, and those without a place are told") {
  // Contact 2 is 1 away from its law, contact 3 is open with a force of 2, the others are right.
  const MixedProblem problem = points_on_floor(3, {1, 1, 1, 0.5}, {-4, 1, 0, -4, 0, 1, 3, 0, 0, -2, 0, 0});
  const ConeDisc disc = disc_of(problem, {4, -1, 0, 4, 1, -1, 2, 0, 0, 2, 0, 0});
  std::vector<std::size_t> marked;
  for (const ConePoint& point : disc.points) {
    if (point.marked) marked.push_back(point.contact);
  }
  CHECK(marked == std::vector<std::size_t>{1});
  CHECK(disc.unplaced == std::vector<std::size_t>{2});
  const auto tree = drawn(disc);
  REQUIRE(how_many(tree, "//g[@class='marks']/circle") == 1);
  CHECK(std::string(tree.select_node("//g[@class='marks']/text").node().text().get()) == "2");
  const auto ring = tree.select_node("//g[@class='marks']/circle").node();
  CHECK(how_many(tree, ("//g[@class='points fit-stick']/circle[@cx='" + std::string(ring.attribute("cx").value()) +
                        "' and @cy='" + ring.attribute("cy").value() + "']")
                           .c_str()) == 1);
  const std::string text = tree.select_node("//svg/desc").node().text().get();
  CHECK(text.find("contact 2 sticks, at (0.25, -0.25)") != text.npos);
}

TEST_CASE("in the plane contacts stand below each other, between -1 and 1") {
  const ConeDisc disc = disc_of(points_on_floor(2, {0.5, 0.5}, {-4, 1, -4, 3}), {4, -1, 4, -2});
  const auto tree = drawn(disc);
  const auto stick = places(tree, "fit-stick"), slide = places(tree, "fit-slide");
  REQUIRE(stick.size() == 1);
  REQUIRE(slide.size() == 1);
  CHECK(std::abs(stick[0].x + 0.5) < 1e-4);
  CHECK(std::abs(slide[0].x + 1) < 1e-4);
  CHECK(stick[0].y > slide[0].y);
}

TEST_CASE("what is far outside stands at the edge of the picture, in its direction, and is told") {
  const ConeDisc disc = disc_of(points_on_floor(3, {1e-3}, {-1, -3, -4}), {1, 0.03, 0.04});
  REQUIRE(disc.points.size() == 1);
  CHECK(is_beyond(disc, disc.points[0]));
  const auto tree = drawn(disc);
  auto all = places(tree, "fit-slide");
  for (const Drawn& at : places(tree, "fit-stick")) all.push_back(at);
  REQUIRE(all.size() == 1);
  CHECK(all[0].x / all[0].y == doctest::Approx(0.75).epsilon(1e-3));
  const double size = std::hypot(all[0].x, all[0].y);
  CHECK(size > 1.4);
  CHECK(size < 1.6);
}

TEST_CASE("the pyramid that an answer is right for is drawn: a square, or a diamond") {
  const MixedProblem problem = points_on_floor(3, {0.5}, {-10, 9, 9});
  const auto square = drawn(disc_of(problem, {10, -5, -5}));
  CHECK(how_many(square, "//rect[@class='line']") == 1);
  const auto point = places(square, "fit-slide");
  REQUIRE(point.size() == 1);
  CHECK(std::abs(point[0].x + 1) < 1e-4);  // at its corner
  CHECK(std::abs(point[0].y + 1) < 1e-4);
  const auto diamond = drawn(disc_of(problem, {10, -2.5, -2.5}));
  CHECK(how_many(diamond, "//rect") == 0);
  CHECK(how_many(diamond, "//path[@class='line']") == 1);
  MixedProblem box = problem;
  box.law.kind = FrictionLaw::box;
  const auto asked = drawn(disc_of(box, {10, -5, -5}));
  CHECK(how_many(asked, "//rect[@class='edge']") == 1);
  CHECK(how_many(asked, "//circle[@class='line']") == 1);
}

TEST_CASE("of many contacts as many are drawn as may be, spread over all, and every marked one") {
  test::ScatteredContacts made = test::scattered_contacts(3000, 3);
  const MixedProblem problem = mixed_problem(made.problem);
  std::set<std::size_t> spoiled;
  for (std::size_t k = 0; spoiled.size() < 7; k += 131) {
    if (made.r[3 * k] == 0 || problem.mu[k] == 0) continue;
    made.r[3 * k] += 100;
    spoiled.insert(k);
  }
  const ContactJudgement judgement = judge_contacts(problem, made.r, {}, {});
  const ConeDisc disc = cone_disc(problem, judgement, 100);
  CHECK(disc.placed > 1500);
  CHECK(disc.points.size() >= 100);
  CHECK(disc.points.size() <= 110);
  for (const std::size_t k : spoiled) {
    const auto here = [&](const ConePoint& point) { return point.contact == k && point.marked; };
    CHECK(std::count_if(disc.points.begin(), disc.points.end(), here) == 1);
  }
  for (std::size_t i = 1; i < disc.points.size(); ++i) {
    CHECK(disc.points[i - 1].contact < disc.points[i].contact);
    CHECK(disc.points[i].contact - disc.points[i - 1].contact < 150);
  }
}
