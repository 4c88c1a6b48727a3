#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "base/input/diagnostic.hpp"
#include "claims/uniqueness/scene_setting.hpp"
#include "faces/python/bind.hpp"
#include "faces/python/interruptible.hpp"
#include "faces/python/numbers.hpp"
#include "mechanics/bicycle/scene.hpp"
#include "mechanics/bicycle_modes/motions.hpp"
#include "mechanics/checks/checks.hpp"
#include "mechanics/checks/show.hpp"
#include "mechanics/reading/shipped.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "report/scenes/solve_report.hpp"
#include "report/scenes/uniqueness_report.hpp"

namespace slipproof::python {

namespace {

namespace py = pybind11;

py::object integer(const Integer& x) {
  if (x.fits_long()) return py::int_(x.to_long());
  // Base 16 is linear, and Python does not limit its length.
  return py::reinterpret_steal<py::object>(PyLong_FromString(x.str(16).c_str(), nullptr, 16));
}

/// Of a bicycle, or of a mechanism; a struct, as pybind11 would take a variant apart.
struct AnyScene {
  std::variant<Scene, MechanismScene> of;

  AnyScene(const std::string& text, const std::string& file)
      : of(is_mechanism_scene(text) ? decltype(of)(parse_mechanism_scene(text, file)) : parse_scene(text, file)) {}

  const std::string& name() const {
    return std::visit([](const auto& scene) -> const std::string& { return scene.name; }, of);
  }
  const std::vector<std::string>& notes() const {
    return std::visit([](const auto& scene) -> const std::vector<std::string>& { return scene.notes; }, of);
  }
  bool is_mechanism() const { return std::holds_alternative<MechanismScene>(of); }
};

/// Modes that are solved before somebody could want to stop it.
constexpr double few_modes = 300;

bool is_short(const MechanismScene& scene) {
  return mode_count(element_kinds(scene.mechanism, scene.values.starts, scene.values.given)) <= few_modes;
}

/// A scene with all of its motions. Numbers are made when they are asked for.
class Solution {
 public:
  explicit Solution(std::unique_ptr<const SolvedScene> solved) : solved_(std::move(solved)) {}
  explicit Solution(std::unique_ptr<const SolvedMechanism> solved) : solved_(std::move(solved)) {}

  std::string json() const {
    return std::visit([](const auto& solved) { return solve_json(*solved); }, solved_);
  }
  std::string text(int digits) const {
    if (const auto* bicycle = std::get_if<OfBicycle>(&solved_)) return solve_text(**bicycle, {.digits = digits});
    return solve_text(*std::get<OfMechanism>(solved_), digits);
  }

  /// (modes, whether strict) of each motion of a bicycle at its force; None for what has to be read from the document.
  py::object motions() const {
    const MotionsAtForce* found = at_force();
    if (found == nullptr) return py::none();
    py::list list;
    for (const auto& motion : found->motions) {
      py::list modes;
      for (const ContactMode mode : motion.modes) modes.append(name(mode));
      list.append(py::make_tuple(std::move(modes), motion.strict));
    }
    return list;
  }
  py::tuple number(std::size_t motion, const std::string& quantity) const {
    const auto q = parse_quantity(quantity);
    if (!q) throw py::key_error(quantity);
    return to_python(at_force()->motions.at(motion).values[*q]);
  }
  /// The partition of the loads of a mechanism; None for what has to be read from the document.
  py::object cells() const;

 private:
  using OfBicycle = std::unique_ptr<const SolvedScene>;
  using OfMechanism = std::unique_ptr<const SolvedMechanism>;

  const MotionsAtForce* at_force() const {
    const auto* bicycle = std::get_if<OfBicycle>(&solved_);
    return bicycle != nullptr && (*bicycle)->at_force ? &*(*bicycle)->at_force : nullptr;
  }

  std::variant<OfBicycle, OfMechanism> solved_;
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

py::object Solution::cells() const {
  const auto* mechanism = std::get_if<OfMechanism>(&solved_);
  if (mechanism == nullptr) return py::none();
  const auto accelerations = acceleration_names((*mechanism)->scene.mechanism);
  const auto forces = force_names((*mechanism)->scene.mechanism);
  py::list cells;
  for (const LoadCell& cell : (*mechanism)->cells) {
    py::list motions;
    for (const MotionOverLoads& motion : cell.motions) {
      motions.append(py::make_tuple(names(motion.modes), names(motion.boundary_modes),
                                    named(accelerations, motion.accelerations), named(forces, motion.forces)));
    }
    const ForceInterval& loads = cell.loads;
    cells.append(py::make_tuple(end(loads.lower()), end(loads.upper()), loads.lower_closed(), loads.upper_closed(),
                                std::move(motions), names(cell.continua)));
  }
  return cells;
}

Solution solve(const AnyScene& scene) {
  if (const Scene* bicycle = std::get_if<Scene>(&scene.of)) {
    const WithoutInterpreter released;
    return Solution(std::make_unique<const SolvedScene>(*bicycle));
  }
  const auto& mechanism = std::get<MechanismScene>(scene.of);
  const auto work = [scene = mechanism](Call&) { return std::make_unique<const SolvedMechanism>(scene); };
  if (!is_short(mechanism)) return Solution(interruptible(work));
  const WithoutInterpreter released;
  return Solution(std::make_unique<const SolvedMechanism>(mechanism));
}

/// (document, text). `x` empty: the usual parameter.
py::tuple critical(const std::string& text, const std::string& file, const std::string& x) {
  const auto work = [text, file, x](Call&) {
    const MechanismScene scene = parse_any_scene(text, file);
    try {
      const UniquenessAlong along = uniqueness_along(scene, x.empty() ? usual_parameter(scene) : x);
      return std::pair(uniqueness_json(scene, along), uniqueness_text(scene, along, 6));
    } catch (const NoValue& error) {
      throw InputError({{file, 0, 0, error.what()}});
    }
  };
  const auto [document, words] = interruptible(work);
  return py::make_tuple(document, words);
}

void bind_scene(py::module_& module) {
  py::class_<AnyScene>(module, "Scene")
      .def(py::init<const std::string&, const std::string&>())
      .def_property_readonly("name", &AnyScene::name)
      .def_property_readonly("notes", &AnyScene::notes)
      .def_property_readonly("is_mechanism", &AnyScene::is_mechanism)
      .def("solve", &solve);
  py::class_<Solution>(module, "Solution")
      .def("json", &Solution::json)
      .def("text", &Solution::text)
      .def("motions", &Solution::motions)
      .def("number", &Solution::number)
      .def("cells", &Solution::cells);
}

py::dict parameter(const MechanismParameter& p) {
  py::dict entry;
  entry["symbol"] = p.symbol;
  entry["unit"] = p.unit;
  entry["meaning"] = p.meaning;
  entry["optional"] = p.optional;
  return entry;
}

/// What a person wants to know of a mechanism before it is solved.
py::dict described(const Mechanism& mechanism) {
  py::dict about;
  py::list parameters, angles, elements;
  for (const MechanismParameter& p : mechanism.parameters) parameters.append(parameter(p));
  for (const MechanismAngle& angle : mechanism.angles) angles.append(angle.name);
  for (std::size_t i = 0; i < mechanism.elements(); ++i) elements.append(element_name(mechanism, i));
  about["name"] = mechanism.name;
  about["source"] = mechanism.source;
  about["parameters"] = std::move(parameters);
  about["angles"] = std::move(angles);
  about["load"] = mechanism.load ? py::object(py::str(mechanism.load->symbol)) : py::none();
  about["elements"] = std::move(elements);
  return about;
}

}  // namespace

py::tuple to_python(const Rational& x) {
  return py::make_tuple(integer(numerator(x)), integer(denominator(x)));
}

void bind_scenes(py::module_& module) {
  bind_scene(module);
  module.def("critical", &critical);
  module.def("describe_mechanism", [](const std::string& name) { return described(open_mechanism(name)); });
  module.def("show_mechanism", [](const std::string& name) {
    return interruptible([name](Call&) {
      const Mechanism mechanism = open_mechanism(name);
      return show_text(mechanism, check_mechanism(mechanism));
    });
  });
  module.def("shipped_mechanisms", [] {
    py::list names;
    for (const ShippedMechanism& mechanism : shipped_mechanisms()) names.append(mechanism.name);
    return names;
  });
}

}  // namespace slipproof::python
