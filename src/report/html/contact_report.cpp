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

void add_contact_header(const Element& body, const JudgedProblem& problem) {
  body.add("a", "skip").set("href", "#overview").text("Skip to the results");
  const Element header = body.add("header", "top");
  header.add("a", "brand").set("href", "#overview").text("slipproof");
  const Element list = header.add("nav").set("aria-label", "Sections").add("ul");
  const auto link = [&](const std::string& target, const std::string& text) {
    list.add("li").add("a").set("href", target).text(text);
  };
  link("#overview", "Overview");
  if (problem.answers.size() == 1) {
    link("#answer-1", "Answer");
  } else if (problem.answers.size() <= 8) {
    for (std::size_t i = 0; i < problem.answers.size(); ++i) {
      link("#answer-" + std::to_string(i + 1), "Answer " + std::to_string(i + 1));
    }
  }
  if (!problem.problem.remarks.empty()) link("#remarks", "The file");
  link("#reproduce", "Reproduce");
}

void add_contact_overview(const Element& main, const JudgedProblem& problem) {
  const Element section = main.add("section", "overview").set("id", "overview").set("aria-labelledby", "title");
  section.add("p", "kicker").text("A contact problem, and what is proved about its answers");
  section.add("h1").set("id", "title").add("bdi").text(title_of(problem));
  const Element facts = section.add("dl");
  const auto fact = [&](std::string_view term, const std::string& value) {
    facts.add("dt").text(term);
    facts.add("dd").text(value);
  };
  fact("file", problem.file);
  fact("form", form_words(problem.problem.form));
  fact("size", size_words(problem));
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
  const Document document("html");
  const Element html = document.root().set("lang", "en");
  const std::string program = version.empty() ? "slipproof" : "slipproof " + version;
  add_head(html, "slipproof: " + title_of(problem), version);
  const Element body = html.add("body");
  add_contact_header(body, problem);
  const Element main = body.add("main");
  add_contact_overview(main, problem);
  for (std::size_t i = 0; i < problem.answers.size(); ++i) add_contact_card(main, problem, i);
  add_remarks(main, problem);
  add_contact_reproduce(main, command);
  body.add("footer").add("p").text("Made by " + program +
                                   ". Numbers of the problem are taken as they stand in its file, exactly.");
  return document.html();
}

}  // namespace slipproof
