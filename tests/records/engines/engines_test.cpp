#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/input/diagnostic.hpp"
#include "records/engines/judged_engines.hpp"
#include "support/files/engine_files.hpp"

using namespace slipproof;

namespace {

EngineVerdict verdict_on(const std::string& scene, const std::string& line) {
  const test::EngineFiles files;
  files.answer(scene, line);
  const JudgedEngines judged = judge_engines(files.folder());
  for (const EngineScene& one : judged.scenes) {
    if (one.name == scene) return one.answers.at(0).verdict;
  }
  return EngineVerdict::failed;
}

std::string mistake_of(const std::string& line) {
  const test::EngineFiles files;
  files.line(line);
  try {
    judge_engines(files.folder());
  } catch (const InputError& error) {
    return error.diagnostics().front().message;
  }
  return {};
}

}  // namespace

TEST_CASE("an engine's answer is right within a thousandth of the largest acceleration, near within a hundredth") {
  using enum EngineVerdict;
  CHECK(verdict_on("one-motion/pulled", R"("motion":{"ax":1,"ay":0})") == right);
  CHECK(verdict_on("one-motion/pulled", R"("motion":{"ax":1.009,"ay":0})") == right);  // of 10
  CHECK(verdict_on("one-motion/pulled", R"("motion":{"ax":1.02,"ay":0})") == near);
  CHECK(verdict_on("one-motion/pulled", R"("motion":{"ax":0,"ay":0})") == wrong);
  CHECK(verdict_on("one-motion/pulled", R"("refused":"it has no blocks")") == refused);
  CHECK(verdict_on("one-motion/pulled", R"("failed":"no answer within 10 s")") == failed);
  CHECK(verdict_on("one-motion/pulled", R"("motion":{"ax":null,"ay":0})") == failed);
}

TEST_CASE("an answer to an impact is judged by each law, and its energy is told") {
  const test::EngineFiles files;
  files.impact();
  const auto judged = [&](const std::string& motion) {
    files.answer("impact/bar", "\"motion\":" + motion);
    return judge_engines(files.folder()).scenes.at(0).answers.at(0);
  };
  const JudgedEngineAnswer newton = judged(R"({"vx":0,"vy":1.3333333,"omega":-0.6666667})");
  CHECK(newton.verdict == EngineVerdict::right);
  CHECK(newton.laws == std::vector{ImpactLaw::newton});
  CHECK(*newton.energy_gained == doctest::Approx(-14.0 / 27));
  const JudgedEngineAnswer moreau = judged(R"({"vx":0,"vy":0.5,"omega":-1.5})");
  CHECK(moreau.laws == std::vector{ImpactLaw::moreau});
  CHECK(*moreau.energy_gained == -0.75);
  const JudgedEngineAnswer none = judged(R"({"vx":0,"vy":1,"omega":3})");
  CHECK(none.verdict == EngineVerdict::wrong);
  CHECK(none.laws.empty());
  CHECK(*none.energy_gained == 0);
}

TEST_CASE("where there is no motion every answer is wrong") {
  CHECK(verdict_on("none/rod", R"("motion":{"ax":0,"ay":0,"phi":0})") == EngineVerdict::wrong);
  CHECK(verdict_on("none/rod", R"("motion":{"ax":0,"ay":-10,"phi":0})") == EngineVerdict::wrong);
}

TEST_CASE("what a line lacks is told with its place") {
  CHECK(mistake_of("{}").starts_with("schema: found nothing"));
  CHECK(mistake_of("[1]") == "found no JSON object, expected an answer of an engine");
  const std::string head = R"({"schema":"slipproof/engine-answer/1","engine":"e","asked":"default","scene":)";
  CHECK(mistake_of(head + R"("one-motion/pulled"})")
            .starts_with("found no motion, changes_at, drift, energy, refused or failed"));
  CHECK(mistake_of(head + R"("one-motion/pulled","drift":{"1":null}})").starts_with("drift: found"));
  CHECK(mistake_of(head + R"("one-motion/pulled","energy":1})").starts_with("energy: found"));
  CHECK(mistake_of(head + R"("one-motion/pushed","refused":"no"})").starts_with("found the scene"));
  CHECK(mistake_of(head + R"("one-motion/pulled","motion":{"ax":1}})").find("ay") != std::string::npos);
  CHECK(mistake_of(head + R"("one-motion/pulled","motion":{"az":1}})").find("az") != std::string::npos);
  CHECK(mistake_of(head + R"("one-motion/pulled","motion":{"ax":"1"}})").starts_with("motion: found"));
  const std::string threshold = R"("one-motion/pulled","parameter":"F","changes_at":1,"within":0)";
  CHECK(mistake_of(head + threshold + "}").empty());
  CHECK(mistake_of(head + threshold + R"(,"floor":"low"})") == "floor: found \"low\", expected a number");
}

TEST_CASE("the shipped answers can be read, and are about shipped scenes") {
  const std::filesystem::path engines = SLIPPROOF_SOURCE_DIR "/cases/engines";
  std::size_t files = 0, motions = 0;
  for (const auto& file : std::filesystem::directory_iterator(engines / "answers")) {
    ++files;
    for (const EngineAnswer& answer : read_engine_answers(file.path())) {
      CAPTURE(answer.scene);
      CHECK(answer.engine == file.path().stem());
      CHECK(answer.date.size() == 10);
      REQUIRE(std::filesystem::exists(engines / "scenes" / (answer.scene + ".toml")));
      motions += answer.motion.empty() ? 0 : 1;
    }
  }
  CHECK(files >= 10);
  CHECK(motions > 3000);
}
