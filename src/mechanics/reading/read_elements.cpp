#include <algorithm>
#include <array>

#include "mechanics/reading/element_parts.hpp"

namespace slipproof::mechanism_reader {

namespace {

using Role = MechanismUnknown::Role;

class ElementReader : public ElementParts {
 public:
  using ElementParts::ElementParts;

  void read(const TableReader& root) {
    for (const TomlValue* contact : tables(root, "contact", max_elements)) read_contact(*contact);
    for (const TomlValue* friction : tables(root, "friction", max_elements)) read_friction(*friction);
    for (const TomlValue* link : tables(root, "link", max_elements)) read_link(*link);
    read_shapes(root);
  }
  void read_shapes(const TableReader& root) {
    for (const TomlValue* shape : tables(root, "shape", max_shapes)) read_shape(*shape);
  }

 private:
  void read_contact(const TomlValue& value) {
    static constexpr std::array<std::string_view, 14> keys{
        "name",      "gap",        "slip",     "friction",  "normal", "tangent",   "state",
        "bilateral", "lift_needs", "gap_name", "slip_name", "at",     "direction", "slip_direction"};
    const bool drawn = value.find("of") != nullptr || value.find("point") != nullptr;
    const TableReader table(value, drawn ? "[[contact]] of a file without [[body]]" : "[[contact]]", keys,
                            context_.mistakes);
    MechanismContact contact;
    contact.place = value.place;
    contact.name = name_of(table);
    table.require("gap", "the acceleration with which the contact opens");
    contact.gap = context_.expression(table, "gap", Sort::number);
    read_coefficients(table, contact);
    if (!contact.frictionless()) table.require("slip", "the tangential acceleration of the contact");
    contact.slip = context_.expression(table, "slip", Sort::number);
    read_contact_states(table, contact);
    const std::size_t owner = mechanism_.contacts.size();
    contact.normal = unknown(table, "normal", "N_" + contact.name, Role::normal, owner);
    if (!contact.frictionless()) {
      contact.tangent = unknown(table, "tangent", "S_" + contact.name, Role::tangent, owner);
    } else if (table.has("tangent")) {
      table.refuse("tangent", "found the name of a force that a frictionless contact does not have");
    }
    contact.gap_name = named(table, "gap_name", "gap_" + contact.name);
    if (table.has("slip")) contact.slip_name = named(table, "slip_name", "slip_" + contact.name);
    contact.at = coordinates(table, "at");
    contact.direction = coordinates(table, "direction");
    contact.slip_direction = coordinates(table, "slip_direction");
    mechanism_.contacts.push_back(std::move(contact));
  }

  void read_friction(const TomlValue& value) {
    static constexpr std::array<std::string_view, 6> keys{"name", "slip", "limit", "force", "state", "contact"};
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
    read_its_contact(table, friction);
    mechanism_.friction.push_back(std::move(friction));
  }

  void read_its_contact(const TableReader& table, MechanismFriction& friction) {
    const std::string name = context_.text(table, "contact");
    if (name.empty()) return;
    std::vector<std::string_view> known;
    for (const MechanismContact& contact : mechanism_.contacts) known.push_back(contact.name);
    const auto found = std::ranges::find(known, name);
    if (found == known.end()) return table.refuse("contact", unknown_name("contact", name, known));
    friction.contact = static_cast<std::size_t>(found - known.begin());
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

  void read_shape(const TomlValue& value) {
    static constexpr std::array<std::string_view, 8> keys{"kind",  "points",       "radius", "text",
                                                          "force", "acceleration", "still",  "thin"};
    const TableReader table(value, "[[shape]]", keys, context_.mistakes);
    MechanismShape shape;
    shape.place = value.place;
    const bool known = read_kind(table, shape);
    table.require("points", "an array of points such as [[\"b\", \"-h\"]]");
    const TomlValue* points = table.value("points");
    if (points != nullptr && points->kind == TomlValue::Kind::array) {
      for (const TomlValue& point : points->items) shape.points.push_back(coordinates(point, "points"));
    } else if (points != nullptr) {
      table.refuse("points", "found " + std::string(kind_name(points->kind)) + ", expected an array of points");
    }
    shape.radius = context_.expression(table, "radius", Sort::number);
    shape.text = context_.text(table, "text");
    shape.force = context_.expression(table, "force", Sort::number);
    shape.acceleration = context_.text(table, "acceleration");
    shape.still = table.boolean("still").value_or(false);
    shape.thin = table.boolean("thin").value_or(false);
    if (known && points != nullptr) check_shape(table, shape);
    mechanism_.shapes.push_back(std::move(shape));
  }

  bool read_kind(const TableReader& table, MechanismShape& shape) {
    using Kind = MechanismShape::Kind;
    const std::string found =
        context_.required(table, "kind", "polygon, line, circle, point, arrow, label, measure or turn");
    std::vector<std::string_view> words;
    for (const Kind kind :
         {Kind::polygon, Kind::line, Kind::circle, Kind::point, Kind::arrow, Kind::label, Kind::measure, Kind::turn}) {
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
    const bool many = shape.kind == Kind::polygon || shape.kind == Kind::line, measure = shape.kind == Kind::measure;
    const bool two = shape.kind == Kind::line || shape.kind == Kind::arrow || measure;
    const std::size_t needed = shape.kind == Kind::polygon ? 3 : two ? 2 : 1;
    const std::size_t count = shape.points.size();
    if (count < needed || (!many && count > needed && !(measure && count == 4))) {
      table.refuse("points", "found " + std::to_string(count) + " for a " + std::string(name(shape.kind)) +
                                 ", expected " + std::to_string(needed) +
                                 (many      ? " or more"
                                  : measure ? ", or 4 with those measured"
                                            : ""));
    }
    const auto belongs = [&](std::string_view key, std::initializer_list<Kind> kinds, std::string_view what) {
      const bool has = std::ranges::find(kinds, shape.kind) != kinds.end();
      if (has && !what.empty()) table.require(key, what);
      if (!has && table.has(key)) table.refuse(key, "a " + std::string(name(shape.kind)) + " has none");
    };
    belongs("radius", {Kind::circle, Kind::turn}, "the radius");
    if (shape.kind != Kind::arrow) belongs("text", {Kind::label, Kind::measure, Kind::turn}, "the text beside it");
    belongs("force", {Kind::arrow}, "");
    belongs("acceleration", {Kind::arrow}, "");
  }
};

}  // namespace

void read_elements(const TableReader& root, Context& context) {
  ElementReader(context).read(root);
}

void read_shapes(const TableReader& root, Context& context) {
  ElementReader(context).read_shapes(root);
}

}  // namespace slipproof::mechanism_reader
