#include "faces/explorer/explorer.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "base/number/parse.hpp"
#include "contact/problem/every_push.hpp"
#include "faces/explorer/pasted.hpp"
#include "mechanics/planes/axis_choice.hpp"
#include "mechanics/scene/read_again.hpp"
#include "mechanics/scene/solve_mechanism.hpp"
#include "report/phase/phase_svg.hpp"
#include "report/picture/motion_words.hpp"
#include "report/picture/motions_svg.hpp"
#include "report/picture/palette.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof {

namespace {

constexpr std::size_t usual_columns = 48, most_columns = 1000;

/// Without a value, of the load only, its value goes.
void change(MechanismScene& scene, const std::string& symbol, const std::optional<Rational>& value) {
  const auto& load = scene.mechanism.load;
  if (!value && load && load->symbol == symbol) {
    scene.load.reset();
    return;
  }
  if (!value) throw std::invalid_argument(symbol + ": found nothing, expected a number");
  if (set_value(scene, symbol, *value)) return;
  throw std::invalid_argument("found the symbol " + in_quotes(symbol) + ", which the scene does not have");
}

std::optional<Rational> number_of(const std::string& symbol, const Json& value) {
  if (value.is_null()) return std::nullopt;
  if (!value.is_string()) throw std::invalid_argument(symbol + ": found no text, expected a number as a text");
  try {
    return parse_rational(value.get<std::string>());
  } catch (const NumberError& error) {
    throw std::invalid_argument(symbol + ": " + error.what());
  }
}

Json axis_json(const Axis& axis) {
  return {{"symbol", axis.symbol},     {"unit", axis.unit},
          {"is_angle", axis.is_angle}, {"from", to_json(axis.from)},
          {"to", to_json(axis.to)},    {"near", {axis.from.to_double(), axis.to.to_double()}}};
}

/// tan(angle/2); nothing for a half turn.
std::optional<Rational> tan_half(const MechanismValues::Circle& point) {
  if (point.cosine == -1) return std::nullopt;
  return Rational(point.sine / (1 + point.cosine));
}

Json near(const std::optional<Rational>& value) {
  return value ? Json(value->to_double()) : Json(nullptr);
}

Json value_json(const char* kind, const std::string& symbol, const std::string& unit, const std::string& meaning,
                const std::optional<Rational>& value) {
  return {{"kind", kind},       {"symbol", symbol},        {"unit", unit},
          {"meaning", meaning}, {"value", to_json(value)}, {"near", near(value)}};
}

/// The range of a slider: that of an axis. Nothing where the program would ask for one.
class Sliders {
 public:
  explicit Sliders(const MechanismScene& scene) : scene_(scene) {}

  void put(Json& value) const {
    const std::string symbol = value["symbol"];
    try {
      const bool is_load = value["kind"] == "load";
      MechanismAxes axes;
      axes.x = is_load ? usual_parameter(scene_) : symbol;
      const FreedScene freed(scene_, find_symbol(scene_, axes.x), FreedScene::Tied::follow);
      const AxisChoice choice(freed, scene_, axes);
      const Axis across = choice.across();
      value["range"] = axis_json(is_load ? choice.up(across).axis : across);
    } catch (const std::invalid_argument&) {
      value["range"] = nullptr;
    } catch (const InputError&) {
      value["range"] = nullptr;
    }
  }

 private:
  const MechanismScene& scene_;
};

Json values_of(const MechanismScene& scene, bool ranges) {
  const Mechanism& m = scene.mechanism;
  Json all = Json::array();
  if (m.load) all.push_back(value_json("load", m.load->symbol, m.load->unit, m.load->meaning, scene.load));
  for (std::size_t i = 0; i < m.parameters.size(); ++i) {
    const MechanismParameter& p = m.parameters[i];
    const auto value = scene.values.given[i] ? std::optional(scene.values.parameters[i]) : std::nullopt;
    all.push_back(value_json("parameter", p.symbol, p.unit, p.meaning, value));
  }
  for (std::size_t i = 0; i < m.angles.size(); ++i) {
    all.push_back(value_json("angle", m.angles[i].name, "", m.angles[i].meaning, tan_half(scene.values.angles[i])));
  }
  if (ranges) {
    const Sliders sliders(scene);
    for (Json& value : all) sliders.put(value);
  }
  return all;
}

Json pictures_of(const SolvedMechanism& solved) {
  Json pictures = Json::array();
  if (!has_picture(solved.scene.mechanism)) return pictures;
  const std::size_t single = solved.at_load ? solved.at_load->motions.size() : 0;
  const std::vector<MotionAtLoad> motions =
      solved.at_load ? drawn_motions(*solved.at_load) : std::vector<MotionAtLoad>{};
  CommonLook look = common_look(solved.scene, motions);
  look.movable = true;
  look.share = 0.7;  // three of them stand side by side
  const auto add = [&](const std::string& title, const MotionAtLoad* motion) {
    const ElementTree document("div");
    const Element svg = add_mechanism(document.root(), solved.scene, motion, title, look);
    svg.add("style").code(picture_style());
    pictures.push_back({{"title", title}, {"svg", svg.xml()}});
  };
  for (std::size_t i = 0; i < motions.size(); ++i) {
    add(modes_text(motions[i]) + (i < single ? "" : ", a continuum"), &motions[i]);
  }
  if (motions.empty()) add(solved.at_load ? "no motion" : "every load", nullptr);
  return pictures;
}

Json motions_answer(const MechanismScene& scene, const std::string& text, bool ranges, bool with_every_q) {
  const SolvedMechanism solved = solve_mechanism(scene, Listing::motions);  // quickly, as values are dragged
  Json answer;
  answer["scene"] = text;
  answer["name"] = scene.name;
  answer["mechanism"] = scene.mechanism.name;
  answer["values"] = values_of(scene, ranges);
  if (ranges && scene.mechanism.load) answer["usual"] = usual_parameter(scene);
  answer["solve"] = Json::parse(solve_json(solved, with_every_q ? for_every_push(solved.problem) : std::nullopt));
  if (!with_every_q) answer["solve"].erase("every_q");
  answer["pictures"] = pictures_of(solved);
  return answer;
}

Json map_answer(const MechanismScene& scene, const std::string& x, std::size_t columns) {
  MechanismAxes axes;
  axes.x = x;
  Plane plane = mechanism_plane(scene, axes, "map");
  plane.mark.reset();  // the page moves a mark of its own
  const PhaseDiagram diagram = phase_diagram(std::move(plane), columns);
  const PhasePicture picture = phase_picture(diagram);
  Json frames = Json::array({{{"x", axis_json(diagram.plane.x)}, {"y", axis_json(diagram.plane.y)}}});
  for (const Enlargement& part : picture.thin.enlargements) {
    frames.push_back({{"x", axis_json(part.diagram.plane.x)}, {"y", axis_json(part.diagram.plane.y)}});
  }
  return {{"map", phase_svg_file(picture)}, {"frames", std::move(frames)}, {"note", diagram.plane.note}};
}

Json mistakes_json(const std::vector<std::string>& mistakes) {
  return {{"mistakes", mistakes}};
}

constexpr const char* scene_file = "scene.toml";

}  // namespace

Explorer::Explorer(PortableScene given) : given_(std::move(given)), scene_(parse_scene(given_.scene, scene_file)) {}

std::string Explorer::answer(std::string_view text) const {
  try {
    const Json request = Json::parse(text);
    MechanismScene scene = scene_;
    const Json changes = request.value("set", Json::object());
    for (const auto& [symbol, value] : changes.items()) {
      change(scene, symbol, number_of(symbol, value));
    }
    // Written and read again: what the page shows and copies is what the program reads, with all that it refuses.
    const std::string written = to_toml(scene, given_.mechanism, given_.along);
    scene = parse_scene_of(scene_.mechanism, written, scene_file);
    if (request.contains("pasted"))
      return json_text({{"judged", judge_pasted(request["pasted"].get<std::string>(), written)}});
    if (request.contains("map")) {
      const std::size_t columns = request.value("columns", usual_columns);
      return json_text(map_answer(scene, request["map"], std::clamp<std::size_t>(columns, 2, most_columns)));
    }
    return json_text(motions_answer(scene, written, request.value("ranges", false), request.value("every_q", true)));
  } catch (const InputError& error) {
    std::vector<std::string> mistakes;
    for (const Diagnostic& mistake : error.diagnostics()) mistakes.push_back(mistake.message);
    return json_text(mistakes_json(mistakes));
  } catch (const std::invalid_argument& error) {
    return json_text(mistakes_json({error.what()}));
  } catch (const Json::exception& error) {
    return json_text(mistakes_json({error.what()}));
  }
}

}  // namespace slipproof
