#include <string>

#include "base/expression/logic.hpp"
#include "report/html/sections.hpp"
#include "report/markup/mathml.hpp"
#include "report/markup/symbol.hpp"
#include "report/papers/explain.hpp"

namespace slipproof {

namespace {

void add_modes(const Element& p, const std::vector<MechanismMode>& modes) {
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (i > 0) p.text(i + 1 == modes.size() ? " and " : ", ");
    p.add("span", "mode").text(name(modes[i]));
  }
}

void add_claims(const Element& p, const PageInput& input, const std::vector<std::size_t>& claims) {
  for (std::size_t i = 0; i < claims.size(); ++i) {
    if (i > 0) p.text(i + 1 == claims.size() ? " and " : ", ");
    add_claim_id(p, input, input.claims->claims[claims[i]].id);
  }
}

void add_equations(const Element& p, const std::vector<Expression>& equations) {
  for (const Expression& equation : equations) {
    add_math(p.add("span", "equation"), equation);
    p.text(" ");
  }
}

/// Where: the region, and the forces unless they are the claim itself.
void add_where(const Element& p, const Expression& region, const Expression& forces = make_truth(true)) {
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

void add_linear(const Element& p, const PageInput& input, const LinearEquations& claim, const char* relation) {
  if (claim.from_model()) {
    p.text("the model's equations ");
  } else {
    add_claims(p, input, claim.claims);
    if (!claim.claims.empty() && !claim.given.empty()) p.text(" with ");
    add_claims(p, input, claim.given);
  }
  if (claim.mode) {
    p.text(" in ");
    add_modes(p, {*claim.mode});
  }
  if (!claim.assume.empty()) {
    p.text(" together with ");
    add_equations(p, claim.assume);
  }
  p.text(relation);
  add_equations(p, claim.equations);
}

void add_unique(const Element& p, const PageInput& input, const Unique& claim) {
  p.text("there is one motion, ");
  if (!claim.modes.empty()) {
    p.text("in one of ");
    add_modes(p, claim.modes);
    p.text(" or ");
  }
  p.text("as stated by ");
  add_claims(p, input, claim.claims);
  if (claim.except.empty()) return;
  p.text(", except where ");
  add_claims(p, input, claim.except);
  p.text(" stands");
}

/// What a claim says, kind by kind, as text in p.
struct FormalText {
  const Element& p;
  const PageInput& input;
  const Expression& region;

  void operator()(const Interval& c) const {
    add_where(p, region);
    add_modes(p, {c.mode});
    p.text(" is a motion exactly for ");
    add_math(p, c.forces);
  }

  void operator()(const Impossible& c) const {
    add_where(p, region, c.forces);
    p.text("no motion in ");
    add_modes(p, c.modes);
  }

  void operator()(const Formula& c) const {
    add_where(p, region, c.forces);
    if (!c.modes.empty()) {
      p.text("in ");
      add_modes(p, c.modes);
      p.text(", ");
    }
    add_math(p, c.holds);
  }

  void operator()(const Limit& c) const {
    add_where(p, region);
    add_math(p, c.holds);
    p.text(" from some value of ");
    add_symbol(add_math(p), c.parameter);
    p.text(" on");
  }

  void operator()(const Equivalence& c) const {
    add_where(p, region);
    add_math(p, c.forces);
    p.text(" if and only if ");
    add_math(p, c.holds);
  }

  void operator()(const Motions& c) const {
    add_where(p, region, c.forces);
    p.text("there is one motion in each of ");
    add_modes(p, c.modes);
    p.text(", and no other");
  }

  void operator()(const Unique& c) const {
    add_where(p, region, c.forces);
    add_unique(p, input, c);
  }

  void operator()(const Cover& c) const {
    add_where(p, region);
    p.text("every " + std::string(noun(*input.claims)) + " is in the case of one of ");
    add_claims(p, input, c.claims);
  }

  void operator()(const ForceCover& c) const {
    add_where(p, region, c.forces);
    p.text("each force is one of those that are stated by one of ");
    add_claims(p, input, c.claims);
  }

  void operator()(const Exists& c) const {
    add_where(p, region, c.forces);
    p.text("somewhere there is a motion in ");
    add_modes(p, c.modes);
  }

  void operator()(const Consequence& c) const {
    add_where(p, region);
    add_linear(p, input, c, " imply ");
  }

  void operator()(const System& c) const {
    add_where(p, region);
    add_linear(p, input, c, " say the same as ");
  }
};

}  // namespace

void add_formal(const Element& parent, const PageInput& input, const Claim& claim, Reading reading) {
  const ClaimBody& body = claim.body(reading);
  const Element p = parent.add("p", "formal");
  std::visit(FormalText{p, input, body.region}, body.says);
}

}  // namespace slipproof
