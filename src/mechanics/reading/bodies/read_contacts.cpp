#include <array>

#include "mechanics/reading/bodies/body_parts.hpp"

namespace slipproof::mechanism_reader {

namespace {

using Role = MechanismUnknown::Role;

class BodyContactReader : public BodyParts {
 public:
  using BodyParts::BodyParts;

  void read_contacts(const TableReader& root) {
    default_restitution_ = one(root, "restitution");
    for (const TomlValue* contact : tables(root, "contact", max_scene_elements)) read_contact(*contact);
  }
  void read_frictions(const TableReader& root) {
    if (in_space() && root.has("friction")) {
      return root.refuse("friction",
                         "found a friction element with a limit of its own, which only mechanisms in the "
                         "plane have, expected friction at contacts");
    }
    for (const TomlValue* friction : tables(root, "friction", max_elements)) read_friction(*friction);
    for (BodyContact& contact : bodies_.contacts) add_rolling(contact);
  }

 private:
  void read_contact(const TomlValue& value) {
    std::vector<std::string_view> keys{
        "name",     "of",        "point",     "radius",     "on",    "normal", "through",     "friction",
        "on_point", "on_radius", "bilateral", "lift_needs", "state", "names",  "restitution", "tangential_restitution"};
    if (in_space()) {
      keys.emplace_back("tangent");
    } else {
      keys.insert(keys.end(), {"slip_direction", "rolling_resistance"});
    }
    static constexpr std::array<std::string_view, 5> names_in_plane{"N", "S", "gap", "slip", "rolling"};
    static constexpr std::array<std::string_view, 6> names_in_space{"N", "T1", "T2", "gap", "slip", "slip2"};
    const bool by_equations = value.find("gap") != nullptr || value.find("slip") != nullptr;
    const TableReader table(value, by_equations ? "[[contact]] of a file with [[body]]" : "[[contact]]", keys,
                            context_.mistakes);
    MechanismContact contact;
    contact.place = value.place;
    contact.name = name_of(table);
    read_coefficients(table, contact);
    read_contact_states(table, contact);
    BodyContact touch;
    touch.place = value.place;
    touch.contact = mechanism_.contacts.size();
    touch.state_given = table.has("state");
    read_touch(table, touch);
    const std::span<const std::string_view> name_keys = in_space() ? std::span<const std::string_view>(names_in_space)
                                                                   : std::span<const std::string_view>(names_in_plane);
    const TableReader names = names_of(table, name_keys);
    name_forces(names, contact, touch.contact);
    if (!in_space()) touch.rolling_force = context_.text(names, "rolling");
    touch.well_named = named_well_;
    mechanism_.contacts.push_back(std::move(contact));
    bodies_.contacts.push_back(std::move(touch));
  }

  void check_pair(const TableReader& table, const BodyContact& touch) {
    if (!context_.sound) return;  // one of them may be another body
    const Body &of = bodies_.bodies[touch.of], &on = bodies_.bodies[touch.on];
    if (touch.of == touch.on) {
      table.refuse("of", "found the body " + in_quotes(of.name) + " in contact with itself, expected two bodies");
    } else if (of.is_prescribed() && on.is_prescribed()) {
      table.refuse("of", "found a contact of two bodies without a mass, expected one that moves");
    }
  }

  void read_touch(const TableReader& table, BodyContact& touch) {
    touch.of = body_of(table, "of");
    if (table.has("on")) touch.on = body_of(table, "on");
    check_pair(table, touch);
    table.require("point", "the point that touches, or the centre of the disc");
    touch.point = vector(table, "point");
    touch.radius = one(table, "radius");
    touch.normal = vector(table, "normal");
    touch.through = vector(table, "through");
    touch.on_point = vector(table, "on_point");
    touch.on_radius = one(table, "on_radius");
    read_restitution(table, touch);
    if (in_space()) {
      touch.tangent = vector(table, "tangent");
    } else {
      touch.slip_direction = vector(table, "slip_direction");
      touch.rolling_resistance = one(table, "rolling_resistance");
    }
    if (table.has("on_radius")) {
      table.require("on_point", "the centre of the disc that is touched");
      for (const std::string_view key : {"normal", "through"}) {
        if (table.has(key)) table.refuse(key, "found together with a disc, from which it follows, expected none");
      }
    } else {
      table.require("normal", "the normal of the line that is touched, out of its body, such as [\"0\", \"1\"]");
      if (table.has("on_point")) table.require("on_radius", "the radius of the disc that is touched");
      touch.on_radius = {};
    }
    if (in_space() || !table.has("rolling_resistance")) return;
    if (!table.has("radius")) {
      table.refuse("rolling_resistance", "found it at a point, expected a disc: missing radius");
    }
    if (context_.sound && !turns({touch.of, touch.on})) {
      table.refuse("rolling_resistance",
                   "found it between bodies whose turning is prescribed" + std::string(expected_turning));
    }
  }

  void read_restitution(const TableReader& table, BodyContact& touch) {
    touch.restitution = one(table, "restitution");
    touch.tangential_restitution = one(table, "tangential_restitution");
    if (!table.boolean("bilateral").value_or(false)) {
      if (!touch.restitution) touch.restitution = default_restitution_;
    } else if (table.has("restitution")) {
      table.refuse("restitution", "found it at a guide, which no impact opens, expected none");
    }
    if (table.has("tangential_restitution") && !table.has("friction")) {
      table.refuse("tangential_restitution", "found it at a contact without friction, expected none");
    }
  }

  void add_rolling(BodyContact& touch) {
    if (!touch.rolling_resistance) return;
    const MechanismContact& contact = mechanism_.contacts[touch.contact];
    MechanismFriction rolling;
    rolling.place = touch.rolling_resistance.place();
    rolling.name = contact.name + "_rolling";
    rolling.contact = touch.contact;
    const std::string force = touch.rolling_force.empty() ? "S_" + rolling.name : touch.rolling_force;
    rolling.slip_name = "slip_" + rolling.name;
    if (touch.well_named) {
      context_.declare_element(rolling.name, rolling.place);
      context_.declare(force, rolling.place);
      context_.declare(rolling.slip_name, rolling.place);
    }
    mechanism_.unknowns.push_back({force, Role::friction, mechanism_.friction.size(), {}, rolling.place});
    rolling.force = mechanism_.unknowns.size() - 1;
    touch.rolling = mechanism_.friction.size();
    mechanism_.friction.push_back(std::move(rolling));
  }

  void read_friction(const TomlValue& value) {
    static constexpr std::array<std::string_view, 5> keys{"name", "between", "limit", "force", "state"};
    const TableReader table(value, "[[friction]]", keys, context_.mistakes);
    MechanismFriction friction;
    friction.place = value.place;
    friction.name = name_of(table);
    if (table.require("limit", "the largest couple that it bears")) {
      read_two(*table.value("limit"), "limit", friction.static_limit, friction.kinetic_limit);
    }
    friction.force = unknown(table, "force", "S_" + friction.name, Role::friction, mechanism_.friction.size());
    friction.slip_name = "slip_" + friction.name;
    if (named_well_) context_.declare(friction.slip_name, table.place("name"));
    read_state(table, friction.start, {.law = ElementKind::Law::limited});
    const auto [first, second] = read_between(table);
    if (context_.sound && !turns({first, second})) {
      table.refuse("between",
                   "found friction between bodies whose turning is prescribed" + std::string(expected_turning));
    }
    bodies_.friction.push_back({mechanism_.friction.size(), first, second, table.has("state"), value.place});
    mechanism_.friction.push_back(std::move(friction));
  }

  PlacedExpression default_restitution_;  ///< of contacts that give none
};

}  // namespace

void read_body_contacts(const TableReader& root, Context& context, Bodies& bodies) {
  BodyContactReader(context, bodies).read_contacts(root);
}

void read_body_friction(const TableReader& root, Context& context, Bodies& bodies) {
  BodyContactReader(context, bodies).read_frictions(root);
}

}  // namespace slipproof::mechanism_reader
