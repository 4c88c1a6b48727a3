#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "page/sections.hpp"
#include "report/errata.hpp"
#include "report/verify_report.hpp"
#include "typeset/latex.hpp"

namespace slipproof {

namespace {

constexpr std::array<std::string_view, 5> claim_verdicts{"proved", "holds", "refuted", "undecided", "vacuous"};
using VerdictCounts = std::array<std::size_t, claim_verdicts.size()>;

struct Counts {
  VerdictCounts printed{}, repaired{};
  std::size_t claims = 0;
};

Counts count(const PageInput& input) {
  Counts counts;
  for (const ClaimResult& result : input.result->claims) {
    const auto at =
        std::find(claim_verdicts.begin(), claim_verdicts.end(), verdict_name(result)) - claim_verdicts.begin();
    if (result.reading == Reading::printed) {
      ++counts.claims;
      ++counts.printed[static_cast<std::size_t>(at)];
    } else {
      ++counts.repaired[static_cast<std::size_t>(at)];
    }
  }
  return counts;
}

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

/// One bar cut in proportion to its counts, with its numbers written out below.
void add_bar(const Element& parent, std::string_view label, const VerdictCounts& counts) {
  std::size_t all = 0;
  for (const std::size_t n : counts) all += n;
  if (all == 0) return;
  const Element row = parent.add("div", "bar-row");
  row.add("span", "bar-label").text(label);
  const Element svg = row.add("svg", "bar").set("viewBox", "0 0 600 22").set("preserveAspectRatio", "none");
  svg.set("aria-hidden", "true");
  double x = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double width = 600.0 * static_cast<double>(counts[i]) / static_cast<double>(all);
    if (counts[i] == 0) continue;
    svg.add("rect", "fill-" + std::string(claim_verdicts[i])).set("x", x).set("width", width).set("height", 22);
    x += width;
  }
  const Element text = row.add("span", "bar-text");
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const Element item = text.add("span", "bar-item");
    add_chip(item, claim_verdicts[i]);
    item.text(" " + std::to_string(counts[i]));
  }
}

std::string findings_detail(const std::vector<Finding>& findings) {
  std::array<std::size_t, 4> grades{};
  for (const Finding& finding : findings) ++grades[static_cast<std::size_t>(finding.grade)];
  std::string text;
  const std::array<std::pair<Grade, std::string_view>, 4> names{{{Grade::wrong, "false statement"},
                                                                 {Grade::misprint, "misprint"},
                                                                 {Grade::gap, "gap"},
                                                                 {Grade::boundary, "boundary case"}}};
  for (const auto& [grade, noun] : names) {
    const std::size_t n = grades[static_cast<std::size_t>(grade)];
    if (n > 0) text += (text.empty() ? "" : ", ") + counted(n, noun);
  }
  return text;
}

/// False statements first: what the authors would want to know.
void add_headlines(const Element& section, const PageInput& input, const std::vector<Finding>& findings) {
  const auto wrong = [](const Finding& f) { return f.grade == Grade::wrong; };
  if (std::none_of(findings.begin(), findings.end(), wrong)) return;
  section.add("h2", "sub").text("What is false");
  const Element list = section.add("ul", "headlines");
  for (const Finding& finding : findings) {
    if (!wrong(finding)) continue;
    const Element item = list.add("li");
    add_claim_id(item, input, finding.id);
    item.text(", line " + std::to_string(finding.line) + ": ");
    add_sentence(item.add("q"), finding.statement);
  }
}

std::size_t count(const std::vector<PageCertificate>& certificates, CertificateState state) {
  return static_cast<std::size_t>(
      std::count_if(certificates.begin(), certificates.end(), [&](const auto& c) { return c.state == state; }));
}

/// `3 undecided, 1 missing`.
std::string not_accepted(const std::vector<PageCertificate>& certificates) {
  using enum CertificateState;
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

}  // namespace

void add_overview(const Element& main, const PageInput& input) {
  const Element section = main.add("section", "overview").set("id", "overview").set("aria-labelledby", "title");
  const ClaimsFile& file = *input.claims;
  section.add("p", "kicker").text("Every claim of one paper, held against exact mechanics");
  section.add("h1").set("id", "title").text(file.paper.title);
  std::string authors;
  for (const std::string& author : file.paper.authors) authors += (authors.empty() ? "" : ", ") + author;
  if (!authors.empty()) section.add("p", "authors").text(authors);

  const Counts counts = count(input);
  const std::size_t fail = counts.printed[2], open = counts.printed[3];
  const std::size_t mended = counts.repaired[0] + counts.repaired[1];
  const std::vector<Finding> findings = errata(file, *input.result);
  const Element cards = section.add("ul", "cards");
  add_card(cards, "plain", counts.claims, "claims judged", "each as printed, and as repaired where it was misprinted",
           "#claims");
  add_card(cards, "good", counts.printed[0] + counts.printed[1], "hold as printed",
           proved_share(counts.printed[0], counts.printed[1]) + " proved for all parameters", "#claims");
  add_card(cards, "bad", fail, "refuted as printed",
           open > 0 ? std::to_string(open) + " more have no value as printed" : "with exact counterexamples",
           "#claims");
  add_card(cards, "good", mended, "hold as repaired",
           proved_share(counts.repaired[0], counts.repaired[1]) + " proved for all parameters, " +
               std::to_string(counts.repaired[2]) + " false in every reading",
           "#claims");
  add_card(cards, "bad", findings.size(), "findings", findings_detail(findings), "#errata");
  if (!input.certificates.empty()) {
    const std::size_t accepted = count(input.certificates, CertificateState::accepted);
    const bool all = accepted == input.certificates.size();
    add_card(cards, all ? "good" : "bad", accepted, "certificates accepted",
             all ? "all, by a checker of its own" : not_accepted(input.certificates), "#certificates");
  }
  if (input.opinions) add_opinions_card(cards, *input.opinions);
  const Element columns = section.add("div", "halves");
  const Element verdicts_half = columns.add("div");
  const Element bars = verdicts_half.add("div", "bars");
  add_bar(bars, "as printed", counts.printed);
  add_bar(bars, "as repaired", counts.repaired);
  add_headlines(verdicts_half, input, findings);
  if (input.trade && !input.trade->workloads.empty()) {
    const Element figure = columns.add("figure", "glance");
    figure.add("h2", "sub").add("a").set("href", "#trade").text("Speed and wrong verdicts");
    add_trade_plot(figure, *input.trade, false, true);
  }

  const Summary worst = summary(file, *input.result);
  const Element how = section.add("p", "how");
  how.text(worst == Summary::as_expected ? "Every verdict is the one that the claims file expects. "
                                         : "Some verdicts are not those that the claims file expects. ");
  how.text("Made from " + std::to_string(input.result->samples) + " rational bicycles for each setting and " +
           std::to_string(input.result->lines) + " lines of bicycles for each claim, seed " +
           std::to_string(input.result->seed) + ", slipproof " + input.version + ", by ");
  how.add("code").text(input.command);
  how.text("; ").add("a").set("href", "#reproduce").text("inputs and their SHA-256");
  how.text(".");
}

}  // namespace slipproof
