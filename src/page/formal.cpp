#include <string>

#include "page/sections.hpp"
#include "typeset/mathml.hpp"
#include "typeset/symbol.hpp"

namespace slipproof {

namespace {

bool trivial(const Expression& e) {
  return !e || (e->operation == Operation::truth && e->truth);
}

void add_modes(const Element& p, const std::vector<ContactMode>& modes) {
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
void add_where(const Element& p, const ClaimBody& body, bool forces_too) {
  const bool region = !trivial(body.region), forces = forces_too && !trivial(body.forces);
  if (!region && !forces) {
    p.text("Always: ");
    return;
  }
  p.text("For ");
  if (region) add_math(p, body.region);
  if (region && forces) p.text(" and ");
  if (forces) add_math(p, body.forces);
  p.text(": ");
}

}  // namespace

void add_formal(const Element& parent, const PageInput& input, const Claim& claim, Reading reading) {
  const ClaimBody& body = claim.body(reading);
  const Element p = parent.add("p", "formal");
  switch (claim.kind) {
    case ClaimKind::interval:
      add_where(p, body, false);
      add_modes(p, body.modes);
      p.text(" is a motion exactly for ");
      add_math(p, body.forces);
      break;
    case ClaimKind::impossible:
      add_where(p, body, true);
      p.text("no motion in ");
      add_modes(p, body.modes);
      break;
    case ClaimKind::formula:
    case ClaimKind::limit:
      add_where(p, body, true);
      if (!body.modes.empty()) {
        p.text("in ");
        add_modes(p, body.modes);
        p.text(", ");
      }
      add_math(p, body.holds);
      if (claim.kind == ClaimKind::limit) {
        p.text(" from some value of ");
        add_symbol(add_math(p), body.parameter);
        p.text(" on");
      }
      break;
    case ClaimKind::equivalence:
      add_where(p, body, false);
      add_math(p, body.forces);
      p.text(" if and only if ");
      add_math(p, body.holds);
      break;
    case ClaimKind::motions:
      add_where(p, body, true);
      p.text("there is one motion in each of ");
      add_modes(p, body.modes);
      p.text(", and no other");
      break;
    case ClaimKind::unique:
      add_where(p, body, true);
      p.text("there is one motion, ");
      if (!body.modes.empty()) {
        p.text("in one of ");
        add_modes(p, body.modes);
        p.text(" or ");
      }
      p.text("as stated by ");
      add_claims(p, input, body.claims);
      if (!body.except.empty()) {
        p.text(", except where ");
        add_claims(p, input, body.except);
        p.text(" stands");
      }
      break;
    case ClaimKind::cover:
      add_where(p, body, false);
      p.text("every bicycle is in the case of one of ");
      add_claims(p, input, body.claims);
      break;
    case ClaimKind::exists:
      add_where(p, body, true);
      p.text("somewhere there is a motion in ");
      add_modes(p, body.modes);
      break;
    case ClaimKind::consequence:
    case ClaimKind::system:
      add_where(p, body, false);
      if (body.claims.empty() && body.given.empty()) {
        p.text("the model's equations ");
      } else {
        add_claims(p, input, body.claims);
        if (!body.claims.empty() && !body.given.empty()) p.text(" with ");
        add_claims(p, input, body.given);
      }
      if (!body.modes.empty()) {
        p.text(" in ");
        add_modes(p, body.modes);
      }
      if (!body.assume.empty()) {
        p.text(" together with ");
        add_equations(p, body.assume);
      }
      p.text(claim.kind == ClaimKind::system ? " say the same as " : " imply ");
      add_equations(p, body.equations);
      break;
  }
}

}  // namespace slipproof
