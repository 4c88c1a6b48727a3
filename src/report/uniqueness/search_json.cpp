#include "report/scenes/impact_report.hpp"
#include "report/uniqueness/search_report.hpp"
#include "report/values/mode_json.hpp"

namespace slipproof {

namespace {

Json place_json(const Mechanism& mechanism, const SearchPlace& place) {
  Json object = values_json(mechanism, place.values);
  if (place.load) object[mechanism.load->symbol] = to_json(*place.load);
  return object;
}

Json energy_json(const SolvedImpact& solved) {
  Json outcomes = Json::array();
  for (const ImpactOutcome& outcome : solved.outcomes) {
    Range gain = outcome.energy;
    if (gain.lower) *gain.lower -= solved.energy;
    if (gain.upper) *gain.upper -= solved.energy;
    outcomes.push_back({{"modes", outcome.modes},
                        {"after", range_value(outcome.energy)},
                        {"gain", range_value(gain)},
                        {"gains_energy", outcome.gains ? Json(*outcome.gains) : Json(nullptr)}});
  }
  return {{"before", to_json(solved.energy)}, {"outcomes", std::move(outcomes)}};
}

Json gains_json(EnergyBalance balance) {
  if (balance == EnergyBalance::gained || balance == EnergyBalance::not_gained) return balance == EnergyBalance::gained;
  return nullptr;
}

Json cell_json(const SearchReport& report, std::size_t index) {
  const Mechanism& mechanism = report.mechanism;
  const SearchCell& cell = report.result.cells[index];
  Json modes = Json::array(), not_modelled = Json::array();
  for (const auto& motion : cell.found.modes) modes.push_back(names_json(motion));
  for (const std::string& mode : cell.found.in_space) modes.push_back(Json::array({mode}));
  for (const std::size_t contact : cell.found.not_modelled) not_modelled.push_back(mechanism.contacts[contact].name);
  Json object{{"modes", std::move(modes)},
              {"motions", cell.found.motions()},
              {"on_boundary", cell.found.on_boundary},
              {"continua", names_json(cell.found.continua)},
              {"not_modelled", std::move(not_modelled)},
              {"samples", cell.samples},
              {"simplest", place_json(mechanism, cell.simplest)},
              {"simplest_realisable", cell.realisable ? place_json(mechanism, *cell.realisable) : Json(nullptr)}};
  if (mechanism.impact) {
    const auto impact = report.impacts.find(index);
    object["gains_energy"] = gains_json(cell.found.energy);
    object["energy"] = impact == report.impacts.end() ? Json(nullptr) : energy_json(impact->second);
  }
  return object;
}

Json proof_json(const UniqueEverywhere& proof) {
  Json statements = Json::array();
  for (const CheckedStatement& one : proof.statements) {
    statements.push_back({{"name", one.name}, {"statement", one.text}, {"certificate", one.certificate}});
  }
  return {{"by", "theorem 1 of proofs/two-wheeler"}, {"modes", proof.modes}, {"statements", std::move(statements)}};
}

}  // namespace

std::string search_json(const SearchReport& report) {
  const SearchResult& result = report.result;
  Json document;
  document["schema"] = "slipproof/search/1";
  document["mechanism"] = report.mechanism.name;
  document["within"] = report.within.empty() ? Json(nullptr) : Json(report.within);
  document["seed"] = report.options.seed;
  document["for"] = report.options.wanted ? Json(name(*report.options.wanted)) : Json(nullptr);
  document["verdict"] = name(verdict(report));
  document["proof"] = report.proof ? proof_json(*report.proof) : Json(nullptr);
  document["tried"] = result.tried;
  document["samples"] = result.samples;
  document["without_value"] = result.without_value;
  document["one"] = result.one_everywhere;
  for (const MotionCount count : {MotionCount::none, MotionCount::none_modelled, MotionCount::several,
                                  MotionCount::continuum, MotionCount::hysteresis}) {
    document[std::string(name(count))] = result.count(count);
  }
  if (report.mechanism.dimension == 3) document["undecided"] = result.count(MotionCount::undecided);
  if (report.mechanism.impact) {
    document["gain"] = result.count(EnergyBalance::gained);
    document["energy_undecided"] = result.count(EnergyBalance::undecided);
    document["energy_not_judged"] = result.count(EnergyBalance::not_judged);
  }
  document["cells"] = Json::array();
  for (std::size_t i = 0; i < result.cells.size(); ++i) document["cells"].push_back(cell_json(report, i));
  return dump(document);
}

}  // namespace slipproof
