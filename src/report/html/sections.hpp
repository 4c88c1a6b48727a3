// The sections of the page, in its order.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/document/document.hpp"
#include "report/html/frame.hpp"
#include "report/html/page.hpp"
#include "report/markup/element.hpp"
#include "report/papers/explain.hpp"
#include "report/papers/prose.hpp"
#include "report/phase/phase_diagram.hpp"

namespace slipproof {

void add_overview(const Element& main, const PageInput& input);
void add_phase_section(const Element& main, const PageInput& input);
/// From which friction on the paper's scenes have several motions.
void add_machines_section(const Element& main, const PageInput& input);
void add_claims_section(const Element& main, const PageInput& input);
void add_errata_section(const Element& main, const PageInput& input);
void add_certificates_section(const Element& main, const PageInput& input);
void add_trade_section(const Element& main, const PageInput& input);
/// One picture: speed against errors, or against wrong verdicts.
void add_trade_plot(const Element& parent, const Trade& trade, bool errors, bool small);
void add_solvers_section(const Element& main, const PageInput& input);
/// What the paper leaves open, in its own words.
void add_open_section(const Element& main, const PageInput& input);
/// What each symbol means: those of the model, and those of the paper's settings.
void add_notation_section(const Element& main, const PageInput& input);
void add_reproduce_section(const Element& main, const PageInput& input);

/// What other programs say of a claim's certificates; nothing where none was asked of any.
void add_second_opinions(const Element& parent, const SecondOpinions& opinions,
                         const std::vector<std::string>& theorems);
/// What each program says, in numbers.
void add_opinions_table(const Element& parent, const SecondOpinions& opinions, std::size_t certificates);
/// With how many statements a program (of `opinion_programs`) agrees.
std::size_t agreeing(const SecondOpinions& opinions, std::size_t program);
/// `z3, Coq`: those that agree with a statement.
std::string agreeing_programs(const SecondOpinions& opinions, std::string_view theorem);

/// The id of a claim: a link to it where it was judged and stands in the page, as it is otherwise.
void add_claim_id(const Element& parent, const PageInput& input, std::string_view id);
/// One claim in all of its readings.
void add_claim_card(const Element& parent, const PageInput& input, std::size_t claim);
/// What a claim says, in words and formulas.
void add_formal(const Element& parent, const PageInput& input, const Claim& claim, Reading reading);
/// What is wrong, with a picture, and the arithmetic to follow by hand.
void add_counterexample(const Element& parent, const PageInput& input, const ClaimResult& result);

/// A diagram with its legend, its sample points for the script, and the table behind it.
struct PhaseFigure {
  const PhaseDiagram& diagram;
  std::string caption;
  bool small = false;
};
void add_phase_figure(const Element& parent, const PhaseFigure& figure);

/// What a verdict is called: proved, holds, refuted, undecided.
std::string_view verdict_name(const ClaimResult& result);
/// A verdict as a small label that does not rely on its colour.
Element add_chip(const Element& parent, std::string_view verdict);
/// The same for other words: the class of its colours is one of the verdicts' names, the sign is not read out.
Element add_chip(const Element& parent, std::string_view css_class, std::string_view sign, std::string_view text);

}  // namespace slipproof
