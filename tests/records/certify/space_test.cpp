// Records of scenes in space: the verdict follows from the list of all motions.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "base/input/text_file.hpp"
#include "base/number/format.hpp"
#include "contact/space/solve_space.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "records/record/bicycle_records.hpp"
#include "support/certified.hpp"

using namespace slipproof;

namespace {

/// A block of mass 2 that touches below its centre; it is pulled along (3, 4).
const std::string sledge = R"(
schema = "slipproof/mechanism/1"
name = "sledge"
dimension = 3
gravity = ["0", "0", "-10"]
[parameters]
mu = "mu >= 0"
[load]
symbol = "F"
[[body]]
name = "sledge"
mass = "2"
inertia = ["1", "1", "1"]
[[contact]]
name = "runner"
of = "sledge"
point = ["0", "0", "0"]
normal = ["0", "0", "1"]
friction = "mu"
tangent = ["1", "0", "0"]
[[force]]
on = "sledge"
is = ["3/5*F", "4/5*F", "0"]
)";

CertifyOptions records_in_space(const Mechanism& mechanism) {
  CertifyOptions options;
  options.format = RecordFormat::csv;
  options.mechanism.emplace(mechanism);
  return options;
}

std::vector<nlohmann::json> judged_lines(const CertifyOptions& options, const std::string& text) {
  return test::certified(text, options).lines();
}

nlohmann::json judged_sledge(const std::string& answer, double tolerance = 1e-9) {
  CertifyOptions options = records_in_space(parse_mechanism(sledge, "sledge.toml"));
  options.judge.tolerance = tolerance;
  const auto lines =
      judged_lines(options, "mu,F,ax,ay,az,alphax,alphay,alphaz,N_runner,T1_runner,T2_runner\n" + answer + "\n");
  REQUIRE(lines.size() == 1);
  return lines.front();
}

std::string file_in_space(const std::string& name) {
  return SLIPPROOF_SOURCE_DIR "/cases/space/" + name + ".toml";
}
SolvedSpace shipped_in_space(const std::string& name) {
  return solve_space(read_scene(file_in_space(name), Dimensions::any));
}

/// Records of a scene of cases/space; the header names what it does not give.
nlohmann::json judged_shipped(const std::string& name, const std::string& header, const std::string& answer) {
  const std::string file = file_in_space(name);
  CertifyOptions options;
  options.format = RecordFormat::csv;
  options.mechanism = records_of_scene(read_text_file(file), file);
  return judged_lines(options, header + "\n" + answer + "\n").front();
}

}  // namespace

TEST_CASE("a block that is pulled obliquely: right, badly computed and wrong answers, in slipping and at rest") {
  // N = 20. At F = 30 friction takes 10 of the pull, so that a = 10 along (3, 4)/5.
  const auto right = judged_sledge("0.5,30,6,8,0,0,0,0,20,-6,-8");
  CHECK(right["verdict"] == "certified");
  CHECK(right["modes"] == nlohmann::json({"slip"}));
  CHECK(right["motions"] == 1);
  CHECK(judged_sledge("0.5,9,0,0,0,0,0,0,20,-5.4,-7.2")["modes"] == nlohmann::json({"stick"}));
  CHECK(judged_sledge("0.5,9,0,0,0,0,0,0,20,-5.4,-7.2")["verdict"] == "certified");
  CHECK(judged_sledge("0.5,30,6,8,0,0,0,0,,,")["verdict"] == "certified");
  const auto rough = judged_sledge("0.5,30,6.0001,8,0,0,0,0,20,-6,-8");
  CHECK(rough["verdict"] == "inaccurate");
  CHECK(rough["worst"] == "ax");
  CHECK(judged_sledge("0.5,30,6.0001,8,0,0,0,0,20,-6,-8", 1e-4)["verdict"] == "certified");
  const auto wrong = judged_sledge("0.5,30,8,6,0,0,0,0,20,-6,-8");  // friction against the wrong direction
  CHECK(wrong["verdict"] == "wrong");
  CHECK(wrong["complete"] == true);
  CHECK(wrong["found"].size() == 1);
  CHECK(judged_sledge("0.5,30,6,8,0,0,0,0,20,-8,-6")["verdict"] == "wrong");
  CHECK(judged_sledge("-1,30,6,8,0,0,0,0,20,-8,-6")["verdict"] == "invalid");
}

TEST_CASE("a range that is wider than the tolerance gives no verdict") {
  const auto line = judged_sledge("0.5,30,6,8,0,0,0,0,20,-6,-8", 0);
  CHECK(line["verdict"] == "undecided");
  CHECK(line["reason"].get<std::string>().find("wider than the tolerance") != std::string::npos);
  for (const std::size_t end : {0U, 1U}) {  // an end of each range: the motion may be at the other
    std::string answer = "0.5,30";
    for (const char* name : {"ax", "ay", "az", "alphax", "alphay", "alphaz"}) {
      answer += "," + line["found"][0]["accelerations"][name][end].get<std::string>();
    }
    CHECK(judged_sledge(answer + ",,,", 0)["verdict"] == "undecided");
    CHECK(judged_sledge(answer + ",,,")["verdict"] == "certified");
  }
}

TEST_CASE("forces that a motion leaves open are right if the law allows some near them") {
  const std::string header = "ax,ay,az,alphax,alphay,alphaz";
  const SolvedSpace stool = shipped_in_space("stool-tipping");
  REQUIRE(stool.motions.front().open_directions == 1);
  std::string accelerations;
  for (std::size_t i = 0; i < stool.scene.mechanism.accelerations; ++i) {
    accelerations += (i == 0 ? "" : ",") + exact_text(*stool.motions.front().accelerations[i].lower);
  }
  CHECK(judged_shipped("stool-tipping", header, accelerations)["verdict"] == "certified");
  // Of two legs on a line along y each may push the other away: what is added to T2 of one is taken from that of the
  // other.
  std::string names = header, shared = accelerations, spoiled = accelerations;
  const auto forces = force_names(stool.scene.mechanism);
  int signs = 0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const Rational force = *stool.motions.front().forces[i]->lower;
    const bool is_shared = forces[i].starts_with("T2_") && stool.motions.front().modes[i / 3] == "stick";
    const Rational more = is_shared ? Rational(++signs == 1 ? 1 : -1, 10) : Rational(0);
    names += "," + forces[i];
    shared += "," + exact_text(force + more);
    spoiled += "," + exact_text(force + abs(more));
  }
  REQUIRE(signs == 2);
  CHECK(judged_shipped("stool-tipping", names, shared)["verdict"] == "certified");
  const auto wrong = judged_shipped("stool-tipping", names, spoiled);
  CHECK(wrong["verdict"] == "undecided");
  CHECK(wrong["reason"].get<std::string>().find("leaves its forces open") != std::string::npos);
  CHECK(judged_shipped("stool-tipping", header, "1,2,3,4,5,6")["verdict"] == "wrong");
}

TEST_CASE("one motion of a continuum is ambiguous, and one that is not known is undecided") {
  const SolvedSpace cube = shipped_in_space("cube-pushed-obliquely");
  std::string answer, other;
  for (std::size_t i = 0; i < cube.scene.mechanism.accelerations; ++i) {
    answer += (i == 0 ? "" : ",") + exact_text(*cube.motions.front().accelerations[i].lower);
    other += i == 0 ? "1" : ",1";
  }
  const std::string header = "ax,ay,az,alphax,alphay,alphaz";
  const auto one = judged_shipped("cube-pushed-obliquely", header, answer);
  CHECK(one["verdict"] == "ambiguous");
  const auto far = judged_shipped("cube-pushed-obliquely", header, other);
  CHECK(far["verdict"] == "undecided");
  CHECK(far["reason"] == "it may be another motion of a continuum");
}

TEST_CASE("beside a motion others may be: it is right, they are not excluded, and what is far from all is wrong") {
  const std::string header = "ax,ay,az,alphax,alphay,alphaz", name = "box-on-slope-pulled-sideways";
  const SolvedSpace box = shipped_in_space(name);
  REQUIRE(box.motions.front().others_within.value_or(0) > 0);
  const auto right = judged_shipped(name, header, "981/6500,2943/26000,0,0,0,0");
  CHECK(right["verdict"] == "certified");
  CHECK(right["others"] == "not excluded");
  CHECK(judged_shipped(name, header, "0.151,0.1132,0,0,0,0")["verdict"] == "undecided");
  CHECK(judged_shipped(name, header, "5,5,0,0,0,0")["verdict"] == "wrong");
}

TEST_CASE("a record in space claims no mode, and the motions at a point are found once") {
  CertifyOptions options = records_in_space(parse_mechanism(sledge, "sledge.toml"));
  CHECK_THROWS_WITH_AS(judged_lines(options, "mu,F,mode,ax,ay,az,alphax,alphay,alphaz\n"), doctest::Contains("mode"),
                       InputError);
  std::string text = "mu,F,ax,ay,az,alphax,alphay,alphaz\n";
  for (int i = 0; i < 300; ++i) text += "0.5,30,6,8,0,0,0,0\n0.5,9,0,0,0,0,0,0\n";
  const auto lines = judged_lines(options, text);
  REQUIRE(lines.size() == 600);
  for (const auto& line : lines) CHECK(line["verdict"] == "certified");
}
