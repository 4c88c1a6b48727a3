#include "report/planes/map_json.hpp"

#include "mechanics/points/degrees.hpp"
#include "report/values/mode_json.hpp"
#include "report/values/motions_json.hpp"

namespace slipproof {

namespace {

Json across_json(const Axis& axis, const Rational& x) {
  if (!axis.is_angle) return to_json(x);
  const MechanismValues::Circle point = point_of_tan_half(x);
  return {{"cos", to_json(point.cosine)}, {"sin", to_json(point.sine)}};
}

}  // namespace

std::string map_json(const PhaseDiagram& diagram, const MechanismScene& scene) {
  const Axis &x = diagram.plane.x, &y = diagram.plane.y;
  Json document, columns = Json::array();
  document["schema"] = "slipproof/map/2";
  document["mechanism"] = scene.mechanism.name;
  document["scene"] = scene.name;
  document["values"] = values_json(scene.mechanism, scene.values);
  document["x"] = {{"symbol", x.symbol},
                   {"kind", x.is_angle ? "angle" : "parameter"},
                   {"range", Json::array({across_json(x, x.from), across_json(x, x.to)})}};
  document["load"] = {{"symbol", y.symbol}, {"range", Json::array({to_json(y.from), to_json(y.to)})}};
  document["note"] = diagram.plane.note;
  for (const PhaseColumn& column : diagram.columns) {
    Json cells = Json::array();
    for (const LoadCell& cell : column.cells) cells.push_back(cell_json(cell));
    columns.push_back({{"x", across_json(x, column.x)}, {"cells", std::move(cells)}});
  }
  document["columns"] = std::move(columns);
  return dump(document);
}

}  // namespace slipproof
