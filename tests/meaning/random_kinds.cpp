#include "meaning/random_kinds.hpp"

#include <algorithm>

namespace slipproof::meaning {

void RandomKinds::add(const std::string& kind) {
  Claim claim;
  claim.kind = kind;
  claim.region = trees_.region();
  if (kind == "interval") interval(claim);
  if (kind == "impossible") impossible(claim);
  if (kind == "formula") formula(claim);
  if (kind == "motions") motions(claim);
  if (kind == "unique") unique(claim);
  if (kind == "cover") cover(claim);
  if (kind == "force-cover") force_cover(claim);
  if (kind == "limit") limit(claim);
  if (kind == "exists") exists(claim);
  if (kind == "consequence") consequence(claim);
  if (kind == "system") system(claim);
  if (kind == "equivalence") {
    claim.forces = trees_.forces();
    claim.holds = dice_.one_in(4) ? trees_.forces() : trees_.nearly(claim.forces);
    if (dice_.one_in(2)) std::swap(claim.forces, claim.holds);
  }
  claim.id = new_id();
  file_.claims.push_back(std::move(claim));
}

ContactMode RandomKinds::mode() {
  for (int tries = 0; tries < 5; ++tries) {
    const ContactMode mode = all_modes()[dice_.below(16)];
    if (world_.solutions(mode) != nullptr) return mode;
  }
  return all_modes()[dice_.below(16)];
}

std::size_t RandomKinds::add_interval(ContactMode mode) {
  Claim claim;
  claim.kind = "interval";
  claim.modes = {mode};
  claim.forces = trees_.nearly(trees_.forces_of(mode));
  if (dice_.one_in(3)) claim.region = trees_.region();
  claim.id = new_id();
  file_.claims.push_back(claim);
  return file_.claims.size() - 1;
}

void RandomKinds::interval(Claim& claim) {
  claim.modes = {mode()};
  claim.forces = dice_.one_in(6) ? trees_.forces() : trees_.nearly(trees_.forces_of(claim.modes[0]));
}

void RandomKinds::impossible(Claim& claim) {
  for (std::size_t i = dice_.below(3) + 1; i > 0; --i) claim.modes.push_back(mode());
  const Tree beyond = make(Op::negation, {trees_.forces_of(claim.modes[0])});
  claim.forces = dice_.one_in(4) ? trees_.forces() : trees_.nearly(beyond);
}

void RandomKinds::formula(Claim& claim) {
  claim.forces = dice_.one_in(3) ? nullptr : trees_.forces();
  if (dice_.one_in(3)) {
    claim.holds = claim.forces && dice_.one_in(2) ? trees_.nearly(claim.forces) : trees_.forces();
    return;
  }
  for (std::size_t i = dice_.below(2) + 1; i > 0; --i) claim.modes.push_back(mode());
  claim.holds = trees_.about_motion(claim.modes[0]);
}

std::vector<ContactMode> RandomKinds::modes_at(const Rational& x, bool strict) {
  const Motions found = world_.motions(x, strict);
  std::vector<ContactMode> result = found.continua;
  for (const Motions::One& one : found.single) result.push_back(dice_.of(one.modes));
  return result;
}

/// Where the same modes have motions, more or less.
Tree RandomKinds::where_motions_are_as_at(const Rational& x, bool strict) {
  const auto has = [&](ContactMode m) { return world_.motions(x, strict).in(m) > 0; };
  Tree result = truth(true);
  for (const ContactMode m : all_modes()) {
    if (world_.solutions(m) == nullptr) continue;
    const Tree forces = trees_.forces_of(m);
    if (forces->op != Op::truth) {
      result = make(Op::conjunction, {result, has(m) ? forces : make(Op::negation, {forces})});
    }
  }
  return result;
}

void RandomKinds::motions(Claim& claim) {
  const Rational x = dice_.of(everywhere(world_.ends()));
  claim.modes = modes_at(x, world_.setting().strict);
  if (claim.modes.empty() || dice_.one_in(5)) claim.modes.push_back(mode());
  claim.forces = dice_.one_in(4) ? compare(symbol(world_.setting().force), "=", number(x))
                                 : trees_.nearly(where_motions_are_as_at(x, world_.setting().strict));
}

/// An interval for some of the modes, the rest in `modes`; except where there is not one motion.
void RandomKinds::unique(Claim& claim) {
  std::vector<ContactMode> alone;
  for (const Rational& x : everywhere(world_.ends())) {
    const Motions found = world_.motions(x, false);
    if (found.exactly_one()) {
      const ContactMode m = found.single[0].modes.front();
      if (std::find(alone.begin(), alone.end(), m) == alone.end()) alone.push_back(m);
    } else if (!dice_.one_in(4) && claim.except.size() < 4) {
      Claim several{new_id(), "motions", nullptr, where_motions_are_as_at(x, false), nullptr, {}, {}, {}, {}, {},
                    {},       {},        {}};
      several.modes = modes_at(x, false);
      if (several.modes.empty()) several.modes.push_back(mode());
      claim.except.push_back(file_.claims.size());
      file_.claims.push_back(std::move(several));
    }
  }
  for (const ContactMode m : alone) {
    if (dice_.one_in(2)) {
      claim.modes.push_back(m);
    } else {
      claim.claims.push_back(add_interval(m));
    }
  }
  if (claim.claims.empty()) claim.claims.push_back(add_interval(mode()));
  if (claim.modes.empty() && dice_.one_in(2)) claim.modes.push_back(mode());
  if (dice_.one_in(3)) claim.forces = trees_.forces();
}

void RandomKinds::cover(Claim& claim) {
  for (std::size_t i = dice_.below(3) + 1; i > 0; --i) {
    claim.claims.push_back(add_interval(mode()));
    Tree& region = file_.claims.back().region;
    while (!region) region = trees_.region();
  }
}

/// By the intervals of modes that have motions at some force, most often.
void RandomKinds::force_cover(Claim& claim) {
  for (const ContactMode m : all_modes()) {
    if (world_.solutions(m) != nullptr && !dice_.one_in(8)) claim.claims.push_back(add_interval(m));
  }
  if (claim.claims.empty()) claim.claims.push_back(add_interval(mode()));
  if (dice_.one_in(2)) claim.forces = trees_.nearly(file_.claims[claim.claims.front()].forces);
}

void RandomKinds::limit(Claim& claim) {
  claim.parameter = dice_.one_in(4) ? dice_.of<std::string>({"b", "h", "f"}) : "k";
  claim.region = dice_.one_in(2) ? trees_.about_parameter(claim.parameter) : nullptr;
  claim.holds = trees_.about_parameter(claim.parameter);
  if (dice_.one_in(2)) claim.from = number(trees_.small());
}

void RandomKinds::exists(Claim& claim) {
  const Rational x = dice_.of(everywhere(world_.ends()));
  const std::vector<ContactMode> there = modes_at(x, world_.setting().strict);
  claim.modes = {there.empty() ? mode() : dice_.of(there)};
  if (!there.empty() && dice_.one_in(2)) claim.modes.push_back(dice_.of(there));
  if (claim.modes.size() == 2 && claim.modes[0] == claim.modes[1]) claim.modes.pop_back();
  claim.forces = dice_.one_in(3) ? nullptr : trees_.forces();
}

/// Of every motion with both wheels on the road.
Tree RandomKinds::true_equation() {
  const auto s = [](const char* name) { return symbol(name); };
  const Tree thrust = world_.setting().external ? make(Op::negate, {world_.setting().scene.at("F")}) : number(0);
  return dice_.of<Tree>({
      compare(s("a"), "=", plus(plus(s("S2"), s("S3")), thrust)),
      compare(plus(s("N2"), s("N3")), "=", number(world_.road().g)),
      compare(s("phi"), "=", number(0)),
      compare(s("a_y"), "=", times(s("phi"), s("a"))),
      compare(times(number(world_.bicycle().I3), s("eps3")), "=", make(Op::negate, {s("S3")})),
      compare(times(number(world_.bicycle().r2), s("eps2")), "=", s("eps1")),
      compare(times(s("b"), s("a_y")), "=", times(s("a_y"), s("k"))),
  });
}

Tree RandomKinds::random_equation() {
  const auto term = [&] {
    const std::string unknown = dice_.of<std::string>({"a", "phi", "S2", "N2", world_.setting().force});
    const Tree coefficient = dice_.one_in(4) ? trees_.parameter_number(1) : number(trees_.small());
    return times(coefficient, symbol(unknown));
  };
  Tree left = plus(term(), term());
  if (dice_.one_in(25)) left = times(left, term());
  if (dice_.one_in(25)) left = make(Op::divide, {left, term()});
  return compare(left, "=", dice_.one_in(2) ? number(trees_.small()) : term());
}

Tree RandomKinds::combination(const std::vector<Tree>& equations) {
  Tree left = number(0), right = number(0);
  for (const Tree& equation : equations) {
    const Tree factor = number(trees_.small());
    left = plus(left, times(factor, equation->parts[0]));
    right = plus(right, times(factor, equation->parts[1]));
  }
  return compare(left, "=", right);
}

std::size_t RandomKinds::add_equations() {
  Claim claim;
  claim.kind = "consequence";
  for (std::size_t i = dice_.below(2) + 1; i > 0; --i) claim.equations.push_back(random_equation());
  claim.id = new_id();
  file_.claims.push_back(claim);
  return file_.claims.size() - 1;
}

void RandomKinds::consequence(Claim& claim) {
  if (dice_.one_in(3)) {
    claim.equations = {dice_.one_in(4) ? random_equation() : combination({true_equation(), true_equation()})};
    if (dice_.one_in(3)) claim.modes = {all_modes()[dice_.of<std::size_t>({0, 1, 4, 6, 10})]};
    if (dice_.one_in(4)) claim.assume = {random_equation()};
    return;
  }
  std::vector<Tree> known;
  for (std::size_t i = dice_.below(2) + 1; i > 0; --i) {
    const std::size_t other = add_equations();
    (dice_.one_in(2) ? claim.given : claim.claims).push_back(other);
    for (const Tree& equation : file_.claims[other].equations) known.push_back(equation);
  }
  if (dice_.one_in(3)) claim.assume = {random_equation()};
  known.insert(known.end(), claim.assume.begin(), claim.assume.end());
  for (std::size_t i = dice_.below(2) + 1; i > 0; --i) {
    claim.equations.push_back(dice_.one_in(5) ? random_equation() : combination(known));
  }
}

/// The same equations in another form, or some of them; or what few unknowns are by the model.
void RandomKinds::system(Claim& claim) {
  if (dice_.one_in(3)) {
    for (std::size_t i = dice_.below(3) + 1; i > 0; --i) claim.equations.push_back(true_equation());
    if (dice_.one_in(5)) claim.modes = {ContactMode{}};
    return;
  }
  const std::size_t left = add_equations();
  (dice_.one_in(4) ? claim.given : claim.claims).push_back(left);
  const std::vector<Tree> known = file_.claims[left].equations;
  claim.equations = known;
  if (known.size() == 2) claim.equations[0] = combination(known);
  if (dice_.one_in(4)) claim.equations.pop_back();
  if (claim.equations.empty() || dice_.one_in(5)) claim.equations.push_back(combination(known));
  if (dice_.one_in(6)) claim.assume = {random_equation()};
  // What is said of an unknown that occurs nowhere else: it may have any value, or the one that this gives.
  if (dice_.one_in(3)) {
    claim.assume.push_back(compare(symbol("eps3"), "=", plus(symbol("a"), number(trees_.small()))));
  }
}

}  // namespace slipproof::meaning
