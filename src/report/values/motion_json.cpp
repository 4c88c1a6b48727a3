#include "report/values/motion_json.hpp"

#include <utility>

namespace slipproof {

namespace {

Json continuum_at_force(const FoundContinuum& found, const Rational& force) {
  Json object = continuum_json(*found.continuum);
  object["status"] = found.strict ? "strict" : "boundary";
  Json base, ranges = Json::array();
  for (const Quantity q : all_quantities()) base[std::string(name(q))] = to_json(found.continuum->base[q].at(force));
  for (const ForceInterval& range : found.parameters) {
    ranges.push_back(Json::array({to_json(range.lower()), to_json(range.upper())}));
  }
  object["base"] = std::move(base);
  object["ranges"] = std::move(ranges);
  return object;
}

Json rejection_json(const Rejection& r) {
  Json entry;
  entry["mode"] = name(r.mode);
  entry["violated"] = r.violated ? name(*r.violated) : r.solvable ? "conditions" : "equations";
  entry["margin"] = r.violated ? to_json(r.margin) : Json(nullptr);
  return entry;
}

}  // namespace

Json mode_names(const std::vector<ContactMode>& modes) {
  Json names = Json::array();
  for (const ContactMode mode : modes) names.push_back(name(mode));
  return names;
}

Json continuum_json(const Continuum& c) {
  Json object;
  object["mode"] = name(c.mode);
  put_interval(object, "F", c.closed);
  Json parameters = Json::array(), undetermined = Json::array(), directions = Json::array();
  for (const Quantity q : c.parameters) parameters.push_back(name(q));
  for (const Quantity q : c.undetermined()) undetermined.push_back(name(q));
  for (const auto& direction : c.directions) {
    Json entry;
    for (const Quantity q : all_quantities()) entry[std::string(name(q))] = to_json(direction[q]);
    directions.push_back(std::move(entry));
  }
  object["parameters"] = std::move(parameters);
  object["undetermined"] = std::move(undetermined);
  object["directions"] = std::move(directions);
  return object;
}

void put_motions(Json& document, const MotionsAtForce& found, const Scene& scene, bool chain) {
  Json motions = Json::array(), continua = Json::array(), rejected = Json::array();
  for (const auto& motion : found.motions) motions.push_back(motion_json(motion, scene.bicycle, *scene.F, chain));
  for (const auto& c : found.continua) continua.push_back(continuum_at_force(c, *scene.F));
  for (const Rejection& r : found.rejected) rejected.push_back(rejection_json(r));
  document["motions"] = std::move(motions);
  document["continua"] = std::move(continua);
  document["rejected"] = std::move(rejected);
}

}  // namespace slipproof
