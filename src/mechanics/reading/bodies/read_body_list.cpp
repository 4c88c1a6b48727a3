#include <algorithm>
#include <array>

#include "base/expression/parser.hpp"
#include "base/input/near_match.hpp"
#include "mechanics/reading/bodies/body_parts.hpp"

namespace slipproof::mechanism_reader {

namespace {

using Role = MechanismUnknown::Role;

class BodyListReader : public BodyParts {
 public:
  using BodyParts::BodyParts;

  void read(const TableReader& root) {
    Body still;
    still.name = "ground";
    bodies_.bodies.push_back(std::move(still));
    const auto found = tables(root, "body", max_bodies);
    std::size_t moving = 0;
    for (const TomlValue* body : found) moving += body->find("mass") != nullptr ? 1 : 0;
    for (const TomlValue* body : found) read_body(*body, moving == 1);
    if (context_.bodies_named_well)
      std::ranges::for_each(bodies_.bodies, [this](Body& body) { declare_unknowns(body); });
    if (moving == 0) root.refuse("body", "found no body with a mass, expected at least one that moves");
  }

 private:
  void read_body(const TomlValue& value, bool alone) {
    static constexpr std::array<std::string_view, 11> keys{
        "name", "mass", "inertia", "at", "angle", "velocity", "spin", "acceleration", "turning", "shape", "names"};
    const TableReader table(value, "[[body]]", keys, context_.mistakes);
    Body body;
    body.place = value.place;
    body.name = context_.required(table, "name", "an identifier");
    if (body.name.empty()) {
      context_.bodies_named_well = false;
    } else {
      declare_body(body.name, table.place("name"));
    }
    body.mass = one(table, "mass");
    body.inertia = one(table, "inertia");
    body.at = two(table, "at");
    read_angle(table, body);
    body.velocity = two(table, "velocity");
    body.spin = one(table, "spin");
    body.acceleration = two(table, "acceleration");
    body.turning = one(table, "turning");
    if (const TomlValue* shapes = table.value("shape")) read_shapes(*shapes, body);
    check_motion(table, body);
    name_unknowns(table, body, alone);
    bodies_.bodies.push_back(std::move(body));
  }

  void declare_body(const std::string& name, Place place) {
    const auto refuse = [&](const std::string& message) {
      context_.mistakes.add(place, "name: found " + in_quotes(name) + message);
      context_.bodies_named_well = false;
    };
    if (!is_symbol_name(name)) {
      refuse(", expected an identifier: a letter, then letters, digits and underscores, and no word of the language");
    } else if (name == "ground") {
      refuse(", which is there always and at rest, expected another name");
    } else if (std::ranges::any_of(bodies_.bodies, [&](const Body& other) { return other.name == name; })) {
      refuse(" a second time, expected another");
    }
  }

  void read_angle(const TableReader& table, Body& body) {
    const TomlValue* value = table.value("angle");
    if (value == nullptr) return;
    if (value->kind == TomlValue::Kind::array) {
      PlacedPair circle = two(*value, "angle");
      body.cosine = std::move(circle.x);
      body.sine = std::move(circle.y);
      return;
    }
    std::vector<std::string_view> known;
    for (const MechanismAngle& angle : mechanism_.angles) known.push_back(angle.name);
    if (value->kind == TomlValue::Kind::string) {
      const std::string name = value->text.text();
      for (const MechanismAngle& angle : mechanism_.angles) {
        if (angle.name != name) continue;
        body.cosine = {make_symbol(angle.cosine), PlacedText("", value->place)};
        body.sine = {make_symbol(angle.sine), PlacedText("", value->place)};
        return;
      }
      const auto near = near_match(name, known);
      table.refuse("angle", "found " + in_quotes(name) +
                                (near ? ", did you mean '" + std::string(*near) + "'?" : expected_angle));
      return;
    }
    table.refuse("angle", "found " + std::string(kind_name(value->kind)) + expected_angle);
  }
  static constexpr const char* expected_angle =
      ", expected the name of an entry of [angles], or [\"cosine\", \"sine\"]: an angle in degrees is given in the "
      "scene";

  void check_motion(const TableReader& table, const Body& body) {
    if (!body.is_prescribed()) {
      if (table.has("acceleration")) {
        table.refuse("acceleration",
                     "found together with a mass, expected one of them: a body moves freely, or as prescribed");
      }
      if (!table.has("inertia") && !table.has("turning")) {
        table.require(
            "inertia",
            "the moment of inertia about the centre of mass, or turning = \"0\" for a body that does not turn");
      }
      if (table.has("inertia") && table.has("turning")) {
        table.refuse("turning",
                     "found together with an inertia, expected one of them: a body turns freely, or as prescribed");
      }
      return;
    }
    if (table.has("inertia"))
      context_.sound =
          table.require("mass",
                        "the mass of a body with an inertia (\"0\" if another body's mass counts it), or no inertia "
                        "for one that moves as prescribed") &&
          context_.sound;
    if (!table.has("acceleration") && !table.has("turning") && !table.has("inertia")) {
      table.require("mass", "the mass of the body, or the acceleration of one that moves as prescribed");
    }
  }

  void name_unknowns(const TableReader& table, Body& body, bool alone) {
    static constexpr std::array<std::string_view, 3> keys{"ax", "ay", "alpha"};
    const TomlValue* names = table.value("names") == nullptr ? nullptr : table.table("names");
    std::optional<TableReader> given;
    if (names != nullptr) given.emplace(*names, "names", keys, context_.mistakes);
    const std::array<Body::Unknown*, 3> unknowns{&body.ax, &body.ay, &body.alpha};
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      const bool exists = !body.is_prescribed() && (i < 2 || body.inertia);
      Body::Unknown& unknown = *unknowns[i];
      unknown.place = table.place("name");
      std::string text = given ? context_.text(*given, keys[i]) : std::string();
      if (!text.empty()) unknown.place = given->place(keys[i]);
      if (!exists) {
        if (!text.empty()) given->refuse(keys[i], "found a name of what is prescribed, expected none");
        continue;
      }
      if (text.empty()) text = std::string(keys[i]) + (alone ? "" : "_" + body.name);
      unknown.negated = text.starts_with('-');
      unknown.symbol = text.substr(unknown.negated ? 1 : 0);
    }
  }

  void declare_unknowns(const Body& body) {
    for (const Body::Unknown* unknown : {&body.ax, &body.ay, &body.alpha}) {
      if (unknown->symbol.empty()) continue;
      context_.declare(unknown->symbol, unknown->place);
      mechanism_.unknowns.push_back({unknown->symbol, Role::acceleration, 0, {}, unknown->place});
      ++mechanism_.accelerations;
    }
  }

  void read_shapes(const TomlValue& value, Body& body) {
    if (value.kind == TomlValue::Kind::array) {
      for (const TomlValue& item : value.items) read_shape(item, body);
    } else {
      read_shape(value, body);
    }
  }

  void read_shape(const TomlValue& value, Body& body) {
    static constexpr std::array<std::string_view, 5> keys{"polygon", "line", "box", "circle", "at"};
    if (value.kind != TomlValue::Kind::table) {
      context_.mistakes.add(value.place, "shape: found " + std::string(kind_name(value.kind)) +
                                             ", expected a table such as { box = [\"2*b\", \"2*h\"] }");
      return;
    }
    const TableReader table(value, "shape", keys, context_.mistakes);
    using Kind = BodyShape::Kind;
    BodyShape shape;
    shape.place = value.place;
    std::size_t kinds = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!table.has(keys[i])) continue;
      ++kinds;
      shape.kind = std::array{Kind::polygon, Kind::line, Kind::box, Kind::circle}[i];
    }
    if (kinds != 1) {
      context_.mistakes.add(value.place, "shape: expected one of polygon, line, box, circle");
      return;
    }
    const bool by_points = shape.kind == Kind::polygon || shape.kind == Kind::line;
    if (by_points) {
      read_points(table, shape);
      if (table.has("at")) table.refuse("at", "found together with points, expected it with box or circle");
    } else {
      if (table.has("at")) shape.points.push_back(two(table, "at"));
      shape.radius = shape.kind == Kind::circle ? one(table, "circle") : PlacedExpression{};
      if (shape.kind == Kind::box) {
        PlacedPair size = two(table, "box");
        shape.width = std::move(size.x);
        shape.height = std::move(size.y);
      }
    }
    body.shapes.push_back(std::move(shape));
  }

  void read_points(const TableReader& table, BodyShape& shape) {
    const bool line = shape.kind == BodyShape::Kind::line;
    const std::string_view key = line ? "line" : "polygon";
    const TomlValue* points = table.value(key);
    if (points->kind != TomlValue::Kind::array) {
      return table.refuse(key, "found " + std::string(kind_name(points->kind)) + ", expected an array of points");
    }
    for (const TomlValue& point : points->items) shape.points.push_back(two(point, key));
    const std::size_t needed = line ? 2 : 3;
    if (shape.points.size() < needed) {
      table.refuse(key, "found " + std::to_string(shape.points.size()) + " points, expected " + std::to_string(needed) +
                            " or more");
    }
  }
};

}  // namespace

void read_body_list(const TableReader& root, Context& context, Bodies& bodies) {
  BodyListReader(context, bodies).read(root);
}

}  // namespace slipproof::mechanism_reader
