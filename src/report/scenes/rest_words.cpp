#include "report/scenes/rest_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number/format.hpp"
#include "base/output/listed.hpp"

namespace slipproof {

namespace {

/// `1/2 X`, `-Y`.
std::string product_text(const Rational& factor, const std::string& symbol, int digits) {
  if (factor == 1) return symbol;
  if (factor == -1) return "-" + symbol;
  return brief(factor, digits) + " " + symbol;
}

std::string frame_words(const std::string& symbol, const RestMap::Frame& frame, int digits) {
  std::string text;
  if (frame.from) text += " from " + brief(*frame.from, digits);
  if (frame.to) text += " up to " + brief(*frame.to, digits);
  return text.empty() ? text : symbol + text;
}

Json frame_json(const RestMap::Frame& frame) {
  return Json::array({to_json(frame.from), to_json(frame.to)});
}

}  // namespace

std::string brief(const Rational& x, int digits) {
  constexpr std::size_t short_enough = 12;
  const std::string exact = exact_text(x);
  return exact.size() <= short_enough ? exact : "about " + decimal_text(x, digits);
}

Json named_json(const std::vector<std::string>& names, const std::vector<Rational>& values) {
  Json result = Json::object();
  auto& members = result.get_ref<Json::object_t&>();  // names differ: none is looked for
  for (std::size_t i = 0; i < names.size(); ++i) members.emplace_back(names[i], to_json(values[i]));
  return result;
}

Json virtual_motion_json(const RestProblem& problem, const std::optional<VirtualMotion>& motion) {
  if (!motion) return nullptr;
  Json result{{"power", to_json(motion->power)}, {"motion", named_json(problem.rows, motion->rates)}};
  if (!problem.limits.empty()) {
    std::vector<std::string> names;
    for (const RestProblem::Limit& limit : problem.limits) names.push_back(limit.name);
    result["rubbing"] = named_json(names, motion->rubbing);
  }
  return result;
}

std::string contact_words(const RestProblem& problem, const VirtualMotion& motion) {
  std::vector<std::string> parts;
  const auto moves = [&](std::size_t force) { return !problem.rate_along(force, motion.rates).is_zero(); };
  for (const RestProblem::Contact& contact : problem.contacts) {
    const bool slips = std::ranges::any_of(contact.tangents, moves), opens = moves(contact.normal);
    if (!slips && !opens) continue;
    parts.push_back(contact.name + (slips ? " slips" : "") + (slips && opens ? " and" : "") + (opens ? " opens" : ""));
  }
  for (const RestProblem::Limit& limit : problem.limits) {
    if (moves(limit.force)) parts.push_back(limit.name + " slips");
  }
  return listed(parts, ", ");
}

std::string border_text(const RestMap& map, const RestMap::Border& border, int digits) {
  const Rational size = abs(border.x.is_zero() ? border.y : border.x);
  if (size.is_zero()) return "nowhere";
  const Rational x = border.x / size, y = border.y / size;
  std::string text;
  if (!x.is_zero()) text = product_text(x, map.x, digits);
  if (!y.is_zero() && text.empty()) {
    text = product_text(y, map.y, digits);
  } else if (!y.is_zero()) {
    text += (y.sign() < 0 ? " - " : " + ") + product_text(abs(y), map.y, digits);
  }
  return text + " <= " + brief(border.most / size, digits);
}

void write_rest_map(Document& section, const RestAnswer& answer, int digits) {
  const RestMap& map = *answer.map;
  if (map.none) {
    section.paragraph("It rests at no values of them.");
  } else if (map.inside.empty()) {
    section.paragraph("No region was found with the effort that is made.");
    return;
  } else {
    section.paragraph("It can rest between these corners, at each of which forces hold it" +
                      std::string(map.exact ? ", and nowhere else." : "."));
    ReportTable& corners = section.section("Corners").table({{map.x, map.y}});
    for (const RestMap::Corner& corner : map.inside) corners.row({brief(corner.x, digits), brief(corner.y, digits)});
  }
  ReportTable& borders = section.section("Borders, each with the virtual motion that proves it").table({{"", ""}});
  for (const RestMap::Border& border : map.borders) {
    borders.row({border_text(map, border, digits), contact_words(answer.problem, border.motion)});
  }
  std::vector<std::string> frames;
  for (std::string words : {frame_words(map.x, map.x_frame, digits), frame_words(map.y, map.y_frame, digits)}) {
    if (!words.empty()) frames.push_back(std::move(words));
  }
  if (!frames.empty()) section.paragraph("Only asked for " + listed(frames, ", ") + ".");
  if (!map.none && !map.exact) {
    section.paragraph(
        fmt::format("Between the corners and the borders it is open: {:.2g} of the width and height.", map.gap));
  }
  if (!map.decided) section.paragraph("The effort ended before the polygons were near each other.");
}

Json rest_map_json(const RestAnswer& answer) {
  const RestMap& map = *answer.map;
  Json result{{"x", map.x},
              {"y", map.y},
              {"x_frame", frame_json(map.x_frame)},
              {"y_frame", frame_json(map.y_frame)},
              {"none", map.none},
              {"exact", map.exact},
              {"decided", map.decided},
              {"gap", map.gap}};
  for (const char* key : {"inside", "borders", "around"}) result[key] = Json::array();
  for (const RestMap::Corner& corner : map.inside) {
    result["inside"].push_back({{"x", to_json(corner.x)},
                                {"y", to_json(corner.y)},
                                {"forces", named_json(answer.problem.forces, corner.forces)}});
  }
  for (const RestMap::Border& border : map.borders) {
    Json one = virtual_motion_json(answer.problem, border.motion);
    one["x"] = to_json(border.x), one["y"] = to_json(border.y), one["most"] = to_json(border.most);
    result["borders"].push_back(std::move(one));
  }
  for (const auto& corner : map.around) result["around"].push_back({to_json(corner[0]), to_json(corner[1])});
  return result;
}

}  // namespace slipproof
