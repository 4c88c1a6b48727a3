// Claims about all motions at a force: which there are, and whether there is only one.
#include <algorithm>

#include "claims/judge/claim_judge.hpp"

namespace slipproof {

namespace {

bool names(const Modes& modes, const MechanismMode& mode) {
  return std::find(modes.begin(), modes.end(), mode) != modes.end();
}

bool have_common(const Modes& x, const Modes& y) {
  return std::any_of(x.begin(), x.end(), [&](const MechanismMode& mode) { return names(y, mode); });
}

Modes with_boundary(const MotionOverLoads& motion) {
  Modes modes = motion.modes;
  modes.insert(modes.end(), motion.boundary_modes.begin(), motion.boundary_modes.end());
  return modes;
}

}  // namespace

std::vector<const MotionOverLoads*> ClaimJudge::counted(const LoadCell& cell) const {
  std::vector<const MotionOverLoads*> found;
  for (const MotionOverLoads& motion : cell.motions) {
    if (!motion.modes.empty() || !strict()) found.push_back(&motion);
  }
  return found;
}

Modes ClaimJudge::modes_of(const MotionOverLoads& motion) const {
  return strict() ? motion.modes : with_boundary(motion);
}

std::optional<MechanismMode> ClaimJudge::continuum_at(const LoadCell& cell) {
  for (const MechanismMode& mode : cell.continua) {
    if (!common(sample_.forces_of(*find(mode), strict()), cell.loads).empty()) return mode;
  }
  return std::nullopt;
}

Judgement ClaimJudge::of(const Motions& claim) {
  const auto claimed = sample_.true_at(programs_.forces);
  if (claimed.parts.empty()) return claimed.valued() ? Judgement{} : undecided();
  for (const LoadCell& cell : sample_.cells()) {
    for (const ForceInterval& part : claimed.parts) {
      ForceInterval here = common(cell.loads, part);
      if (here.empty()) continue;
      auto failure = other_motions(claim, cell);
      if (!failure) continue;
      if (claimed.parts.size() == 1) failure->claimed = part;
      failure->witnesses = std::move(here);
      return *failure;
    }
  }
  return complete() && claimed.valued() ? holds() : undecided();
}

std::optional<Judgement> ClaimJudge::other_motions(const Motions& claim, const LoadCell& cell) {
  const auto fail = [](Reason reason, const MechanismMode& mode) {
    Judgement j = refuted(reason);
    j.mode = mode;
    return j;
  };
  if (const auto mode = continuum_at(cell)) return fail(Reason::continuum, *mode);
  const auto motions = counted(cell);
  for (const MotionOverLoads* motion : motions) {
    const Modes modes = modes_of(*motion);
    if (!have_common(modes, claim.modes)) return fail(Reason::extra, modes.front());
  }
  for (const MechanismMode& mode : claim.modes) {
    const auto in_mode = [&](const MotionOverLoads* motion) { return names(modes_of(*motion), mode); };
    if (find(mode) && std::none_of(motions.begin(), motions.end(), in_mode)) return fail(Reason::missing, mode);
  }
  return std::nullopt;
}

std::optional<ClaimJudge::Stated> ClaimJudge::stated(std::size_t claim) {
  const CompiledBody& programs = compiled_.claims[claim].body(reading_);
  Stated result{modes(file_.claims[claim].body(reading_).says).front(), {}, {}};
  const Truth inside = sample_.region(programs.region);
  if (no_value(inside)) return std::nullopt;
  if (inside == Truth::no) return result;
  auto forces = sample_.true_at(programs.forces), near = sample_.true_at(programs.closure);
  if (!forces.valued()) return std::nullopt;
  result.forces = std::move(forces.parts);
  result.near = std::move(near.parts);
  return result;
}

Judgement ClaimJudge::of(const Unique& claim) {
  Intervals excepted;
  std::vector<Stated> known;
  for (const std::size_t other : claim.except) {
    const auto forces = stated(other);
    if (!forces) return undecided();
    excepted.insert(excepted.end(), forces->near.begin(), forces->near.end());
  }
  for (const std::size_t other : claim.claims) {
    auto forces = stated(other);
    if (!forces) return undecided();
    known.push_back(std::move(*forces));
  }
  const auto where = sample_.true_at(programs_.forces);
  std::vector<Intervals> changes{where.parts, excepted};
  for (const Stated& one : known) {
    changes.push_back(one.forces);
    changes.push_back(one.near);
  }
  bool judged = false;
  for (const ForceInterval& piece : pieces(changes)) {
    const Rational force = piece.sample();
    if (!contains(where.parts, force) || contains(excepted, force)) continue;
    Modes expected;
    bool beside = false;  // an end of what a claim states
    for (const Stated& one : known) {
      if (contains(one.forces, force)) expected.push_back(one.mode);
      beside = beside || contains(one.near, force);
    }
    if (expected.empty() && beside) continue;
    judged = true;
    const bool stated_here = !expected.empty();
    if (!stated_here) {
      if (auto failure = not_one_motion(piece, claim.modes)) return *failure;
      continue;
    }
    for (const MechanismMode& mode : expected) {
      if (auto failure = not_one_motion(piece, {mode})) return *failure;
    }
  }
  if (!where.valued()) return undecided();
  if (!judged) return {};
  return complete() ? holds() : undecided();
}

ClaimJudge::Intervals ClaimJudge::pieces(const std::vector<Intervals>& changes) {
  std::vector<Rational> cuts;
  const auto cut = [&](const ForceInterval& interval) {
    for (const auto& end : {interval.lower(), interval.upper()}) {
      if (end) cuts.push_back(*end);
    }
  };
  for (const LoadCell& cell : sample_.cells()) cut(cell.loads);
  for (const Intervals& parts : changes) std::for_each(parts.begin(), parts.end(), cut);
  cut(domain());
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  Intervals result;
  std::optional<Rational> below;
  const auto add = [&](const ForceInterval& piece) {
    if (!common(piece, domain()).empty()) result.push_back(piece);
  };
  for (const Rational& x : cuts) {
    add(ForceInterval::open_between(below, x));
    add(ForceInterval::point(x));
    below = x;
  }
  add(ForceInterval::open_between(below, std::nullopt));
  return result;
}

std::optional<Judgement> ClaimJudge::not_one_motion(const ForceInterval& piece, const Modes& expected) {
  const auto fail = [&](Reason reason, std::optional<MechanismMode> mode) {
    Judgement j = refuted(reason);
    j.mode = mode;
    j.witnesses = piece;
    return j;
  };
  const Rational force = piece.sample();
  const auto& cells = sample_.cells();
  const auto cell =
      std::find_if(cells.begin(), cells.end(), [&](const LoadCell& c) { return c.loads.contains(force); });
  if (!cell->continua.empty()) return fail(Reason::continuum, cell->continua.front());
  for (const MotionOverLoads& motion : cell->motions) {
    const Modes modes = with_boundary(motion);
    if (!have_common(modes, expected)) return fail(Reason::extra, modes.front());
  }
  if (cell->motions.size() > 1) return fail(Reason::extra, with_boundary(cell->motions[1]).front());
  const bool modelled =
      std::all_of(expected.begin(), expected.end(), [&](const MechanismMode& m) { return find(m).has_value(); });
  if (cell->motions.empty() && modelled) {
    return fail(Reason::missing, expected.size() == 1 ? std::optional(expected.front()) : std::nullopt);
  }
  return std::nullopt;
}

}  // namespace slipproof
