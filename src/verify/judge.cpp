#include "verify/judge.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "verify/linear_system.hpp"

namespace slipproof {

std::string_view name(Reason reason) {
  constexpr std::array<std::string_view, 12> names{"none",  "ends",    "forces",    "exists", "formula",  "continuum",
                                                   "extra", "missing", "uncovered", "limit",  "equation", "no value"};
  return names[static_cast<std::size_t>(reason)];
}

namespace {

Judgement made(Outcome outcome, Reason reason) {
  Judgement j;
  j.outcome = outcome;
  j.reason = reason;
  return j;
}
Judgement refuted(Reason reason) {
  return made(Outcome::refuted, reason);
}
Judgement undecided() {
  return made(Outcome::undecided, Reason::no_value);
}
Judgement holds() {
  return made(Outcome::holds, Reason::none);
}

bool no_value(Truth truth) {
  return truth == Truth::undefined || truth == Truth::undecided;
}

ForceInterval common(ForceInterval x, const ForceInterval& y) {
  x.intersect(y);
  return x;
}

/// Some forces that are in one interval and not in the other; the intervals differ.
ForceInterval difference(const ForceInterval& x, const ForceInterval& y) {
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

class Judge {
 public:
  Judge(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading,
        SolvedSample& sample)
      : file_(file),
        compiled_(compiled),
        claim_(file.claims[claim]),
        body_(claim_.body(reading)),
        programs_(compiled.claims[claim].body(reading)),
        reading_(reading),
        sample_(sample) {}

  Judgement judge() {
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

 private:
  const ForceInterval& domain() const { return *sample_.force_domain(); }
  bool strict() const { return file_.settings[claim_.setting].strict; }

  /// The forces of a mode inside the paper's domain.
  ForceInterval forces_of(const ModeSolution& s) const { return sample_.forces_of(s, strict()); }
  /// Where a claim's `forces` is true, if that is one interval.
  std::optional<ForceInterval> claimed_by(const CompiledBody& programs) {
    auto parts = sample_.true_at(programs.forces);
    if (!parts || parts->size() > 1) return std::nullopt;
    return parts->empty() ? ForceInterval::nothing() : std::move(parts->front());
  }

  Judgement interval() {
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

  Judgement impossible() {
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

  Judgement formula() {
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

  Judgement formula_on(std::vector<ForceInterval> where, const ModeSolution* s) {
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

  Judgement equivalence() {
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

  Judgement exists() {
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

  Judgement limit() {
    const std::size_t index = file_.settings[claim_.setting].parameter_index(body_.parameter);
    const Truth inside = sample_.eventually(programs_.region, index);
    if (no_value(inside)) return undecided();
    if (inside == Truth::no) return {};
    const Truth truth = sample_.eventually(programs_.holds, index);
    if (no_value(truth)) return undecided();
    return truth == Truth::yes ? holds() : refuted(Reason::limit);
  }

  std::optional<LinearRows> rows_of(const std::vector<std::size_t>& claims) {
    LinearRows rows;
    for (const std::size_t claim : claims) {
      auto more = rows_of(compiled_.claims[claim].body(reading_).equations);
      if (!more) return std::nullopt;
      rows.insert(rows.end(), more->begin(), more->end());
    }
    return rows;
  }
  std::optional<LinearRows> rows_of(const std::vector<Program>& equations) {
    return linear_rows(compiled_.settings[claim_.setting], sample_.values(), equations);
  }

  Judgement linear() {
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

  /// Motions that count: all of an open cell that are strict (all, if the paper's conditions are not strict).
  bool counts(const FoundMotion<Affine<Rational>>& motion) const { return motion.strict || !strict(); }

  Judgement motions() {
    const auto claimed = claimed_by(programs_);
    if (!claimed) return undecided();
    if (claimed->empty()) return {};
    for (const Cell& cell : sample_.cells()) {
      ForceInterval here = common(cell.forces, *claimed);
      if (here.empty()) continue;
      const auto fail = [&](Reason reason, ContactMode mode) {
        Judgement j = refuted(reason);
        j.mode = mode;
        j.claimed = claimed;
        j.witnesses = here;
        return j;
      };
      if (!cell.continua.empty()) return fail(Reason::continuum, cell.continua.front());
      for (const auto& motion : cell.motions) {
        const bool known =
            std::any_of(motion.modes.begin(), motion.modes.end(), [&](ContactMode m) { return listed(m); });
        if (!known && counts(motion)) return fail(Reason::extra, motion.modes.front());
      }
      for (const ContactMode mode : body_.modes) {
        const bool there = std::any_of(cell.motions.begin(), cell.motions.end(), [&](const auto& motion) {
          return (counts(motion) || cell.forces.is_point()) &&
                 std::find(motion.modes.begin(), motion.modes.end(), mode) != motion.modes.end();
        });
        if (!there) return fail(Reason::missing, mode);
      }
    }
    return holds();
  }

  bool listed(ContactMode mode) const {
    return std::find(body_.modes.begin(), body_.modes.end(), mode) != body_.modes.end();
  }

  /// The forces that another claim states in its region; nothing() outside of it.
  std::optional<ForceInterval> stated(std::size_t claim) {
    const CompiledBody& programs = compiled_.claims[claim].body(reading_);
    const Truth inside = sample_.region(programs.region);
    if (no_value(inside)) return std::nullopt;
    return inside == Truth::yes ? claimed_by(programs) : ForceInterval::nothing();
  }

  /// Judged on open intervals of forces: at their ends two motions meet, and neither is strict.
  Judgement unique() {
    std::vector<ForceInterval> excepted;
    std::vector<std::pair<ContactMode, ForceInterval>> known;
    for (const std::size_t claim : body_.except) {
      auto forces = stated(claim);
      if (!forces) return undecided();
      excepted.push_back(std::move(*forces));
    }
    for (const std::size_t claim : body_.claims) {
      auto forces = stated(claim);
      if (!forces) return undecided();
      const ClaimBody& body = file_.claims[claim].body(reading_);
      if (!forces->empty()) known.emplace_back(body.modes.front(), std::move(*forces));
    }
    const auto where = claimed_by(programs_);
    if (!where) return undecided();
    bool judged = false;
    for (const ForceInterval& piece : pieces(*where, excepted, known)) {
      const Rational force = piece.sample();
      if (std::any_of(excepted.begin(), excepted.end(), [&](const auto& e) { return e.contains(force); })) continue;
      judged = true;
      if (auto failure = not_unique(piece, force, known)) return *failure;
    }
    return judged ? holds() : Judgement{};
  }

  /// Open intervals on which neither the motions nor the claims change.
  std::vector<ForceInterval> pieces(const ForceInterval& where, const std::vector<ForceInterval>& excepted,
                                    const std::vector<std::pair<ContactMode, ForceInterval>>& known) {
    std::vector<Rational> cuts;
    const auto cut = [&](const ForceInterval& interval) {
      for (const auto& end : {interval.lower(), interval.upper()}) {
        if (end) cuts.push_back(*end);
      }
    };
    for (const Cell& cell : sample_.cells()) cut(cell.forces);
    for (const ForceInterval& interval : excepted) cut(interval);
    for (const auto& [mode, interval] : known) cut(interval);
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    std::vector<ForceInterval> result;
    std::optional<Rational> below;
    const auto add = [&](std::optional<Rational> upper) {
      ForceInterval piece = common(ForceInterval::between(below, false, upper, false), where).interior();
      if (!piece.empty()) result.push_back(std::move(piece));
      below = std::move(upper);
    };
    for (const Rational& x : cuts) add(x);
    add(std::nullopt);
    return result;
  }

  std::optional<Judgement> not_unique(const ForceInterval& piece, const Rational& force,
                                      const std::vector<std::pair<ContactMode, ForceInterval>>& known) {
    const auto fail = [&](Reason reason, std::optional<ContactMode> mode) {
      Judgement j = refuted(reason);
      j.mode = mode;
      j.witnesses = piece;
      return j;
    };
    const auto& cells = sample_.cells();
    const auto cell = std::find_if(cells.begin(), cells.end(), [&](const Cell& c) { return c.forces.contains(force); });
    if (!cell->continua.empty()) return fail(Reason::continuum, cell->continua.front());
    std::optional<ContactMode> only;
    // One motion alone that is on a boundary at all of these forces is a motion, too.
    const bool alone = cell->motions.size() == 1;
    for (const auto& motion : cell->motions) {
      if (!counts(motion) && !alone) continue;
      for (const ContactMode mode : motion.modes) {
        const bool expected = listed(mode) || std::any_of(known.begin(), known.end(), [&](const auto& k) {
                                return k.first == mode && k.second.contains(force);
                              });
        if (!expected) return fail(Reason::extra, mode);
      }
      if (only) return fail(Reason::extra, motion.modes.front());
      only = motion.modes.front();
    }
    if (!only) return fail(Reason::missing, std::nullopt);
    for (const auto& [mode, forces] : known) {
      if (mode != *only && forces.contains(force)) return fail(Reason::missing, mode);
    }
    return std::nullopt;
  }

  Judgement cover() {
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

  const ClaimsFile& file_;
  const CompiledClaims& compiled_;
  const Claim& claim_;
  const ClaimBody& body_;
  const CompiledBody& programs_;
  Reading reading_;
  SolvedSample& sample_;
};

}  // namespace

Judgement judge(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading,
                SolvedSample& sample) {
  return Judge(file, compiled, claim, reading, sample).judge();
}

}  // namespace slipproof
