#include "report/scenes/simulation_report.hpp"

#include <fmt/format.h>

#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "report/values/exact_json.hpp"
#include "report/values/number_text.hpp"

namespace slipproof {

namespace {

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
  std::vector<std::string> words;
  for (std::size_t i = 0; i < names.size(); ++i) words.push_back(names[i] + " " + decimal_text(values[i], digits));
  return listed(words, "  ");
}

void write_motions(Document& document, const MechanismScene& scene, const Simulation& simulation, int digits) {
  const ContactSolutions& exact = simulation.exact;
  Document& section =
      document.section(counted(exact.solutions.size(), "motion") + " of rigid contacts: exact, here rounded");
  for (const ContactSolution& motion : exact.solutions) {
    Document& below = section.item(names_of(motion));
    below.line(values_text(motion_names(scene.mechanism), motion.w, digits));
    below.line(values_text(contact_force_names(scene.mechanism), motion.z, digits));
  }
  for (const ContactContinuum& continuum : exact.continua) {
    section.item(name(continuum.mode) + ": a continuum, which is not compared");
  }
}

void write_runs(Document& document, const Simulation& simulation) {
  Document& section = document.section("Which of them contacts that give come to: a simulation, not a proof");
  section.line("The load comes on in `rise` periods of the slowest elastic vibration; the times count from then on.");
  section.line("What is seen after 10 times as many is what contacts 100 times as stiff show in the same time.");
  ReportTable& table = section.table({{"stiffness T/N", "damping", "rise"}});
  for (const double horizon : horizons) {
    table.columns.push_back({ReportLine(fmt::format("after {} periods", horizon)), false, 28});
  }
  for (const SimulatedRun& run : simulation.runs) {
    const Compliance& c = run.compliance;
    std::vector<ReportCell> cells{fmt::format("{}", c.stiffness_ratio), fmt::format("{}", c.damping),
                                  fmt::format("{}", c.rise)};
    for (const SeenMotion& seen : run.seen) cells.emplace_back(in_words(seen, simulation.exact));
    table.row(std::move(cells));
  }
}

/// How many runs end in each motion, in the order of the motions, and how many in none.
std::string last_line(const Simulation& simulation) {
  std::vector<std::size_t> counts(simulation.exact.solutions.size() + 1);
  for (const SimulatedRun& run : simulation.runs) ++counts[run.seen.back().motion.value_or(counts.size() - 1)];
  std::vector<std::string> words;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    words.push_back(
        fmt::format("{} {}", i + 1 < counts.size() ? names_of(simulation.exact.solutions[i]) : "none", counts[i]));
  }
  return fmt::format("s SIMULATED {}: {}", counted(simulation.runs.size(), "run"), listed(words));
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

Document simulation_document(const MechanismScene& scene, const Simulation& simulation, int digits) {
  Document document = scene_document(scene, scene.mechanism.name);
  if (scene.load) document.line(scene.mechanism.load->symbol + " = " + number_text(*scene.load, digits));
  write_motions(document, scene, simulation, digits);
  write_runs(document, simulation);
  document.status(last_line(simulation));
  return document;
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
