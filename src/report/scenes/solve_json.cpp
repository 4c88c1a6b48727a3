#include <utility>

#include "report/scenes/solve_report.hpp"
#include "report/values/every_load.hpp"
#include "report/values/motion_json.hpp"

namespace slipproof {

namespace {

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

Json cells_json(const SolvedScene& solved, const SolveReportOptions& options) {
  const Affine<Rational> F(0, 1);
  Json cells = Json::array();
  for (const Cell& cell : solved.cells) {
    Json entry, motions = Json::array();
    put_interval(entry, "F", cell.forces);
    for (const auto& found : cell.motions) {
      motions.push_back(motion_json(found, solved.scene.bicycle,
                                    cell.forces.is_point() ? Affine<Rational>(*cell.forces.lower()) : F,
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
  document["every_q"] = every_load_json(solved.for_every_q);
  if (solved.at_force) {
    put_motions(document, *solved.at_force, solved.scene, options.chain);
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
