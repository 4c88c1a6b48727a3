#include <algorithm>
#include <string>
#include <vector>

#include "base/output/listed.hpp"
#include "report/html/sections.hpp"

namespace slipproof {

namespace {

using Theorems = std::vector<std::string>;

Opinions opinions_of(const SecondOpinions& opinions, std::string_view theorem) {
  const auto found = opinions.find(theorem);
  return found == opinions.end() ? Opinions{} : found->second;
}

Theorems with_opinion(const SecondOpinions& opinions, const Theorems& theorems, std::size_t program, Opinion opinion) {
  Theorems found;
  std::copy_if(theorems.begin(), theorems.end(), std::back_inserter(found),
               [&](const std::string& theorem) { return opinions_of(opinions, theorem)[program] == opinion; });
  return found;
}

/// Adds `it`, `both`, `all 7`, the names if there are few, or `5 of the 7`.
void add_which(const Element& p, const Theorems& these, std::size_t all) {
  constexpr std::size_t few = 3;
  if (these.size() == all) {
    p.text(all == 1 ? "it" : all == 2 ? "both" : "all " + std::to_string(all));
  } else if (these.size() > few) {
    p.text(std::to_string(these.size()) + " of the " + std::to_string(all));
  } else {
    for (const std::string& theorem : these) {
      if (theorem != these.front()) p.text(theorem == these.back() ? " and " : ", ");
      p.add("a").set("href", "#certificate-" + theorem).text(theorem);
    }
  }
}

}  // namespace

std::size_t agreeing(const SecondOpinions& opinions, std::size_t program) {
  return static_cast<std::size_t>(std::count_if(opinions.begin(), opinions.end(), [&](const auto& opinion) {
    return opinion.second[program] == Opinion::agrees;
  }));
}

void add_second_opinions(const Element& parent, const SecondOpinions& opinions, const Theorems& theorems) {
  constexpr std::array<std::pair<Opinion, std::string_view>, 4> order{{{Opinion::agrees, ""},
                                                                       {Opinion::timeout, "timed out on "},
                                                                       {Opinion::unknown, "could not tell of "},
                                                                       {Opinion::not_asked, "was not asked of "}}};
  const auto asked = [&](std::size_t program) {
    return with_opinion(opinions, theorems, program, Opinion::not_asked).size() < theorems.size();
  };
  const bool anyone = asked(0) || asked(1) || asked(2);
  if (!anyone) return;
  const Element p = parent.add("p", "evidence");
  p.add("b").text("Second opinions. ");
  bool first_program = true;
  for (std::size_t program = 0; program < opinion_programs.size(); ++program) {
    if (!asked(program)) continue;
    p.text(std::string(first_program ? "" : "; ") + std::string(opinion_programs[program]) + " ");
    first_program = false;
    bool first = true;
    for (const auto& [opinion, words] : order) {
      const Theorems these = with_opinion(opinions, theorems, program, opinion);
      if (these.empty()) continue;
      if (!first) p.text(", ");
      first = false;
      p.text(opinion != Opinion::agrees ? words : opinion_programs[program] == "Coq" ? "accepts " : "confirms ");
      add_which(p, these, theorems.size());
    }
  }
  p.text(".");
}

void add_opinions_table(const Element& parent, const SecondOpinions& opinions, std::size_t certificates) {
  ReportTable table{{"program", {"agrees", true}, {"timed out", true}, {"could not tell", true}, {"not asked", true}}};
  table.label = "Second opinions by program";
  table.caption =
      "Second opinions: what programs that share nothing with slipproof say of the same statements. z3 and cvc5 look "
      "for a counterexample and find that there is none; Coq checks the certificate, too.";
  table.css_class = "opinions";
  for (std::size_t program = 0; program < opinion_programs.size(); ++program) {
    std::array<std::size_t, 4> counts{};
    for (const auto& [statement, row] : opinions) ++counts[static_cast<std::size_t>(row[program])];
    counts[static_cast<std::size_t>(Opinion::not_asked)] += certificates - opinions.size();
    std::vector<ReportCell> cells{opinion_programs[program]};
    for (const Opinion opinion : {Opinion::agrees, Opinion::timeout, Opinion::unknown, Opinion::not_asked}) {
      cells.push_back(ReportCell::count(counts[static_cast<std::size_t>(opinion)]));
    }
    table.row(std::move(cells));
  }
  add_table(parent, table);
}

std::string agreeing_programs(const SecondOpinions& opinions, std::string_view theorem) {
  const Opinions row = opinions_of(opinions, theorem);
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i] == Opinion::agrees) names.push_back(opinion_programs[i]);
  }
  return listed(names);
}

}  // namespace slipproof
