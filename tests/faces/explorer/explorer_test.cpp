// The explorer's answers are those of the program for the scene that it shows; its page holds that scene and nothing
// else can come out of it.
#include "faces/explorer/explorer.hpp"

#include <doctest/doctest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/input/diagnostic.hpp"
#include "contact/problem/every_push.hpp"
#include "contact/space/solve_space.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/scene/solve_mechanism.hpp"
#include "report/explorer/explorer_page.hpp"
#include "report/explorer/space_page.hpp"
#include "report/scenes/mechanism_report.hpp"

using namespace slipproof;
using AnswerJson = nlohmann::json;

namespace {

const std::string shipped_cases = SLIPPROOF_SOURCE_DIR "/cases/";

AnswerJson answer(const Explorer& explorer, const AnswerJson& request) {
  return AnswerJson::parse(explorer.answer(request.dump()));
}

std::string solved_json(const MechanismScene& scene) {
  const SolvedMechanism solved = solve_mechanism(scene);
  return solve_json(solved, for_every_push(solved.problem));
}

AnswerJson solved(const std::string& scene) {
  return AnswerJson::parse(solved_json(parse_scene(scene, "scene.toml")));
}

}  // namespace

TEST_CASE("the explorer answers for every shipped scene as solve does, at its own values and at others") {
  for (const char* folder : {"", "mechanisms/scenes"}) {
    for (const auto& entry : std::filesystem::directory_iterator(shipped_cases + folder)) {
      if (entry.path().extension() != ".toml") continue;
      CAPTURE(entry.path().string());
      const MechanismScene scene = read_scene(entry.path());
      const Explorer explorer(portable(scene));
      const AnswerJson own = answer(explorer, AnswerJson::object());
      REQUIRE(own.contains("solve"));
      CHECK(own["solve"] == solved(own["scene"]));
      AnswerJson fast = answer(explorer, {{"every_q", false}})["solve"];
      CHECK_FALSE(fast.contains("every_q"));
      fast["every_q"] = own["solve"]["every_q"];
      CHECK(fast == own["solve"]);
      AnswerJson expected = AnswerJson::parse(solved_json(scene));
      AnswerJson found = own["solve"];
      expected.erase("notes"), found.erase("notes");  // they say how the file was understood
      CHECK(found == expected);
      if (!scene.mechanism.load) continue;
      const AnswerJson other = answer(explorer, {{"set", {{scene.mechanism.load->symbol, "1/7"}}}});
      if (other.contains("mistakes")) continue;  // outside the load's domain
      CHECK(other["solve"]["load"]["value"] == "1/7");
      CHECK(other["solve"] == solved(other["scene"]));
      const std::size_t motions = other["solve"]["motions"].size() + other["solve"]["continua"].size();
      CHECK(other["pictures"].size() == std::max<std::size_t>(1, motions));
    }
  }
}

TEST_CASE("a mechanism that is not shipped goes with its scene") {
  MechanismScene scene = read_scene(shipped_cases + "mechanisms/scenes/ladder.toml");
  scene.mechanism.shipped = false;
  const PortableScene given = portable(scene);
  CHECK(given.mechanism == "mechanism.toml");
  const Mechanism again = parse_mechanism(given.file, "mechanism.toml");
  CHECK(again.contacts.size() == scene.mechanism.contacts.size());
}

TEST_CASE("the explorer draws the diagram of any parameter, and gives ranges with rational ends") {
  const Explorer explorer(portable(read_scene(shipped_cases + "ambiguous.toml")));
  const AnswerJson map = answer(explorer, {{"map", "h"}, {"columns", 5}});
  REQUIRE(!map["frames"].empty());
  for (const AnswerJson& frame : map["frames"]) {
    CHECK(frame["x"]["symbol"] == "h");
    CHECK(frame["y"]["symbol"] == "F");
  }
  CHECK(std::string(map["map"]).find("data-plot") != std::string::npos);
  const AnswerJson values = answer(explorer, {{"ranges", true}})["values"];
  CHECK(values[0]["kind"] == "load");
  for (const AnswerJson& value : values) {
    if (value["symbol"] == "f") CHECK(value["range"]["to"] == "2");
  }
}

TEST_CASE("what the explorer cannot answer, it says") {
  const Explorer explorer(portable(read_scene(shipped_cases + "ambiguous.toml")));
  const auto mistake = [&](const std::string& request) {
    const AnswerJson document = AnswerJson::parse(explorer.answer(request));
    REQUIRE(document.contains("mistakes"));
    return std::string(document["mistakes"][0]);
  };
  CHECK(mistake(R"({"set": {"f": "-1"}})") == "f: found '-1', expected f >= 0");
  CHECK(mistake(R"({"set": {"f": "x"}})").starts_with("f: found"));
  CHECK(mistake(R"({"set": {"f": null}})") == "f: found nothing, expected a number");
  CHECK(mistake(R"({"set": {"z": "1"}})") == "found the symbol 'z', which the scene does not have");
  CHECK(mistake(R"({"map": "z"})").find("'z'") != std::string::npos);
  for (const char* bad : {"", "[", "[]", "7", R"({"set": 7})", R"({"set": [1]})", R"({"map": 7})",
                          R"({"map": "f", "columns": "x"})", "\xff"}) {
    CAPTURE(bad);
    CHECK_FALSE(mistake(bad).empty());
  }
}

TEST_CASE("the page holds the scene, and no name can end its element") {
  MechanismScene scene = read_scene(shipped_cases + "ambiguous.toml");
  scene.name = "</script><b>";
  const std::string built = "<p></p><script type=\"application/json\" id=\"given\">null</script><p></p>";
  const std::string page = explorer_page(built, "explorer.html", scene);
  CHECK(page.find("<b>") == std::string::npos);
  const std::size_t from = page.find('{'), to = page.find("</script>");
  const AnswerJson given = AnswerJson::parse(page.substr(from, to - from));
  CHECK(parse_scene(std::string(given["scene"]), "scene.toml").name == scene.name);
  CHECK_THROWS_AS(explorer_page("<p>", "x.html", scene), InputError);
}

TEST_CASE("a link to the page holds the scene in characters that an address may have") {
  MechanismScene scene = read_scene(shipped_cases + "mechanisms/scenes/ladder.toml");
  scene.name = "50 % \"<a>\" & \xC3\xA4 #";
  const std::string start = "explorer.html#scene:=";
  const std::string link = explorer_link("explorer.html", scene);
  REQUIRE(link.starts_with(start));
  std::string text;
  for (std::size_t i = start.size(); i < link.size(); ++i) {
    if (link[i] != '%') {
      CHECK((std::isalnum(link[i]) != 0 || std::string("-_.~").find(link[i]) != std::string::npos));
      text += link[i];
      continue;
    }
    text += static_cast<char>(std::stoi(link.substr(i + 1, 2), nullptr, 16));
    i += 2;
  }
  const AnswerJson given = AnswerJson::parse(text);
  const Explorer explorer({given["scene"], given["mechanism"], given["along"], given["file"]});
  CHECK(answer(explorer, AnswerJson::object())["name"] == scene.name);
}

TEST_CASE("the page of a scene in space holds its motions, and nothing can come out of it") {
  MechanismScene scene = read_scene(shipped_cases + "space/domino.toml", Dimensions::any);
  scene.name = "a </script> & \"domino\"";
  const SolvedSpace solved = solve_space(scene);
  const std::string page = space_page(solved), begin = "id=\"scene\">";
  const std::size_t from = page.find(begin) + begin.size(), to = page.find("</script>", from);
  const AnswerJson model = AnswerJson::parse(page.substr(from, to - from));
  CHECK(model["name"] == scene.name);
  REQUIRE(model["motions"].size() == solved.motions.size());
  const auto& strokes = model["motions"][0]["strokes"];
  const auto count = [&](const char* kind, const char* css) {
    return std::count_if(strokes.begin(), strokes.end(),
                         [&](const auto& stroke) { return stroke["kind"] == kind && stroke["css"] == css; });
  };
  CHECK(count("arrow", "friction") == 2);  // of the two feet that do not lift
  CHECK(count("cone", "cone") == 2);
  CHECK(count("dot", "contact ink") == 2);
  CHECK(count("dot", "contact paper frame") == 2);
  CHECK(page.find('@') == page.find("@media"));  // all marks are replaced
  CHECK(page.find("http") == page.find("http-equiv"));
}
