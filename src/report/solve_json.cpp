#include <utility>

#include "model/chain.hpp"
#include "report/exact_json.hpp"
#include "report/solve_report.hpp"

namespace slipproof {

namespace {

Json mode_names(const std::vector<ContactMode>& modes) {
  Json names = Json::array();
  for (const ContactMode mode : modes) names.push_back(name(mode));
  return names;
}

template <class V>
void put_motion(Json& object, const Motion<V>& motion) {
  for (const Quantity q : all_quantities()) object[std::string(name(q))] = to_json(motion[q]);
}

template <class V>
Json motion_json(const FoundMotion<V>& found, const SolvedScene& solved, const V& F, bool chain) {
  Json object;
  object["modes"] = mode_names(found.modes);
  object["status"] = found.strict ? "strict" : "boundary";
  put_motion(object, found.values);
  if (chain) {
    const Chain<V> values = chain_of(solved.scene.bicycle, found.values, F);
    object["eps1"] = to_json(values.eps1);
    object["T"] = to_json(values.T);
  }
  return object;
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
    put_motion(entry, direction);
    directions.push_back(std::move(entry));
  }
  object["parameters"] = std::move(parameters);
  object["undetermined"] = std::move(undetermined);
  object["directions"] = std::move(directions);
  return object;
}

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

Json ranges_json(const ModeTable& table) {
  Json ranges = Json::array();
  for (const ModeSolution& s : table.solutions()) {
    if (s.closed().empty()) continue;
    Json entry;
    entry["mode"] = name(s.mode());
    put_interval(entry, "F", s.closed());
    ranges.push_back(std::move(entry));
  }
  return ranges;
}

void put_at_force(Json& document, const SolvedScene& solved, const SolveReportOptions& options) {
  const Rational& F = *solved.scene.F;
  Json motions = Json::array(), continua = Json::array(), rejected = Json::array();
  for (const auto& found : solved.at_force->motions) motions.push_back(motion_json(found, solved, F, options.chain));
  for (const auto& found : solved.at_force->continua) continua.push_back(continuum_at_force(found, F));
  for (const Rejection& r : solved.at_force->rejected) {
    Json entry;
    entry["mode"] = name(r.mode);
    entry["violated"] = r.violated ? name(*r.violated) : "equations";
    entry["margin"] = r.violated ? to_json(r.margin) : Json(nullptr);
    rejected.push_back(std::move(entry));
  }
  document["motions"] = std::move(motions);
  document["continua"] = std::move(continua);
  document["rejected"] = std::move(rejected);
}

Json cells_json(const SolvedScene& solved, const SolveReportOptions& options) {
  const Affine<Rational> F(0, 1);
  Json cells = Json::array();
  for (const Cell& cell : solved.cells) {
    Json entry, motions = Json::array();
    put_interval(entry, "F", cell.forces);
    for (const auto& found : cell.motions) {
      motions.push_back(motion_json(found, solved, cell.forces.is_point() ? Affine<Rational>(*cell.forces.lower()) : F,
                                    options.chain));
    }
    entry["motions"] = std::move(motions);
    entry["continua"] = mode_names(cell.continua);
    cells.push_back(std::move(entry));
  }
  return cells;
}

}  // namespace

std::string solve_json(const SolvedScene& solved, const SolveReportOptions& options) {
  Json document;
  document["schema"] = "slipproof/solve/1";
  document["scene"] = solved.scene.name;
  document["force"] = solved.scene.force_kind == ForceKind::internal ? "internal" : "external";
  document["detachment"] = solved.table.detachment();
  document["F"] = to_json(solved.scene.F);
  document["notes"] = solved.scene.notes;
  if (solved.at_force) {
    put_at_force(document, solved, options);
  } else {
    Json continua = Json::array();
    for (const ModeSolution& s : solved.table.solutions()) {
      if (s.kind() == ModeSolution::Kind::continuum && !s.closed().empty()) {
        continua.push_back(continuum_json(s.continuum()));
      }
    }
    document["continua"] = std::move(continua);
    document["cells"] = cells_json(solved, options);
  }
  document["ranges"] = ranges_json(solved.table);
  return dump(document);
}

}  // namespace slipproof
