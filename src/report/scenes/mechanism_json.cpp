#include <utility>

#include "mechanics/mechanism/words.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "report/values/every_load.hpp"
#include "report/values/mode_json.hpp"
#include "report/values/motions_json.hpp"

namespace slipproof {

namespace {

/// Builds the document for one scene.
class SolveDocument {
 public:
  SolveDocument(const SolvedMechanism& solved, const std::optional<EveryLoad>& every_q)
      : solved_(solved),
        every_q_(every_q),
        mechanism_(solved.scene.mechanism),
        accelerations_(acceleration_names(mechanism_)) {}

  Json whole() const {
    Json document;
    document["schema"] = "slipproof/solve/2";
    document["mechanism"] = mechanism_.name;
    document["scene"] = solved_.scene.name;
    document["values"] = values_json(mechanism_, solved_.scene.values);
    document["load"] = load();
    document["notes"] = solved_.scene.notes;
    document["by_kinematics"] = solved_.by_kinematics;
    document["complete"] = !solved_.by_kinematics;
    document["every_q"] = every_load_json(every_q_);
    if (solved_.at_load) put_motions(document, mechanism_, *solved_.at_load);
    document["not_modelled"] = not_modelled();
    if (mechanism_.load) {
      document["ranges"] = ranges();
      document["ranges_complete"] = solved_.ranges_complete;
    }
    if (!solved_.at_load) document["cells"] = cells();
    return document;
  }

 private:
  Json load() const {
    if (!mechanism_.load) return nullptr;
    return {{"symbol", mechanism_.load->symbol}, {"value", to_json(solved_.scene.load)}};
  }

  Json not_modelled() const {
    Json entries = Json::array();
    for (const MechanismContact& contact : mechanism_.contacts) {
      Json needs = Json::array();
      for (const std::size_t parameter : missing_for_lift(contact, solved_.scene.values.given)) {
        needs.push_back(mechanism_.parameters[parameter].symbol);
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
        accelerations[accelerations_[i]] = over_load_json({form.constant, form.coefficients.back()});
      }
      entry["accelerations"] = std::move(accelerations);
      entries.push_back(std::move(entry));
    }
    return entries;
  }

  Json cells() const {
    Json entries = Json::array();
    for (const LoadCell& cell : solved_.cells) entries.push_back(cell_json(cell, mechanism_));
    return entries;
  }

  const SolvedMechanism& solved_;
  const std::optional<EveryLoad>& every_q_;
  const Mechanism& mechanism_;
  std::vector<std::string> accelerations_;
};

}  // namespace

std::string solve_json(const SolvedMechanism& solved, const std::optional<EveryLoad>& every_q) {
  return dump(SolveDocument(solved, every_q).whole());
}

}  // namespace slipproof
