#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "base/number/parse.hpp"
#include "claims/uniqueness/along.hpp"
#include "contact/problem/every_push.hpp"
#include "contact/rest/rest.hpp"
#include "contact/space/solve_space.hpp"
#include "faces/python/bind.hpp"
#include "faces/python/interruptible.hpp"
#include "faces/python/numbers.hpp"
#include "mechanics/checks/checks.hpp"
#include "mechanics/checks/show.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/shipped.hpp"
#include "mechanics/scene/solve_mechanism.hpp"
#include "report/planes/rest_map_svg.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "report/scenes/rest_report.hpp"
#include "report/scenes/space_report.hpp"
#include "report/uniqueness/uniqueness_report.hpp"

namespace slipproof::python {

namespace {

namespace py = pybind11;

py::object integer(const Integer& x) {
  if (x.fits_long()) return py::int_(x.to_long());
  // Conversion from base 16 takes linear time, and Python does not limit its length.
  return py::reinterpret_steal<py::object>(PyLong_FromString(x.str(16).c_str(), nullptr, 16));
}

/// Solving so many modes is too fast for anyone to want to stop it.
constexpr double few_modes = 300;

bool is_short(const MechanismScene& scene) {
  return mode_count(element_kinds(scene.mechanism, scene.values.starts, scene.values.given)) <= few_modes;
}

struct Found {
  SolvedMechanism solved;
  std::optional<EveryLoad> every_q;

  explicit Found(const MechanismScene& scene)
      : solved(solve_mechanism(scene)), every_q(for_every_push(solved.problem)) {}
};

/// A scene with all its motions. Numbers are converted when they are requested.
class Solution {
 public:
  explicit Solution(std::unique_ptr<const Found> found)
      : found_(std::move(found)),
        accelerations_(acceleration_names(found_->solved.scene.mechanism)),
        forces_(force_names(found_->solved.scene.mechanism)) {}

  std::string json() const { return solve_json(found_->solved, found_->every_q); }
  std::string text(int digits) const { return text_of(solve_document(found_->solved, found_->every_q, digits)); }

  /// For each motion at the load: (modes, boundary modes, names of the numbers, ranges of the other forces). None if
  /// the scene has no load.
  py::object motions() const;
  py::tuple number(std::size_t motion, const std::string& quantity) const;
  /// The partition of the loads.
  py::list cells() const;

 private:
  std::unique_ptr<const Found> found_;
  std::vector<std::string> accelerations_, forces_;
};

py::object end(const std::optional<Rational>& x) {
  return x ? py::object(to_python(*x)) : py::none();
}

py::list names(const std::vector<MechanismMode>& modes) {
  py::list list;
  for (const MechanismMode& mode : modes) list.append(name(mode));
  return list;
}

py::object affine(const std::optional<Affine<Rational>>& x) {
  return x ? py::object(py::make_tuple(to_python(x->alpha), to_python(x->beta))) : py::none();
}

template <class Values>
py::dict named(const std::vector<std::string>& names, const Values& values) {
  py::dict dict;
  for (std::size_t i = 0; i < names.size(); ++i) dict[py::str(names[i])] = affine(values[i]);
  return dict;
}

py::object Solution::motions() const {
  if (!found_->solved.at_load) return py::none();
  py::list list;
  for (const MotionAtLoad& motion : found_->solved.at_load->motions) {
    py::list known = py::cast(accelerations_);
    py::dict ranges;
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      const Range& force = motion.forces[i];
      if (force.is_point()) {
        known.append(forces_[i]);
      } else {
        ranges[py::str(forces_[i])] = py::make_tuple(end(force.lower), end(force.upper));
      }
    }
    list.append(py::make_tuple(names(motion.modes), names(motion.boundary_modes), std::move(known), std::move(ranges)));
  }
  return list;
}

py::tuple Solution::number(std::size_t index, const std::string& quantity) const {
  const MotionAtLoad& motion = found_->solved.at_load->motions.at(index);
  const auto place = [&](const std::vector<std::string>& names) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), quantity) - names.begin());
  };
  if (const std::size_t i = place(accelerations_); i < accelerations_.size()) return to_python(motion.accelerations[i]);
  const std::size_t i = place(forces_);
  if (i == forces_.size() || !motion.forces[i].is_point()) throw py::key_error(quantity);
  return to_python(*motion.forces[i].lower);
}

py::list Solution::cells() const {
  py::list cells;
  for (const LoadCell& cell : found_->solved.cells) {
    py::list motions;
    for (const MotionOverLoads& motion : cell.motions) {
      motions.append(py::make_tuple(names(motion.modes), names(motion.boundary_modes),
                                    named(accelerations_, motion.accelerations), named(forces_, motion.forces)));
    }
    const ForceInterval& loads = cell.loads;
    cells.append(py::make_tuple(end(loads.lower()), end(loads.upper()), loads.lower_closed(), loads.upper_closed(),
                                std::move(motions), names(cell.continua)));
  }
  return cells;
}

/// A scene in space with all its motions. Python reads their numbers from the document.
class SpaceSolution {
 public:
  explicit SpaceSolution(SolvedSpace solved) : solved_(std::move(solved)) {}

  std::string json() const { return space_json(solved_); }
  std::string text(int digits) const { return text_of(space_document(solved_, digits)); }

 private:
  SolvedSpace solved_;
};

std::unique_ptr<const Found> found(const MechanismScene& scene) {
  if (!is_short(scene)) return interruptible([scene](Call&) { return std::make_unique<const Found>(scene); });
  const WithoutInterpreter released;
  return std::make_unique<const Found>(scene);
}

py::object solve(const MechanismScene& scene) {
  if (scene.mechanism.dimension == 2) return py::cast(Solution(found(scene)));
  return py::cast(SpaceSolution(interruptible([scene](Call&) { return solve_space(scene); })));
}

using TextRange = std::optional<std::pair<std::string, std::string>>;

RestMap::Frame frame_of(const char* name, const TextRange& range) {
  if (!range) return {};
  RestMap::Frame frame{parse_rational(range->first), parse_rational(range->second)};
  if (*frame.from < *frame.to) return frame;
  throw std::invalid_argument(std::string(name) +
                              ": found a range that ends where it begins, expected a number below " + "the other");
}

/// (document, text, picture of the map). An empty `parameter` asks for none; `tilt` has the three coordinates of an
/// axis, or nothing; `map` two symbols, or nothing.
py::tuple rest(const MechanismScene& scene, const std::string& parameter, const std::vector<std::string>& tilt,
               const std::vector<std::string>& map, const TextRange& x_range, const TextRange& y_range) {
  RestQuestions questions;
  questions.parameter = parameter;
  if (!tilt.empty()) {
    questions.tilt = {parse_rational(tilt.at(0)), parse_rational(tilt.at(1)), parse_rational(tilt.at(2))};
  }
  if (!map.empty()) {
    questions.map = {map.at(0), map.at(1), frame_of("x_range", x_range), frame_of("y_range", y_range)};
  }
  const auto [document, words, picture] = interruptible([scene, questions](Call&) {
    const RestAnswer answer = find_rest(scene, questions);
    return std::tuple(rest_json(answer), text_of(rest_document(answer, 6)),
                      answer.map ? rest_map_svg_file(answer) : std::string());
  });
  return py::make_tuple(document, words, picture);
}

/// (document, text). An empty `x` stands for the usual parameter.
py::tuple critical(const std::string& text, const std::string& file, const std::string& x) {
  const auto work = [text, file, x](Call&) {
    const MechanismScene scene = parse_scene(text, file);
    try {
      const UniquenessAlong along = uniqueness_along(scene, x.empty() ? usual_parameter(scene) : x);
      return std::pair(uniqueness_json(scene, along), text_of(uniqueness_document(scene, along, 6)));
    } catch (const NoValue& error) {
      throw InputError({{file, 0, 0, error.what()}});
    }
  };
  const auto [document, words] = interruptible(work);
  return py::make_tuple(document, words);
}

void bind_scene(py::module_& module) {
  py::class_<MechanismScene>(module, "Scene")
      .def(py::init(
          [](const std::string& text, const std::string& file) { return parse_scene(text, file, Dimensions::any); }))
      .def_property_readonly("name", [](const MechanismScene& scene) { return scene.name; })
      .def_property_readonly("notes", [](const MechanismScene& scene) { return scene.notes; })
      .def_property_readonly("dimension", [](const MechanismScene& scene) { return scene.mechanism.dimension; })
      .def("solve", &solve)
      .def("rest", &rest);
  py::class_<Solution>(module, "Solution")
      .def("json", &Solution::json)
      .def("text", &Solution::text)
      .def("motions", &Solution::motions)
      .def("number", &Solution::number)
      .def("cells", &Solution::cells);
  py::class_<SpaceSolution>(module, "SpaceSolution")
      .def("json", &SpaceSolution::json)
      .def("text", &SpaceSolution::text);
}

py::dict parameter(const MechanismParameter& p) {
  py::dict entry;
  entry["symbol"] = p.symbol;
  entry["unit"] = p.unit;
  entry["meaning"] = p.meaning;
  entry["optional"] = p.optional;
  return entry;
}

/// What a person wants to know about a mechanism before it is solved.
py::dict described(const Mechanism& mechanism) {
  py::dict about;
  py::list parameters, angles, elements;
  for (const MechanismParameter& p : mechanism.parameters) parameters.append(parameter(p));
  for (const MechanismAngle& angle : mechanism.angles) angles.append(angle.name);
  for (std::size_t i = 0; i < mechanism.elements(); ++i) elements.append(element_name(mechanism, i));
  about["name"] = mechanism.name;
  about["source"] = mechanism.source;
  about["dimension"] = mechanism.dimension;
  about["parameters"] = std::move(parameters);
  about["angles"] = std::move(angles);
  about["load"] = mechanism.load ? py::object(py::str(mechanism.load->symbol)) : py::none();
  about["elements"] = std::move(elements);
  return about;
}

}  // namespace

Mechanism mechanism_of(const std::string& name, const std::optional<std::string>& text,
                       const MechanismRequest& request) {
  Mechanism mechanism =
      text ? parse_mechanism(*text, name, request.impact) : open_mechanism(name, {}, {Dimensions::any, request.impact});
  refuse_other(mechanism, request.dimensions);
  return mechanism;
}

py::tuple to_python(const Rational& x) {
  return py::make_tuple(integer(numerator(x)), integer(denominator(x)));
}

void bind_scenes(py::module_& module) {
  bind_scene(module);
  module.def("critical", &critical);
  module.def(
      "describe_mechanism",
      [](const std::string& name, const std::optional<std::string>& text) {
        return described(mechanism_of(name, text, Dimensions::any));
      },
      py::arg("name"), py::arg("text") = py::none());
  module.def(
      "show_mechanism",
      [](const std::string& name, const std::optional<std::string>& text) {
        return interruptible([name, text](Call&) {
          const Mechanism shown = mechanism_of(name, text, Dimensions::any);
          return show_text(shown, check_mechanism(shown));
        });
      },
      py::arg("name"), py::arg("text") = py::none());
  module.def("shipped_mechanisms", [] {
    py::list names;
    for (const ShippedMechanism& one : shipped_mechanisms()) names.append(one.name);
    return names;
  });
}

}  // namespace slipproof::python
