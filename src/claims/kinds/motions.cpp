// At each of the forces there is one motion in each of the modes, and no other motion.
#include <fmt/format.h>

#include "claims/kinds/kind_base.hpp"

namespace slipproof {

namespace {

class MotionsKind : public KindBase {
 public:
  MotionsKind()
      : KindBase({.name = "motions",
                  .fields = {{"modes"}, {"forces", Need::optional}},
                  .of_all_motions = true,
                  .compares_modes = Traits::Compares::in_closed_settings,
                  .in_planes = Traits::InPlanes::judged}) {}

  Judgement judge(ClaimJudge& at) const override {
    const auto claimed = at.sample().true_at(at.programs().forces);
    if (claimed.parts.empty()) return claimed.valued() ? Judgement{} : ClaimJudge::undecided();
    for (const LoadCell& cell : at.sample().cells(at.body().modes)) {
      for (const ForceInterval& part : claimed.parts) {
        ForceInterval here = ClaimJudge::common(cell.loads, part);
        if (here.empty()) continue;
        auto failure = other_motions(at, cell);
        if (!failure) continue;
        if (claimed.parts.size() == 1) failure->claimed = part;
        failure->witnesses = std::move(here);
        return *failure;
      }
    }
    return at.complete() && claimed.valued() ? ClaimJudge::holds() : ClaimJudge::undecided();
  }

  /// ID.1, ID.2, ...: there is a motion in each mode; ID.1.one, ...: only one; ID.complete: each motion is in one of
  /// the modes.
  void state(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    const Assumptions assumptions = {{"region", claim.region}, {"force", claim.forces}};
    const bool strict = writer.setting().strict;
    std::vector<Expression> modes;
    for (std::size_t i = 0; i < claim.modes.size(); ++i) {
      const MechanismMode& mode = claim.modes[i];
      const StatedMotion motion = writer.motion(mode);
      writer.exists({fmt::format(".{}", i + 1), assumptions, {}, true, {}, true}, motion);
      writer.one_motion(fmt::format(".{}.one", i + 1), assumptions, motion, motion);
      modes.push_back(braced(writer.mechanics().in_mode(mode)));
    }
    if (writer.mechanics().may_leave_forces_open() && !claim.modes.empty()) {
      writer.same_as_one_of(".complete", assumptions, claim.modes, strict);
    } else {
      writer.implied({".complete", assumptions, writer.any_motion(strict)},
                     modes.empty() ? make_truth(false) : disjoined(modes), {});
    }
    writer.have_values(".defined", claim.region, claim.forces);
  }

  /// Writes a motion in none of the modes; gives up if all modes are listed. A strict motion is in one mode only,
  /// unless forces are undetermined. A boundary motion may also be in a listed mode, so the conditions of the listed
  /// modes must fail.
  void refute(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    const bool strict = writer.setting().strict;
    std::vector<Expression> in_none;
    if (!strict || writer.mechanics().may_leave_forces_open()) {
      for (const MechanismMode& mode : claim.modes) in_none.push_back(braced(writer.mechanics().mode_missed(mode)));
    }
    std::vector<ClaimWriter::ModeAndMore> others;
    for (const MechanismMode& mode : writer.mechanics().modes()) {
      if (!names(claim.modes, mode)) others.emplace_back(mode, conjoined(in_none));
    }
    if (others.empty()) writer.give_up();
    writer.somewhere(refuted_suffix, {claim.region, claim.forces}, {writer.one_of(others, strict)});
  }

  ClaimWords words(const ClaimBody& claim, std::string_view) const override {
    return {"there is one motion in each of ", claim.modes, ", and no other"};
  }

 private:
  static std::optional<Judgement> other_motions(ClaimJudge& at, const LoadCell& cell) {
    for (const MechanismMode& mode : cell.continua) {
      const bool here = !ClaimJudge::common(at.forces_of(*at.find(mode)), cell.loads).empty();
      if (here) return ClaimJudge::refuted(Reason::continuum, mode);
    }
    // In a strict setting only strict motions and their modes count.
    std::vector<Modes> motions;
    for (const MotionOverLoads& motion : cell.motions) {
      if (!motion.modes.empty() || !at.strict()) motions.push_back(at.strict() ? motion.modes : motion.all_modes());
    }
    const Modes& stated = at.body().modes;
    for (const Modes& modes : motions) {
      if (!have_common(modes, stated)) return ClaimJudge::refuted(Reason::extra, modes.front());
    }
    for (const MechanismMode& mode : stated) {
      const auto in_mode = [&](const Modes& modes) { return names(modes, mode); };
      if (at.find(mode) && std::none_of(motions.begin(), motions.end(), in_mode)) {
        return ClaimJudge::refuted(Reason::missing, mode);
      }
    }
    return std::nullopt;
  }
};

}  // namespace

const ClaimKind& motions_kind() {
  static const MotionsKind kind;
  return kind;
}

}  // namespace slipproof
