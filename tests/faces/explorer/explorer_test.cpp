// The explorer's answers are those of the program for the scene that it shows; its page holds that scene and nothing
// else can come out of it.
#include "faces/explorer/explorer.hpp"

#include <doctest/doctest.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "base/input/diagnostic.hpp"
#include "base/number/parse.hpp"
#include "contact/problem/every_push.hpp"
#include "contact/space/solve_space.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/scene/solve_mechanism.hpp"
#include "records/certify/certify.hpp"
#include "records/record/bicycle_records.hpp"
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

namespace {

/// With its mechanism's file where the explorer looks for it.
Explorer opened(const MechanismScene& scene) {
  const PortableScene given = portable(scene);
  std::ofstream(given.mechanism) << given.file;
  return Explorer(given);
}

}  // namespace

TEST_CASE("pasted answers are judged as certify judges them") {
  const MechanismScene scene = read_scene(shipped_cases + "ambiguous.toml");
  const Explorer explorer(portable(scene));
  const auto judged = [&](const std::string& text) { return answer(explorer, {{"pasted", text}}); };
  const auto certified = [&](const std::string& text, bool of_scene) {
    CertifyOptions options;
    options.judge.tolerance = of_scene ? options.judge.tolerance : options.contact.tolerance;
    if (of_scene) options.mechanism = CertifiedMechanism(scene);
    std::istringstream input(text);
    AnswerJson lines = AnswerJson::array();
    certify(
        input,
        [&](std::string_view some) {
          std::istringstream each{std::string(some)};
          for (std::string line; std::getline(each, line);) lines.push_back(AnswerJson::parse(line));
        },
        options);
    for (AnswerJson& line : lines) line.erase("tier"), line.erase("max_relative_error");  // a bound, by either
    return lines;
  };
  const auto alike = [&](const std::string& text, bool of_scene) {
    AnswerJson lines = judged(text)["judged"];
    for (AnswerJson& line : lines) line.erase("tier"), line.erase("max_relative_error");
    CHECK(lines == certified(text, of_scene));
    return lines;
  };
  std::ifstream problems(shipped_cases + "contact-problems/examples.jsonl");
  std::size_t count = 0;
  for (std::string line; std::getline(problems, line); ++count) alike(line, false);
  CHECK(count == 10);
  // The first motion, the same with another a, and with NaN.
  const AnswerJson motion = answer(explorer, AnswerJson::object())["solve"]["motions"][0];
  std::string names, right, wrong, broken;
  for (const char* kind : {"accelerations", "forces"}) {
    for (const auto& [symbol, value] : motion[kind].items()) {
      std::ostringstream number;
      number << std::setprecision(17) << parse_rational(value.get<std::string>()).to_double() << ',';
      names += symbol + ",", right += number.str();
      wrong += symbol == "a" ? "1," : number.str(), broken += symbol == "a" ? "nan," : number.str();
    }
  }
  const AnswerJson records = alike(names + "mode\n" + right + "\n" + wrong + "\n" + broken + "\n", true);
  CHECK(records[0]["verdict"] == "ambiguous");
  CHECK(records[1]["verdict"] == "wrong");
  CHECK(records[2]["verdict"] == "invalid");
  // A problem over several lines, and what is nothing of all this.
  CHECK(judged("{\"W\": [[1, 0],\n[0, 1]], \"q\": [-9.81, 0.5],\n\"mu\": 0.3, \"r\": [9.81, -0.5]}")["judged"][0]
                                                                                                    ["verdict"] ==
        "certified");
  for (const char* text :
       {"", " \n", "a,S2\n", "a,S2,S3,N2,N3\n", "{\"W\": [[1", "7",
        "{\"dimension\": 3, \"W\": [[1,0,0],[0,1,0],[0,0,1]], \"q\": [1,0,0], \"mu\": 1, \"r\": [0,0,0]}"}) {
    CAPTURE(text);
    CHECK(judged(text).contains("mistakes"));
  }
  for (const char* text : {"W = [[1, 0], [0, 1]]", "{\"W\": [[1, 0], [0, 1]], \"mu\": 0.3, \"r\": [1, 0]}"}) {
    CHECK(judged(text)["mistakes"][0].get<std::string>().find("found lists") == 0);
  }
}

TEST_CASE("the pictures of a scene of bodies say how they move: a wheel that rolls turns as far as it goes") {
  const Explorer explorer = opened(read_scene(shipped_cases + "three-motions/drawn.toml"));
  const AnswerJson found = answer(explorer, AnswerJson::object());
  REQUIRE(found["pictures"].size() == 3);
  std::size_t rolling = 0, not_rolling = 0;
  for (const AnswerJson& picture : found["pictures"]) {
    const std::string svg = picture["svg"];
    CHECK((svg.find("data-opens") != std::string::npos) == (picture["title"] == "stick/lift"));
    // The wheels are the two largest circles, the rear one first.
    const std::regex circle(R"re(<circle class="body"[^>]* r="([^"]*)"[^>]*data-acceleration="(\S+) (\S+) ([^"]*)")re");
    std::vector<bool> rolls;
    double largest = 0;
    for (std::sregex_iterator at(svg.begin(), svg.end(), circle), end; at != end; ++at) {
      largest = std::max(largest, std::stod((*at)[1]));
    }
    for (std::sregex_iterator at(svg.begin(), svg.end(), circle), end; at != end; ++at) {
      const double radius = std::stod((*at)[1]), along = std::stod((*at)[2]), turn = std::stod((*at)[4]);
      if (radius < 0.9 * largest) continue;
      rolls.push_back(std::abs(along - radius * turn) < 1e-3 * std::abs(along));
    }
    CAPTURE(svg);
    REQUIRE(rolls.size() == 2);
    for (const bool one : rolls) ++(one ? rolling : not_rolling);
    CHECK(rolls[0]);
    CHECK(rolls[1] == (picture["title"] == "stick/stick"));
  }
  CHECK(rolling == 4);
  CHECK(not_rolling == 2);
  const Explorer by_equations(portable(read_scene(shipped_cases + "three-motions/three-motions.toml")));
  CHECK(by_equations.answer("{}").find("data-about") == std::string::npos);
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
