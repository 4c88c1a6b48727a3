#include "verify/judge.hpp"

#include <algorithm>
#include <array>

#include "verify/claim_judge.hpp"

namespace slipproof {

std::string_view name(Reason reason) {
  constexpr std::array<std::string_view, 12> names{"none",  "ends",    "forces",    "exists", "formula",  "continuum",
                                                   "extra", "missing", "uncovered", "limit",  "equation", "no value"};
  return names[static_cast<std::size_t>(reason)];
}

ForceInterval ClaimJudge::difference(const ForceInterval& x, const ForceInterval& y) {
  for (const auto& [a, b] : {std::pair(&x, &y), std::pair(&y, &x)}) {
    if (a->empty()) continue;
    if (b->empty()) return *a;
    const ForceInterval below = ForceInterval::between(std::nullopt, false, b->lower(), !b->lower_closed());
    const ForceInterval above = ForceInterval::between(b->upper(), !b->upper_closed(), std::nullopt, false);
    if (b->lower()) {
      if (auto part = common(*a, below); !part.empty()) return part;
    }
    if (b->upper()) {
      if (auto part = common(*a, above); !part.empty()) return part;
    }
  }
  return ForceInterval::nothing();
}

Judgement ClaimJudge::judge() {
  if (!sample_.force_domain()) return undecided();
  if (claim_.kind == ClaimKind::cover) return cover();
  if (claim_.kind == ClaimKind::limit) return limit();
  const Truth inside = sample_.region(programs_.region);
  if (no_value(inside)) return undecided();
  if (inside == Truth::no) return {};
  switch (claim_.kind) {
    case ClaimKind::interval:
      return interval();
    case ClaimKind::impossible:
      return impossible();
    case ClaimKind::formula:
      return formula();
    case ClaimKind::motions:
      return motions();
    case ClaimKind::unique:
      return unique();
    case ClaimKind::equivalence:
      return equivalence();
    case ClaimKind::exists:
      return exists();
    case ClaimKind::consequence:
    case ClaimKind::system:
      return linear();
    case ClaimKind::cover:
    case ClaimKind::limit:
      break;
  }
  return undecided();
}

std::optional<ForceInterval> ClaimJudge::claimed_by(const CompiledBody& programs) {
  auto parts = sample_.true_at(programs.forces);
  if (!parts || parts->size() > 1) return std::nullopt;
  return parts->empty() ? ForceInterval::nothing() : std::move(parts->front());
}

Judgement ClaimJudge::interval() {
  const ModeSolution* s = sample_.table().find(body_.modes.front());
  if (s == nullptr) return undecided();
  auto claimed = claimed_by(programs_);
  if (!claimed) return undecided();
  ForceInterval real = forces_of(*s);
  if (*claimed == real) return holds();
  const bool ends =
      !claimed->empty() && !real.empty() && claimed->interior() == real.interior() && !claimed->interior().empty();
  Judgement j = refuted(ends                                         ? Reason::ends
                        : s->kind() == ModeSolution::Kind::continuum ? Reason::continuum
                                                                     : Reason::forces);
  j.mode = s->mode();
  j.witnesses = difference(*claimed, real);
  j.claimed = std::move(claimed);
  j.real = std::move(real);
  return j;
}

Judgement ClaimJudge::impossible() {
  const auto claimed = claimed_by(programs_);
  if (!claimed) return undecided();
  for (const ContactMode mode : body_.modes) {
    const ModeSolution* s = sample_.table().find(mode);
    if (s == nullptr) return undecided();
    ForceInterval real = common(forces_of(*s), *claimed);
    if (real.empty()) continue;
    Judgement j = refuted(s->kind() == ModeSolution::Kind::continuum ? Reason::continuum : Reason::exists);
    j.mode = mode;
    j.witnesses = real;
    j.real = std::move(real);
    return j;
  }
  return holds();
}

Judgement ClaimJudge::formula() {
  const auto where = sample_.true_at(programs_.forces);
  if (!where) return undecided();
  if (body_.modes.empty()) return formula_on(*where, nullptr);
  Judgement result;
  for (const ContactMode mode : body_.modes) {
    const ModeSolution* s = sample_.table().find(mode);
    Judgement j = s == nullptr ? undecided() : formula_on(*where, s);
    if (j.outcome == Outcome::refuted) return j;
    if (j.outcome == Outcome::undecided || result.outcome == Outcome::outside) result = std::move(j);
  }
  return result;
}

Judgement ClaimJudge::formula_on(std::vector<ForceInterval> where, const ModeSolution* s) {
  if (s != nullptr) {
    for (ForceInterval& forces : where) forces.intersect(forces_of(*s));
  }
  std::erase_if(where, [](const ForceInterval& forces) { return forces.empty(); });
  if (where.empty()) return {};
  const auto fail = [&](Reason reason, ForceInterval witnesses) {
    Judgement j = refuted(reason);
    if (s != nullptr) j.mode = s->mode();
    j.witnesses = std::move(witnesses);
    return j;
  };
  if (s != nullptr) {
    if (s->kind() == ModeSolution::Kind::continuum) return fail(Reason::continuum, where.front());
    sample_.set_motion(s->motion());
  }
  bool decided = true;
  for (const TruthCell& cell : sample_.over_forces(programs_.holds)) {
    for (const ForceInterval& forces : where) {
      ForceInterval here = common(cell.forces, forces);
      if (here.empty() || cell.truth == Truth::yes) continue;
      if (!no_value(cell.truth)) return fail(Reason::formula, std::move(here));
      decided = false;
    }
  }
  return decided ? holds() : undecided();
}

Judgement ClaimJudge::equivalence() {
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

Judgement ClaimJudge::exists() {
  const auto where = sample_.true_at(programs_.forces);
  if (!where) return undecided();
  for (ForceInterval forces : *where) {
    for (const ContactMode mode : body_.modes) {
      const ModeSolution* s = sample_.table().find(mode);
      if (s == nullptr) return undecided();
      forces.intersect(forces_of(*s));
    }
    if (forces.empty()) continue;
    Judgement j = holds();
    j.witnesses = std::move(forces);
    return j;
  }
  return {};
}

Judgement ClaimJudge::limit() {
  const std::size_t index = file_.settings[claim_.setting].parameter_index(body_.parameter);
  const Truth inside = sample_.eventually(programs_.region, index);
  if (no_value(inside)) return undecided();
  if (inside == Truth::no) return {};
  const Truth truth = sample_.eventually(programs_.holds, index);
  if (no_value(truth)) return undecided();
  return truth == Truth::yes ? holds() : refuted(Reason::limit);
}

std::optional<LinearRows> ClaimJudge::rows_of(const std::vector<std::size_t>& claims) {
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

Judgement ClaimJudge::linear() {
  const auto given = rows_of(body_.given), claims = rows_of(body_.claims), equations = rows_of(programs_.equations);
  const auto assumed = rows_of(programs_.assume);
  if (!given || !claims || !equations || !assumed) return undecided();
  LinearRows left = *given, right = *given;
  left.insert(left.end(), claims->begin(), claims->end());
  right.insert(right.end(), equations->begin(), equations->end());
  if (body_.given.empty() && body_.claims.empty()) {
    const bool mode = !body_.modes.empty();
    left = sample_.equations(mode ? std::optional(body_.modes.front()) : std::nullopt);
  }
  left.insert(left.end(), assumed->begin(), assumed->end());
  const bool fine = claim_.kind == ClaimKind::system ? equivalent(left, right) : follows(*equations, left);
  return fine ? holds() : refuted(Reason::equation);
}

Judgement ClaimJudge::cover() {
  for (const std::size_t claim : body_.claims) {
    const Truth inside = sample_.region(compiled_.claims[claim].body(reading_).region);
    if (no_value(inside)) return undecided();
    if (inside == Truth::yes) return holds();
  }
  Judgement j = refuted(Reason::uncovered);
  for (const std::size_t claim : body_.claims) {  // what really happens there, in the mode they are about
    const auto& modes = file_.claims[claim].body(reading_).modes;
    if (modes.empty()) continue;
    const ModeSolution* s = sample_.table().find(modes.front());
    if (s == nullptr) continue;
    j.mode = s->mode();
    j.real = forces_of(*s);
    if (!j.real->empty()) j.witnesses = j.real;
    break;
  }
  return j;
}

Judgement judge(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading,
                SolvedSample& sample) {
  return ClaimJudge(file, compiled, claim, reading, sample).judge();
}

}  // namespace slipproof
