// Except where a claim of `except` applies, there is exactly one motion: the one that a claim of `claims` states, or a
// motion in one of the modes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "claims/kinds/kind_base.hpp"
#include "claims/kinds/unique_statements.hpp"

namespace slipproof {

namespace {

using Intervals = ClaimJudge::Intervals;

bool contains(const Intervals& parts, const Rational& force) {
  return std::any_of(parts.begin(), parts.end(), [&](const ForceInterval& part) { return part.contains(force); });
}

/// Where a claim that uniqueness refers to states forces, and the same with the ends of these forces.
struct Stated {
  MechanismMode mode;
  Intervals forces, near;
};

/// Nothing if a condition of the claim has no value.
std::optional<Stated> stated(ClaimJudge& at, std::size_t claim) {
  const CompiledBody& programs = at.programs(claim);
  Stated result{at.body(claim).modes.front(), {}, {}};
  const Truth inside = at.sample().region(programs.region);
  if (ClaimJudge::no_value(inside)) return std::nullopt;
  if (inside == Truth::no) return result;
  auto forces = at.sample().true_at(programs.forces), near = at.sample().true_at(programs.closure);
  if (!forces.valued()) return std::nullopt;
  result.forces = std::move(forces.parts);
  result.near = std::move(near.parts);
  return result;
}

/// Points and open intervals of forces on which neither the motions nor the claims change.
Intervals pieces(ClaimJudge& at, const std::vector<LoadCell>& cells, const std::vector<Intervals>& changes) {
  std::vector<Rational> cuts;
  const auto cut = [&](const ForceInterval& interval) {
    for (const auto& end : {interval.lower(), interval.upper()}) {
      if (end) cuts.push_back(*end);
    }
  };
  for (const LoadCell& cell : cells) cut(cell.loads);
  for (const Intervals& parts : changes) std::for_each(parts.begin(), parts.end(), cut);
  cut(at.domain());
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  Intervals result;
  std::optional<Rational> below;
  const auto add = [&](const ForceInterval& piece) {
    if (!ClaimJudge::common(piece, at.domain()).empty()) result.push_back(piece);
  };
  for (const Rational& x : cuts) {
    add(ForceInterval::open_between(below, x));
    add(ForceInterval::point(x));
    below = x;
  }
  add(ForceInterval::open_between(below, std::nullopt));
  return result;
}

std::optional<Judgement> not_one_motion(ClaimJudge& at, const std::vector<LoadCell>& cells, const ForceInterval& piece,
                                        const Modes& expected) {
  const auto fail = [&](Reason reason, std::optional<MechanismMode> mode) {
    return ClaimJudge::refuted(reason, std::move(mode), piece);
  };
  const Rational force = piece.sample();
  const auto cell =
      std::find_if(cells.begin(), cells.end(), [&](const LoadCell& c) { return c.loads.contains(force); });
  if (!cell->continua.empty()) return fail(Reason::continuum, cell->continua.front());
  for (const MotionOverLoads& motion : cell->motions) {
    const Modes modes = motion.all_modes();
    if (!have_common(modes, expected)) return fail(Reason::extra, modes.front());
  }
  if (cell->motions.size() > 1) return fail(Reason::extra, cell->motions[1].all_modes().front());
  const bool modelled =
      std::all_of(expected.begin(), expected.end(), [&](const MechanismMode& m) { return at.find(m).has_value(); });
  if (cell->motions.empty() && modelled) {
    return fail(Reason::missing, expected.size() == 1 ? std::optional(expected.front()) : std::nullopt);
  }
  return std::nullopt;
}

class UniqueKind : public KindBase {
 public:
  UniqueKind()
      : KindBase({.name = "unique",
                  .fields = {{"claims", Need::required, {"interval"}},
                             {"except", Need::optional, {"motions"}},
                             {"modes", Need::optional},
                             {"forces", Need::optional}},
                  .of_all_motions = true,
                  .compares_modes = Traits::Compares::always,
                  .says_by_region = true,
                  .in_planes = Traits::InPlanes::judged}) {}

  Judgement judge(ClaimJudge& at) const override {
    Intervals excepted;
    std::vector<Stated> known;
    for (const std::size_t other : at.body().except) {
      const auto forces = stated(at, other);
      if (!forces) return ClaimJudge::undecided();
      excepted.insert(excepted.end(), forces->near.begin(), forces->near.end());
    }
    for (const std::size_t other : at.body().claims) {
      auto forces = stated(at, other);
      if (!forces) return ClaimJudge::undecided();
      known.push_back(std::move(*forces));
    }
    const auto where = at.sample().true_at(at.programs().forces);
    std::vector<Intervals> changes{where.parts, excepted};
    Modes named = at.body().modes;
    for (const Stated& one : known) {
      changes.insert(changes.end(), {one.forces, one.near});
      named.push_back(one.mode);
    }
    const std::vector<LoadCell>& cells = at.sample().cells(named);
    bool judged = false;
    for (const ForceInterval& piece : pieces(at, cells, changes)) {
      const Rational force = piece.sample();
      if (!contains(where.parts, force) || contains(excepted, force)) continue;
      Modes expected;
      bool beside = false;  // at an end of the forces that a claim states
      for (const Stated& one : known) {
        if (contains(one.forces, force)) expected.push_back(one.mode);
        beside = beside || contains(one.near, force);
      }
      if (expected.empty() && beside) continue;
      judged = true;
      if (expected.empty()) {
        if (auto failure = not_one_motion(at, cells, piece, at.body().modes)) return *failure;
      }
      for (const MechanismMode& mode : expected) {
        if (auto failure = not_one_motion(at, cells, piece, {mode})) return *failure;
      }
    }
    if (!where.valued()) return ClaimJudge::undecided();
    if (!judged) return {};
    return at.complete() ? ClaimJudge::holds() : ClaimJudge::undecided();
  }

  void state(ClaimWriter& writer) const override { unique_statements(writer); }
  void refute(ClaimWriter& writer) const override { unique_refutation(writer); }

  bool says_nothing(const Implications& logic, std::size_t claim, const ClaimBody& body) const override {
    References named = body.claims;
    named.insert(named.end(), body.except.begin(), body.except.end());
    Lemmas lemmas;
    const auto has_value = [&](std::size_t other) {
      const ClaimBody& its = logic.body(other);
      return logic.of_any_force().has_value({body.region}, its.region, lemmas) &&
             logic.has_value({body.region, its.region}, its.forces, lemmas);
    };
    return std::all_of(named.begin(), named.end(), has_value) && KindBase::says_nothing(logic, claim, body);
  }

  ClaimWords words(const ClaimBody& claim, std::string_view) const override {
    ClaimWords words = {"there is one motion, "};
    if (!claim.modes.empty()) words.insert(words.end(), {"in one of ", claim.modes, " or "});
    words.insert(words.end(), {"as stated by ", claim.claims});
    if (!claim.except.empty()) words.insert(words.end(), {", except where ", claim.except, " stands"});
    return words;
  }
};

}  // namespace

const ClaimKind& unique_kind() {
  static const UniqueKind kind;
  return kind;
}

}  // namespace slipproof
