#include "claims/judge/judge.hpp"

#include <algorithm>
#include <array>

#include "claims/judge/claim_judge.hpp"
#include "claims/lines/critical.hpp"

namespace slipproof {

std::string_view name(Reason reason) {
  constexpr std::array<std::string_view, 13> names{"none",      "ends",     "forces",   "exists",    "formula",
                                                   "continuum", "extra",    "missing",  "uncovered", "limit",
                                                   "equation",  "no value", "undecided"};
  return names[static_cast<std::size_t>(reason)];
}

bool ClaimJudge::contains(const Intervals& parts, const Rational& force) {
  return std::any_of(parts.begin(), parts.end(), [&](const ForceInterval& part) { return part.contains(force); });
}

Judgement ClaimJudge::judge() {
  Judgement j = judged();
  if (j.outcome == Outcome::undecided && is_unsure()) j.reason = Reason::unsure;
  return j;
}

bool ClaimJudge::is_unsure() {
  bool unsure = false;
  for (const Program* program :
       {&compiled_.settings[claim_.setting].force_domain(), &programs_.forces, &programs_.holds}) {
    for (const TruthCell& cell : sample_.over_forces(*program)) {
      if (sample_.force_domain() && common(cell.forces, domain()).empty()) continue;
      if (cell.truth == Truth::undefined) return false;
      unsure = unsure || cell.truth == Truth::undecided;
    }
  }
  return unsure;
}

Judgement ClaimJudge::judged() {
  if (!sample_.force_domain()) return undecided();
  if (!claim_.is<Limit>()) {  // of a limit, the region at the end of the parameter's domain counts
    const Truth inside = sample_.region(programs_.region);
    if (no_value(inside)) return undecided();
    if (inside == Truth::no) return {};
  }
  return std::visit([&](const auto& claim) { return of(claim); }, body_.says);
}

Judgement ClaimJudge::of(const Interval& claim) {
  const auto s = find(claim.mode);
  const auto claimed = sample_.true_at(programs_.forces);
  if (!s) return undecided();
  ForceInterval real = forces_of(*s);
  Intervals differ = difference(claimed.parts, real);
  if (differ.empty()) {
    differ = {real};
    for (const Intervals* parts : {&claimed.parts, &claimed.unvalued}) {
      for (const ForceInterval& part : *parts) differ = difference(differ, part);
    }
    std::erase_if(differ, [](const ForceInterval& forces) { return forces.empty(); });
  }
  if (differ.empty()) return claimed.valued() ? holds() : undecided();
  std::optional<ForceInterval> one;
  if (claimed.parts.size() < 2) one = claimed.parts.empty() ? ForceInterval::nothing() : claimed.parts.front();
  const bool ends =
      one && !one->empty() && !real.empty() && one->interior() == real.interior() && !one->interior().empty();
  const bool continuum = s->continuum && !common(real, differ.front()).empty();  // where they differ
  Judgement j = refuted(ends ? Reason::ends : continuum ? Reason::continuum : Reason::forces);
  j.mode = claim.mode;
  j.witnesses = std::move(differ.front());
  j.claimed = std::move(one);
  j.real = std::move(real);
  return j;
}

Judgement ClaimJudge::of(const Impossible& claim) {
  const auto claimed = sample_.true_at(programs_.forces);
  if (claimed.parts.empty()) return claimed.valued() ? Judgement{} : undecided();
  bool modelled = true;
  for (const MechanismMode& mode : claim.modes) {
    const auto s = find(mode);
    modelled = modelled && s;
    if (!s) continue;
    for (const ForceInterval& part : claimed.parts) {
      ForceInterval real = common(forces_of(*s), part);
      if (real.empty()) continue;
      Judgement j = refuted(s->continuum ? Reason::continuum : Reason::exists);
      j.mode = mode;
      j.witnesses = real;
      j.real = std::move(real);
      return j;
    }
  }
  return modelled && claimed.valued() ? holds() : undecided();
}

Judgement ClaimJudge::of(const Formula& claim) {
  const auto where = sample_.true_at(programs_.forces);
  Judgement j = where.parts.empty()   ? Judgement{}
                : claim.modes.empty() ? formula_on(where.parts, nullptr)
                                      : formula_in_modes(claim.modes, where.parts);
  return where.valued() || j.outcome == Outcome::refuted ? j : undecided();
}

Judgement ClaimJudge::formula_in_modes(const Modes& modes, const Intervals& where) {
  return first_of(modes, [&](const MechanismMode& mode) {
    const auto s = find(mode);
    return s ? formula_in(mode, *s, where) : undecided();
  });
}

Judgement ClaimJudge::formula_in(const MechanismMode& mode, const ModeOverLoads& s, Intervals here) {
  for (ForceInterval& forces : here) forces.intersect(forces_of(s));
  std::erase_if(here, [](const ForceInterval& forces) { return forces.empty(); });
  if (here.empty()) return {};
  const ModeForms forms = *sample_.motions().forms(mode);
  if (sample_.set_motion(forms, programs_.holds.slots())) return formula_on(here, &mode);
  return first_of(here, [&](const ForceInterval& forces) { return formula_about_all(forces, mode, forms); });
}

Judgement ClaimJudge::formula_on(const Intervals& here, const MechanismMode* mode) {
  bool decided = true;
  for (const TruthCell& cell : sample_.over_forces(programs_.holds)) {
    for (const ForceInterval& forces : here) {
      ForceInterval both = common(cell.forces, forces);
      if (both.empty() || cell.truth == Truth::yes) continue;
      decided = decided && !no_value(cell.truth);
      if (no_value(cell.truth)) continue;
      Judgement j = refuted(Reason::formula);
      if (mode != nullptr) j.mode = *mode;
      j.witnesses = std::move(both);
      return j;
    }
  }
  return decided ? holds() : undecided();
}

Judgement ClaimJudge::of(const Equivalence&) {
  if (domain().empty()) return {};
  bool decided = true;
  for (const TruthCell& x : sample_.over_forces(programs_.forces)) {
    for (const TruthCell& y : sample_.over_forces(programs_.holds)) {
      ForceInterval here = common(common(x.forces, y.forces), domain());
      if (here.empty()) continue;
      if (no_value(x.truth) || no_value(y.truth)) {
        decided = false;
      } else if (x.truth != y.truth) {
        Judgement j = refuted(Reason::formula);
        j.witnesses = std::move(here);
        return j;
      }
    }
  }
  return decided ? holds() : undecided();
}

Judgement ClaimJudge::of(const Exists& claim) {
  const auto where = sample_.true_at(programs_.forces);
  const bool modelled = std::all_of(claim.modes.begin(), claim.modes.end(),
                                    [&](const MechanismMode& mode) { return find(mode).has_value(); });
  for (ForceInterval forces : where.parts) {
    if (!modelled) break;
    for (const MechanismMode& mode : claim.modes) forces.intersect(forces_of(*find(mode)));
    if (forces.empty()) continue;
    Judgement j = holds();
    j.witnesses = std::move(forces);
    return j;
  }
  return modelled && where.valued() ? Judgement{} : undecided();
}

Judgement ClaimJudge::of(const Limit& claim) {
  const std::size_t index = file_.settings[claim_.setting].parameter_index(claim.parameter);
  const auto judged = [&](const auto& truth) {
    const Truth inside = truth(programs_.region);
    if (no_value(inside)) return undecided();
    if (inside == Truth::no) return Judgement{};
    const Truth holds = truth(programs_.holds);
    return no_value(holds) ? undecided() : holds == Truth::yes ? ClaimJudge::holds() : refuted(Reason::limit);
  };
  const CompiledSetting& setting = compiled_.settings[claim_.setting];
  if (sample_.eventually(setting.is_point(), index) == Truth::yes) {
    return judged([&](const Program& p) { return sample_.eventually(p, index); });
  }
  const auto last = last_points(setting, {&programs_.region, &programs_.holds}, sample_.values(), index);
  if (!last) return undecided();
  return first_of(*last,
                  [&](const auto& bicycle) { return judged([&](const Program& p) { return bicycle->region(p); }); });
}

std::optional<LinearRows> ClaimJudge::rows_of(const References& claims) {
  LinearRows rows;
  for (const std::size_t claim : claims) {
    auto more = rows_of(compiled_.claims[claim].body(reading_).equations);
    if (!more) return std::nullopt;
    rows.insert(rows.end(), more->begin(), more->end());
  }
  return rows;
}
std::optional<LinearRows> ClaimJudge::rows_of(const std::vector<Program>& equations) {
  return linear_rows(compiled_.settings[claim_.setting], sample_.values(), equations);
}

std::optional<ClaimJudge::Sides> ClaimJudge::sides(const LinearEquations& claim) {
  auto given = rows_of(claim.given), claims = rows_of(claim.claims), equations = rows_of(programs_.equations),
       assumed = rows_of(programs_.assume);
  if (!given || !claims || !equations || !assumed) return std::nullopt;
  Sides result{*given, *equations, *given};
  const auto append = [](LinearRows& rows, const LinearRows& more) {
    rows.insert(rows.end(), more.begin(), more.end());
  };
  append(result.left, claim.from_model() ? sample_.equations(claim.mode) : *claims);
  append(result.left, *assumed);
  append(result.right, *equations);
  return result;
}

std::vector<bool> ClaimJudge::occurring(const LinearEquations& claim) const {
  const CompiledSetting& setting = compiled_.settings[claim_.setting];
  std::vector<bool> occurs(setting.unknowns());
  const auto look = [&](const std::vector<Program>& equations) {
    for (const Program& equation : equations) {
      for (const std::size_t slot : equation.slots()) {
        for (std::size_t i = 0; i < occurs.size(); ++i) occurs[i] = occurs[i] || slot == setting.unknown_slot(i);
      }
    }
  };
  look(programs_.equations);
  for (const std::size_t other : claim.given) look(compiled_.claims[other].body(reading_).equations);
  return occurs;
}

Judgement ClaimJudge::of(const Consequence& claim) {
  const auto rows = sides(claim);
  if (!rows) return undecided();
  if (!has_solution(rows->left)) return {};
  if (follows(rows->equations, rows->left)) return holds();
  for (std::size_t i = 0; i < rows->equations.size(); ++i) {
    if (follows({rows->equations[i]}, rows->left)) continue;
    Judgement j = refuted(Reason::equation);
    j.equation = i;
    return j;
  }
  return refuted(Reason::equation);
}

Judgement ClaimJudge::of(const System& claim) {
  const auto rows = sides(claim);
  if (!rows) return undecided();
  if (!has_solution(rows->left) && !has_solution(rows->right)) return {};
  return equivalent(rows->left, rows->right, occurring(claim)) ? holds() : refuted(Reason::equation);
}

Judgement ClaimJudge::of(const Cover& claim) {
  bool decided = true;
  for (const std::size_t other : claim.claims) {
    const Truth inside = sample_.region(compiled_.claims[other].body(reading_).region);
    if (inside == Truth::yes) return holds();
    decided = decided && !no_value(inside);
  }
  if (!decided) return undecided();
  Judgement j = refuted(Reason::uncovered);
  for (const std::size_t other : claim.claims) {  // what really happens there, in the mode they are about
    const MechanismMode mode = modes(file_.claims[other].body(reading_).says).front();
    const auto s = find(mode);
    if (!s) continue;
    j.mode = mode;
    j.real = forces_of(*s);
    if (!j.real->empty()) j.witnesses = j.real;
    break;
  }
  return j;
}

Judgement ClaimJudge::of(const ForceCover& claim) {
  const auto where = sample_.true_at(programs_.forces);
  Intervals rest = where.parts, unsure;  // where nothing is stated, and where something may be
  for (const std::size_t other : claim.claims) {
    const CompiledBody& programs = compiled_.claims[other].body(reading_);
    const Truth inside = sample_.region(programs.region);
    if (inside == Truth::no) continue;
    const auto stated = sample_.true_at(programs.forces);
    if (no_value(inside)) {
      unsure.insert(unsure.end(), stated.parts.begin(), stated.parts.end());
    } else {
      for (const ForceInterval& part : stated.parts) rest = difference(rest, part);
    }
    unsure.insert(unsure.end(), stated.unvalued.begin(), stated.unvalued.end());
  }
  Intervals bare = rest;
  for (const ForceInterval& part : unsure) bare = difference(bare, part);
  if (!bare.empty()) {
    Judgement j = refuted(Reason::uncovered);
    j.witnesses = std::move(bare.front());
    return j;
  }
  if (!rest.empty() || !where.valued()) return undecided();
  return where.parts.empty() ? Judgement{} : holds();
}

Judgement judge(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading,
                SolvedSample& sample) {
  return ClaimJudge(file, compiled, claim, reading, sample).judge();
}

}  // namespace slipproof
