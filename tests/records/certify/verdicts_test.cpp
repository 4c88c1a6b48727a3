// Each verdict, on scenes that a person can follow; and broken input.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "base/number/format.hpp"
#include "records/certify/certify.hpp"
#include "support/bicycle/motions.hpp"
#include "support/certified.hpp"
#include "support/scenes/random_scene.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

std::vector<nlohmann::json> judged_lines(const std::string& text, const CertifyOptions& options = {}) {
  return certified(text, options).lines();
}

// M = R = h = b = 1, I2 = I3 = 1, I1 = 0, mu = 1, L = 1, g = 10, f = 1.
const std::string head = "M,R,h,b,I1,I2,I3,mu,L,f,g,F,mode,a,S2,S3,N2,N3\n";
const std::string parameters = "1,1,1,1,0,1,1,1,1,1,10,";

/// The answer of the exact solver to the parameters above, as a record.
std::string answer(const Rational& F, const std::string& mode_text) {
  const Bicycle<Rational> p{
      .M = 1, .R = 1, .h = 1, .b2 = 1, .b3 = 1, .I1 = 0, .I2 = 1, .I3 = 1, .r1 = 1, .r2 = 1, .L = 1};
  const ModeTable table(p, {1, 10}, ForceKind::internal);
  const auto found = motions_at(table, F);
  REQUIRE(found.motions.size() == 1);
  std::string line = parameters + F.str() + "," + mode_text;
  for (const Quantity q : {Quantity::a, Quantity::S2, Quantity::S3, Quantity::N2, Quantity::N3}) {
    line += "," + found.motions.front().values[q].str();
  }
  return line;
}

}  // namespace

TEST_CASE("a right answer is certified, with its mode named or not, in fractions and on a boundary") {
  const auto lines = judged_lines(head + answer(Rational(1), "stick/stick") + "\n" + answer(Rational(1), "") + "\n" +
                                  answer(Rational(0), "stick/stick") + "\n");
  for (const auto& line : lines) {
    CHECK(line["verdict"] == "certified");
    CHECK(line["motions"] == 1);
    CHECK(line["modes"] == nlohmann::json::array({"stick/stick"}));
  }
}

TEST_CASE("a wrong mode is wrong, with the violated condition, its exact margin and the motions there are") {
  const auto lines = judged_lines(head + answer(Rational(1), "slip+/stick") + "\n");
  REQUIRE(lines.size() == 1);
  CHECK(lines[0]["verdict"] == "wrong");
  CHECK(lines[0]["claimed"] == "slip+/stick");
  CHECK(lines[0]["violated"] == "slip2 >= 0");
  CHECK(Rational(lines[0]["margin"].get<std::string>()) < 0);
  CHECK(lines[0]["found"].size() == 1);
  CHECK(lines[0]["found"][0]["modes"][0] == "stick/stick");
}

TEST_CASE("a small error is inaccurate, and certified with a tolerance above it") {
  std::string record = answer(Rational(1), "stick/stick");
  record.replace(record.rfind(','), std::string::npos, ",4.00001");
  const auto exact = judged_lines(head + answer(Rational(1), "") + "\n")[0];
  CertifyOptions loose;
  loose.judge.tolerance = 0.9;
  loose.judge.near = 0.9;
  CHECK(judged_lines(head + record + "\n", loose)[0]["verdict"] == "certified");
  CHECK(judged_lines(head + record + "\n")[0]["verdict"] != "certified");
}

TEST_CASE("never certified where several motions exist: ambiguous, and all are listed") {
  test::RandomScenes random(95);
  int seen = 0;
  for (int i = 0; i < 400 && seen < 10; ++i) {
    const auto p = random.bicycle(true);
    const auto road = random.road();
    const ModeTable table(p, road, ForceKind::internal);
    for (const Cell& cell : partition(table)) {
      if (cell.motions.size() < 2) continue;
      const Rational F = cell.forces.sample();
      const auto found = motions_at(table, F);
      std::string text = "M,R,h,b2,b3,I1,I2,I3,r1,r2,L,J,f,g,F,a,S2,S3,N2,N3\n";
      for (const Rational* x :
           {&p.M, &p.R, &p.h, &p.b2, &p.b3, &p.I1, &p.I2, &p.I3, &p.r1, &p.r2, &p.L, &*p.J, &road.f, &road.g}) {
        text += exact_text(*x) + ",";
      }
      text += exact_text(F);
      for (const Quantity q : {Quantity::a, Quantity::S2, Quantity::S3, Quantity::N2, Quantity::N3}) {
        text += "," + exact_text(found.motions.back().values[q]);
      }
      // A fraction counts as it stands, an integer too: the record is exact.
      const auto line = judged_lines(text + "\n")[0];
      CHECK(line["verdict"] == "ambiguous");
      CHECK(line["motions"] == found.motions.size());
      CHECK(line["found"].size() == found.motions.size());
      ++seen;
    }
  }
  CHECK(seen >= 10);
}

TEST_CASE("NaN, infinities, numbers outside the domain and broken records are invalid, with the reason") {
  const std::string tail = ",1,stick/stick,0,0,0,5,5\n";
  const auto lines =
      judged_lines(head + "1,1,1,1,0,1,1,1,1,1,10,nan,stick/stick,0,0,0,5,5\n" +
                   "1,1,1,1,0,1,1,1,1,1,10,1,stick/stick,0,0,inf,5,5\n" + "-1,1,1,1,0,1,1,1,1,1,10" + tail +
                   "1,1,-1,1,0,1,1,1,1,1,10" + tail + "1,1,1,1,0,1,1,1,1,-1,10" + tail + "1,1,1,1,0,1,1,1,1,1e999,10" +
                   tail + "1,1,1,1,0,1,1,1,1,1\n" + "1,1,1,1,0,1,1,1,1,1,10,1,stick/glide,0,0,0,5,5\n" +
                   "1,1,1,1,0,1,1,1,1,x,10" + tail + "1,1,1,1,0,1,1,1,1,1,10,1,stick/stick,0,0,0,5,5,6\n" +
                   "1,1,1,1,0,1,1,1,1,1/0,10" + tail + ",1,1,1,0,1,1,1,1,1,10" + tail);
  REQUIRE(lines.size() == 12);
  const char* reasons[] = {"F: found NaN",
                           "S3: found infinity",
                           "M: found -1, expected M > 0",
                           "h: found -1, expected h > -R",
                           "f: found -1, expected f >= 0",
                           "",
                           "fewer cells",
                           "stick/glide",
                           "f: ",
                           "more cells",
                           "f: ",
                           "missing M"};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    CAPTURE(i);
    CHECK(lines[i]["verdict"] == "invalid");
    CHECK(lines[i]["record"] == i + 1);
    CHECK(lines[i]["reason"].get<std::string>().find(reasons[i]) != std::string::npos);
  }
}

TEST_CASE("a number that only rounds to that of a word is outside the domain, in the filter too") {
  const auto verdict = [](const std::string& external) {
    return judged_lines("external," + head + external + ",129,.25,.25,.125,0,.25,.125,1,.25,1,8,0,,0,0,0,516,516\n")[0];
  };
  const auto right = verdict("1");
  CHECK(right["verdict"] == "certified");
  CHECK(right["tier"] == "filter");
  const auto nearly = verdict("100000000000000000001/100000000000000000000");
  CHECK(nearly["verdict"] == "invalid");
}

TEST_CASE("a header that cannot be used, and with stop_at_broken a record, is refused with its place") {
  const auto refused = [](const std::string& text, CertifyOptions options = {}) {
    std::istringstream input(text);
    try {
      certify(
          input, [](std::string_view) {}, options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  CHECK(
      refused("").starts_with("-:1:1: found the column '', expected a parameter or a part of the answer\n"
                              "-:1:1: missing M (or M2 and M3), R, h (or h0), "));
  CHECK(refused("M,M,Q\n").find("-:1:3: found the column 'M' twice") != std::string::npos);
  CHECK(refused("M,M,Q\n").find("-:1:5: found the column 'Q'") != std::string::npos);
  CHECK(refused("M,R,h,h0,b,I1,I2,I3,mu,L,f,g,F,a,S2,S3,N2,N3\n")
            .find("found h0 together with h, expected only one of them") != std::string::npos);
  CertifyOptions stop;
  stop.stop_at_broken = true;
  CHECK(refused(head + answer(Rational(1), "") + "\n\n1,x\n", stop).find("-:4:") == 0);
  CHECK(refused(head + answer(Rational(1), "") + "\n", stop) == "accepted");
  CHECK(refused(head + std::string(3 * max_record_line, '1'), stop).find("found a line of more than") !=
        std::string::npos);
  CertifyOptions json;
  json.format = RecordFormat::json_lines;
  json.stop_at_broken = true;
  for (const char* line :
       {"[1]", "1", "{\"M\":[1]}", "{\"M\":{}}", "{\"M\":1,\"M\":1}", "{\"Q\":1}", "{\"M\":tru", "{}"}) {
    CHECK(refused(std::string(line) + "\n", json).find("-:1") == 0);
  }
}

TEST_CASE("decimals mean the nearest binary64, or exactly what they say") {
  // f N = S exactly in decimals; the nearest binary64 of 0.1 is a little above one tenth.
  const Bicycle<Rational> p{
      .M = 1, .R = 1, .h = 1, .b2 = 1, .b3 = 1, .I1 = 0, .I2 = 1, .I3 = 1, .r1 = 1, .r2 = 1, .L = 1};
  const ModeTable table(p, {Rational(1, 10), 10}, ForceKind::internal);
  const ModeSolution& sticking = *table.find({WheelState::stick, WheelState::stick});
  REQUIRE(sticking.closed().upper());
  const Rational F = *sticking.closed().upper();
  std::string text = head + "1,1,1,1,0,1,1,1,1,0.1,10," + F.str() + ",stick/stick";
  for (const Quantity q : {Quantity::a, Quantity::S2, Quantity::S3, Quantity::N2, Quantity::N3}) {
    text += "," + sticking.quantity(q).at(F).str();
  }
  CertifyOptions exact;
  exact.decimal_exact = true;
  const auto on_boundary = judged_lines(text + "\n", exact)[0], inside = judged_lines(text + "\n")[0];
  CHECK(on_boundary["verdict"] == "certified");
  CHECK(on_boundary["tier"] == "exact");
  CHECK(on_boundary["modes"].size() == 2);
  CHECK(inside["verdict"] == "certified");
  CHECK(inside["modes"].size() == 1);
}
