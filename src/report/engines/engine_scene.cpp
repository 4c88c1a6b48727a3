#include <fmt/format.h>

#include "report/engines/engine_sections.hpp"
#include "report/explorer/explorer_page.hpp"
#include "report/html/sections.hpp"
#include "report/picture/mechanism_svg.hpp"
#include "report/picture/space/space_svg.hpp"
#include "report/picture/space/space_view.hpp"
#include "report/picture/velocities/impact_svg.hpp"
#include "report/scenes/impact_report.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "report/scenes/space_report.hpp"

namespace slipproof {

namespace engine_scene {

namespace {

Document document_of(const ExpectedAnswer& answer) {
  return solve_document(answer.solved, answer.every_q, 6);
}
Document document_of(const ExpectedInSpace& answer) {
  Document document = space_document(answer.solved, 6);
  const auto say = [&](const std::optional<bool>& known, const char* yes, const char* no) {
    if (known) document.paragraph(*known ? yes : no);
  };
  say(answer.can_rest, "Forces can hold it at rest.", "No forces hold it at rest.");
  if (answer.can_rest == true) say(answer.must_rest, "It must rest.", "It need not rest: there is another motion.");
  return document;
}

void add_picture(const Element& top, const EnginePageInput&, const EngineScene& scene, const ExpectedAnswer& answer) {
  const auto& found = answer.solved.at_load;
  const MotionAtLoad* first = found && !found->motions.empty() ? &found->motions.front() : nullptr;
  if (!has_picture(scene.scene.mechanism)) return;
  const Element figure = top.add("figure", "plot");
  add_mechanism(figure, scene.scene, first, scene.scene.name);
  figure.add("figcaption").text(first ? "With the forces of its first motion." : "It has no motion.");
}
/// A file beside the page; on a narrow screen it is scrolled.
void add_picture(const Element& top, const EnginePageInput& input, const EngineScene& scene, const std::string& svg,
                 const std::string& caption) {
  input.write(scene.name + ".svg", svg);
  const Element figure = top.add("figure", "plot").set("tabindex", 0);
  figure.add("img").set("src", scene.name.substr(scene.name.find('/') + 1) + ".svg").set("alt", scene.scene.name);
  figure.add("figcaption").text(caption);
}
void add_picture(const Element& top, const EnginePageInput& input, const EngineScene& scene,
                 const ExpectedInSpace& answer) {
  add_picture(top, input, scene, space_motions_svg_file(answer.solved, view_direction(usual_view)),
              "All motions, each with its forces.");
}
void add_picture(const Element& top, const EnginePageInput& input, const EngineScene& scene,
                 const ExpectedImpact& impact) {
  const SolvedImpact& own = impact.laws.front();
  add_picture(top, input, scene, impact_svg_file(own, view_direction(usual_view)),
              "Before and after, by " + own.law_words() + ".");
}

template <class Answer>
void add_exact(const Element& main, const Answer& answer) {
  add_document(add_section(main, "exact", "Every motion, exactly"), document_of(answer).as_part());
}
void add_exact(const Element& main, const ExpectedImpact& impact) {
  const Element section = add_section(main, "exact", "Every outcome, by each law");
  for (const SolvedImpact& solved : impact.laws) {
    section.add("h3").text("By " + solved.law_words());
    add_document(section, impact_document(solved, 6).as_part());
  }
}

void add_answers(const Element& main, const EnginePageInput& input, const EngineScene& scene) {
  const Element section = add_section(main, "engines", "What engines say");
  const bool answers_impact = scene.scene.mechanism.impact.has_value();
  ReportTable table{{"engine", "asked", "verdict", answers_impact ? "velocities after" : "accelerations", "settings"}};
  table.label = "Answers of engines";
  for (const JudgedEngineAnswer& one : scene.answers) {
    const EngineAnswer& answer = one.answer;
    const bool off = one.verdict == EngineVerdict::near || one.verdict == EngineVerdict::wrong;
    const bool is_judged = !answer.threshold && answer.drift.empty() && answer.energy.empty();
    const ReportCell verdict = is_judged ? verdict_cell(one, "") : ReportCell("");
    table.row({answer.engine + " " + answer.version, answer.asked,
               off ? input.with_design(answer.engine, verdict) : verdict, answer_text(answer) + impact_text(one),
               ReportLine(code(answer.settings))});
  }
  add_table(section, table);
  section.add("p", "how").text("Ask an engine again, and judge what it has answered:");
  section.add("pre")
      .set("tabindex", 0)
      .add("code")
      .text(
          fmt::format("./run engines ENGINE --only {1} --no-thresholds\n"
                      "grep '\"{1}\"' {0}/answers/ENGINE.jsonl | sed -n 's/.*\"motion\": \\({{[^}}]*}}\\).*/\\1/p' |\n"
                      "  slipproof certify --scene {0}/scenes/{1}.toml -",
                      input.folder, scene.name));
}

}  // namespace

}  // namespace engine_scene

void add_scene_page(const Element& main, const EnginePageInput& input, std::size_t index) {
  const EngineScene& scene = input.judged().scenes[index];
  const Expected& expected = input.results.expected[index];
  const Element top = add_title(main, class_title(scene.class_name()), scene.scene.name);
  if (!scene.scene.question.empty()) top.add("p", "lead").text(scene.scene.question);
  if (!scene.scene.asked.empty()) top.add("p", "how").text("Asked: " + scene.scene.asked + ".");
  std::visit([&](const auto& answer) { engine_scene::add_picture(top, input, scene, answer); }, expected);
  if (!input.explorer.empty() && scene.scene.mechanism.dimension == 2) {
    const std::string link = explorer_link("../" + input.explorer, scene.scene);
    top.add("p", "explore").add("a").set("href", link).text(explorer_words);
  }
  std::visit([&](const auto& answer) { engine_scene::add_exact(main, answer); }, expected);
  engine_scene::add_answers(main, input, scene);
}

}  // namespace slipproof
