#include <algorithm>
#include <string>
#include <vector>

#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "claims/paper/setting_names.hpp"
#include "report/html/headline.hpp"
#include "report/html/sections.hpp"
#include "report/markup/latex.hpp"
#include "report/markup/mathml.hpp"

namespace slipproof {

namespace {

/// The definitions that a reading of a claim uses.
void add_definitions(const Element& parent, const ClaimsFile& file, const Claim& claim, Reading reading) {
  const Setting& setting = file.settings[claim.setting];
  const SettingNames names(setting);
  std::vector<std::size_t> indices;
  for (const Expression& expression : expressions(claim.body(reading))) {
    for (const std::size_t i : names.needs(expression, reading)) indices.push_back(i);
  }
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  if (indices.empty()) return;
  const Element list = parent.add("p", "where");
  list.text("where ");
  for (const std::size_t i : indices) {
    if (i != indices.front()) list.text(", ");
    const Expression& definition = names.definition(i, reading);
    const Element item = list.add("span", "definition");
    if (setting.definitions[i].is_nowhere(reading)) {
      add_symbol(add_math(item), setting.definitions[i].symbol);
      item.text(" is defined nowhere");
    } else {
      add_definition(item, setting.definitions[i].symbol, definition);
    }
  }
}

std::vector<std::string> theorems_of(const ClaimResult& result) {
  std::vector<std::string> theorems;
  for (const std::string& file : result.certificates) theorems.push_back(file.substr(0, file.rfind('.')));
  return theorems;
}

void add_theorem_links(const Element& p, const std::vector<std::string>& theorems) {
  for (const std::string& theorem : theorems) {
    if (theorem != theorems.front()) p.text(", ");
    p.add("a").set("href", "#certificate-" + theorem).text(theorem);
  }
}

void add_evidence(const Element& parent, const PageInput& input, const Claim& claim, const ClaimResult& result) {
  const Element p = parent.add("p", "evidence");
  p.add("b").text("Evidence. ");
  const std::string samples = std::to_string(result.samples());
  if (result.verdict == Verdict::holds) {
    if (result.proved && claim.kind().traits().seeks) {
      p.text("Such a motion was found, which proves it. ");
    } else if (!result.certificates.empty()) {
      p.text("Proved for all parameters: ");
      add_theorem_links(p, theorems_of(result));
      p.text(". ");
    } else if (result.proved) {
      p.text("An identity of rational functions, checked as polynomials: it holds for all parameters. ");
    }
    p.text("Of " + counted(result.tried, noun(*input.claims)) + " that were tried, it says something of " + samples +
           ", and is right at " + (result.samples() == 1 ? "it." : "each of them."));
    if (const std::string where = result.identity_where(); !where.empty()) {
      p.text(" It is an identity of rational functions wherever " + where + ".");
    }
  } else if (result.verdict == Verdict::refuted) {
    p.text("Of " + counted(result.tried, noun(*input.claims)) + " that were tried, it says something of " + samples +
           ", and is wrong at " + std::to_string(result.refuted) + " of them.");
    if (!result.certificates.empty()) {
      p.text(" That it is false is proved: ");
      add_theorem_links(p, theorems_of(result));
      p.text(".");
    }
  } else {
    add_prose(p, *input.claims, sentence(explain(*input.claims, result)));
  }
  if (input.opinions) add_second_opinions(parent, *input.opinions, theorems_of(result));
  for (const std::string& objection : result.rejections) parent.add("p", "evidence").text("Rejected: " + objection);
  for (const CheckedCertificate& statement : result.unproved) {
    const Element line = parent.add("p", "evidence").text("No proof of ");
    line.text(statement.theorem + ": " + std::string(to_string(statement.state)));
    line.text(statement.message.empty() ? "." : "; " + statement.message);
  }
}

void add_reading(const Element& parent, const PageInput& input, const Claim& claim, const ClaimResult& result) {
  const Element part = parent.add("div", "reading");
  const Element heading = part.add("h4");
  heading.text(result.reading == Reading::repaired ? "As repaired "
               : claim.origin == Origin::ours      ? "As stated "
                                                   : "As printed ");
  add_chip(heading, verdict_name(result));
  add_formal(part, input, claim, result.reading);
  add_definitions(part, *input.claims, claim, result.reading);
  add_evidence(part, input, claim, result);
  if (result.counterexample) add_counterexample(part, input, result);
}

/// Where the source states the claim, with a link to the paper if the page does not show the source's lines.
void add_place(const Element& body, const PageInput& input, const Claim& claim) {
  const Paper& paper = input.claims->paper;
  std::string place = paper.where(claim.line) + " of " + paper.source;
  const std::string number = "(" + claim.equation + ")";
  if (!claim.equation.empty() && place.find(number) == place.npos) place += ", equation " + number;
  const Element line = body.add("p", "place");
  line.text(place);
  const Reference reference = find_reference(paper.reference);
  if (!input.source && !reference.text.empty()) {
    line.text(", in ");
    line.add("a").set("href", reference.address).text(reference.text);
  }
  line.text(".");
}

}  // namespace

void add_claim_card(const Element& parent, const PageInput& input, std::size_t index) {
  const Claim& claim = input.claims->claims[index];
  std::vector<const ClaimResult*> readings;
  for (const ClaimResult& result : input.result->claims) {
    if (result.claim == index) readings.push_back(&result);
  }
  const bool failing = readings.front()->verdict != Verdict::holds, ours = claim.origin == Origin::ours;
  const bool proved =
      std::all_of(readings.begin(), readings.end(), [](const auto* r) { return verdict_name(*r) == "proved"; });
  const Element card = parent.add("details", std::string("claim") + (failing ? " failing" : "") +
                                                 (proved ? " all-proved" : "") + (ours ? " ours" : ""));
  card.set("id", "claim-" + claim.id);
  const Element summary = card.add("summary");
  summary.add("span", "id").text(claim.id);
  const Element statement = summary.add("span", "statement");
  add_sentence(statement, claim.statement);
  const Element chips = summary.add("span", "chips");
  if (ours) chips.add("small").text("our own");
  for (const ClaimResult* result : readings) {
    const Element one = chips.add("span");
    if (readings.size() > 1) one.add("small").text(std::string(claim.reading_name(result->reading)) + " ");
    add_chip(one, verdict_name(*result));
  }

  const Element body = card.add("div", "body");
  add_place(body, input, claim);
  add_source_line(body, input, claim.line);
  for (const ClaimResult* result : readings) add_reading(body, input, claim, *result);
  if (!claim.why.empty()) {
    add_line(body.add("p"), {strong("Why that is meant. "), prose(*input.claims, claim.why)});
  }
  if (!claim.note.empty()) {
    add_line(body.add("p"), {strong("Note. "), prose(*input.claims, claim.note)});
  }
}

}  // namespace slipproof
