#include "contact/space/in_space.hpp"

#include <algorithm>

#include "base/input/toml.hpp"
#include "mechanics/bodies/bodies.hpp"
#include "mechanics/mechanism/algebra.hpp"
#include "mechanics/reading/write_mechanism.hpp"

namespace slipproof::test {

namespace {

class SpaceWriter {
 public:
  explicit SpaceWriter(const Mechanism& planar) : m_(planar), bodies_(*planar.bodies) {}

  std::string text() {
    const std::string written = to_toml(m_);
    text_ = written.substr(0, written.find("\n[unknowns]"));
    text_.insert(text_.find("name = "), "dimension = 3\ngravity = " + gravity() + "\n");
    for (std::size_t i = ground + 1; i < bodies_.bodies.size(); ++i) body(bodies_.bodies[i]);
    for (const BodyContact& contact : bodies_.contacts) this->contact(contact);
    for (const BodyJoint& joint : bodies_.joints) this->joint(joint);
    for (const BodyForce& force : bodies_.forces) {
      text_ += "\n[[force]]\non = \"" + bodies_.bodies[force.on].name + "\"\n";
      line("at", force.at), line("is", force.is);
      if (force.follows) text_ += "axes = \"body\"\n";
      if (force.back_on) text_ += "back_on = \"" + bodies_.bodies[*force.back_on].name + "\"\n";
    }
    for (const BodyTorque& torque : bodies_.torques) {
      text_ += "\n[[torque]]\non = \"" + bodies_.bodies[torque.on].name + "\"\n";
      turning("is", torque.is);
      if (torque.back_on) text_ += "back_on = \"" + bodies_.bodies[*torque.back_on].name + "\"\n";
    }
    return text_;
  }

 private:
  static std::string quoted(const PlacedExpression& placed) {
    return toml_string(placed ? to_string(placed.expression) : "0");
  }
  static std::string vector(const PlacedVector& v) { return "[" + quoted(v.x) + ", \"0\", " + quoted(v.y) + "]"; }
  void line(const std::string& key, const PlacedVector& v) {
    if (v) text_ += key + " = " + vector(v) + "\n";
  }
  void line(const std::string& key, const PlacedExpression& e) {
    if (e) text_ += key + " = " + quoted(e) + "\n";
  }
  void turning(const std::string& key, const PlacedVector& v) {
    if (v.z) text_ += key + " = [\"0\", " + toml_string(to_string(negative_of(v.z.expression))) + ", \"0\"]\n";
  }
  std::string gravity() const { return bodies_.gravity ? vector(bodies_.gravity) : "\"none\""; }

  void body(const Body& body) {
    text_ += "\n[[body]]\nname = \"" + body.name + "\"\n";
    line("mass", body.mass);
    if (const PlacedExpression& i = body.inertia.entries[2]) {
      text_ += "inertia = [" + quoted(i) + ", " + quoted(i) + ", " + quoted(i) + "]\n";
    }
    line("at", body.at);
    if (body.cosine) {
      text_ += "turn = { axis = [\"0\", \"-1\", \"0\"], angle = [" + quoted(body.cosine) + ", " + quoted(body.sine) +
               "] }\n";
    }
    line("velocity", body.velocity), line("acceleration", body.acceleration);
    turning("spin", body.spin), turning("turning", body.turning);
  }

  void contact(const BodyContact& c) {
    const MechanismContact& given = m_.contacts[c.contact];
    text_ += "\n[[contact]]\nname = \"" + given.name + "\"\nof = \"" + bodies_.bodies[c.of].name + "\"\non = \"" +
             bodies_.bodies[c.on].name + "\"\n";
    line("point", c.point), line("radius", c.radius), line("normal", c.normal), line("through", c.through);
    line("on_point", c.on_point), line("on_radius", c.on_radius);
    line("friction", given.kinetic_friction);
    if (given.bilateral) text_ += "bilateral = true\n";
    if (given.start == ElementKind::Start::open && c.state_given) text_ += "state = \"open\"\n";
  }

  void joint(const BodyJoint& j) {
    const bool pin = j.kind == BodyJoint::Kind::pin, gear = j.kind == BodyJoint::Kind::gear;
    text_ += "\n[[joint]]\nname = \"" + j.name + "\"\nkind = \"" + (pin ? "hinge" : std::string(name(j.kind))) +
             "\"\nbetween = [\"" + bodies_.bodies[j.first].name + "\", \"" + bodies_.bodies[j.second].name + "\"]\n";
    line("at", j.at), line("to", j.to), line("axis", j.axis), line("length", j.length), line("force", j.tension);
    line("ratio", j.ratio);
    if (pin || gear) text_ += "axis = [\"0\", \"-1\", \"0\"]\n";
    if (gear) text_ += "carrier = \"" + bodies_.bodies[j.carrier].name + "\"\n";
    if (j.contact && m_.contacts[*j.contact].start == ElementKind::Start::open && j.state_given) {
      text_ += "state = \"slack\"\n";
    }
  }

  const Mechanism& m_;
  const Bodies& bodies_;
  std::string text_;
};

}  // namespace

std::optional<std::string> in_space(const Mechanism& planar) {
  const bool two_coefficients = std::ranges::any_of(planar.contacts, [](const MechanismContact& c) {
    return c.static_friction && (c.bilateral || !same(c.static_friction.expression, c.kinetic_friction.expression));
  });
  const bool one_sided = std::ranges::any_of(planar.bodies->joints, [](const BodyJoint& joint) {
    return joint.kind == BodyJoint::Kind::gear && joint.contact.has_value();
  });
  if (!planar.friction.empty() || two_coefficients || one_sided) return std::nullopt;
  return SpaceWriter(planar).text();
}

}  // namespace slipproof::test
