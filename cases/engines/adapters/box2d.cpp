// Box2D 2.4, in binary32. Contacts are found by the engine, between a disc on one body and a box on the other that meet
// in the contact's point and nothing else; default sweeps are 8 of velocities, 3 of positions.
#include <box2d/box2d.h>

#include "adapter.hpp"

using namespace engines;

namespace {

b2Vec2 vec(const Vector& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1])};
}

class Scene {
 public:
  explicit Scene(const Question& q) : q_(q), world_(vec(q.gravity)) {
    world_.SetAllowSleeping(false);
    for (const Body& body : q.bodies) bodies_.push_back(add(body, body.is_prescribed()));
    for (const Contact& contact : q.contacts) add(contact);
    for (std::size_t i = 0; i < q.bodies.size(); ++i) load(q.bodies[i], bodies_[i]);
    for (const Joint& joint : q.joints) add(joint);
    for (const Friction& brake : q.friction) add(brake);
  }

  Answer step() {
    Answer answer;
    const int sweeps = q_.iterations > 0 ? q_.iterations : 8, positions = 3;
    answer.settings = {{"velocityIterations", sweeps}, {"positionIterations", positions}};
    world_.Step(static_cast<float>(q_.step), sweeps, positions);
    for (const b2Body* body : bodies_) {
      answer.velocity.push_back({body->GetLinearVelocity().x, body->GetLinearVelocity().y, body->GetAngularVelocity()});
    }
    for (const Contact& contact : q_.contacts) answer.push(contact, 0, 0);
    for (b2Contact* c = world_.GetContactList(); c; c = c->GetNext()) tell(*c, answer);
    return answer;
  }

 private:
  b2Body* add(const Body& body, bool prescribed) {
    b2BodyDef def;
    def.type = prescribed ? b2_kinematicBody : b2_dynamicBody;
    def.position = vec(body.at);
    def.linearVelocity = vec(body.is_free ? body.velocity : body.velocity_after(q_.step));
    def.angularVelocity = static_cast<float>(body.turns ? body.spin : body.spin_after(q_.step));
    def.fixedRotation = !body.turns;
    return world_.CreateBody(&def);
  }

  /// Masses come last: fixtures without density would reset them.
  void load(const Body& body, b2Body* made) {
    if (body.is_prescribed()) return;
    const b2MassData mass{static_cast<float>(body.is_free ? body.mass : 1), {0, 0}, static_cast<float>(body.inertia)};
    made->SetMassData(&mass);
    made->ApplyForceToCenter(vec(body.force), true);
    made->ApplyTorque(static_cast<float>(body.torque), true);
    if (body.is_free) return;
    b2RevoluteJointDef def;
    b2Body* anchor = add(body, true);
    anchor->SetAngularVelocity(0);
    def.Initialize(anchor, made, vec(body.at));
    world_.CreateJoint(&def);
  }

  /// Box2D rounds polygons by a skin; the disc touches the skin, and overlaps it by a little to be found.
  void add(const Contact& contact) {
    const std::size_t number = static_cast<std::size_t>(&contact - q_.contacts.data());
    const double r = q_.disc(contact), down = q_.half(contact) + b2_polygonRadius;
    const Vector up = q_.arm(contact.of, contact.at), face = q_.arm(contact.on, contact.at), n = contact.normal;
    b2FixtureDef def;
    def.friction = static_cast<float>(contact.friction);
    def.restitution = static_cast<float>(contact.restitution);
    def.filter.maskBits = 0;
    def.filter.groupIndex = static_cast<int16>(number + 1);
    def.userData.pointer = number;
    b2CircleShape disc;
    disc.m_p = vec({up[0] + r * n[0], up[1] + r * n[1]});
    disc.m_radius = static_cast<float>(r + 1e-6 * q_.size);
    def.shape = &disc;
    bodies_[contact.of]->CreateFixture(&def);
    b2PolygonShape box;
    const float half = static_cast<float>(q_.half(contact));
    box.SetAsBox(half, half, vec({face[0] - down * n[0], face[1] - down * n[1]}),
                 static_cast<float>(std::atan2(-n[0], n[1])));
    def.shape = &box;
    bodies_[contact.on]->CreateFixture(&def);
  }

  template <class Def>
  void create(Def def) {
    def.collideConnected = true;
    world_.CreateJoint(&def);
  }

  void add(const Joint& joint) {
    b2Body *a = bodies_[joint.first], *b = bodies_[joint.second];
    if (joint.kind == "pin") {
      b2RevoluteJointDef def;
      def.Initialize(a, b, vec(joint.at));
      create(def);
    } else if (joint.kind == "slider") {
      b2PrismaticJointDef def;
      def.Initialize(a, b, vec(joint.at), vec(joint.axis));
      create(def);
    } else if (joint.kind == "weld") {
      b2WeldJointDef def;
      def.Initialize(a, b, vec(joint.at));
      create(def);
    } else if (joint.kind == "rod" || joint.kind == "rope") {
      b2DistanceJointDef def;
      def.Initialize(a, b, vec(joint.at), vec(joint.to));
      def.minLength = joint.kind == "rod" ? def.length : 0, def.maxLength = def.length;
      create(def);
    } else {
      throw Refused("Box2D has no " + joint.kind + " of this kind");
    }
  }

  void add(const Friction& brake) {
    b2FrictionJointDef def;
    def.Initialize(bodies_[brake.first], bodies_[brake.second], {0, 0});
    def.maxTorque = static_cast<float>(brake.limit);
    create(def);
  }

  void tell(b2Contact& c, Answer& answer) const {
    const b2Manifold& manifold = *c.GetManifold();
    if (manifold.pointCount != 1) throw std::logic_error("expected contacts of one point");
    const Contact& contact = q_.contacts[c.GetFixtureA()->GetUserData().pointer];
    const double along = dot({contact.normal[1], -contact.normal[0]}, contact.tangent) / q_.step;
    answer.push(contact, manifold.points[0].normalImpulse / q_.step, along * manifold.points[0].tangentImpulse);
  }

  const Question& q_;
  b2World world_;
  std::vector<b2Body*> bodies_;
};

}  // namespace

int main() {
  const std::string version = std::to_string(b2_version.major) + "." + std::to_string(b2_version.minor) + "." +
                              std::to_string(b2_version.revision);
  return run({"box2d", version, "cone, by sweeps; the first step from rest",
              [](const Question& q) { return Scene(q).step(); }});
}
