#include <pybind11/stl.h>

#include <optional>
#include <string>

#include "base/number/parse.hpp"
#include "base/output/output_file.hpp"
#include "faces/python/bind.hpp"
#include "faces/python/interruptible.hpp"
#include "mechanics/planes/mechanism_plane.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/phase/phase_svg.hpp"
#include "report/planes/map_json.hpp"

namespace slipproof::python {

namespace {

namespace py = pybind11;
using DrawnRange = std::optional<std::pair<std::string, std::string>>;

/// The requested values; those left out are chosen from the scene.
struct Wanted {
  std::string text, file, x, y;
  DrawnRange x_range, y_range;
  std::size_t columns = 240;
};

struct Drawn {
  std::string svg, json;
};

Drawn draw_map(const Wanted& wanted) {
  MechanismScene scene = parse_scene(wanted.text, wanted.file);
  if (!wanted.y.empty()) scene = with_load(scene, wanted.y);
  MechanismAxes axes;
  axes.x = wanted.x;
  if (wanted.x_range) {
    axes.x_from = parse_rational(wanted.x_range->first);
    axes.x_to = parse_rational(wanted.x_range->second);
  }
  if (wanted.y_range) {
    axes.y_from = parse_rational(wanted.y_range->first);
    axes.y_to = parse_rational(wanted.y_range->second);
  }
  const PhaseDiagram diagram = phase_diagram(mechanism_plane(scene, axes, "map"), wanted.columns);
  return {phase_svg_file(diagram), map_json(diagram, scene)};
}

py::tuple draw(const std::string& text, const std::string& file, const std::string& x, const std::string& y,
               const DrawnRange& x_range, const DrawnRange& y_range, std::size_t columns) {
  const Wanted wanted{text, file, x, y, x_range, y_range, columns};
  const Drawn drawn = interruptible([wanted](Call&) { return draw_map(wanted); });
  return py::make_tuple(drawn.svg, drawn.json);
}

}  // namespace

void bind_pictures(py::module_& module) {
  module.def("phase_diagram", &draw);
  module.def("write_file", [](const std::string& path, const std::string& text) { write_file(path, text); });
}

}  // namespace slipproof::python
