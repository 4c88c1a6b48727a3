#include <algorithm>
#include <array>
#include <span>
#include <tuple>

#include "mechanics/reading/bodies/body_parts.hpp"

namespace slipproof::mechanism_reader {

namespace {

using Role = MechanismUnknown::Role;

class JointReader : public BodyParts {
 public:
  using BodyParts::BodyParts;

  void read(const TableReader& root) {
    for (const TomlValue* joint : tables(root, "joint", max_scene_elements)) read_joint(*joint);
  }

  void add_links(BodyJoint& joint) {
    using Kind = BodyJoint::Kind;
    const Kind kind = joint.kind;
    const auto add = [&](std::string_view key, const std::string& suffix) {
      MechanismLink link;
      link.place = joint.place;
      link.name = joint.name + suffix;
      const auto given = joint.force_names.find(key);
      const std::string symbol = given == joint.force_names.end() ? "R_" + link.name : given->second;
      if (joint.well_named) {
        if (!suffix.empty()) context_.declare_element(link.name, joint.place);
        context_.declare(symbol, joint.place);
      }
      mechanism_.unknowns.push_back({symbol, Role::link, mechanism_.links.size(), {}, joint.place});
      link.force = mechanism_.unknowns.size() - 1;
      joint.links.push_back(mechanism_.links.size());
      mechanism_.links.push_back(std::move(link));
    };
    const auto several = [&](const std::string& key, std::size_t count) {
      for (std::size_t i = 1; i <= count; ++i) add(key + std::to_string(i), "_" + key + std::to_string(i));
    };
    const bool slides = kind == Kind::slider || kind == Kind::cylindrical, rigid = kind == Kind::weld;
    if (kind == Kind::pin || rigid || kind == Kind::ball || kind == Kind::hinge || kind == Kind::universal) {
      add("x", "_x"), add("y", "_y");
      if (in_space()) add("z", "_z");
    }
    if (slides && !in_space()) add("across", "_across");
    if (slides && in_space()) several("across", 2);
    // nothing is linked where neither turns by itself
    if (turns({joint.first, joint.second})) {
      if ((rigid || kind == Kind::slider) && !in_space()) add("turn", "_turn");
      if ((rigid || kind == Kind::slider) && in_space()) several("turn", 3);
      if (kind == Kind::hinge || kind == Kind::cylindrical) several("turn", 2);
      if (kind == Kind::universal) several("turn", 1);
    }
    if (kind == Kind::rod || (kind == Kind::gear && !joint.contact)) add("force", "");
  }

 private:
  void read_joint(const TomlValue& value) {
    static constexpr std::array<std::string_view, 20> all{
        "name",      "kind",  "between", "at",       "to",     "axis", "length",   "force",   "ratio",  "carrier",
        "one_sided", "state", "names",   "friction", "radius", "ring", "armature", "to_axis", "normal", "width"};
    const std::span<const std::string_view> keys(all.data(), in_space() ? 20 : 17);
    const TableReader table(value, "[[joint]]", keys, context_.mistakes);
    BodyJoint joint;
    joint.place = value.place;
    joint.name = name_of(table);
    const bool known = read_kind(table, joint);
    std::tie(joint.first, joint.second) = read_between(table);
    joint.at = vector(table, "at");
    joint.to = vector(table, "to");
    joint.axis = vector(table, "axis");
    joint.to_axis = in_space() ? vector(table, "to_axis") : PlacedVector{};
    joint.length = one(table, "length");
    joint.tension = one(table, "force");
    joint.ratio = one(table, "ratio");
    joint.armature = one(table, "armature");
    if (table.has("carrier")) joint.carrier = body_of(table, "carrier");
    joint.radius = one(table, "radius");
    joint.ring = one(table, "ring");
    if (in_space()) joint.normal = vector(table, "normal");
    joint.width = in_space() ? one(table, "width") : PlacedExpression{};
    joint.state_given = table.has("state");
    if (known) check_keys(table, joint);
    if (context_.sound) check_free(table, joint);
    if (known && table.has("friction")) return add_guides(table, std::move(joint), named_well_, context_, bodies_);
    static constexpr std::array<std::string_view, 5> in_plane{"x", "y", "turn", "across", "force"};
    static constexpr std::array<std::string_view, 9> spatial{"x",     "y",     "z",     "across1", "across2",
                                                             "turn1", "turn2", "turn3", "force"};
    const std::span<const std::string_view> name_keys =
        in_space() ? std::span<const std::string_view>(spatial) : std::span<const std::string_view>(in_plane);
    const TableReader names = names_of(table, name_keys);
    joint.well_named = named_well_;
    for (const std::string_view key : name_keys) {
      const std::string given = table.has("names") ? context_.text(names, key) : std::string();
      if (!given.empty()) joint.force_names.emplace(key, given);
    }
    if (joint.kind == BodyJoint::Kind::rope ||
        (joint.kind == BodyJoint::Kind::gear && table.boolean("one_sided").value_or(false))) {
      const auto force = joint.force_names.find("force");
      add_one_sided(table, joint, force == joint.force_names.end() ? std::string() : force->second);
    }
    bodies_.joints.push_back(std::move(joint));
  }

  /// Where all that a joint holds is prescribed, it holds nothing.
  void check_free(const TableReader& table, const BodyJoint& joint) {
    if (joint.kind == BodyJoint::Kind::gear) {
      if (turns({joint.first, joint.second, joint.carrier})) return;
      return table.refuse("between",
                          "found a gear of bodies whose turning is prescribed" + std::string(expected_turning));
    }
    if (!bodies_.bodies[joint.first].is_prescribed() || !bodies_.bodies[joint.second].is_prescribed()) return;
    table.refuse("between", "found a joint of two bodies without a mass, expected one that moves");
  }

  bool read_kind(const TableReader& table, BodyJoint& joint) {
    const std::string found =
        context_.required(table, "kind",
                          in_space() ? "ball, hinge, slider, cylindrical, universal, weld, rod, rope, spring or gear"
                                     : "pin, slider, weld, rod, rope, spring or gear");
    const auto kinds = joint_kinds_of(mechanism_.dimension);
    const auto word = std::ranges::find(joint_kinds, found);
    if (word == joint_kinds.end() || std::ranges::find(kinds, found) == kinds.end()) {
      if (!found.empty()) table.refuse("kind", unknown_name("kind of joint", found, {kinds.begin(), kinds.end()}));
      context_.sound = false;
      return false;
    }
    joint.kind = static_cast<BodyJoint::Kind>(word - joint_kinds.begin());
    return true;
  }

  /// What a kind needs, and what it has no use for.
  void check_keys(const TableReader& table, const BodyJoint& joint) {
    using Kind = BodyJoint::Kind;
    const Kind kind = joint.kind;
    const bool span = kind == Kind::rod || kind == Kind::rope || kind == Kind::spring;
    const bool rubs = table.has("friction"), turning = turns({joint.first, joint.second});
    const bool guided = rubs && kind == Kind::slider, round = kind == Kind::pin || kind == Kind::hinge;
    const bool in_ring = rubs && round, in_two_rings = rubs && kind == Kind::hinge;
    const std::string word = table.string("kind")->text();
    const auto rule = [&](std::string_view key, bool allowed, bool needed, std::string_view expected) {
      if (needed) context_.sound = table.require(key, expected) && context_.sound;
      if (!allowed && table.has(key)) table.refuse(key, "a " + word + " has none");
    };
    rule("at", kind != Kind::gear, kind != Kind::gear, "the point of the first body");
    rule("to", kind != Kind::gear, span || in_ring, "the point of the second body");
    const bool slides = kind == Kind::slider || kind == Kind::cylindrical;
    const bool gear_in_space = kind == Kind::gear && in_space();
    rule("axis", slides || kind == Kind::hinge || kind == Kind::universal || gear_in_space,
         slides || kind == Kind::hinge || kind == Kind::universal || gear_in_space,
         !in_space() ? "the direction in which it slides, such as [\"1\", \"0\"]"
         : slides    ? "the direction in which it slides, such as [\"1\", \"0\", \"0\"]"
                     : "the axis about which it turns, such as [\"0\", \"1\", \"0\"]");
    if (in_space()) {
      rule("to_axis", kind == Kind::universal || gear_in_space, kind == Kind::universal,
           "the other axis, in the axes of the second body");
    }
    rule("friction", kind == Kind::slider || round, false, "");
    rule("length", span || guided || in_two_rings, span || (guided && turning) || in_two_rings,
         guided         ? "the distance of its two guides"
         : in_two_rings ? "the distance of its two rings along the axis"
                        : "the length between its ends");
    if (in_space()) {
      rule("normal", guided, guided, "the normal of the rail, out of the first body, across the axis");
      rule("width", guided, guided && turning, "the distance of the feet on both sides of the rail");
    }
    rule("force", kind == Kind::spring, kind == Kind::spring, "the tension of the spring now, such as \"k*x\"");
    rule("ratio", kind == Kind::gear, kind == Kind::gear, "the second body's turning over the first's");
    rule("armature", kind == Kind::pin || kind == Kind::hinge || kind == Kind::slider || kind == Kind::ball, false, "");
    rule("carrier", kind == Kind::gear, false, "");
    rule("one_sided", kind == Kind::gear, false, "");
    const bool one_sided = kind == Kind::rope || (kind == Kind::gear && table.boolean("one_sided").value_or(false));
    rule("state", one_sided || rubs, false, "");
    check_friction_keys(table, joint);
  }

  /// What a joint with friction needs, and what one without has no use for.
  void check_friction_keys(const TableReader& table, const BodyJoint& joint) {
    const bool rubs = table.has("friction");
    const bool pin = joint.kind == BodyJoint::Kind::pin || joint.kind == BodyJoint::Kind::hinge;
    if (rubs && table.has("names")) {
      table.refuse("names", "found them at a joint with friction, whose forces are those of contacts, expected none");
    }
    for (const std::string_view key : {"radius", "ring"}) {
      if (!table.has(key) || (rubs && pin)) continue;
      table.refuse(
          key, pin ? "found it at a " + table.string("kind")->text() + " without friction, expected friction as well"
                   : "a " + table.string("kind")->text() + " has none");
    }
    if (!rubs || !pin) return;
    const bool whole =
        table.require("radius", in_space() ? "the radius of the shaft, about `to` on the second body"
                                           : "the radius of the pin, a disc about `to` on the second body") &&
        table.require("ring", in_space()
                                  ? "the radius of the rings about `at` on the first body, larger than the shaft's"
                                  : "the radius of the ring about `at` on the first body, larger than the pin's");
    context_.sound = context_.sound && whole;
  }

  /// A rope or a freewheel: a frictionless contact that is closed while it is taut or drives.
  void add_one_sided(const TableReader& table, BodyJoint& joint, const std::string& force) {
    MechanismContact contact;
    contact.place = joint.place;
    contact.name = joint.name;
    const std::string symbol = force.empty() ? (joint.kind == BodyJoint::Kind::rope ? "T_" : "N_") + joint.name : force;
    contact.gap_name = "gap_" + joint.name;
    if (named_well_) {
      context_.declare(symbol, table.place("name"));
      context_.declare(contact.gap_name, table.place("name"));
    }
    joint.contact = mechanism_.contacts.size();
    mechanism_.unknowns.push_back({symbol, Role::normal, *joint.contact, {}, table.place("name")});
    contact.normal = mechanism_.unknowns.size() - 1;
    if (const PlacedText* state = table.string("state")) {
      const std::string slack = joint.kind == BodyJoint::Kind::rope ? "slack" : "open";
      if (state->text() == slack) {
        contact.start = ElementKind::Start::open;
      } else {
        table.refuse("state", "found " + in_quotes(state->text()) + ", expected \"" + slack + "\"");
      }
    }
    mechanism_.contacts.push_back(std::move(contact));
  }
};

}  // namespace

void read_joints(const TableReader& root, Context& context, Bodies& bodies) {
  JointReader(context, bodies).read(root);
}

void add_joint_links(Context& context, Bodies& bodies) {
  for (BodyJoint& joint : bodies.joints) JointReader(context, bodies).add_links(joint);
}

}  // namespace slipproof::mechanism_reader
