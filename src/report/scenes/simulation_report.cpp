#include "report/scenes/simulation_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "base/input/utf8.hpp"
#include "base/number/format.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "report/values/exact_json.hpp"
#include "report/values/number_text.hpp"

namespace slipproof {

namespace {

using Out = std::back_insert_iterator<std::string>;

/// The mechanism's names for gap, slip, N and T of each contact.
std::vector<std::string> motion_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const MechanismContact& contact : mechanism.contacts) {
    names.push_back(contact.gap_name), names.push_back(contact.slip_name);
  }
  return names;
}
std::vector<std::string> contact_force_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const MechanismContact& contact : mechanism.contacts) {
    names.push_back(mechanism.unknowns[contact.normal].symbol);
    names.push_back(mechanism.unknowns[contact.tangent.value()].symbol);
  }
  return names;
}

std::string names_of(const ContactSolution& motion) {
  return equal_modes({motion.modes.begin(), motion.modes.end()});
}

/// The motion; or the parts of the time for which the contacts were in each mode.
std::string in_words(const SeenMotion& seen, const ContactSolutions& exact) {
  if (seen.motion) return names_of(exact.solutions[*seen.motion]);
  return fmt::format("none ({} for {:.0f} %)", name(seen.mode), 100 * seen.share);
}

std::string values_text(const std::vector<std::string>& names, const std::vector<Rational>& values, int digits) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += fmt::format("  {} {}", names[i], decimal_text(values[i], digits));
  }
  return text;
}

void write_motions(Out out, const MechanismScene& scene, const Simulation& simulation, int digits) {
  const ContactSolutions& exact = simulation.exact;
  fmt::format_to(out, "\n{} of rigid contacts: exact, here rounded\n", counted(exact.solutions.size(), "motion"));
  for (const ContactSolution& motion : exact.solutions) {
    fmt::format_to(out, "  {}\n  {}\n  {}\n", names_of(motion),
                   values_text(motion_names(scene.mechanism), motion.w, digits),
                   values_text(contact_force_names(scene.mechanism), motion.z, digits));
  }
  for (const ContactContinuum& continuum : exact.continua) {
    fmt::format_to(out, "  {}: a continuum, which is not compared\n", name(continuum.mode));
  }
}

std::string row(const std::string& first, const auto& cells) {
  std::string line = fmt::format("  {:<28}", first);
  for (const std::string& cell : cells) line += fmt::format("  {:<28}", cell);
  return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

void write_runs(Out out, const Simulation& simulation) {
  std::vector<std::string> cells;
  for (const double horizon : horizons) cells.push_back(fmt::format("after {} periods", horizon));
  fmt::format_to(
      out,
      "\nWhich of them contacts that give come to: a simulation, not a proof\n"
      "  The load comes on in `rise` periods of the slowest elastic vibration; the times count from then on.\n"
      "  What is seen after 10 times as many is what contacts 100 times as stiff show in the same time.\n\n{}",
      row("stiffness T/N, damping, rise", cells));
  for (const SimulatedRun& run : simulation.runs) {
    const Compliance& c = run.compliance;
    cells.clear();
    for (const SeenMotion& seen : run.seen) cells.push_back(in_words(seen, simulation.exact));
    fmt::format_to(out, "{}", row(fmt::format("{:<15}{:<9}{}", c.stiffness_ratio, c.damping, c.rise), cells));
  }
}

/// How many runs end in each motion, in the order of the motions, and how many in none.
std::string write_end(const Simulation& simulation) {
  std::vector<std::size_t> counts(simulation.exact.solutions.size() + 1);
  for (const SimulatedRun& run : simulation.runs) ++counts[run.seen.back().motion.value_or(counts.size() - 1)];
  std::vector<std::string> words;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    words.push_back(
        fmt::format("{} {}", i + 1 < counts.size() ? names_of(simulation.exact.solutions[i]) : "none", counts[i]));
  }
  return fmt::format("\ns SIMULATED {}: {}\n", counted(simulation.runs.size(), "run"), fmt::join(words, ", "));
}

Json named(const std::vector<std::string>& names, const auto& values) {
  Json object = Json::object();
  for (std::size_t i = 0; i < names.size(); ++i) object[names[i]] = values[i];
  return object;
}

std::vector<Json> exact_values(const std::vector<Rational>& values) {
  std::vector<Json> result;
  for (const Rational& x : values) result.push_back(to_json(x));
  return result;
}

}  // namespace

std::string simulation_text(const MechanismScene& scene, const Simulation& simulation, int digits) {
  std::string text = fmt::format("{}: {}\n", scene.name, scene.mechanism.name) + notes_text(scene);
  if (scene.load) text += fmt::format("{} = {}\n", scene.mechanism.load->symbol, number_text(*scene.load, digits));
  write_motions(Out(text), scene, simulation, digits);
  write_runs(Out(text), simulation);
  return text + write_end(simulation);
}

std::string simulation_json(const MechanismScene& scene, const Simulation& simulation) {
  const auto accelerations = motion_names(scene.mechanism), forces = contact_force_names(scene.mechanism);
  Json document{{"schema", "slipproof/simulate/1"}, {"proof", false}};
  document["scene"] = scene.name;
  document["mechanism"] = scene.mechanism.name;
  document["load"] = to_json(scene.load);
  document["motions"] = Json::array();
  for (const ContactSolution& motion : simulation.exact.solutions) {
    Json modes = Json::array();
    for (const ProblemMode& mode : motion.modes) modes.push_back(name(mode));
    document["motions"].push_back({{"modes", modes},
                                   {"strict", motion.strict},
                                   {"accelerations", named(accelerations, exact_values(motion.w))},
                                   {"forces", named(forces, exact_values(motion.z))}});
  }
  document["continua"] = Json::array();
  for (const ContactContinuum& continuum : simulation.exact.continua) {
    document["continua"].push_back(name(continuum.mode));
  }
  document["runs"] = Json::array();
  for (const SimulatedRun& run : simulation.runs) {
    const Compliance& c = run.compliance;
    Json object{{"stiffness_ratio", c.stiffness_ratio}, {"damping", c.damping}, {"rise", c.rise}};
    for (const SeenMotion& seen : run.seen) {
      object["seen"].push_back({{"periods", seen.periods},
                                {"motion", seen.motion ? Json(*seen.motion) : Json(nullptr)},
                                {"mode", name(seen.mode)},
                                {"share", seen.share},
                                {"accelerations", named(accelerations, seen.accelerations)},
                                {"forces", named(forces, seen.forces)}});
    }
    document["runs"].push_back(std::move(object));
  }
  return dump(document);
}

}  // namespace slipproof
