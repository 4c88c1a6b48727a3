#include <algorithm>
#include <array>

#include "base/input/near_match.hpp"
#include "mechanics/reading/reader.hpp"

namespace slipproof::mechanism_reader {

namespace {

using Role = MechanismUnknown::Role;

class ElementReader {
 public:
  ElementReader(const TableReader& root, Context& context)
      : root_(root), context_(context), mechanism_(context.mechanism) {}

  void read() {
    each("contact", max_elements, &ElementReader::read_contact);
    each("friction", max_elements, &ElementReader::read_friction);
    each("link", max_elements, &ElementReader::read_link);
    each("shape", max_shapes, &ElementReader::read_shape);
  }

 private:
  void each(std::string_view key, std::size_t limit, void (ElementReader::*read_one)(const TomlValue&)) {
    const auto tables = root_.tables(key);
    if (!within(tables.size(), limit, key, root_.place(key), context_.mistakes)) return;
    for (const TomlValue* table : tables) (this->*read_one)(*table);
  }

  std::string name_of(const TableReader& table) {
    const std::string name = context_.required(table, "name", "an identifier");
    named_well_ = !name.empty() && context_.declare_element(name, table.place("name"));
    return name;
  }

  /// The name of a quantity or force: as the file has it, or the default.
  std::string named(const TableReader& table, std::string_view key, const std::string& otherwise) {
    const std::string given = context_.text(table, key);
    const std::string name = given.empty() && !table.has(key) ? otherwise : given;
    if (table.has(key) ? !name.empty() : named_well_) {
      context_.declare(name, table.place(table.has(key) ? key : std::string_view("name")));
    }
    return name;
  }

  std::size_t unknown(const TableReader& table, std::string_view key, const std::string& otherwise, Role role,
                      std::size_t owner) {
    const Place place = table.place(table.has(key) ? key : std::string_view("name"));
    mechanism_.unknowns.push_back({named(table, key, otherwise), role, owner, {}, place});
    return mechanism_.unknowns.size() - 1;
  }

  void read_contact(const TomlValue& value) {
    static constexpr std::array<std::string_view, 14> keys{
        "name",      "gap",        "slip",     "friction",  "normal", "tangent",   "state",
        "bilateral", "lift_needs", "gap_name", "slip_name", "at",     "direction", "slip_direction"};
    const TableReader table(value, "[[contact]]", keys, context_.mistakes);
    MechanismContact contact;
    contact.place = value.place;
    contact.name = name_of(table);
    table.require("gap", "the acceleration with which the contact opens");
    contact.gap = context_.expression(table, "gap", Sort::number);
    read_coefficients(table, contact);
    if (!contact.frictionless()) table.require("slip", "the tangential acceleration of the contact");
    contact.slip = context_.expression(table, "slip", Sort::number);
    contact.bilateral = table.boolean("bilateral").value_or(false);
    read_lift_needs(table, contact);
    const std::size_t owner = mechanism_.contacts.size();
    contact.normal = unknown(table, "normal", "N_" + contact.name, Role::normal, owner);
    if (!contact.frictionless()) {
      contact.tangent = unknown(table, "tangent", "S_" + contact.name, Role::tangent, owner);
    } else if (table.has("tangent")) {
      table.refuse("tangent", "found the name of a force that a frictionless contact does not have");
    }
    contact.gap_name = named(table, "gap_name", "gap_" + contact.name);
    if (table.has("slip")) contact.slip_name = named(table, "slip_name", "slip_" + contact.name);
    contact.at = pair(table, "at");
    contact.direction = pair(table, "direction");
    contact.slip_direction = pair(table, "slip_direction");
    read_state(table, contact.start,
               {.law = contact.frictionless() ? ElementKind::Law::frictionless : ElementKind::Law::coulomb,
                .bilateral = contact.bilateral});
    mechanism_.contacts.push_back(std::move(contact));
  }

  void read_coefficients(const TableReader& table, MechanismContact& contact) {
    const TomlValue* friction = table.value("friction");
    if (friction == nullptr) return;
    read_two(*friction, "friction", contact.static_friction, contact.kinetic_friction);
    if (friction->kind == TomlValue::Kind::table) return;
    if (contact.static_friction && is_literal_zero(contact.static_friction.expression)) {
      contact.static_friction = contact.kinetic_friction = {};
    }
  }

  /// Reads one expression for both, or { static = ..., kinetic = ... }. Reports what cannot be read, and uses 1 in its
  /// place, so that the element keeps its forces.
  void read_two(const TomlValue& value, const std::string& key, PlacedExpression& at_rest, PlacedExpression& in_slip) {
    if (value.kind == TomlValue::Kind::table) {
      static constexpr std::array<std::string_view, 2> keys{"static", "kinetic"};
      const TableReader table(value, key, keys, context_.mistakes);
      for (const std::string_view one : keys) {
        context_.sound = table.require(one, "an expression") && context_.sound;
      }
      at_rest = context_.expression(table, "static", Sort::number);
      in_slip = context_.expression(table, "kinetic", Sort::number);
    } else {
      at_rest = in_slip = context_.expression(value, key, Sort::number);
    }
    for (PlacedExpression* one : {&at_rest, &in_slip}) {
      if (!*one) one->expression = make_number(1);
    }
  }

  void read_lift_needs(const TableReader& table, MechanismContact& contact) {
    std::vector<std::string_view> known;
    for (const MechanismParameter& parameter : mechanism_.parameters) {
      if (parameter.optional) known.push_back(parameter.symbol);
    }
    const auto names = table.strings("lift_needs");
    if (!within(names.size(), max_symbols, "lift_needs", table.place("lift_needs"), context_.mistakes)) return;
    for (const PlacedText* name : names) {
      for (std::size_t i = 0; i < mechanism_.parameters.size(); ++i) {
        const MechanismParameter& parameter = mechanism_.parameters[i];
        if (parameter.symbol == name->text() && parameter.optional) contact.lift_needs.push_back(i);
      }
      if (std::find(known.begin(), known.end(), name->text()) == known.end()) {
        context_.mistakes.add(name->at(0), "lift_needs: " + unknown_name("optional parameter", name->text(), known));
      }
    }
    if (contact.bilateral && table.has("lift_needs")) {
      table.refuse("lift_needs", "found a condition of lift, and a bilateral contact does not lift");
    }
  }

  void read_state(const TableReader& table, ElementKind::Start& start, const ElementKind& kind) {
    const PlacedText* text = table.string("state");
    if (text == nullptr) return;
    start = read_start(text->text(), "state", table.place("state"), kind, context_.mistakes).value_or(start);
  }

  void read_friction(const TomlValue& value) {
    static constexpr std::array<std::string_view, 5> keys{"name", "slip", "limit", "force", "state"};
    const TableReader table(value, "[[friction]]", keys, context_.mistakes);
    MechanismFriction friction;
    friction.place = value.place;
    friction.name = name_of(table);
    table.require("slip", "the acceleration that it works against");
    friction.slip = context_.expression(table, "slip", Sort::number);
    if (table.require("limit", "the largest force that it bears")) {
      read_two(*table.value("limit"), "limit", friction.static_limit, friction.kinetic_limit);
    }
    friction.force = unknown(table, "force", "S_" + friction.name, Role::friction, mechanism_.friction.size());
    friction.slip_name = "slip_" + friction.name;
    if (named_well_) context_.declare(friction.slip_name, table.place("name"));
    read_state(table, friction.start, {.law = ElementKind::Law::limited});
    mechanism_.friction.push_back(std::move(friction));
  }

  void read_link(const TomlValue& value) {
    static constexpr std::array<std::string_view, 3> keys{"name", "zero", "force"};
    const TableReader table(value, "[[link]]", keys, context_.mistakes);
    MechanismLink link;
    link.place = value.place;
    link.name = name_of(table);
    table.require("zero", "an acceleration that stays 0");
    link.zero = context_.expression(table, "zero", Sort::number);
    link.force = unknown(table, "force", "R_" + link.name, Role::link, mechanism_.links.size());
    mechanism_.links.push_back(std::move(link));
  }

  std::vector<PlacedExpression> pair(const TableReader& table, std::string_view key) {
    const TomlValue* value = table.value(key);
    return value == nullptr ? std::vector<PlacedExpression>{} : pair(*value, key);
  }

  std::vector<PlacedExpression> pair(const TomlValue& value, std::string_view key) {
    std::vector<PlacedExpression> result;
    if (value.kind != TomlValue::Kind::array || value.items.size() != 2) {
      context_.mistakes.add(value.place, std::string(key) + ": expected two coordinates such as [\"b\", \"-h\"]");
      return result;
    }
    for (const TomlValue& item : value.items) result.push_back(context_.expression(item, key, Sort::number));
    return result;
  }

  void read_shape(const TomlValue& value) {
    static constexpr std::array<std::string_view, 4> keys{"kind", "points", "radius", "text"};
    const TableReader table(value, "[[shape]]", keys, context_.mistakes);
    MechanismShape shape;
    shape.place = value.place;
    const bool known = read_kind(table, shape);
    table.require("points", "an array of points such as [[\"b\", \"-h\"]]");
    const TomlValue* points = table.value("points");
    if (points != nullptr && points->kind == TomlValue::Kind::array) {
      for (const TomlValue& point : points->items) shape.points.push_back(pair(point, "points"));
    } else if (points != nullptr) {
      table.refuse("points", "found " + std::string(kind_name(points->kind)) + ", expected an array of points");
    }
    shape.radius = context_.expression(table, "radius", Sort::number);
    shape.text = context_.text(table, "text");
    if (known && points != nullptr) check_shape(table, shape);
    mechanism_.shapes.push_back(std::move(shape));
  }

  bool read_kind(const TableReader& table, MechanismShape& shape) {
    using Kind = MechanismShape::Kind;
    const std::string found = context_.required(table, "kind", "polygon, line, circle, point, arrow or label");
    std::vector<std::string_view> words;
    for (const Kind kind : {Kind::polygon, Kind::line, Kind::circle, Kind::point, Kind::arrow, Kind::label}) {
      words.push_back(name(kind));
      shape.kind = kind;
      if (words.back() == found) return true;
    }
    if (!found.empty()) table.refuse("kind", unknown_name("kind of shape", found, words));
    return false;
  }

  /// How many points a shape has, and what else it needs.
  void check_shape(const TableReader& table, const MechanismShape& shape) {
    using Kind = MechanismShape::Kind;
    const bool many = shape.kind == Kind::polygon || shape.kind == Kind::line;
    const std::size_t needed = shape.kind == Kind::polygon                             ? 3
                               : shape.kind == Kind::line || shape.kind == Kind::arrow ? 2
                                                                                       : 1;
    const std::size_t count = shape.points.size();
    if (count < needed || (!many && count > needed)) {
      table.refuse("points", "found " + std::to_string(count) + " for a " + std::string(name(shape.kind)) +
                                 ", expected " + std::to_string(needed) + (many ? " or more" : ""));
    }
    const auto belongs = [&](std::string_view key, Kind kind, std::string_view what) {
      if (shape.kind == kind) table.require(key, what);
      if (shape.kind != kind && table.has(key)) {
        table.refuse(key, "a " + std::string(name(shape.kind)) + " has none");
      }
    };
    belongs("radius", Kind::circle, "the radius of the circle");
    belongs("text", Kind::label, "the text of the label");
  }

  const TableReader& root_;
  Context& context_;
  Mechanism& mechanism_;
  bool named_well_ = false;  ///< the element's name is fine, and so names may be made of it
};

}  // namespace

void read_elements(const TableReader& root, Context& context) {
  ElementReader(root, context).read();
}

}  // namespace slipproof::mechanism_reader
