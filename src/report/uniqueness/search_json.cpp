#include "report/uniqueness/search_report.hpp"
#include "report/values/mode_json.hpp"

namespace slipproof {

namespace {

Json place_json(const Mechanism& mechanism, const SearchPlace& place) {
  Json object = values_json(mechanism, place.values);
  if (place.load) object[mechanism.load->symbol] = to_json(*place.load);
  return object;
}

Json cell_json(const Mechanism& mechanism, const SearchCell& cell) {
  Json modes = Json::array(), not_modelled = Json::array();
  for (const auto& motion : cell.found.modes) modes.push_back(names_json(motion));
  for (const std::string& mode : cell.found.in_space) modes.push_back(Json::array({mode}));
  for (const std::size_t contact : cell.found.not_modelled) not_modelled.push_back(mechanism.contacts[contact].name);
  return {{"modes", std::move(modes)},
          {"motions", cell.found.motions()},
          {"on_boundary", cell.found.on_boundary},
          {"continua", names_json(cell.found.continua)},
          {"not_modelled", std::move(not_modelled)},
          {"samples", cell.samples},
          {"simplest", place_json(mechanism, cell.simplest)},
          {"simplest_realisable", cell.realisable ? place_json(mechanism, *cell.realisable) : Json(nullptr)}};
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
  document["cells"] = Json::array();
  for (const SearchCell& cell : result.cells) document["cells"].push_back(cell_json(report.mechanism, cell));
  return dump(document);
}

}  // namespace slipproof
