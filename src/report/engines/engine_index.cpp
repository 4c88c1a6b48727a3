#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "report/engines/engine_sections.hpp"
#include "report/html/sections.hpp"

namespace slipproof {

namespace engine_index {

namespace {

void add_counts(const Element& main, const EnginePageInput& input) {
  const Element section = add_section(main, "table", "Right answers, by class of scenes");
  section.add("p", "how")
      .text(
          "Of the scenes that the engine supports. A class opens its scenes, and a scene its picture, its exact "
          "motions and what each engine says.");
  ReportTable table{{"engine", "asked", {"all", true}}};
  table.label = "Right answers by engine and class";
  table.css_class = "solvers engines";
  for (const std::string& name : input.classes) {
    table.columns.emplace_back(ReportLine(link_to(class_title(name), name + ".html")), true);
  }
  for (const EngineRow& row : input.rows) {
    std::vector<ReportCell> cells{row.engine + " " + row.version, row.asked,
                                  input.with_design(row.engine, share_text(row.all))};
    for (const std::string& name : input.classes) {
      const auto found = row.classes.find(name);
      cells.emplace_back(found == row.classes.end() ? "–" : share_text(found->second));
    }
    table.row(std::move(cells));
  }
  add_table(section, table);
}

/// How far off the thresholds of each engine are.
void add_thresholds(const Element& main, const EnginePageInput& input) {
  std::map<std::pair<std::string, std::string>, std::vector<double>> off;
  std::string page;
  for (const EngineThresholdRow& row : input.thresholds) {
    if (page.empty()) page = row.scene.substr(0, row.scene.find('/')) + ".html";
    auto& engine = off[{row.engine, row.asked}];
    if (row.exact) engine.push_back(row.off());
  }
  if (off.empty()) return;
  const Element section = add_section(main, "changes", "Where engines change their minds");
  add_line(section.add("p", "how"),
           {"A parameter is varied until a body begins to move in the engine; how far is that from the exact value? "
            "An engine that creeps at rest by more than a hundredth of the scene's natural acceleration has none. ",
            link_to("Scene by scene", page + "#changes"), "."});
  ReportTable table{{"engine", "asked", {"thresholds", true}, {"to 1e-6", true}, {"to 1e-3", true}, {"median", true}}};
  table.label = "Thresholds by engine";
  for (auto& [who, of_engine] : off) {
    std::vector<double>& errors = of_engine;
    std::ranges::sort(errors);
    const auto within = [&](double bound) {
      return std::to_string(std::ranges::count_if(errors, [&](double error) { return error <= bound; }));
    };
    table.row({who.first, who.second, input.with_design(who.first, std::to_string(errors.size())), within(1e-6),
               within(1e-3), errors.empty() ? "–" : error_text(errors[errors.size() / 2])});
  }
  add_table(section, table);
}

/// What engines say over many steps: of each the median over the scenes, and the largest.
struct OverSteps {
  const char *id, *title, *how, *label;
  std::map<std::string, double> EngineAnswer::*values;
  std::vector<std::string> steps;
};

void add_over_steps(const Element& main, const EnginePageInput& input, const OverSteps& about) {
  std::map<std::string, std::map<std::string, std::vector<double>>> found;
  for (const EngineScene& scene : input.judged().scenes) {
    for (const JudgedEngineAnswer& one : scene.answers) {
      for (const auto& [steps, value] : one.answer.*about.values) found[one.answer.engine][steps].push_back(value);
    }
  }
  if (found.empty()) return;
  const Element section = add_section(main, about.id, about.title);
  section.add("p", "how").text(about.how);
  ReportTable table{{"engine", {"scenes", true}}};
  table.label = about.label;
  table.css_class = "engines";
  for (const std::string& steps : about.steps)
    table.columns.emplace_back(steps + (steps == "1" ? " step" : " steps"), true);
  for (auto& [engine, by_steps] : found) {
    std::vector<ReportCell> cells{engine, input.with_design(engine, std::to_string(by_steps.begin()->second.size()))};
    for (const std::string& steps : about.steps) {
      std::vector<double>& values = by_steps[steps];
      std::ranges::sort(values);
      cells.emplace_back(values.empty() ? "–"
                                        : error_text(values[values.size() / 2]) + "; " + error_text(values.back()));
    }
    table.row(std::move(cells));
  }
  add_table(section, table);
}

void add_drift(const Element& main, const EnginePageInput& input) {
  add_over_steps(
      main, input,
      {"drift",
       "What creeps that should rest",
       "Scenes in space whose one motion is rest, at default settings: how far a body is after so many steps "
       "from where it began, over the size of the scene; the median over the scenes, and the largest.",
       "Drift by engine",
       &EngineAnswer::drift,
       {"1", "10", "100"}});
}

void add_energy(const Element& main, const EnginePageInput& input) {
  add_over_steps(
      main, input,
      {"energy",
       "Does energy rise where nothing drives?",
       "Scenes in space without pushes, under gravity straight down: what rests, slides until it rests, rolls, "
       "spins or flies, at default settings. By the laws of motion, kinetic and potential energy together "
       "never rise. In the engine they rose at most by this within so many steps, above an earlier step or "
       "the start, over the energy at the start and what lifts all bodies by the size; the median over the "
       "scenes, and the largest.",
       "Rise of energy by engine",
       &EngineAnswer::energy,
       {"1", "10", "100", "1000"}});
}

/// By which law impacts are right, and where energy is gained.
void add_impacts(const Element& main, const EnginePageInput& input) {
  const std::vector<EngineImpactRow> rows = engine_impacts(input.judged());
  if (rows.empty()) return;
  const Element section = add_section(main, "impacts", "Impacts: right by which law, and does energy grow?");
  section.add("p", "how")
      .text(
          "Contacts approach, and the engine makes one step. Its velocities are held against all outcomes by each law; "
          "an answer may be right by several, which often agree. Energy grows where it is more than a thousandth above "
          "that before.");
  ReportTable table{{"engine", "asked", {"scenes", true}}};
  table.label = "Impacts by engine";
  table.css_class = "engines";
  for (const ImpactLaw law : judged_laws) table.columns.emplace_back("right by " + std::string(name(law)), true);
  table.columns.emplace_back("by none", true);
  table.columns.emplace_back("gains energy", true);
  table.columns.emplace_back("at most", true);
  for (const EngineImpactRow& row : rows) {
    std::vector<ReportCell> cells{row.engine, row.asked, std::to_string(row.scenes)};
    for (const std::size_t right : row.right) cells.emplace_back(std::to_string(right));
    cells.push_back(input.with_design(row.engine, std::to_string(row.by_no_law)));
    cells.emplace_back(std::to_string(row.gains));
    cells.emplace_back(row.most ? fmt::format("{:+.3g} %", 100 * *row.most) : "–");
    table.row(std::move(cells));
  }
  add_table(section, table);
}

void add_laws(const Element& main, const EnginePageInput& input) {
  const Element section = add_section(main, "laws", "What each engine solves");
  section.add("p", "how")
      .text(
          "In the words of its adapter; an engine that softens contacts solves another law, and is asked about that "
          "one here.");
  ReportTable table{{"engine", "law", "asked on", "differs on purpose"}};
  table.label = "Laws of engines";
  std::string last;
  for (const EngineRow& row : input.rows) {
    if (row.engine != last) {
      table.row({row.engine + " " + row.version, row.law, row.date, row.design});
    }
    last = row.engine;
  }
  add_table(section, table);
}

void add_reproduce(const Element& main, const EnginePageInput& input) {
  const Element section = add_section(main, "reproduce", "Ask again");
  section.add("pre")
      .set("tabindex", 0)
      .add("code")
      .text(fmt::format("./run engines\nslipproof report {} --out REPORT", input.folder));
}

/// Every scene, to be searched.
void add_scenes(const Element& main, const EnginePageInput& input) {
  const Element section = add_section(main, "scenes", "Every scene");
  add_search(section, "all-scenes", "Search scenes: words of their names, questions and threads");
  const Element folded = section.add("details", "data").set("id", "all-scenes").set("open", "open");
  folded.add("summary").text(fmt::format("{} scenes", input.judged().scenes.size()));
  const Element list = folded.add("ul", "scene-list");
  for (const EngineScene& scene : input.judged().scenes) {
    const Element item = list.add("li", "item");
    item.add("a").set("href", scene.name + ".html").text(scene.scene.name);
    item.text(" " + scene.scene.question + " ");
    item.add("small").text(class_title(scene.class_name()) +
                           (scene.scene.asked.empty() ? "" : ", " + scene.scene.asked));
  }
}

}  // namespace

}  // namespace engine_index

void add_engines_index(const Element& main, const EnginePageInput& input) {
  const Element top =
      add_title(main, fmt::format("{} scenes, {} engines", input.judged().scenes.size(), input.judged().engines.size()),
                "What physics engines answer where the truth is known");
  top.add("p", "lead")
      .text(
          "Each scene is at rest, or in a state of motion that it names, and is pushed. The first step of an engine "
          "then says an acceleration of each body, and slipproof knows all motions that the scene has, in exact "
          "numbers. Right is an answer within a thousandth of the largest acceleration from one of them, near one "
          "within a hundredth; wrong is everything else. Where a scene has no motion, every answer is wrong.");
  add_key(top);
  engine_index::add_counts(main, input);
  engine_index::add_thresholds(main, input);
  engine_index::add_drift(main, input);
  engine_index::add_energy(main, input);
  engine_index::add_impacts(main, input);
  engine_index::add_laws(main, input);
  engine_index::add_scenes(main, input);
  engine_index::add_reproduce(main, input);
}

}  // namespace slipproof
