#include "claims/meaning/random/random_kinds.hpp"

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

void RandomKinds::settle(Claim& claim) {
  const Tree k = symbol("k"), divisor = minus(k, number(trees_.small()));
  const bool equations = claim.kind == "consequence";
  if ((equations || claim.kind == "formula") && dice_.one_in(2)) {
    const Tree value = over(symbol(equations ? unknown() : dice_.of(world_.quantities())), divisor);
    claim.modes = equations ? mode_of_equations() : std::vector<Mode>{mode()};
    if (equations) claim.equations = {compare(value, "=", value)};
    if (!equations) claim.holds = compare(value, "=", value);
    claim.given = claim.claims = {};
    claim.assume = {};
    return;
  }
  const Tree value = dice_.of<Tree>({k, over(number(1), divisor), symbol("d2"), trees_.parameter_number(1)});
  const Tree above = compare(value, ">", number(dice_.of<int>({1, 2}))), below = compare(value, "<", number(1));
  claim.region = dice_.one_in(2) ? compare(k, dice_.of<std::string>({"<", "<=", ">"}), number(trees_.small()))
                                 : make(Op::conjunction, {above, below});
}

Mode RandomKinds::mode() {
  for (int tries = 0; tries < 5; ++tries) {
    const Mode& mode = dice_.of(world_.modes());
    if (world_.solutions(mode) != nullptr) return mode;
  }
  return dice_.of(world_.modes());
}

std::size_t RandomKinds::add_interval(const Mode& mode) {
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

std::vector<Mode> RandomKinds::modes_at(const Rational& x, bool strict) {
  const Motions found = world_.motions(x, strict);
  std::vector<Mode> result = found.continua;
  for (const Motions::One& one : found.single) result.push_back(dice_.of(one.modes));
  return result;
}

/// Where the same modes have motions, more or less.
Tree RandomKinds::where_motions_are_as_at(const Rational& x, bool strict) {
  const auto has = [&](const Mode& m) { return world_.motions(x, strict).in(m) > 0; };
  Tree result = truth(true);
  for (const Mode& m : world_.modes()) {
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
  claim.forces = dice_.one_in(4) && !world_.setting().force.empty()
                     ? compare(symbol(world_.setting().force), "=", number(x))
                     : trees_.nearly(where_motions_are_as_at(x, world_.setting().strict));
}

/// An interval for some of the modes, the rest in `modes`; except where there is not one motion.
void RandomKinds::unique(Claim& claim) {
  std::vector<Mode> alone;
  for (const Rational& x : everywhere(world_.ends())) {
    const Motions found = world_.motions(x, false);
    if (found.exactly_one()) {
      const Mode m = found.single[0].modes.front();
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
  for (const Mode& m : alone) {
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
  for (const Mode& m : world_.modes()) {
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
  const std::vector<Mode> there = modes_at(x, world_.setting().strict);
  claim.modes = {there.empty() ? mode() : dice_.of(there)};
  if (!there.empty() && dice_.one_in(2)) claim.modes.push_back(dice_.of(there));
  if (claim.modes.size() == 2 && claim.modes[0] == claim.modes[1]) claim.modes.pop_back();
  claim.forces = dice_.one_in(3) ? nullptr : trees_.forces();
}

/// Of every motion with no contact open.
Tree RandomKinds::true_equation() {
  if (dice_.one_in(8))
    return compare(times(symbol("b"), symbol(unknown())), "=", times(symbol("k"), symbol(unknown())));
  const Rows rows = world_.model_rows({});
  const Row row = dice_.of(rows);
  Tree left = number(row.back());
  for (std::size_t i = 0; i < world_.constant_column(); ++i) {
    if (row[i] == 0) continue;
    const std::string& name = i == world_.force_column() ? world_.setting().force : world_.unknowns()[i];
    left = plus(left, times(number(row[i]), symbol(name)));
  }
  return compare(left, "=", number(0));
}

/// One in which no contact lifts, or none.
std::vector<Mode> RandomKinds::mode_of_equations() {
  const Mode& mode = dice_.of(world_.modes());
  if (std::find(mode.begin(), mode.end(), ElementState::lift) != mode.end()) return {};
  return {mode};
}

std::string RandomKinds::unknown() {
  return dice_.of(world_.unknowns());
}

Tree RandomKinds::random_equation() {
  const auto term = [&] {
    const std::string& force = world_.setting().force;
    const std::string name = force.empty() || !dice_.one_in(5) ? unknown() : force;
    const Tree coefficient = dice_.one_in(4) ? trees_.parameter_number(1) : number(trees_.small());
    return times(coefficient, symbol(name));
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
    if (dice_.one_in(3)) claim.modes = mode_of_equations();
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
    if (dice_.one_in(5)) claim.modes = mode_of_equations();
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
    claim.assume.push_back(compare(symbol(unknown()), "=", plus(symbol(unknown()), number(trees_.small()))));
  }
}

}  // namespace slipproof::meaning
