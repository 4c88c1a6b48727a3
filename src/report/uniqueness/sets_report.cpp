#include "report/uniqueness/sets_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number/format.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "report/values/mode_json.hpp"
#include "report/values/number_text.hpp"
#include "report/values/set_json.hpp"

namespace slipproof {

namespace {

/// `2 motions: slip/lift, stick/stick`.
std::string words_of(const std::optional<MotionSet>& set) {
  if (!set) return "out of the domain";
  const std::size_t motions = set->motions.size();
  if (motions == 0 && set->continua.empty()) return name(*set);
  const std::string count = motions > 0 ? counted(motions, "motion") : counted(set->continua.size(), "continuum");
  return count + ": " + name(*set);
}

std::string value_text(const Axis& axis, const Rational& x, int digits) {
  if (axis.is_angle) {
    const MechanismValues::Circle at = point_of_tan_half(x);
    return decimal_text(degrees_of_direction(at.cosine, at.sine, 12).first, digits) + " degrees";
  }
  return short_text(x, digits) + (axis.unit.empty() || axis.unit == "1" ? "" : " " + axis.unit);
}

}  // namespace

Document sets_document(const MechanismScene& scene, const SetsAlong& along, int digits) {
  Document document = scene_document(scene, scene.mechanism.name);
  const std::string at = scene.mechanism.load && scene.load
                             ? fmt::format(", {} = {}", scene.mechanism.load->symbol, exact_text(*scene.load))
                             : "";
  Document& section = document.section("Along " + along.x.symbol + ", all else as it is" + at);
  const auto runs = along.runs();
  const auto text = [&](std::size_t i) { return value_text(along.x, along.places[i].x, digits); };
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto [first, last] = runs[r];
    Document& item =
        section.item(fmt::format("{} {}", along.x.symbol,
                                 first == last ? "= " + text(first) : "from " + text(first) + " to " + text(last)),
                     {0, 4});
    item.line(words_of(along.places[first].set));
    if (last - first > 1) item.line(fmt::format("the same at {} values between", last - first - 1));
  }
  section.paragraph("Motions are proved at the values; between two values that are alike others may be.");
  document.status(fmt::format("s {} changes {} values {}", along.is_complete() ? "COMPLETE" : "UNDECIDED",
                              runs.size() - 1, along.places.size()));
  return document;
}

std::string sets_json(const MechanismScene& scene, const SetsAlong& along) {
  Json document{{"schema", "slipproof/critical-space/1"}, {"mechanism", scene.mechanism.name}, {"scene", scene.name}};
  document["values"] = values_json(scene.mechanism, scene.values);
  document["load"] = nullptr;
  if (const auto& load = scene.mechanism.load)
    document["load"] = {{"symbol", load->symbol}, {"value", to_json(scene.load)}};
  document["x"] = {{"symbol", along.x.symbol}, {"kind", along.x.is_angle ? "angle" : "parameter"}};
  document["complete"] = along.is_complete();
  const auto value = [&](std::size_t i) { return across_json(along.x, along.places[i].x); };
  Json alike = Json::array(), changes = Json::array();
  for (const auto& [first, last] : along.runs()) {
    if (first > 0) changes.push_back(Json::array({value(first - 1), value(first)}));
    alike.push_back(set_json(along.places[first].set));
    alike.back()["x"] = Json::array({value(first), value(last)});
    alike.back()["values"] = last - first + 1;
  }
  document["changes"] = std::move(changes);
  document["alike"] = std::move(alike);
  return dump(document);
}

}  // namespace slipproof
