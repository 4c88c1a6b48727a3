#include "report/scenes/mechanism_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "base/input/diagnostic.hpp"
#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "mechanics/mechanism/words.hpp"
#include "report/picture/motion_words.hpp"
#include "report/values/every_load.hpp"
#include "report/values/number_text.hpp"
#include "report/values/quantity_units.hpp"

namespace slipproof {

namespace {

/// Builds the document of one scene.
class SolveText {
 public:
  SolveText(const SolvedMechanism& solved, const std::optional<EveryLoad>& every_q, int digits)
      : solved_(solved),
        every_q_(every_q),
        mechanism_(solved.scene.mechanism),
        accelerations_(acceleration_names(mechanism_)),
        forces_(force_names(mechanism_)),
        acceleration_units_(acceleration_units(mechanism_)),
        force_units_(force_units(mechanism_)),
        digits_(digits) {}

  Document whole() {
    const MechanismScene& scene = solved_.scene;
    const double modes = mode_count(element_kinds(mechanism_, scene.values.starts, scene.values.given));
    document_ = scene_document(scene, mechanism_.name + ", " +
                                          (modes < 1e15 ? counted(static_cast<std::size_t>(modes), "contact mode")
                                                        : fmt::format("{:.3g} contact modes", modes)));
    if (solved_.by_kinematics) {
      document_.paragraph(
          "Too many modes to try each: every motion is found, but not every mode at its border, and rejected modes are "
          "not listed.");
    }
    if (solved_.at_load) {
      write_motions(*solved_.at_load);
    } else {
      write_ranges();
      write_cells();
    }
    return std::move(document_);
  }

 private:
  void write_value(ReportTable& table, const std::string& name, const Range& range, const std::string& unit) const {
    table.row({name, range.is_point()
                         ? number_text(*range.lower, digits_, unit)
                         : "in " + to_string(ForceInterval::between(range.lower, true, range.upper, true)) +
                               unit_suffix(unit)});
  }

  /// As many names as a line holds, and how many more there are.
  static std::string first_of(const std::vector<MechanismMode>& modes, std::string_view between) {
    constexpr std::size_t shown = 8;
    const std::size_t count = std::min(modes.size(), shown);
    const auto name_of = [](const MechanismMode& mode) { return name(mode); };
    return listed(std::vector(modes.begin(), modes.begin() + static_cast<std::ptrdiff_t>(count)), name_of, between) +
           (modes.size() > count ? " and " + counted(modes.size() - count, "other") : "");
  }

  void write_motion(Document& document, const MotionAtLoad& motion) const {
    Document& below = document.section(equal_modes(motion.strict() ? motion.modes : motion.boundary_modes) +
                                       (motion.strict() ? "  (strict)" : "  (boundary)"));
    if (motion.strict() && !motion.boundary_modes.empty()) {
      below.line("on the boundary of " + first_of(motion.boundary_modes, " = "));
    }
    if (!motion.continua.empty()) below.line("in the continuum of " + first_of(motion.continua, ", in that of "));
    ReportTable& table = below.table({{"", ""}});
    for (std::size_t i = 0; i < accelerations_.size(); ++i) {
      table.row({accelerations_[i], number_text(motion.accelerations[i], digits_, acceleration_units_[i])});
    }
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      write_value(table, forces_[i], motion.forces[i], force_units_[i]);
    }
  }

  void write_continuum(Document& document, const MotionsAtLoad& found, const ContinuumAtLoad& continuum) const {
    Document& below = document.section(name(continuum.mode) + "  a continuum of motions " +
                                       (continuum.strict ? "(strict)" : "(boundary)"));
    const std::vector<MechanismMode> inside = modes_in(found, continuum);
    if (!inside.empty()) below.line("contains the motions of " + first_of(inside, ", "));
    ReportTable& table = below.table({{"", ""}});
    for (std::size_t i = 0; i < accelerations_.size(); ++i) {
      write_value(table, accelerations_[i], continuum.accelerations[i], acceleration_units_[i]);
    }
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      write_value(table, forces_[i], continuum.forces[i], force_units_[i]);
    }
  }

  /// One by one, or, if that takes more than some pages, counted by what is violated.
  void write_rejected(const std::vector<RejectedMode>& rejected) {
    constexpr std::size_t most_listed = 1024;
    if (rejected.size() > most_listed) return count_rejected(rejected);
    ReportTable& table =
        document_.section("Rejected, with what is violated", {0, 4}).table({{{"", false, 12}, {"", false, 14}, ""}});
    for (const RejectedMode& mode : rejected) {
      std::vector<ReportCell> cells{name(mode.mode), what_is_broken(mechanism_, mode)};
      if (mode.margin) cells.emplace_back(number_text(*mode.margin, digits_, {}, 28));
      table.row(std::move(cells));
    }
  }

  void count_rejected(const std::vector<RejectedMode>& rejected) {
    std::map<std::string, std::size_t> counts;
    for (const RejectedMode& mode : rejected) ++counts[what_is_broken(mechanism_, mode)];
    ReportTable& table = document_.section("Rejected, counted by what is violated (--json lists each)", {0, 4})
                             .table({{{"", false, 14}, {"", true}}});
    for (const auto& [broken, count] : counts) table.row({broken, counted(count, "mode")});
  }

  void write_motions(const MotionsAtLoad& found) {
    std::string heading = counted_motions(found);
    if (solved_.scene.load) {
      heading = fmt::format("{} = {} {}: {}", mechanism_.load->symbol, exact_text(*solved_.scene.load),
                            mechanism_.load->unit, heading);
    }
    Document& section = document_.section(heading);
    for (const MotionAtLoad& motion : found.motions) write_motion(section, motion);
    for (const ContinuumAtLoad& continuum : found.continua) write_continuum(section, found, continuum);
    if (!found.hysteresis.empty()) {
      document_.paragraph(
          "Hysteresis: with the static coefficients as low as the kinetic ones one motion is left, without " +
          equal_modes(found.hysteresis));
    }
    if (!found.rejected.empty()) write_rejected(found.rejected);
    document_.line(every_load_line(every_q_));
    const auto strict =
        std::count_if(found.motions.begin(), found.motions.end(), [](const auto& m) { return m.strict(); });
    document_.status(fmt::format("s SOLVED motions {} strict {} continua {} rejected {}", found.motions.size(), strict,
                                 found.continua.size(), found.rejected.size()));
  }

  void write_ranges() {
    const std::string& symbol = mechanism_.load->symbol;
    ReportTable& table = document_.section("Loads " + symbol + " for which each mode has a motion", {0, 4})
                             .table({{{"", false, 12}, {"", false, 28}, ""}});
    for (const ConsistentMode& mode : solved_.modes) {
      table.row({name(mode.mode), interval_text(symbol, mode.solutions.loads, digits_),
                 to_string(mode.solutions.loads) + (mode.determined ? "" : "  a continuum of motions")});
    }
  }

  void write_cells() {
    ReportTable& table =
        document_.section("The line of loads, cut where the motions change", {0, 4}).table({{{"", false, 28}, ""}});
    for (const LoadCell& cell : solved_.cells) {
      std::vector<std::string> motions;
      for (const MotionOverLoads& motion : cell.motions) {
        motions.push_back(motion.modes.empty() ? equal_modes(motion.boundary_modes) + " (boundary)"
                                               : equal_modes(motion.modes));
      }
      for (const MechanismMode& mode : cell.continua) motions.push_back(name(mode) + " (continuum)");
      if (motions.empty()) motions.emplace_back("no motion");
      table.row({interval_text(mechanism_.load->symbol, cell.loads, digits_), listed(motions, "; ")});
    }
    document_.line(every_load_line(every_q_));
    document_.status(fmt::format("s SOLVED modes {} cells {}", solved_.modes.size(), solved_.cells.size()));
  }

  const SolvedMechanism& solved_;
  const std::optional<EveryLoad>& every_q_;
  const Mechanism& mechanism_;
  std::vector<std::string> accelerations_, forces_, acceleration_units_, force_units_;
  int digits_;
  Document document_;
};

}  // namespace

Document scene_document(const MechanismScene& scene, const std::string& about) {
  Document document;
  document.title(scene.name + ": " + about);
  for (const std::string& note : scene.notes) document.paragraph("note: " + note);
  for (const MechanismContact& contact : scene.mechanism.contacts) {
    for (const std::size_t parameter : missing_for_lift(contact, scene.values.given)) {
      document.line(fmt::format("note: without {} the contact {} does not open: that is not modelled",
                                scene.mechanism.parameters[parameter].symbol, contact.name));
    }
  }
  return document;
}

std::string what_is_broken(const Mechanism& mechanism, const RejectedMode& mode) {
  std::string text;
  for (const ViolatedCondition& c : mode.because) {
    const std::string condition = condition_name(mechanism, c.element, c.state, c.condition);
    if (!text.ends_with(condition)) text += (text.empty() ? "" : " against ") + condition;
  }
  return text.empty() ? "its equations have no solution" : text;
}

Document solve_document(const SolvedMechanism& solved, const std::optional<EveryLoad>& every_q, int digits) {
  return SolveText(solved, every_q, digits).whole();
}

}  // namespace slipproof
