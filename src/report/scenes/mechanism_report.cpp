#include "report/scenes/mechanism_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/input/diagnostic.hpp"
#include "base/number/format.hpp"
#include "mechanics/mechanism/words.hpp"
#include "report/values/every_load.hpp"
#include "report/values/number_text.hpp"

namespace slipproof {

namespace {

FrictionProblem checked_problem(const MechanismScene& scene) {
  refuse_too_many_modes(scene.mechanism, element_kinds(scene.mechanism, scene.values.starts, scene.values.given));
  FrictionProblem problem;
  try {
    problem = friction_problem(scene.mechanism, scene.values);
  } catch (const NoValue& error) {
    throw InputError({{scene.mechanism.file, 0, 0, error.what()}});
  }
  return without_equations(problem);
}

}  // namespace

SolvedMechanism::SolvedMechanism(MechanismScene given) : scene(std::move(given)), problem(checked_problem(scene)) {
  if (problem.has_load) modes = ModeSolver(problem, std::nullopt).consistent();
  if (scene.load || !problem.has_load) {
    at_load = motions_of(problem, scene.load);
    // Modes that were excluded together share a reason. Solved alone, each has its own reason, which may be a single
    // condition.
    const ModeSolver solver(problem, scene.load);
    for (RejectedMode& rejected : at_load->rejected) {
      if (!rejected.margin) rejected = std::move(solver.one(rejected.mode).rejected.front());
    }
  } else {
    cells = cells_of(problem, modes);
  }
  if (const auto contacts = contact_problem(problem)) for_every_q = for_every_load(*contacts);
}

namespace {

using Out = std::back_insert_iterator<std::string>;

/// Builds the text for one scene.
class SolveText {
 public:
  SolveText(const SolvedMechanism& solved, int digits)
      : solved_(solved),
        mechanism_(solved.scene.mechanism),
        accelerations_(acceleration_names(mechanism_)),
        forces_(force_names(mechanism_)),
        digits_(digits) {
    for (const auto* names : {&accelerations_, &forces_}) {
      for (const std::string& name : *names) width_ = std::max(width_, name.size());
    }
  }

  std::string whole() {
    const MechanismScene& scene = solved_.scene;
    const double modes = mode_count(element_kinds(mechanism_, scene.values.starts, scene.values.given));
    fmt::format_to(out_, "{}: {}, {}\n", scene.name, mechanism_.name,
                   counted(static_cast<std::size_t>(modes), "contact mode"));
    text_ += notes_text(scene);
    if (solved_.at_load) {
      write_motions(*solved_.at_load);
    } else {
      write_ranges();
      write_cells();
    }
    return std::move(text_);
  }

 private:
  void write_value(const std::string& name, const Range& range) {
    if (range.is_point()) {
      fmt::format_to(out_, "    {:<{}} {}\n", name, width_, number_text(*range.lower, digits_));
    } else {
      fmt::format_to(out_, "    {:<{}} in {}\n", name, width_,
                     to_string(ForceInterval::between(range.lower, true, range.upper, true)));
    }
  }

  void write_motion(const MotionAtLoad& motion) {
    fmt::format_to(out_, "\n  {}  ({})\n", equal_modes(motion.strict() ? motion.modes : motion.boundary_modes),
                   motion.strict() ? "strict" : "boundary");
    if (motion.strict() && !motion.boundary_modes.empty()) {
      fmt::format_to(out_, "    on the boundary of {}\n", equal_modes(motion.boundary_modes));
    }
    for (std::size_t i = 0; i < accelerations_.size(); ++i) {
      fmt::format_to(out_, "    {:<{}} {}\n", accelerations_[i], width_, number_text(motion.accelerations[i], digits_));
    }
    for (std::size_t i = 0; i < forces_.size(); ++i) write_value(forces_[i], motion.forces[i]);
  }

  void write_continuum(const ContinuumAtLoad& continuum) {
    fmt::format_to(out_, "\n  {}  a continuum of motions ({})\n", name(continuum.mode),
                   continuum.strict ? "strict" : "boundary");
    for (std::size_t i = 0; i < accelerations_.size(); ++i) write_value(accelerations_[i], continuum.accelerations[i]);
    for (std::size_t i = 0; i < forces_.size(); ++i) write_value(forces_[i], continuum.forces[i]);
  }

  /// A single broken condition is in a column of its own, before the margins.
  void write_rejected(const RejectedMode& mode) {
    const std::string broken = what_is_broken(mechanism_, mode);
    if (mode.margin) {
      fmt::format_to(out_, "    {:<12} {:<14} {}\n", name(mode.mode), broken, number_text(*mode.margin, digits_));
    } else {
      fmt::format_to(out_, "    {:<12} {}\n", name(mode.mode), broken);
    }
  }

  void write_motions(const MotionsAtLoad& found) {
    if (solved_.scene.load) {
      fmt::format_to(out_, "\n{} = {} {}: ", mechanism_.load->symbol, exact_text(*solved_.scene.load),
                     mechanism_.load->unit);
    } else {
      fmt::format_to(out_, "\n");
    }
    fmt::format_to(out_, "{}\n", counted(found.motions.size(), "motion"));
    for (const MotionAtLoad& motion : found.motions) write_motion(motion);
    for (const ContinuumAtLoad& continuum : found.continua) write_continuum(continuum);
    if (!found.hysteresis.empty()) {
      fmt::format_to(out_,
                     "\nHysteresis: with the static coefficients as low as the kinetic ones one motion is left,\n"
                     "without {}\n",
                     equal_modes(found.hysteresis));
    }
    if (!found.rejected.empty()) fmt::format_to(out_, "\nRejected, with what is violated\n");
    for (const RejectedMode& mode : found.rejected) write_rejected(mode);
    write_every_q();
    const auto strict =
        std::count_if(found.motions.begin(), found.motions.end(), [](const auto& m) { return m.strict(); });
    fmt::format_to(out_, "\ns SOLVED motions {} strict {} continua {} rejected {}\n", found.motions.size(), strict,
                   found.continua.size(), found.rejected.size());
  }

  void write_ranges() {
    fmt::format_to(out_, "\nLoads {} for which each mode has a motion\n", mechanism_.load->symbol);
    for (const ConsistentMode& mode : solved_.modes) {
      fmt::format_to(out_, "    {:<12} {:<28} {}{}\n", name(mode.mode),
                     interval_text(mechanism_.load->symbol, mode.solutions.loads, digits_),
                     to_string(mode.solutions.loads), mode.determined ? "" : "  a continuum of motions");
    }
  }

  void write_cells() {
    fmt::format_to(out_, "\nThe line of loads, cut where the motions change\n");
    for (const LoadCell& cell : solved_.cells) {
      std::vector<std::string> motions;
      for (const MotionOverLoads& motion : cell.motions) {
        motions.push_back(motion.modes.empty() ? equal_modes(motion.boundary_modes) + " (boundary)"
                                               : equal_modes(motion.modes));
      }
      for (const MechanismMode& mode : cell.continua) motions.push_back(name(mode) + " (continuum)");
      if (motions.empty()) motions.emplace_back("no motion");
      fmt::format_to(out_, "    {:<28} {}\n", interval_text(mechanism_.load->symbol, cell.loads, digits_),
                     fmt::join(motions, "; "));
    }
    write_every_q();
    fmt::format_to(out_, "\ns SOLVED modes {} cells {}\n", solved_.modes.size(), solved_.cells.size());
  }

  void write_every_q() {
    const std::string line = every_load_line(solved_.for_every_q);
    if (!line.empty()) text_ += '\n' + line;
  }

  const SolvedMechanism& solved_;
  const Mechanism& mechanism_;
  std::vector<std::string> accelerations_, forces_;
  int digits_;
  std::size_t width_ = 0;
  std::string text_;
  Out out_{text_};
};

}  // namespace

std::string notes_text(const MechanismScene& scene) {
  std::string text;
  Out out(text);
  for (const std::string& note : scene.notes) fmt::format_to(out, "note: {}\n", note);
  for (const MechanismContact& contact : scene.mechanism.contacts) {
    for (const std::size_t parameter : missing_for_lift(contact, scene.values.given)) {
      fmt::format_to(out, "note: without {} the contact {} does not open: that is not modelled\n",
                     scene.mechanism.parameters[parameter].symbol, contact.name);
    }
  }
  return text;
}

std::string what_is_broken(const Mechanism& mechanism, const RejectedMode& mode) {
  std::string text;
  for (const ViolatedCondition& c : mode.because) {
    const std::string condition = condition_name(mechanism, c.element, c.state, c.condition);
    if (!text.ends_with(condition)) text += (text.empty() ? "" : " against ") + condition;
  }
  return text.empty() ? "its equations have no solution" : text;
}

std::string solve_text(const SolvedMechanism& solved, int digits) {
  return SolveText(solved, digits).whole();
}

}  // namespace slipproof
