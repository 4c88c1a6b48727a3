#include "report/html/contact_report.hpp"

#include <filesystem>

#include "base/number/format.hpp"
#include "report/html/contact_card.hpp"
#include "report/html/sections.hpp"
#include "report/scenes/contact_words.hpp"

namespace slipproof {

namespace {

std::string title_of(const JudgedProblem& problem) {
  const std::string& title = problem.problem.title;
  return title.empty() ? std::filesystem::path(problem.file).filename().string() : title;
}

std::string form_words(ProblemForm form) {
  switch (form) {
    case ProblemForm::complementarity:
      return "a linear complementarity problem";
    case ProblemForm::global:
      return "friction with the bodies' own equations of motion";
    default:
      return "friction between bodies, by their Delassus matrix";
  }
}

std::string size_words(const JudgedProblem& problem) {
  const MixedProblem& mixed = problem.mixed;
  std::string text = counted(mixed.contacts(), "contact") + " in dimension " + std::to_string(mixed.dimension);
  if (mixed.free > 0) text += ", " + counted(mixed.free, "unknown") + " besides";
  return text + "; " + std::to_string(mixed.A.entries()) + " entries of matrices";
}

std::vector<std::pair<std::string, std::string>> links_of(const JudgedProblem& problem) {
  std::vector<std::pair<std::string, std::string>> links{{"#overview", "Overview"}};
  const std::size_t answers = problem.answers.size();
  for (std::size_t i = 0; answers <= 8 && i < answers; ++i) {
    const std::string number = std::to_string(i + 1);
    links.emplace_back("#answer-" + number, answers == 1 ? "Answer" : "Answer " + number);
  }
  if (!problem.problem.remarks.empty()) links.emplace_back("#remarks", "The file");
  links.emplace_back("#reproduce", "Reproduce");
  return links;
}

void add_contact_overview(const Element& main, const JudgedProblem& problem) {
  const Element section = main.add("section", "overview").set("id", "overview").set("aria-labelledby", "title");
  section.add("p", "kicker").text("A contact problem, and what is proved about its answers");
  section.add("h1").set("id", "title").add("bdi").text(title_of(problem));
  Document facts;
  facts.fact("file", problem.file);
  facts.fact("form", form_words(problem.problem.form));
  facts.fact("size", size_words(problem));
  add_document(section, facts);
  if (problem.answers.size() == 1) return;
  const Element list = section.add("ol", "headlines");
  for (std::size_t i = 0; i < problem.answers.size(); ++i) {
    const Element item = list.add("li");
    add_contact_chip(item, problem.answers[i].judgement.verdict);
    item.text(" ");
    item.add("a").set("href", "#answer-" + std::to_string(i + 1)).add("bdi").text(problem.answers[i].origin);
    item.text(": " + verdict_words(problem.answers[i].judgement));
  }
}

void add_remarks(const Element& main, const JudgedProblem& problem) {
  if (problem.problem.remarks.empty()) return;
  const Element section = add_section(main, "remarks", "Remarks about the file");
  section.add("p", "how").text("What the file says, or what reading it showed. The verdicts do not rely on it.");
  const Element list = section.add("ul");
  for (const std::string& remark : problem.problem.remarks) list.add("li").text(remark + ".");
}

void add_contact_reproduce(const Element& main, const std::string& command) {
  const Element section = add_section(main, "reproduce", "Reproduce");
  section.add("p", "lead")
      .text(
          "The same file, options and version give the same verdicts. Bounds are rounded in their safe direction: an "
          "upper one up, a lower one down.");
  section.add("pre").set("tabindex", 0).add("code").text(command);
}

}  // namespace

std::string contact_report(const JudgedProblem& problem, const std::string& command, const std::string& version) {
  const std::string program = version.empty() ? "slipproof" : "slipproof " + version;
  const std::string footer =
      "Made by " + program + ". Numbers of the problem are taken as they stand in its file, exactly.";
  return framed({"slipproof: " + title_of(problem), version, links_of(problem), footer}, [&](const Element& main) {
    add_contact_overview(main, problem);
    for (std::size_t i = 0; i < problem.answers.size(); ++i) add_contact_card(main, problem, i);
    add_remarks(main, problem);
    add_contact_reproduce(main, command);
  });
}

}  // namespace slipproof
