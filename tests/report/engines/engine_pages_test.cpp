#include "report/engines/engine_pages.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <map>
#include <pugixml.hpp>
#include <sstream>

#include "base/output/json.hpp"
#include "support/files/engine_files.hpp"

using namespace slipproof;

namespace {

const char* const answers =
    R"({"schema":"slipproof/engine-answer/1","engine":"e","version":"1","asked":"default","law":"cone","scene":"one-motion/pulled","motion":{"ax":1,"ay":0}}
{"schema":"slipproof/engine-answer/1","engine":"e","version":"1","asked":"default","law":"cone","scene":"none/rod","motion":{"ax":1,"ay":0,"phi":0}}
{"schema":"slipproof/engine-answer/1","engine":"e","version":"1","asked":"threshold","scene":"one-motion/pulled","parameter":"F","changes_at":5.05,"within":0.001,"floor":1e-05}
{"schema":"slipproof/engine-answer/1","engine":"<f>","version":"2","asked":"default","law":"box","scene":"none/rod","refused":"no <rods>"})";

EngineResults results_of(const test::EngineFiles& files) {
  files.line(answers);
  return engine_results(judge_engines(files.folder()));
}

std::map<std::string, std::string> pages_of(const EngineResults& results, const std::string& explorer = "") {
  std::map<std::string, std::string> pages;
  write_engine_pages(results, "engines", "0", explorer,
                     [&](const auto& name, const auto& html) { pages[name] = html; });
  return pages;
}

}  // namespace

TEST_CASE("the table counts what each engine answers, class by class") {
  const test::EngineFiles files;
  const Json table = Json::parse(engine_table_json(results_of(files)));
  CHECK(table["scenes"] == 2);
  REQUIRE(table["engines"].size() == 2);
  CHECK(table["engines"][0]["engine"] == "<f>");
  CHECK(table["engines"][0]["all"] == Json{{"refused", 1}});
  CHECK(table["engines"][1]["classes"] == Json{{"none", {{"wrong", 1}}}, {"one-motion", {{"right", 1}}}});
  CHECK(table["engines"][1]["law"] == "cone");
}

TEST_CASE("a threshold that an engine has stands beside the exact one") {
  const test::EngineFiles files;
  std::filesystem::path scene = files.folder() / "scenes/one-motion/pulled.toml";
  std::ofstream(scene, std::ios::app) << "[threshold]\nparameter = \"F\"\nfrom = \"-9\"\nto = \"9\"\n";
  const auto rows = engine_thresholds(results_of(files));
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].exact == 5);  // mu times the weight; -5 is farther
  CHECK(rows[0].off() == doctest::Approx(0.01));
}

TEST_CASE("the floor above which a threshold was found stands beside it") {
  const test::EngineFiles files;
  const EngineResults results = results_of(files);
  const auto pages = pages_of(results);
  const std::string& of_class = pages.at("one-motion.html");
  CHECK(of_class.find(">floor</th>") != std::string::npos);
  CHECK(of_class.find(">1e-05</td>") != std::string::npos);
  CHECK(pages.at("one-motion/pulled.html").find("changes at F = 5.05, where motion exceeds a floor of 1e-05") !=
        std::string::npos);
  CHECK(Json::parse(engine_table_json(results))["thresholds"][0]["floor"] == 1e-5);
}

TEST_CASE("how far bodies creep that should rest stands in a table, and is no answer that is judged") {
  const test::EngineFiles files;
  files.line(std::string(answers) +
             R"(
{"schema":"slipproof/engine-answer/1","engine":"c","version":"1","asked":"drift","scene":"one-motion/pulled","drift":{"1":1e-9,"10":2e-8,"100":0.003}}
{"schema":"slipproof/engine-answer/1","engine":"c","version":"1","asked":"energy","scene":"one-motion/pulled","energy":{"1":0,"10":0,"100":1e-9,"1000":0.25}})");
  const EngineResults results = engine_results(judge_engines(files.folder()));
  const auto pages = pages_of(results);
  pugi::xml_document index;
  REQUIRE(index.load_string(pages.at("index.html").c_str(), pugi::parse_default | pugi::parse_doctype));
  CHECK(index.select_node("//*[@id='drift']//tr[th='c']/td[.='3.0e-03; 3.0e-03']"));
  CHECK(index.select_node("//*[@id='energy']//tr[th='c']/td[last()][.='2.5e-01; 2.5e-01']"));
  CHECK(pages.at("one-motion/pulled.html")
            .find("moves by 1.0e-09 of the size in 1 step, 2.0e-08 of the size in 10 steps") != std::string::npos);
  CHECK(pages.at("one-motion/pulled.html").find("1.0e-09 in 100 steps, 2.5e-01 in 1000 steps") != std::string::npos);
  CHECK(Json::parse(engine_table_json(results))["engines"].size() == 2);
}

TEST_CASE("engines stand in rows, with a sign for each scene that leads to it, and scenes can be searched") {
  const test::EngineFiles files;
  const auto pages = pages_of(results_of(files));
  pugi::xml_document page;
  REQUIRE(page.load_string(pages.at("none.html").c_str(), pugi::parse_default | pugi::parse_doctype));
  const auto row = page.select_node("//*[@id='answers']//tr[th='e']");
  REQUIRE(row);
  const auto link = row.node().select_node(".//a[starts-with(@href,'none/rod')]").node();
  CHECK(std::string(link.attribute("title").value()).ends_with(": wrong"));
  CHECK(std::string(link.child_value("span")) == "✗");
  CHECK_FALSE(page.select_node("//*[@id='answers']//tr[th='<f>']"));  // it refuses all of them
  CHECK(page.select_node("//input[@type='search'][@data-list='scene-list']"));
  CHECK(page.select_node("//*[@id='scene-list']//li[contains(@class,'item')]/a[starts-with(@href,'none/rod')]"));
  CHECK(pages.at("index.html").find("type=search") != std::string::npos);  // the script
}

TEST_CASE("the page of a scene leads to the explorer, where there is one") {
  const test::EngineFiles files;
  const EngineResults results = results_of(files);
  auto pages = pages_of(results, "explorer.html");
  const std::string link = "href=\"../explorer.html#scene:=%7B%22scene%22";
  CHECK(pages.at("one-motion/pulled.html").find(link) != std::string::npos);
  CHECK(pages.at("none/rod.html").find(link) != std::string::npos);
  CHECK(pages.at("index.html").find("explorer") == std::string::npos);
  for (const auto& [name, html] : pages_of(results)) CHECK(html.find("explorer") == std::string::npos);
}

TEST_CASE("each link of the pages leads to a page, and what engines call themselves stays text") {
  const test::EngineFiles files;
  const auto pages = pages_of(results_of(files));
  CHECK(pages.size() == 5);
  int links = 0;
  for (const auto& [name, html] : pages) {
    pugi::xml_document page;
    REQUIRE(page.load_string(html.c_str()));
    CHECK(page.select_nodes("//f").empty());
    for (const auto& link : page.select_nodes("//a[@href]")) {
      std::string target = link.node().attribute("href").value();
      const std::size_t hash = target.find('#');
      const std::string id = hash == target.npos ? "" : target.substr(hash + 1);
      target = target.substr(0, hash);
      const auto path = (std::filesystem::path(name).parent_path() / target).lexically_normal().generic_string();
      const std::string& there = target.empty() ? html : pages.at(path);
      if (!id.empty()) CHECK(there.find("id=\"" + id + "\"") != std::string::npos);
      ++links;
    }
  }
  CHECK(links > 20);
  CHECK(pages.at("one-motion/pulled.html").find("right") != std::string::npos);
}

TEST_CASE("the numbers of an engine that differs by its design say so, those of others do not") {
  const test::EngineFiles files;
  const std::string words = "its design, not a mistake";
  const auto count = [&](const std::string& html) {
    std::size_t n = 0;
    for (std::size_t at = html.find(words); at != html.npos; at = html.find(words, at + 1)) ++n;
    return n;
  };
  CHECK(count(pages_of(results_of(files)).at("index.html")) == 0);
  files.design("[e]\ndesign = \"soft contacts\"\n[\"<f>\"]\n");
  const EngineResults results = results_of(files);
  const auto pages = pages_of(results);
  pugi::xml_document index;
  REQUIRE(index.load_string(pages.at("index.html").c_str(), pugi::parse_default | pugi::parse_doctype));
  CHECK(count(pages.at("index.html")) == 2);  // the table and the thresholds
  CHECK(index.select_node("//*[@id='table']//tr[th[starts-with(.,'e 1')]]/td[starts-with(.,'1 of 2')]/small"));
  CHECK(index.select_node("//*[@id='laws']//td[.='soft contacts']"));
  CHECK(count(pages.at("one-motion.html")) > 0);
  CHECK(count(pages.at("none/rod.html")) == 1);           // a wrong answer
  CHECK(count(pages.at("one-motion/pulled.html")) == 0);  // a right one
  const Json table = Json::parse(engine_table_json(results));
  CHECK(table["engines"][1]["design"] == "soft contacts");
  CHECK_FALSE(table["engines"][0].contains("design"));
}

TEST_CASE("a design that is no string is refused at its place") {
  const test::EngineFiles files;
  files.line(answers);
  files.design("[e]\ndesign = 3\n");
  CHECK_THROWS_WITH_AS(judge_engines(files.folder()),
                       doctest::Contains("engines.toml:2:10: design: found a number, expected a string"), InputError);
}

TEST_CASE("the shipped table says whose contacts differ on purpose") {
  const std::string table = SLIPPROOF_SOURCE_DIR "/cases/engines/engines.toml";
  const auto designs = engine_designs(table);
  for (const char* engine : {"mujoco", "mujoco3", "mujoco3-shapes", "physx", "physx-shapes", "rapier2d", "rapier3d",
                             "rapier3d-shapes", "box2d3", "newton", "genesis", "drake", "chrono"})
    CHECK(designs.contains(engine));
  CHECK(designs.size() == 13);
}

TEST_CASE("impacts are counted by the laws by which they are right") {
  const test::EngineFiles files;
  files.impact();
  files.answer("impact/bar", R"("motion":{"vx":0,"vy":0.5,"omega":-1.5})");
  const EngineResults results = engine_results(judge_engines(files.folder()));
  const Json rows = Json::parse(engine_table_json(results))["impacts"];
  REQUIRE(rows.size() == 1);
  CHECK(rows[0]["right_by"] == Json{{"newton", 0}, {"moreau", 1}, {"poisson", 0}});
  CHECK(rows[0]["gains_energy"] == 0);
  const auto pages = pages_of(results);
  CHECK(pages.at("index.html").find("id=\"impacts\"") != std::string::npos);
  CHECK(pages.at("impact/bar.html").find("right by moreau; energy -75 %") != std::string::npos);
  CHECK(pages.at("impact/bar.html").find("<h3>By Poisson") != std::string::npos);
  CHECK(pages.at("impact/bar.svg").find("<svg") != std::string::npos);
}
