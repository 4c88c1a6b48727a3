#include <string>

#include "base/expression/logic.hpp"
#include "report/html/sections.hpp"
#include "report/markup/mathml.hpp"
#include "report/papers/explain.hpp"

namespace slipproof {

namespace {

void add_modes(const Element& p, const Modes& modes) {
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (i > 0) p.text(i + 1 == modes.size() ? " and " : ", ");
    p.add("span", "mode").text(name(modes[i]));
  }
}

void add_claims(const Element& p, const PageInput& input, const References& claims) {
  for (std::size_t i = 0; i < claims.size(); ++i) {
    if (i > 0) p.text(i + 1 == claims.size() ? " and " : ", ");
    add_claim_id(p, input, input.claims->claims[claims[i]].id);
  }
}

void add_equations(const Element& p, const Equations& equations) {
  for (const Expression& equation : equations) {
    add_math(p.add("span", "equation"), equation);
    p.text(" ");
  }
}

/// Adds the region and the forces that the claim is about.
void add_where(const Element& p, const Expression& region, const Expression& forces) {
  if (is_true(region) && is_true(forces)) {
    p.text("Always: ");
    return;
  }
  p.text("For ");
  if (!is_true(region)) add_math(p, region);
  if (!is_true(region) && !is_true(forces)) p.text(" and ");
  if (!is_true(forces)) add_math(p, forces);
  p.text(": ");
}

/// A piece of what a claim says.
struct WordText {
  const Element& p;
  const PageInput& input;

  void operator()(const std::string& text) const { p.text(text); }
  void operator()(const Modes& modes) const { add_modes(p, modes); }
  void operator()(const References& claims) const { add_claims(p, input, claims); }
  void operator()(const Expression& e) const {
    const bool symbol = e->operation == Operation::symbol;
    symbol ? add_symbol(add_math(p), e->symbol) : add_math(p, e);
  }
  void operator()(const Equations& equations) const { add_equations(p, equations); }
};

}  // namespace

void add_formal(const Element& parent, const PageInput& input, const Claim& claim, Reading reading) {
  const ClaimBody& body = claim.body(reading);
  const Element p = parent.add("p", "formal");
  add_where(p, body.region, body.where());
  for (const auto& word : body.kind->words(body, noun(*input.claims))) std::visit(WordText{p, input}, word);
}

}  // namespace slipproof
