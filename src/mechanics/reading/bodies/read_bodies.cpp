#include <array>
#include <span>

#include "mechanics/reading/bodies/body_parts.hpp"

namespace slipproof::mechanism_reader {

namespace {

/// Forces, gravity, and the scene as a whole.
class BodySceneReader : public BodyParts {
 public:
  using BodyParts::BodyParts;

  void read_gravity(const TableReader& root) {
    const TomlValue* value = root.value("gravity");
    if (value == nullptr) {
      root.require("gravity", in_space() ? "a vector such as [\"0\", \"0\", \"-g\"], or \"none\""
                                         : "a vector such as [\"0\", \"-g\"], or \"none\" (a table seen from above)");
      context_.sound = false;
    } else if (value->kind == TomlValue::Kind::string && value->text.text() == "none") {
      return;
    } else if (value->kind != TomlValue::Kind::array) {
      root.refuse("gravity",
                  "found " +
                      std::string(value->kind == TomlValue::Kind::string ? in_quotes(value->text.text())
                                                                         : std::string(kind_name(value->kind))) +
                      (in_space() ? ", expected a vector such as [\"0\", \"0\", \"-g\"], or \"none\""
                                  : ", expected a vector such as [\"0\", \"-g\"], or \"none\""));
    } else {
      bodies_.gravity = vector(*value, "gravity");
    }
  }

  void read_forces(const TableReader& root) {
    for (const TomlValue* force : tables(root, "force", max_scene_elements)) read_force(*force);
    for (const TomlValue* torque : tables(root, "torque", max_scene_elements)) read_torque(*torque);
  }

  /// A body that nothing touches or joins falls out of the picture.
  void check_held() {
    if (!context_.sound || !context_.bodies_named_well) return;  // what holds it may be where a mistake is
    std::vector<bool> held(bodies_.bodies.size());
    for (const BodyContact& contact : bodies_.contacts) held[contact.of] = held[contact.on] = true;
    for (const BodyJoint& joint : bodies_.joints) held[joint.first] = held[joint.second] = true;
    for (const BodyFriction& friction : bodies_.friction) held[friction.first] = held[friction.second] = true;
    for (std::size_t i = 1; i < held.size(); ++i) {
      const Body& body = bodies_.bodies[i];
      if (held[i]) continue;
      const std::string what = body.is_prescribed() ? "nothing touches it and no joint has it"
                                                    : "nothing holds it: it is in no contact and in no joint";
      context_.mistakes.add(body.place,
                            "body " + body.name + ": " + what + ", expected it to have a part in the scene");
    }
  }

  /// Units may all be left out; if one stands, all must.
  void check_units(const TableReader& root) {
    std::vector<const MechanismParameter*> without;
    bool any = mechanism_.load && !mechanism_.load->unit.empty();
    for (const MechanismParameter& parameter : mechanism_.parameters) {
      any = any || !parameter.unit.empty();
      if (parameter.unit.empty()) without.push_back(&parameter);
    }
    if (!any) return;
    for (const MechanismParameter* parameter : without) {
      context_.mistakes.add(
          parameter->place,
          parameter->symbol +
              ": missing a unit, which others have, expected one, or none at all (\"1\" for a plain number)");
    }
    if (mechanism_.load && mechanism_.load->unit.empty()) {
      root.refuse("load",
                  "missing a unit, which parameters have, expected one, or none at all (\"1\" for a plain number)");
    }
    for (std::size_t i = 0, body = 1; body < bodies_.bodies.size(); ++body) {
      const auto& unknowns = bodies_.bodies[body].unknowns;
      for (std::size_t k = 0; k < unknowns.size(); ++k) {
        if (!unknowns[k].symbol.empty()) mechanism_.unknowns[i++].unit = k < 3 ? "m/s^2" : "s^-2";
      }
    }
  }

  void refuse_equations(const TableReader& root) {
    for (const std::string_view key : {"unknowns", "motion", "equations", "units", "energy", "link"}) {
      if (root.has(key)) {
        root.refuse(key, "found together with [[body]], from which it follows, expected one of them");
      }
    }
  }

 private:
  void read_force(const TomlValue& value) {
    static constexpr std::array<std::string_view, 5> keys{"on", "at", "is", "axes", "back_on"};
    const TableReader table(value, "[[force]]", keys, context_.mistakes);
    BodyForce force;
    force.place = value.place;
    force.on = body_of(table, "on");
    force.at = vector(table, "at");
    table.require("is",
                  in_space() ? "the force, such as [\"0\", \"0\", \"-W\"]" : "the force, such as [\"0\", \"-W\"]");
    force.is = vector(table, "is");
    force.follows = read_follows(table);
    if (table.has("back_on")) force.back_on = body_of(table, "back_on");
    check_pushed(table, force.on, force.back_on);
    bodies_.forces.push_back(std::move(force));
  }

  /// Whether `axes` says that a force or couple turns with the body.
  static bool read_follows(const TableReader& table) {
    const PlacedText* axes = table.string("axes");
    if (axes == nullptr || axes->text() == "scene") return false;
    if (axes->text() == "body") return true;
    table.refuse("axes", "found " + in_quotes(axes->text()) + ", expected \"scene\" or \"body\"");
    return false;
  }

  void read_torque(const TomlValue& value) {
    static constexpr std::array<std::string_view, 4> all{"on", "is", "back_on", "axes"};
    const std::span<const std::string_view> keys(all.data(), in_space() ? 4 : 3);
    const TableReader table(value, "[[torque]]", keys, context_.mistakes);
    BodyTorque torque;
    torque.place = value.place;
    torque.on = body_of(table, "on");
    table.require("is", in_space() ? "the couple, such as [\"0\", \"0\", \"T\"]" : "the couple, counterclockwise");
    torque.is = turning(table, "is");
    if (in_space()) torque.follows = read_follows(table);
    if (table.has("back_on")) torque.back_on = body_of(table, "back_on");
    check_pushed(table, torque.on, torque.back_on);
    bodies_.torques.push_back(std::move(torque));
  }

  void check_pushed(const TableReader& table, std::size_t on, const std::optional<std::size_t>& back_on) {
    if (!context_.sound) return;  // it may be another body
    const Body& body = bodies_.bodies[on];
    if (body.is_prescribed() && !(back_on && !bodies_.bodies[*back_on].is_prescribed())) {
      table.refuse("on", "found " + in_quotes(body.name) + ", which nothing can push, expected a body with a mass");
    }
    if (back_on && *back_on == on) table.refuse("back_on", "found the body that is pushed, expected another");
  }
};

}  // namespace

Bodies read_bodies(const TableReader& root, Context& context) {
  Bodies bodies;
  BodySceneReader scene(context, bodies);
  scene.refuse_equations(root);
  read_body_list(root, context, bodies);
  scene.read_gravity(root);
  read_body_contacts(root, context, bodies);
  read_joints(root, context, bodies);
  read_body_friction(root, context, bodies);
  add_joint_links(context, bodies);
  read_state(root, context, bodies);
  scene.read_forces(root);
  scene.check_held();
  scene.check_units(root);
  return bodies;
}

}  // namespace slipproof::mechanism_reader
