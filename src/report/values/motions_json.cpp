#include "report/values/motions_json.hpp"

#include <utility>

#include "mechanics/mechanism/words.hpp"
#include "report/values/mode_json.hpp"

namespace slipproof {

Json ends_json(const Range& range) {
  return Json::array({to_json(range.lower), to_json(range.upper)});
}

namespace {

class MotionsDocument {
 public:
  explicit MotionsDocument(const Mechanism& mechanism)
      : mechanism_(mechanism), accelerations_(acceleration_names(mechanism)), forces_(force_names(mechanism)) {}

  void put(Json& document, const MotionsAtLoad& found) const {
    Json motions = Json::array(), continua = Json::array(), rejected = Json::array();
    for (const MotionAtLoad& motion : found.motions) motions.push_back(motion_json(motion));
    for (const ContinuumAtLoad& continuum : found.continua) continua.push_back(continuum_json(found, continuum));
    for (const RejectedMode& mode : found.rejected) rejected.push_back(rejected_json(mode));
    document["motions"] = std::move(motions);
    document["hysteresis"] = names_json(found.hysteresis);
    document["continua"] = std::move(continua);
    document["rejected"] = std::move(rejected);
  }

 private:
  Json motion_json(const MotionAtLoad& motion) const {
    Json accelerations = Json::object(), forces = Json::object(), undetermined = Json::object();
    for (std::size_t i = 0; i < accelerations_.size(); ++i) {
      accelerations[accelerations_[i]] = to_json(motion.accelerations[i]);
    }
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      if (motion.forces[i].is_point()) {
        forces[forces_[i]] = to_json(*motion.forces[i].lower);
      } else {
        undetermined[forces_[i]] = ends_json(motion.forces[i]);
      }
    }
    return {{"modes", names_json(motion.modes)},
            {"boundary_modes", names_json(motion.boundary_modes)},
            {"status", motion.strict() ? "strict" : "boundary"},
            {"accelerations", std::move(accelerations)},
            {"forces", std::move(forces)},
            {"force_ranges", std::move(undetermined)},
            {"continua", names_json(motion.continua)}};
  }

  Json continuum_json(const MotionsAtLoad& found, const ContinuumAtLoad& continuum) const {
    Json ranges = Json::object();
    for (std::size_t i = 0; i < accelerations_.size(); ++i) {
      ranges[accelerations_[i]] = ends_json(continuum.accelerations[i]);
    }
    for (std::size_t i = 0; i < forces_.size(); ++i) ranges[forces_[i]] = ends_json(continuum.forces[i]);
    return {{"mode", name(continuum.mode)},
            {"status", continuum.strict ? "strict" : "boundary"},
            {"ranges", std::move(ranges)},
            {"modes_inside", names_json(modes_in(found, continuum))}};
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

  const Mechanism& mechanism_;
  std::vector<std::string> accelerations_, forces_;
};

}  // namespace

Json over_load_json(const Affine<Rational>& value) {
  return {{"const", to_json(value.alpha)}, {"per_load", to_json(value.beta)}};
}

Json cell_json(const LoadCell& cell) {
  Json entry, motions = Json::array();
  put_interval(entry, "load", cell.loads);
  for (const MotionOverLoads& motion : cell.motions) {
    motions.push_back({{"modes", names_json(motion.modes)},
                       {"boundary_modes", names_json(motion.boundary_modes)},
                       {"continua", names_json(motion.continua)}});
  }
  entry["motions"] = std::move(motions);
  entry["continua"] = names_json(cell.continua);
  return entry;
}

Json cell_json(const LoadCell& cell, const Mechanism& mechanism) {
  const auto accelerations = acceleration_names(mechanism), forces = force_names(mechanism);
  Json entry = cell_json(cell);
  for (std::size_t k = 0; k < cell.motions.size(); ++k) {
    const MotionOverLoads& motion = cell.motions[k];
    Json of_bodies = Json::object(), of_forces = Json::object();
    for (std::size_t i = 0; i < accelerations.size(); ++i) {
      of_bodies[accelerations[i]] = over_load_json(motion.accelerations[i]);
    }
    for (std::size_t i = 0; i < forces.size(); ++i) {
      of_forces[forces[i]] = motion.forces[i] ? over_load_json(*motion.forces[i]) : Json(nullptr);
    }
    entry["motions"][k]["accelerations"] = std::move(of_bodies);
    entry["motions"][k]["forces"] = std::move(of_forces);
  }
  return entry;
}

void put_motions(Json& document, const Mechanism& mechanism, const MotionsAtLoad& found) {
  MotionsDocument(mechanism).put(document, found);
}

}  // namespace slipproof
