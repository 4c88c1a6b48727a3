// Claims about all motions at a force: which there are, and whether there is only one.
#include <algorithm>

#include "verify/claim_judge.hpp"

namespace slipproof {

Judgement ClaimJudge::motions() {
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

bool ClaimJudge::listed(ContactMode mode) const {
  return std::find(body_.modes.begin(), body_.modes.end(), mode) != body_.modes.end();
}

std::optional<ForceInterval> ClaimJudge::stated(std::size_t claim) {
  const CompiledBody& programs = compiled_.claims[claim].body(reading_);
  const Truth inside = sample_.region(programs.region);
  if (no_value(inside)) return std::nullopt;
  return inside == Truth::yes ? claimed_by(programs) : ForceInterval::nothing();
}

Judgement ClaimJudge::unique() {
  std::vector<ForceInterval> excepted;
  Known known;
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

std::vector<ForceInterval> ClaimJudge::pieces(const ForceInterval& where, const std::vector<ForceInterval>& excepted,
                                              const Known& known) {
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

std::optional<Judgement> ClaimJudge::not_unique(const ForceInterval& piece, const Rational& force, const Known& known) {
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

}  // namespace slipproof
