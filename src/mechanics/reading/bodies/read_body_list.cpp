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
    bodies_.dimension = mechanism_.dimension;
    const auto found = tables(root, "body", max_scene_bodies);
    std::size_t moving = 0;
    for (const TomlValue* body : found) moving += body->find("mass") != nullptr ? 1 : 0;
    for (const TomlValue* body : found) read_body(*body, moving == 1);
    if (context_.bodies_named_well)
      std::ranges::for_each(bodies_.bodies, [this](Body& body) { declare_unknowns(body); });
    if (moving == 0) root.refuse("body", "found no body with a mass, expected at least one that moves");
  }

 private:
  void read_body(const TomlValue& value, bool alone) {
    static constexpr std::array<std::string_view, 14> all{"name", "mass",         "inertia", "at",    "velocity",
                                                          "spin", "acceleration", "turning", "shape", "names",
                                                          "by",   "displacement", "angle",   "turn"};
    const std::span<const std::string_view> keys(all.data(), in_space() ? 14 : 13);
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
    read_inertia(table, body);
    body.at = vector(table, "at");
    in_space() ? read_turn(table, body) : read_angle(table, body);
    read_placement(table, body);
    body.velocity = vector(table, "velocity");
    body.spin = turning(table, "spin");
    body.acceleration = vector(table, "acceleration");
    body.turning = turning(table, "turning");
    if (const TomlValue* shapes = table.value("shape")) read_shapes(*shapes, body);
    check_motion(table, body);
    name_unknowns(table, body, alone);
    bodies_.bodies.push_back(std::move(body));
  }

  /// A body that a joint places.
  void read_placement(const TableReader& table, Body& body) {
    if (!table.has("by")) {
      if (table.has("displacement")) table.refuse("displacement", "found it without `by`, the joint along which it is");
      if (in_space() && table.has("angle")) {
        table.refuse("angle", "found it without `by`, the joint about whose axis it is, expected `turn`");
      }
      return;
    }
    if (table.has("at")) table.refuse("at", "found together with `by`, from which it follows, expected one of them");
    if (in_space() && table.has("angle")) {
      if (table.has("turn")) table.refuse("turn", "found together with an angle, expected one of them");
      read_angle(table, body);
    }
    if (const PlacedText* joint = table.string("by")) body.by = {*joint, one(table, "displacement")};
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

  void read_inertia(const TableReader& table, Body& body) {
    const TomlValue* value = table.value("inertia");
    if (value == nullptr) return;
    if (!in_space()) {
      body.inertia.entries[2] = one(table, "inertia");
      return;
    }
    if (value->kind != TomlValue::Kind::array || (value->items.size() != 3 && value->items.size() != 6)) {
      return table.refuse("inertia",
                          "expected three numbers xx yy zz, or six xx yy zz xy xz yz: the entries of its matrix about "
                          "the centre of mass, in the axes of the body");
    }
    for (std::size_t i = 0; i < value->items.size(); ++i) {
      body.inertia.entries[i] = folded_number(value->items[i], "inertia");
    }
  }

  void read_turn(const TableReader& table, Body& body) {
    const TomlValue* value = table.value("turn");
    if (value == nullptr) return;
    if (value->kind == TomlValue::Kind::array && value->items.size() == 4) {
      for (std::size_t i = 0; i < 4; ++i) body.quaternion[i] = folded_number(value->items[i], "turn");
      const auto is_zero = [](const PlacedExpression& part) { return part && is_literal_zero(part.expression); };
      if (std::ranges::all_of(body.quaternion, is_zero)) {
        table.refuse("turn", "found a quaternion of length 0, expected w x y z such as [\"1\", \"0\", \"0\", \"0\"]");
      }
    } else if (value->kind == TomlValue::Kind::table) {
      static constexpr std::array<std::string_view, 2> keys{"axis", "angle"};
      const TableReader turn(*value, "turn", keys, context_.mistakes);
      turn.require("axis", "the axis, of length 1, such as [\"0\", \"0\", \"1\"]");
      turn.require("angle", "the name of an entry of [angles], or [\"cosine\", \"sine\"]");
      body.turn_axis = vector(turn, "axis");
      read_angle(turn, body);
    } else {
      table.refuse("turn",
                   "expected a quaternion w x y z such as [\"1\", \"0\", \"0\", \"0\"], or { axis = [\"0\", \"0\", "
                   "\"1\"], angle = \"theta\" }");
    }
  }

  void read_angle(const TableReader& table, Body& body) {
    const TomlValue* value = table.value("angle");
    if (value == nullptr) return;
    if (value->kind == TomlValue::Kind::array) {
      if (value->items.size() != 2) return table.refuse("angle", "expected two numbers, [\"cosine\", \"sine\"]");
      body.cosine = context_.expression(value->items[0], "angle", Sort::number);
      body.sine = context_.expression(value->items[1], "angle", Sort::number);
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
    static constexpr std::array<std::string_view, 6> in_plane{"ax", "ay", "", "", "", "alpha"},
        spatial{"ax", "ay", "az", "alphax", "alphay", "alphaz"};
    const auto& keys = in_space() ? spatial : in_plane;
    std::vector<std::string_view> named;
    std::ranges::copy_if(keys, std::back_inserter(named), [](std::string_view key) { return !key.empty(); });
    const TomlValue* names = table.value("names") == nullptr ? nullptr : table.table("names");
    std::optional<TableReader> given;
    if (names != nullptr) given.emplace(*names, "names", named, context_.mistakes);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      if (keys[i].empty()) continue;
      const bool exists = !body.is_prescribed() && (i < 3 || body.turns_freely());
      Body::Unknown& unknown = body.unknowns[i];
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
    for (const Body::Unknown& unknown : body.unknowns) {
      if (unknown.symbol.empty()) continue;
      context_.declare(unknown.symbol, unknown.place);
      mechanism_.unknowns.push_back({unknown.symbol, Role::acceleration, 0, {}, unknown.place});
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
    using Kind = BodyShape::Kind;
    struct Word {
      std::string_view key;
      Kind kind;
    };
    static constexpr std::array<Word, 4> in_plane{
        {{"polygon", Kind::polygon}, {"line", Kind::line}, {"box", Kind::box}, {"circle", Kind::circle}}};
    static constexpr std::array<Word, 5> spatial{{{"box", Kind::box},
                                                  {"sphere", Kind::sphere},
                                                  {"cylinder", Kind::cylinder},
                                                  {"capsule", Kind::capsule},
                                                  {"hull", Kind::hull}}};
    const std::span<const Word> words = in_space() ? std::span<const Word>(spatial) : std::span<const Word>(in_plane);
    if (value.kind != TomlValue::Kind::table) {
      context_.mistakes.add(value.place, "shape: found " + std::string(kind_name(value.kind)) +
                                             ", expected a table such as { box = [\"2*b\", " +
                                             (in_space() ? "\"2*b\", " : "") + "\"2*h\"] }");
      return;
    }
    std::vector<std::string_view> keys{"at"};
    if (in_space()) keys.push_back("axis");
    for (const Word& word : words) keys.push_back(word.key);
    const TableReader table(value, "shape", keys, context_.mistakes);
    BodyShape shape;
    shape.place = value.place;
    std::string list, key;
    std::size_t kinds = 0;
    for (const Word& word : words) {
      list += (list.empty() ? "" : ", ") + std::string(word.key);
      if (!table.has(word.key)) continue;
      ++kinds;
      shape.kind = word.kind;
      key = word.key;
    }
    if (kinds != 1) return context_.mistakes.add(value.place, "shape: expected one of " + list);
    if (shape.kind == Kind::polygon || shape.kind == Kind::line || shape.kind == Kind::hull) {
      read_points(table, shape, key);
      if (table.has("at")) {
        table.refuse("at", in_space() ? "found together with points, expected it with another kind"
                                      : "found together with points, expected it with box or circle");
      }
    } else {
      if (table.has("at")) shape.points.push_back(vector(table, "at"));
      read_size(table, shape, key);
    }
    body.shapes.push_back(std::move(shape));
  }

  void read_size(const TableReader& table, BodyShape& shape, const std::string& key) {
    using Kind = BodyShape::Kind;
    const bool is_long = shape.kind == Kind::cylinder || shape.kind == Kind::capsule;
    if (table.has("axis") && !is_long) table.refuse("axis", "a " + key + " has none");
    if (shape.kind == Kind::box) {
      PlacedVector size = vector(table, "box");
      shape.width = std::move(size.x);
      (in_space() ? shape.depth : shape.height) = std::move(size.y);
      if (in_space()) shape.height = std::move(size.z);
    } else if (is_long) {
      const TomlValue& value = *table.value(key);
      if (value.kind != TomlValue::Kind::array || value.items.size() != 2) {
        return table.refuse(key, "expected a radius and a length such as [\"r\", \"l\"]");
      }
      shape.radius = folded_number(value.items[0], key);
      shape.height = folded_number(value.items[1], key);
      shape.axis = vector(table, "axis");
    } else {
      shape.radius = one(table, key);
    }
  }

  void read_points(const TableReader& table, BodyShape& shape, const std::string& key) {
    const TomlValue* points = table.value(key);
    if (points->kind != TomlValue::Kind::array) {
      return table.refuse(key, "found " + std::string(kind_name(points->kind)) + ", expected an array of points");
    }
    for (const TomlValue& point : points->items) shape.points.push_back(vector(point, key));
    const std::size_t needed = shape.kind == BodyShape::Kind::line ? 2 : shape.kind == BodyShape::Kind::hull ? 1 : 3;
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
