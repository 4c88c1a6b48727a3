#include "report/planes/map_json.hpp"

#include "report/values/mode_json.hpp"
#include "report/values/motions_json.hpp"
#include "report/values/set_json.hpp"

namespace slipproof {

namespace {

/// Columns with what is known at each place: `"motions": ["slip/lift"]`.
Json raster_json(const PhaseDiagram& diagram) {
  Json columns = Json::array();
  const PhaseRaster& raster = *diagram.raster;
  for (std::size_t i = 0; i < raster.across; ++i) {
    Json places = Json::array();
    bool complete = true;
    for (std::size_t j = 0; j < raster.up; ++j) {
      const PhaseRaster::Place& place = raster.places[i * raster.up + j];
      complete = complete && place.is_complete();
      places.push_back(set_json(place.set));
      places.back()["load"] = to_json(place.y);
    }
    const Json x = across_json(diagram.plane.x, raster.places[i * raster.up].x);
    columns.push_back({{"x", x}, {"complete", complete}, {"places", std::move(places)}});
  }
  return columns;
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
  if (diagram.raster) columns = raster_json(diagram);
  document["columns"] = std::move(columns);
  return dump(document);
}

}  // namespace slipproof
