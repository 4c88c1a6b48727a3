// The sections of the page, in its order.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mechanics/planes/phase_diagram.hpp"
#include "report/document/document.hpp"
#include "report/html/frame.hpp"
#include "report/html/page.hpp"
#include "report/markup/element.hpp"
#include "report/papers/explain.hpp"
#include "report/papers/prose.hpp"

namespace slipproof {

void add_overview(const Element& main, const PageInput& input);
void add_phase_section(const Element& main, const PageInput& input);
/// The friction from which on the paper's scenes have several motions.
void add_machines_section(const Element& main, const PageInput& input);
/// The lines of the paper's source with the claims about them, if they are beside the claims file.
void add_source_section(const Element& main, const PageInput& input);
/// One of these lines as a quotation; adds nothing without it.
void add_source_line(const Element& parent, const PageInput& input, std::size_t line);
void add_claims_section(const Element& main, const PageInput& input);
void add_errata_section(const Element& main, const PageInput& input);
void add_certificates_section(const Element& main, const PageInput& input);
void add_trade_section(const Element& main, const PageInput& input);
/// One picture: speed against errors, or against wrong verdicts.
void add_trade_plot(const Element& parent, const Trade& trade, bool errors, bool small);
void add_solvers_section(const Element& main, const PageInput& input);
/// The questions that the paper leaves open, in its own words.
void add_open_section(const Element& main, const PageInput& input);
/// The meaning of each symbol of the model and of the paper's settings.
void add_notation_section(const Element& main, const PageInput& input);
void add_reproduce_section(const Element& main, const PageInput& input);

/// What other programs say about a claim's certificates; adds nothing if no program was asked.
void add_second_opinions(const Element& parent, const SecondOpinions& opinions,
                         const std::vector<std::string>& theorems);
/// What each program says, in numbers.
void add_opinions_table(const Element& parent, const SecondOpinions& opinions, std::size_t certificates);
/// The number of statements with which a program (of `opinion_programs`) agrees.
std::size_t agreeing(const SecondOpinions& opinions, std::size_t program);
/// `z3, Coq`: the programs that agree with a statement.
std::string agreeing_programs(const SecondOpinions& opinions, std::string_view theorem);

/// A link that opens a scene in the explorer; empty if the page has no explorer.
std::string link_to_explorer(const PageInput& input, const MechanismScene& scene);
constexpr std::string_view explorer_words = "Drag its values in the explorer";

/// The id of a claim, as a link if the claim was judged and is on the page.
void add_claim_id(const Element& parent, const PageInput& input, std::string_view id);
/// One claim in all of its readings.
void add_claim_card(const Element& parent, const PageInput& input, std::size_t claim);
/// What a claim says, in words and formulas.
void add_formal(const Element& parent, const PageInput& input, const Claim& claim, Reading reading);
/// What is wrong, with a picture, and the arithmetic for checking it by hand.
void add_counterexample(const Element& parent, const PageInput& input, const ClaimResult& result);

/// A diagram with its legend, its sample points for the script, and its data as a table.
struct PhaseFigure {
  const PhaseDiagram& diagram;
  std::string caption;
  bool small = false;
  std::string explorer = {};  ///< a link to the explorer with a scene of the diagram; empty: none
};
void add_phase_figure(const Element& parent, const PhaseFigure& figure);

/// The word for a verdict: proved, holds, refuted, undecided.
std::string_view verdict_name(const ClaimResult& result);
/// A verdict as a small label that does not rely on its colour.
Element add_chip(const Element& parent, std::string_view verdict);
/// The same for other words. The class of its colours is the name of a verdict; the sign is not read aloud.
Element add_chip(const Element& parent, std::string_view css_class, std::string_view sign, std::string_view text);

}  // namespace slipproof
