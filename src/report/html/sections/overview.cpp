#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "report/html/headline.hpp"
#include "report/html/sections.hpp"
#include "report/html/verdict_bar.hpp"
#include "report/markup/latex.hpp"
#include "report/papers/errata.hpp"
#include "report/papers/explain.hpp"
#include "report/papers/verify_report.hpp"
#include "report/picture/mechanism_svg.hpp"

namespace slipproof {

namespace {

void add_card(const Element& list, const char* css_class, std::size_t number, std::string_view what,
              const std::string& detail, const char* target) {
  const Element card = list.add("li", "card").add("a", css_class).set("href", target);
  card.add("span", "number").text(std::to_string(number));
  card.add("span", "what").text(what);
  card.add("span", "detail").text(detail);
}

void add_opinions_card(const Element& list, const SecondOpinions& opinions) {
  std::string detail;
  for (std::size_t i = 0; i < opinion_programs.size(); ++i) {
    const std::size_t agree = agreeing(opinions, i);
    if (agree == 0) continue;
    detail += (detail.empty() ? ": " : ", ") + std::string(opinion_programs[i]) + " " + std::to_string(agree);
  }
  const auto confirmed = std::count_if(opinions.begin(), opinions.end(), [](const auto& opinion) {
    return std::find(opinion.second.begin(), opinion.second.end(), Opinion::agrees) != opinion.second.end();
  });
  add_card(list, "good", static_cast<std::size_t>(confirmed), "with a second opinion that agrees",
           "statements confirmed by programs of others" + detail, "#certificates");
}

std::string mechanisms_in_words(const ClaimsFile& claims) {
  std::vector<std::string> names;
  for (const Setting& setting : claims.settings) {
    const std::string& name = setting.mechanism->name;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return "Bodies in contact with dry friction: " + text + ". What does each contact do: stick, slip, or open?";
}

/// The subject of the page, for readers who know neither the paper nor the model.
void add_problem(const Element& section, const PageInput& input) {
  const Element columns = section.add("div", "halves");
  const Element text = columns.add("div", "problem");
  const bool bicycles = noun(*input.claims) == "bicycle";
  const std::string& question = input.claims->paper.question;
  text.add("h2", "sub").text(question.empty() ? "The problem" : "The question");
  const Element asked = text.add("p");
  if (!question.empty()) {
    add_prose(asked, *input.claims, question);
  } else {
    asked.text(bicycles ? "A vehicle with two wheels, seen from the side, stands on a road with dry friction, and "
                          "a force acts on its pedal. What does each wheel do: roll, slip, or leave the road?"
                        : mechanisms_in_words(*input.claims));
  }
  text.add("p").text(
      "For given parameters and a given load, each combination of these states is a system of linear equations with "
      "conditions that its solution has to meet. Here all of them are solved in exact arithmetic, and each claim is "
      "compared with the solutions: at sampled parameters, for every load at once, and, where there is a proof, for "
      "all parameters.");
  if (!input.model || !bicycles) return;
  const Element figure = columns.add("figure", "model").set("tabindex", 0);
  add_mechanism(figure, *input.model, nullptr, "The bicycle of the model with its signs and symbols");
  figure.add("figcaption")
      .text("Arrows point where a quantity counts as positive: the pedal force F pulls the lower pedal backwards.");
  if (const std::string link = link_to_explorer(input, *input.model); !link.empty()) {
    figure.add("p", "explore").add("a").set("href", link).text(explorer_words);
  }
}

/// The grades, the most serious first, and the words for their findings.
struct GradeWords {
  Grade grade;
  std::string_view noun, heading;
};
constexpr std::array<GradeWords, 4> grade_words{{{Grade::wrong, "false statement", "What is false"},
                                                 {Grade::gap, "gap", "What is left out"},
                                                 {Grade::boundary, "boundary case", "Ends that are not right"},
                                                 {Grade::misprint, "misprint", "What is misprinted"}}};

std::string findings_detail(const std::vector<Finding>& findings) {
  std::string text;
  for (const GradeWords& words : grade_words) {
    const auto n =
        std::count_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.grade == words.grade; });
    if (n > 0) text += (text.empty() ? "" : ", ") + counted(static_cast<std::size_t>(n), words.noun);
  }
  return text;
}

/// A false statement in full: authors would want to read it first.
void add_false(const Element& list, const PageInput& input, const Finding& finding) {
  const Element item = list.add("li");
  add_claim_id(item, input, finding.id);
  item.text(", " + input.claims->paper.where(finding.line) + (finding.graded ? "" : ", no grade is given") + ": ");
  add_sentence(item.add("q"), finding.statement);
  item.add("br");
  add_prose(item.add("span", "because"), *input.claims, sentence(finding.wrong));
}

/// The findings in words, and how their numbers add up.
void add_findings(const Element& section, const PageInput& input, const Errata& errata) {
  section.add("h2", "sub").text("What was found");
  section.add("p").text(standing_text(errata) + " " + sum_text(errata));
  for (const GradeWords& words : grade_words) {
    std::vector<const Finding*> here;
    for (const Finding& f : errata.findings) {
      if (f.grade == words.grade) here.push_back(&f);
    }
    if (here.empty()) continue;
    if (words.grade == Grade::wrong) {
      section.add("h3", "sub").text(words.heading);
      const Element list = section.add("ul", "headlines");
      for (const Finding* finding : here) add_false(list, input, *finding);
      continue;
    }
    const Element p = section.add("p");
    p.add("b").text(std::string(words.heading) + " (" + counted(here.size(), words.noun) + "): ");
    for (const Finding* finding : here) {
      if (finding != here.front()) p.text(", ");
      p.add("a").set("href", "#finding-" + finding->id).text(finding->id);
    }
    p.text(".");
  }
}

std::size_t count(const std::vector<PageCertificate>& certificates, CertificateState state) {
  return static_cast<std::size_t>(
      std::count_if(certificates.begin(), certificates.end(), [&](const auto& c) { return c.state == state; }));
}

/// `3 undecided, 1 missing`.
std::string not_accepted(const std::vector<PageCertificate>& certificates) {
  using enum check::Verdict;  // without the alias CertificateState, which clang 14 does not accept here
  std::string text;
  for (const CertificateState state : {rejected, unreadable, undecided, missing}) {
    const std::size_t n = count(certificates, state);
    if (n > 0) text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + std::string(to_string(state));
  }
  return text;
}

std::string proved_share(std::size_t proved, std::size_t sampled_only) {
  return proved > 0 && sampled_only == 0 ? "all" : std::to_string(proved) + " of them";
}

/// How many claims have each verdict, from the given one of claim_verdicts on: `20 refuted, 3 undecided`.
std::string listed_counts(const VerdictCounts& counts, std::size_t first) {
  std::string text;
  for (std::size_t i = first; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    text += (text.empty() ? "" : ", ") + std::to_string(counts[i]) + " " + std::string(claim_verdicts[i]);
  }
  return text;
}

/// The verdicts on claims as printed, and as repaired where there are repairs.
void add_printed_cards(const Element& cards, const VerdictTotals& counts) {
  const VerdictCounts &printed = counts.printed, &repaired = counts.repaired;
  const std::string open = listed_counts(printed, 3);
  add_card(cards, "plain", sum(printed), "claims as printed",
           sum(repaired) > 0 ? "and as repaired, where the print cannot be meant" : "", "#claims");
  add_card(cards, "good", printed[0] + printed[1], "hold as printed",
           proved_share(printed[0], printed[1]) + " proved for all parameters", "#claims");
  add_card(cards, "bad", printed[2], "refuted as printed",
           open.empty() ? "with exact counterexamples" : "beside them, " + open, "#claims");
  if (sum(repaired) == 0) return;
  add_card(cards, "good", repaired[0] + repaired[1], "hold as repaired",
           proved_share(repaired[0], repaired[1]) + " proved for all parameters, " + std::to_string(repaired[2]) +
               " false in every reading",
           "#claims");
}

void add_own_card(const Element& cards, const VerdictCounts& ours) {
  const std::string rest = listed_counts(ours, 2);
  add_card(
      cards,
      rest.empty()  ? "good"
      : ours[2] > 0 ? "bad"
                    : "plain",
      sum(ours), "claims of our own",
      proved_share(ours[0], sum(ours) - ours[0]) + " proved for all parameters" + (rest.empty() ? "" : ", " + rest),
      "#claims");
}

void add_cards(const Element& section, const PageInput& input, const Errata& errata, const VerdictTotals& counts) {
  const Element cards = section.add("ul", "cards");
  if (sum(counts.printed) > 0) add_printed_cards(cards, counts);
  if (sum(counts.ours) > 0) add_own_card(cards, counts.ours);
  if (sum(counts.printed) > 0 || !errata.findings.empty()) {
    add_card(cards, "bad", errata.findings.size(), errata.findings.size() == 1 ? "finding" : "findings",
             findings_detail(errata.findings), "#errata");
  }
  if (!input.certificates.empty()) {
    const std::size_t accepted = count(input.certificates, CertificateState::accepted);
    const bool all = accepted == input.certificates.size();
    add_card(cards, all ? "good" : "bad", accepted, "certificates accepted",
             !all                           ? not_accepted(input.certificates)
             : input.result->second_checker ? "all, by two checkers, one of them proved correct"
                                            : "all, by a checker of its own",
             "#certificates");
  }
  if (input.opinions) add_opinions_card(cards, *input.opinions);
}

void add_authors(const Element& section, const ClaimsFile& file) {
  const std::string authors = listed(file.paper.authors);
  if (authors.empty() && file.paper.reference.empty()) return;
  const Element p = section.add("p", "authors");
  p.text(authors + (authors.empty() || file.paper.reference.empty() ? "" : ", "));
  add_reference(p, file.paper.reference);
}

/// One sentence of what was found, and the picture of the worst finding.
void add_headline(const Element& section, const PageInput& input, const Errata& errata) {
  const ClaimsFile& file = *input.claims;
  if (!file.paper.found.empty()) add_prose(section.add("p", "headline"), file, file.paper.found);
  const ClaimResult* worst = worst_refuted(file, *input.result);
  if (worst == nullptr) return;
  const Claim& claim = file.claims[worst->claim];
  const Element figure = section.add("figure", "worst-finding");
  add_worst_motions(figure, *worst);
  const Element caption = figure.add("figcaption");
  add_claim_id(caption, input, claim.id);
  caption.text(", " + file.paper.where(claim.line) + ": ");
  add_sentence(caption.add("q"), claim.statement);
  caption.text(" ");
  // What the finding concedes belongs to it.
  const auto& findings = errata.findings;
  const auto finding =
      std::find_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.id == claim.id; });
  add_prose(caption, file, sentence(finding == findings.end() ? explain(file, *worst) : finding->wrong));
}

void add_how(const Element& section, const PageInput& input) {
  const Summary worst = summary(*input.claims, *input.result);
  const Element how = section.add("p", "how");
  how.text(input.result->claims.empty()    ? "No claim was judged. "
           : worst == Summary::as_expected ? "Every verdict is the one that the claims file expects. "
                                           : "Some verdicts are not those that the claims file expects. ");
  const std::string what(noun(*input.claims));
  how.text("Made from " + counted(input.result->samples, "rational " + what) + " for each setting and " +
           counted(input.result->lines, "line") + " of " + what + "s for each claim, seed " +
           std::to_string(input.result->seed) + ", by slipproof " + input.version + ": ");
  how.add("code").text(input.command);
  how.text(". ").add("a").set("href", "#reproduce").text("The inputs and their SHA-256");
  how.text(".");
  const Element print = section.add("label", "print-all switch");
  print.add("input").set("type", "checkbox").set("id", "print-all");
  print.text(" Print everything: each claim, proof and table, which takes hundreds of pages");
}

}  // namespace

void add_overview(const Element& main, const PageInput& input) {
  const Element section = main.add("section", "overview").set("id", "overview").set("aria-labelledby", "title");
  const ClaimsFile& file = *input.claims;
  section.add("p", "kicker")
      .text((file.paper.origin == Origin::ours ? "Claims of our own"
                                               : "Every claim of one " + std::string(kind_of_source(file))) +
            ", compared with exact mechanics");
  section.add("h1").set("id", "title").text(file.paper.title);
  add_authors(section, file);
  const Errata errata = slipproof::errata(file, *input.result);
  add_headline(section, input, errata);
  add_problem(section, input);
  add_findings(section, input, errata);
  const VerdictTotals counts = count_verdicts(file, *input.result);
  add_cards(section, input, errata, counts);
  const Element columns = section.add("div", "halves");
  const Element bars = columns.add("div", "bars");
  add_verdict_bar(bars, "as printed", counts.printed);
  add_verdict_bar(bars, "as repaired", counts.repaired);
  add_verdict_bar(bars, "of our own", counts.ours);
  if (input.trade && !input.trade->workloads.empty()) {
    const Element figure = columns.add("figure", "glance");
    figure.add("h2", "sub").add("a").set("href", "#trade").text("Speed and wrong verdicts");
    add_trade_plot(figure, *input.trade, false, true);
  }
  add_how(section, input);
}

}  // namespace slipproof
