#include "report/engines/engine_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "report/document/document.hpp"
#include "report/engines/engine_cells.hpp"
#include "report/explorer/explorer_page.hpp"
#include "report/html/sections.hpp"
#include "report/picture/mechanism_svg.hpp"
#include "report/scenes/mechanism_report.hpp"

namespace slipproof {

namespace {

/// One of the pages, with what all of them share.
class EnginePages {
 public:
  EnginePages(const EngineResults& results, const std::string& folder, const std::string& version,
              const std::string& explorer, const PageSink& write)
      : results_(results),
        judged_(results.judged),
        classes_(engine_classes(judged_)),
        rows_(engine_rows(judged_)),
        thresholds_(engine_thresholds(results)),
        folder_(folder),
        version_(version),
        explorer_(explorer),
        write_(write) {}

  void write() {
    const std::string all = fmt::format("What {} physics engines answer to {} scenes whose motions are known exactly.",
                                        judged_.engines.size(), judged_.scenes.size());
    write_("index.html",
           page("Engines, tested against the truth", all, "", [&](const Element& main) { add_index(main); }));
    for (const std::string& name : classes_) {
      write_(name + ".html", page(class_title(name), all, "", [&](const Element& main) { add_class(main, name); }));
    }
    for (std::size_t i = 0; i < judged_.scenes.size(); ++i) {
      const EngineScene& scene = judged_.scenes[i];
      write_(scene.name + ".html", page(scene.scene.name, scene.scene.question, "../",
                                        [&](const Element& main) { add_scene(main, scene, results_.expected[i]); }));
    }
  }

 private:
  std::string page(const std::string& title, const std::string& description, const std::string& up,
                   const std::function<void(const Element&)>& fill) {
    std::vector<std::pair<std::string, std::string>> links{{up + "index.html", "Engines"}};
    for (const std::string& name : classes_) links.emplace_back(up + name + ".html", class_title(name));
    PageFrame frame{"slipproof: " + title, version_, std::move(links),
                    "Made by slipproof " + version_ + " from recorded answers. Each page says how to ask again."};
    frame.brand = up + "index.html";
    frame.description = description;
    return framed(frame, fill);
  }

  static Element add_title(const Element& main, const std::string& kicker, const std::string& title) {
    const Element section = main.add("section", "overview").set("id", "overview").set("aria-labelledby", "title");
    section.add("p", "kicker").text(kicker);
    section.add("h1").set("id", "title").text(title);
    return section;
  }

  void add_index(const Element& main) const {
    const Element top =
        add_title(main, fmt::format("{} scenes, {} engines", judged_.scenes.size(), judged_.engines.size()),
                  "What physics engines answer where the truth is known");
    top.add("p", "lead")
        .text(
            "Each scene is at rest, or in a state of motion that it names, and is pushed. The first step of an engine "
            "then says an acceleration of each body, and slipproof knows all motions that the scene has, in exact "
            "numbers. Right is an answer within a thousandth of the largest acceleration from one of them, near one "
            "within a hundredth; wrong is everything else. Where a scene has no motion, every answer is wrong.");
    add_key(top);
    add_counts(main);
    add_thresholds(main);
    add_laws(main);
    add_reproduce(main);
  }

  /// A number of an engine that differs from rigid contacts on purpose says so.
  ReportCell with_design(const std::string& engine, ReportCell cell) const {
    return judged_.designs.contains(engine) ? by_design(std::move(cell)) : cell;
  }

  static void add_key(const Element& top) {
    const Element list = top.add("p", "how");
    for (std::size_t i = 0; i < engine_verdict_count; ++i) {
      const auto verdict = static_cast<EngineVerdict>(i);
      add_verdict(list, verdict, name(verdict));
      list.text(" ");
    }
  }

  void add_counts(const Element& main) const {
    const Element section = add_section(main, "table", "Right answers, by class of scenes");
    section.add("p", "how")
        .text(
            "Of the scenes that the engine can have. A class opens its scenes, and a scene its picture, its exact "
            "motions and what each engine says.");
    ReportTable table{{"engine", "asked"}};
    table.label = "Right answers by engine and class";
    table.css_class = "solvers";
    for (const std::string& name : classes_) {
      table.columns.emplace_back(ReportLine(link_to(class_title(name), name + ".html")), true);
    }
    table.columns.emplace_back("all", true);
    table.columns.emplace_back("share");
    for (const EngineRow& row : rows_) {
      std::vector<ReportCell> cells{row.engine + " " + row.version, row.asked};
      for (const std::string& name : classes_) {
        const auto found = row.classes.find(name);
        cells.emplace_back(found == row.classes.end() ? "–" : share_text(found->second));
      }
      cells.push_back(with_design(row.engine, share_text(row.all)));
      cells.push_back(bar_cell(row.all));
      table.row(std::move(cells));
    }
    add_table(section, table);
  }

  /// How far off the thresholds of each engine are.
  void add_thresholds(const Element& main) const {
    std::map<std::pair<std::string, std::string>, std::vector<double>> off;
    std::string page;
    for (const EngineThresholdRow& row : thresholds_) {
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
    ReportTable table{
        {"engine", "asked", {"thresholds", true}, {"to 1e-6", true}, {"to 1e-3", true}, {"median", true}}};
    table.label = "Thresholds by engine";
    for (auto& [who, of_engine] : off) {
      std::vector<double>& errors = of_engine;
      std::ranges::sort(errors);
      const auto within = [&](double bound) {
        return std::to_string(std::ranges::count_if(errors, [&](double error) { return error <= bound; }));
      };
      table.row({who.first, who.second, with_design(who.first, std::to_string(errors.size())), within(1e-6),
                 within(1e-3), errors.empty() ? "–" : error_text(errors[errors.size() / 2])});
    }
    add_table(section, table);
  }

  /// Each threshold that an engine was asked for in a class.
  void add_changes(const Element& main, const std::string& name) const {
    ReportTable table{
        {"engine", "asked", "scene", "parameter", {"changes at", true}, {"exact", true}, {"off by", true}}};
    table.columns.emplace_back("floor", true);
    table.label = "Thresholds by engine and scene";
    for (const EngineThresholdRow& row : thresholds_) {
      if (!row.scene.starts_with(name + "/")) continue;
      table.row({row.engine, row.asked, ReportLine(link_to(row.scene.substr(name.size() + 1), row.scene + ".html")),
                 row.found.parameter, fmt::format("{:.8g}", row.found.changes_at),
                 row.exact ? fmt::format("{:.8g}", *row.exact) : "none", row.exact ? error_text(row.off()) : "–",
                 row.found.floor ? fmt::format("{:g}", *row.found.floor) : "–"});
    }
    if (table.rows.empty()) return;
    const Element section = add_section(main, "changes", "Where engines change their minds");
    section.add("p", "how")
        .text(
            "What exceeds the floor counted as motion: a part of the scene's natural acceleration, the smallest above "
            "which the engine does not creep.");
    add_table(section, table);
  }

  void add_laws(const Element& main) const {
    const Element section = add_section(main, "laws", "What each engine solves");
    section.add("p", "how")
        .text(
            "In the words of its adapter; an engine that softens contacts solves another law, and is asked about that "
            "one here.");
    ReportTable table{{"engine", "law", "asked on", "differs on purpose"}};
    table.label = "Laws of engines";
    std::string last;
    for (const EngineRow& row : rows_) {
      if (row.engine != last) {
        table.row({row.engine + " " + row.version, row.law, row.date, row.design});
      }
      last = row.engine;
    }
    add_table(section, table);
  }

  void add_reproduce(const Element& main) const {
    const Element section = add_section(main, "reproduce", "Ask again");
    section.add("pre")
        .set("tabindex", 0)
        .add("code")
        .text(fmt::format("./run engines\nslipproof report {} --out REPORT", folder_));
  }

  void add_class(const Element& main, const std::string& name) const {
    add_title(main, "A class of scenes", class_title(name));
    add_matrix(main, name, "default", "What each engine says at its default settings");
    add_matrix(main, name, "many iterations", "And with many iterations");
    add_changes(main, name);
  }

  /// Scenes in rows, engines in columns.
  void add_matrix(const Element& main, const std::string& name, const std::string& asked,
                  const std::string& heading) const {
    const Element section = add_section(main, asked == "default" ? "scenes" : "iterated", heading);
    add_key(section);
    ReportTable table{{"scene", {"motions", true}}};
    table.label = heading;
    for (const std::string& engine : judged_.engines)
      table.columns.emplace_back(ReportLine(with_design(engine, engine)));
    for (std::size_t i = 0; i < judged_.scenes.size(); ++i) {
      const EngineScene& scene = judged_.scenes[i];
      if (scene.class_name() != name) continue;
      const std::string href = scene.name + ".html";
      std::vector<ReportCell> cells{ReportLine(link_to(scene.scene.name, href)),
                                    motions_text(*results_.expected[i].solved.at_load)};
      for (const std::string& engine : judged_.engines) cells.push_back(cell_of(scene, engine, asked, href));
      table.row(std::move(cells));
    }
    add_table(section, table);
  }

  static std::string motions_text(const MotionsAtLoad& found) {
    const auto alone = std::ranges::count_if(found.motions, [](const auto& motion) { return motion.continua.empty(); });
    if (found.continua.empty()) return std::to_string(alone);
    return alone > 0 ? std::to_string(alone) + ", continuum" : "continuum";
  }

  static ReportCell cell_of(const EngineScene& scene, const std::string& engine, const std::string& asked,
                            const std::string& href) {
    const auto found = std::ranges::find_if(scene.answers, [&](const JudgedEngineAnswer& one) {
      return one.answer.engine == engine && one.answer.asked == asked;
    });
    return found == scene.answers.end() ? ReportCell("") : verdict_cell(*found, href + "#engines");
  }

  void add_scene(const Element& main, const EngineScene& scene, const ExpectedAnswer& answer) const {
    const Element top = add_title(main, class_title(scene.class_name()), scene.scene.name);
    if (!scene.scene.question.empty()) top.add("p", "lead").text(scene.scene.question);
    if (!scene.scene.asked.empty()) top.add("p", "how").text("Asked: " + scene.scene.asked + ".");
    const auto& found = answer.solved.at_load;
    const MotionAtLoad* first = found && !found->motions.empty() ? &found->motions.front() : nullptr;
    if (has_picture(scene.scene.mechanism)) {
      const Element figure = top.add("figure", "plot");
      add_mechanism(figure, scene.scene, first, scene.scene.name);
      figure.add("figcaption").text(first ? "With the forces of its first motion." : "It has no motion.");
    }
    if (!explorer_.empty()) {
      const std::string link = explorer_link("../" + explorer_, scene.scene);
      top.add("p", "explore").add("a").set("href", link).text(explorer_words);
    }
    const Element exact = add_section(main, "exact", "Every motion, exactly");
    add_document(exact, solve_document(answer.solved, answer.every_q, 6).as_part());
    add_answers(main, scene);
  }

  void add_answers(const Element& main, const EngineScene& scene) const {
    const Element section = add_section(main, "engines", "What engines say");
    ReportTable table{{"engine", "asked", "verdict", "accelerations", "settings"}};
    table.label = "Answers of engines";
    for (const JudgedEngineAnswer& one : scene.answers) {
      const EngineAnswer& answer = one.answer;
      const bool off = one.verdict == EngineVerdict::near || one.verdict == EngineVerdict::wrong;
      const ReportCell verdict = verdict_cell(one, "");
      table.row({answer.engine + " " + answer.version, answer.asked,
                 off ? with_design(answer.engine, verdict) : verdict, answer_text(answer),
                 ReportLine(code(answer.settings))});
    }
    add_table(section, table);
    section.add("p", "how").text("Ask an engine again, and judge what it has answered:");
    section.add("pre")
        .set("tabindex", 0)
        .add("code")
        .text(fmt::format(
            "./run engines ENGINE --only {1} --no-thresholds\n"
            "grep '\"{1}\"' {0}/answers/ENGINE.jsonl | sed -n 's/.*\"motion\": \\({{[^}}]*}}\\).*/\\1/p' |\n"
            "  slipproof certify --scene {0}/scenes/{1}.toml -",
            folder_, scene.name));
  }

  const EngineResults& results_;
  const JudgedEngines& judged_;
  const std::vector<std::string> classes_;
  const std::vector<EngineRow> rows_;
  const std::vector<EngineThresholdRow> thresholds_;
  const std::string& folder_;
  const std::string& version_;
  const std::string& explorer_;
  const PageSink& write_;
};

}  // namespace

void write_engine_pages(const EngineResults& results, const std::string& folder, const std::string& version,
                        const std::string& explorer, const PageSink& write) {
  EnginePages(results, folder, version, explorer, write).write();
}

}  // namespace slipproof
