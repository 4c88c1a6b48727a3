#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "report/engines/engine_sections.hpp"
#include "report/html/sections.hpp"

namespace slipproof {

namespace engine_class {

namespace {

std::string count_text(const SolvedSpace& solved) {
  if (std::ranges::any_of(solved.motions, &SpaceMotion::is_continuum)) return "continuum";
  return std::to_string(solved.motions.size()) + (solved.complete() ? "" : " or more");
}

/// `1, 1, 2 by newton, moreau, poisson`.
std::string count_text(const ExpectedImpact& impact) {
  std::string counts, laws;
  for (const SolvedImpact& solved : impact.laws) {
    counts +=
        (counts.empty() ? "" : ", ") + std::to_string(solved.outcomes.size()) + (solved.complete() ? "" : " or more");
    laws += (laws.empty() ? " by " : ", ") + std::string(name(solved.scene.mechanism.impact->law));
  }
  return counts + laws;
}

std::string motions_text(const Expected& expected) {
  if (const auto* impact = std::get_if<ExpectedImpact>(&expected)) return count_text(*impact);
  if (const auto* in_space = std::get_if<ExpectedInSpace>(&expected)) {
    return count_text(in_space->solved);
  }
  const MotionsAtLoad& found = *std::get<ExpectedAnswer>(expected).solved.at_load;
  const auto alone = std::ranges::count_if(found.motions, [](const auto& motion) { return motion.continua.empty(); });
  if (found.continua.empty()) return std::to_string(alone);
  return alone > 0 ? std::to_string(alone) + ", continuum" : "continuum";
}

const JudgedEngineAnswer* answer_of(const EngineScene& scene, const std::string& engine, const std::string& asked) {
  const auto found = std::ranges::find_if(scene.answers, [&](const JudgedEngineAnswer& one) {
    return one.answer.engine == engine && one.answer.asked == asked;
  });
  return found == scene.answers.end() ? nullptr : &*found;
}

std::vector<const EngineScene*> scenes_of(const EnginePageInput& input, const std::string& name) {
  std::vector<const EngineScene*> scenes;
  for (const EngineScene& scene : input.judged().scenes) {
    if (scene.class_name() == name) scenes.push_back(&scene);
  }
  return scenes;
}

/// A small sign for each scene, in the order of the list below: engines in rows, which wrap on a narrow screen.
void add_strips(const Element& main, const EnginePageInput& input, const std::string& name, const std::string& asked,
                const std::string& heading) {
  const Element section = add_section(main, asked == "default" ? "answers" : "iterated", heading);
  add_key(section);
  const auto scenes = scenes_of(input, name);
  ReportTable table{{"engine", "right", "scenes, each a link"}};
  table.label = "Scenes by engine: " + asked;
  table.css_class = "engines";
  for (const std::string& engine : input.judged().engines) {
    EngineCounts counts{};
    std::vector<std::pair<const EngineScene*, const JudgedEngineAnswer*>> given;
    for (const EngineScene* scene : scenes) {
      const JudgedEngineAnswer* answer = answer_of(*scene, engine, asked);
      if (answer == nullptr) continue;
      given.emplace_back(scene, answer);
      ++counts[static_cast<std::size_t>(answer->verdict)];
    }
    if (given.empty() || counts[static_cast<std::size_t>(EngineVerdict::refused)] == given.size()) continue;
    const auto strip = [given](const Element& cell) {
      const Element line = cell.add("span", "strip");
      for (const auto& [scene, answer] : given) {
        const Element link = line.add("a").set("href", scene->name + ".html#engines");
        link.set("title", scene->scene.name + ": " + verdict_words(*answer));
        add_sign(link, answer->verdict);
      }
    };
    table.row({engine, input.with_design(engine, share_text(counts)), drawn("", strip)});
  }
  add_table(section, table);
}

/// The scenes of a class, with how many engines are right.
void add_list(const Element& main, const EnginePageInput& input, const std::string& name) {
  const Element section = add_section(main, "scenes", "The scenes");
  add_search(section, "scene-list", "Search scenes");
  const Element list = section.add("ul", "scene-list").set("id", "scene-list");
  for (std::size_t i = 0; i < input.judged().scenes.size(); ++i) {
    const EngineScene& scene = input.judged().scenes[i];
    if (scene.class_name() != name) continue;
    EngineCounts counts{};
    for (const JudgedEngineAnswer& one : scene.answers) {
      if (one.answer.asked == "default") ++counts[static_cast<std::size_t>(one.verdict)];
    }
    const Element item = list.add("li", "item");
    item.add("a").set("href", scene.name + ".html").text(scene.scene.name);
    item.text(" " + scene.scene.question + " ");
    item.add("small").text(
        fmt::format("motions: {}; right by default: {}", motions_text(input.results.expected[i]), share_text(counts)));
  }
}

/// Each threshold that an engine was asked for in a class, folded by scene.
void add_changes(const Element& main, const EnginePageInput& input, const std::string& name) {
  std::map<std::string, std::vector<const EngineThresholdRow*>> by_scene;
  for (const EngineThresholdRow& row : input.thresholds) {
    if (row.scene.starts_with(name + "/")) by_scene[row.scene].push_back(&row);
  }
  if (by_scene.empty()) return;
  const Element section = add_section(main, "changes", "Where engines change their minds");
  section.add("p", "how")
      .text(
          "What exceeds the floor counted as motion: a part of the scene's natural acceleration, the smallest above "
          "which the engine does not creep.");
  add_search(section, "thresholds", "Search thresholds");
  const Element all = section.add("div").set("id", "thresholds");
  for (const auto& [scene, rows] : by_scene) {
    const Element folded = all.add("details", "data item");
    const EngineThresholdRow& first = *rows.front();
    const std::string exact = first.exact ? fmt::format("{:.8g}", *first.exact) : "none";
    folded.add("summary").text(fmt::format("{}: {} = {}", scene.substr(name.size() + 1), first.found.parameter, exact));
    ReportTable table{{"engine", "asked", {"changes at", true}, {"off by", true}, {"floor", true}}};
    table.label = "Thresholds of engines: " + scene;
    for (const EngineThresholdRow* row : rows) {
      table.row({row->engine, row->asked, fmt::format("{:.8g}", row->found.changes_at),
                 row->exact ? error_text(row->off()) : "–",
                 row->found.floor ? fmt::format("{:g}", *row->found.floor) : "–"});
    }
    add_table(folded, table);
    folded.add("p").add("a").set("href", scene + ".html").text("The scene");
  }
}

}  // namespace

}  // namespace engine_class

void add_class_page(const Element& main, const EnginePageInput& input, const std::string& name) {
  add_title(main, "A class of scenes", class_title(name));
  engine_class::add_strips(main, input, name, "default", "What each engine says at its default settings");
  engine_class::add_strips(main, input, name, "many iterations", "And with many iterations");
  engine_class::add_list(main, input, name);
  engine_class::add_changes(main, input, name);
}

}  // namespace slipproof
