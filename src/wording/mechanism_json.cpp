#include <utility>

#include "mechanism/words.hpp"
#include "wording/mechanism_report.hpp"
#include "wording/mode_json.hpp"

namespace slipproof {

namespace {

Json range_json(const Range& range) {
  return Json::array({to_json(range.lower), to_json(range.upper)});
}

/// What goes into the document for one scene.
class SolveDocument {
 public:
  explicit SolveDocument(const SolvedMechanism& solved)
      : solved_(solved),
        mechanism_(solved.scene.mechanism),
        accelerations_(acceleration_names(mechanism_)),
        forces_(force_names(mechanism_)) {}

  Json whole() const {
    Json document;
    document["schema"] = "slipproof/solve/2";
    document["mechanism"] = mechanism_.name;
    document["scene"] = solved_.scene.name;
    document["values"] = values_json(mechanism_, solved_.scene.values);
    document["load"] = load();
    document["notes"] = solved_.scene.notes;
    if (solved_.at_load) put_motions(document);
    document["not_modelled"] = not_modelled();
    if (mechanism_.load) document["ranges"] = ranges();
    return document;
  }

 private:
  Json load() const {
    if (!mechanism_.load) return nullptr;
    return {{"symbol", mechanism_.load->symbol}, {"value", to_json(solved_.scene.load)}};
  }

  void put_motions(Json& document) const {
    const MotionsAtLoad& found = *solved_.at_load;
    Json motions = Json::array(), continua = Json::array(), rejected = Json::array();
    for (const MotionAtLoad& motion : found.motions) motions.push_back(motion_json(motion));
    for (const ContinuumAtLoad& continuum : found.continua) continua.push_back(continuum_json(continuum));
    for (const RejectedMode& mode : found.rejected) rejected.push_back(rejected_json(mode));
    document["motions"] = std::move(motions);
    document["hysteresis"] = names_json(found.hysteresis);
    document["continua"] = std::move(continua);
    document["rejected"] = std::move(rejected);
  }

  Json motion_json(const MotionAtLoad& motion) const {
    Json accelerations = Json::object(), forces = Json::object(), undetermined = Json::object();
    for (std::size_t i = 0; i < accelerations_.size(); ++i) {
      accelerations[accelerations_[i]] = to_json(motion.accelerations[i]);
    }
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      if (motion.forces[i].is_point()) {
        forces[forces_[i]] = to_json(*motion.forces[i].lower);
      } else {
        undetermined[forces_[i]] = range_json(motion.forces[i]);
      }
    }
    return {{"modes", names_json(motion.modes)},
            {"boundary_modes", names_json(motion.boundary_modes)},
            {"status", motion.strict() ? "strict" : "boundary"},
            {"accelerations", std::move(accelerations)},
            {"forces", std::move(forces)},
            {"force_ranges", std::move(undetermined)}};
  }

  Json continuum_json(const ContinuumAtLoad& continuum) const {
    Json ranges = Json::object();
    for (std::size_t i = 0; i < accelerations_.size(); ++i) {
      ranges[accelerations_[i]] = range_json(continuum.accelerations[i]);
    }
    for (std::size_t i = 0; i < forces_.size(); ++i) ranges[forces_[i]] = range_json(continuum.forces[i]);
    return {{"mode", name(continuum.mode)},
            {"status", continuum.strict ? "strict" : "boundary"},
            {"ranges", std::move(ranges)}};
  }

  Json rejected_json(const RejectedMode& mode) const {
    Json because = Json::array();
    for (const ViolatedCondition& c : mode.because) {
      std::string text = condition_name(mechanism_, c.element, c.state, c.condition);
      if (because.empty() || because.back() != text) because.push_back(std::move(text));
    }
    Json entry{{"mode", name(mode.mode)}};
    if (mode.margin) {
      entry["violated"] = because.front();
      entry["margin"] = to_json(*mode.margin);
    } else {
      entry["violated"] = nullptr;
      entry["because"] = std::move(because);
    }
    return entry;
  }

  Json not_modelled() const {
    Json entries = Json::array();
    for (const MechanismContact& contact : mechanism_.contacts) {
      Json needs = Json::array();
      for (const std::size_t parameter : contact.lift_needs) {
        if (!solved_.scene.values.given[parameter]) needs.push_back(mechanism_.parameters[parameter].symbol);
      }
      if (!needs.empty()) {
        entries.push_back({{"contact", contact.name}, {"state", "lift"}, {"needs", std::move(needs)}});
      }
    }
    return entries;
  }

  Json ranges() const {
    Json entries = Json::array();
    for (const ConsistentMode& mode : solved_.modes) {
      Json entry{{"mode", name(mode.mode)}};
      put_interval(entry, "load", mode.solutions.loads);
      entry["strict"] = mode.solutions.strict;
      Json accelerations = Json::object();
      for (std::size_t i = 0; i < accelerations_.size(); ++i) {
        const AffineForm form = mode.solutions.space.on(solved_.problem.accelerations[i]);
        if (!is_free_of_unknowns(form)) continue;
        accelerations[accelerations_[i]] = {{"const", to_json(form.constant)},
                                            {"per_load", to_json(form.coefficients.back())}};
      }
      entry["accelerations"] = std::move(accelerations);
      entries.push_back(std::move(entry));
    }
    return entries;
  }

  const SolvedMechanism& solved_;
  const Mechanism& mechanism_;
  std::vector<std::string> accelerations_, forces_;
};

}  // namespace

std::string solve_json(const SolvedMechanism& solved) {
  return dump(SolveDocument(solved).whole());
}

}  // namespace slipproof
