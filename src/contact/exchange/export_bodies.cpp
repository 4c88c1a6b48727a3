#include "contact/exchange/export_bodies.hpp"

#include <cmath>
#include <utility>

#include "base/number/binary64.hpp"
#include "base/output/json.hpp"
#include "mechanics/bodies/frame.hpp"
#include "mechanics/points/problem.hpp"

namespace slipproof {

namespace bodies_in_motion {

namespace {

class BodiesExporter {
 public:
  explicit BodiesExporter(const MechanismScene& scene)
      : scene_(scene),
        m_(scene.mechanism),
        bodies_(*m_.bodies),
        frames_(frames(bodies_)),
        maker_(m_),
        at_(maker_.at(scene.values)),
        problem_(maker_.problem(scene.values)) {
    if (scene.load) at_.set(maker_.compiled().load(), *scene.load);
  }

  std::string line() {
    Json document{{"schema", "slipproof/bodies/1"}, {"name", scene_.name.empty() ? m_.name : scene_.name}};
    document["gravity"] = pair(unplaced(bodies_.gravity), bodies_.gravity.place);
    document["bodies"] = Json::array();
    for (std::size_t i = ground + 1; i < bodies_.bodies.size(); ++i)
      document["bodies"].push_back(body(bodies_.bodies[i]));
    document["contacts"] = list(bodies_.contacts, &BodiesExporter::contact);
    document["joints"] = list(bodies_.joints, &BodiesExporter::joint);
    document["friction"] = list(bodies_.friction, &BodiesExporter::friction);
    put_pushes(document);
    return json_text(document);
  }

 private:
  template <class Item>
  Json list(const std::vector<Item>& items, Json (BodiesExporter::*one)(const Item&)) {
    Json result = Json::array();
    for (const Item& item : items) result.push_back((this->*one)(item));
    return result;
  }

  [[noreturn]] void refuse(Place place, const std::string& message) const {
    throw InputError({{m_.file, place.line, place.column, message}});
  }

  Json binary64(const Rational& value, Place place) const {
    const double nearest = nearest_binary64(value);
    if (!std::isfinite(nearest)) refuse(place, "found a number beyond binary64, which no engine can read");
    return nearest + 0.0;  // no -0
  }
  Json number(const Expression& expression, Place place) {
    const auto value = at_.number(maker_.compiled().compile(expression));
    if (!value.number) refuse(place, "found a division by zero, expected a number at the scene's values");
    return binary64(*value.number, place);
  }
  Json number(const PlacedExpression& placed) { return number(unplaced(placed), placed.place()); }
  Json pair(const SceneVector& vector, Place place) {
    return Json::array({number(vector.x, place), number(vector.y, place)});
  }
  Json pair(const PlacedVector& given) { return pair(unplaced(given), given.place); }
  void put(Json& object, const char* key, const PlacedExpression& given) {
    if (given) object[key] = number(given);
  }
  void put(Json& object, const char* key, const PlacedVector& given) {
    if (given) object[key] = pair(given);
  }
  const std::string& body_name(std::size_t index) const { return bodies_.bodies[index].name; }
  const std::string& unknown(std::size_t index) const { return m_.unknowns[index].symbol; }

  Json body(const Body& body) {
    Json entry{{"name", body.name}};
    const Frame frame(body);
    put(entry, "mass", body.mass);
    put(entry, "inertia", body.inertia.entries[2]);
    if (body.is_prescribed()) entry["acceleration"] = pair(frame.acceleration, body.place);
    if (!body.inertia) entry["turning"] = number(frame.turning.z, body.place);
    entry["at"] = pair(frame.at, body.at.place);
    entry["angle"] = pair({frame.turn.entry(0, 0), frame.turn.entry(1, 0)}, body.place);
    entry["velocity"] = pair(frame.velocity, body.velocity.place);
    entry["spin"] = number(frame.spin.z, body.place);
    entry["shapes"] = list(body.shapes, &BodiesExporter::shape);
    entry["unknowns"] = Json::array();
    for (const Body::Unknown& one : body.unknowns) {
      if (!one.symbol.empty()) entry["unknowns"].push_back({one.symbol, one.negated ? -1 : 1});
    }
    return entry;
  }

  Json shape(const BodyShape& shape) {
    const SceneVector centre = shape.points.empty() ? unplaced(PlacedVector{}) : unplaced(shape.points.front());
    if (shape.kind == BodyShape::Kind::circle) {
      return {{"circle", number(shape.radius)}, {"at", pair(centre, shape.place)}};
    }
    Json points = Json::array();
    if (shape.kind == BodyShape::Kind::box) {
      const Expression x = over(unplaced(shape.width), make_number(2)),
                       y = over(unplaced(shape.height), make_number(2));
      const Expression left = negative_of(x), low = negative_of(y);
      for (const SceneVector& corner : {SceneVector{left, low}, {x, low}, {x, y}, {left, y}}) {
        points.push_back(pair(centre + corner, shape.place));
      }
    } else {
      for (const PlacedVector& point : shape.points) points.push_back(pair(point));
    }
    return {{shape.kind == BodyShape::Kind::line ? "line" : "polygon", std::move(points)}};
  }

  Json contact(const BodyContact& contact) {
    const MechanismContact& given = m_.contacts[contact.contact];
    Json entry{{"name", given.name}, {"of", body_name(contact.of)}, {"on", body_name(contact.on)}};
    entry["point"] = pair(contact.point);
    entry["radius"] = number(contact.radius);
    put(entry, "normal", contact.normal);
    put(entry, "through", contact.through);
    put(entry, "on_point", contact.on_point);
    put(entry, "on_radius", contact.on_radius);
    entry["friction"] = number(given.kinetic_friction);
    if (given.static_friction && !same(given.static_friction.expression, given.kinetic_friction.expression)) {
      put(entry, "static_friction", given.static_friction);
    }
    entry["bilateral"] = given.bilateral;
    put(entry, "slip_direction", contact.slip_direction);
    entry["forces"] = Json::array({unknown(given.normal)});
    if (given.tangent) entry["forces"].push_back(unknown(*given.tangent));
    if (contact.rolling) {
      put(entry, "rolling_resistance", contact.rolling_resistance);
      entry["rolling_force"] = unknown(m_.friction[*contact.rolling].force);
    }
    put_state(entry, contact.contact);
    return entry;
  }

  /// Elements that do not start at rest.
  void put_state(Json& entry, std::size_t element) const {
    const ElementKind::Start start = scene_.values.starts[element];
    if (start != ElementKind::Start::rest) entry["state"] = name(start);
  }

  Json joint(const BodyJoint& joint) {
    Json entry{{"name", joint.name}, {"kind", name(joint.kind)}};
    entry["between"] = Json::array({body_name(joint.first), body_name(joint.second)});
    if (joint.kind == BodyJoint::Kind::gear) {
      put(entry, "ratio", joint.ratio);
      entry["carrier"] = body_name(joint.carrier);
      entry["one_sided"] = joint.contact.has_value();
    } else {
      const Frame &first = frames_[joint.first], &second = frames_[joint.second];
      const SceneVector at = unplaced(joint.at);
      const SceneVector same_place = second.in_body(first.at + first.in_scene(at) - second.at);
      entry["at"] = pair(at, joint.place);
      entry["to"] = joint.to ? pair(joint.to) : pair(same_place, joint.place);
    }
    if (joint.armature) refuse(joint.armature.place(), joint.name + ": found an armature, expected none in a plane");
    put(entry, "axis", joint.axis);
    put(entry, "length", joint.length);
    put(entry, "force", joint.tension);
    entry["forces"] = Json::array();
    for (const std::size_t link : joint.links) entry["forces"].push_back(unknown(m_.links[link].force));
    if (joint.contact) {
      entry["forces"].push_back(unknown(m_.contacts[*joint.contact].normal));
      put_state(entry, *joint.contact);
    }
    return entry;
  }

  /// At the scene's load.
  Json friction(const BodyFriction& friction) {
    const MechanismFriction& given = m_.friction[friction.friction];
    const std::size_t element = m_.contacts.size() + friction.friction;
    AffineForm limit = problem_.elements[element].kinetic_limit;
    if (problem_.has_load) {
      limit.constant += limit.coefficients[problem_.load_index()] * *scene_.load;
      limit.coefficients[problem_.load_index()] = 0;
    }
    for (const Rational& coefficient : limit.coefficients) {
      if (!coefficient.is_zero()) refuse(given.place, given.name + ": found a limit that depends on other forces");
    }
    Json entry{{"name", given.name}, {"between", {body_name(friction.first), body_name(friction.second)}}};
    entry["limit"] = binary64(limit.constant, given.place);
    entry["force"] = unknown(given.force);
    put_state(entry, element);
    return entry;
  }

  void put_pushes(Json& document) {
    document["forces"] = Json::array();
    for (const BodyForce& force : bodies_.forces) {
      const Frame& frame = frames_[force.on];
      const SceneVector at = unplaced(force.at), given = unplaced(force.is);
      const SceneVector is = force.follows ? frame.in_scene(given) : given;
      put_force(document, force.on, at, is, force.place);
      if (!force.back_on) continue;
      const Frame& back = frames_[*force.back_on];
      put_force(document, *force.back_on, back.in_body(frame.at + frame.in_scene(at) - back.at), -is, force.place);
    }
    document["torques"] = Json::array();
    for (const BodyTorque& torque : bodies_.torques) {
      const Expression is = unplaced(torque.is).z;
      put_torque(document, torque.on, is, torque.place);
      if (torque.back_on) put_torque(document, *torque.back_on, negative_of(is), torque.place);
    }
  }

  /// Nothing for what is prescribed, the ground among it: no force moves that.
  void put_force(Json& document, std::size_t on, const SceneVector& at, const SceneVector& is, Place place) {
    if (bodies_.bodies[on].is_prescribed()) return;
    document["forces"].push_back({{"on", body_name(on)}, {"at", pair(at, place)}, {"is", pair(is, place)}});
  }
  void put_torque(Json& document, std::size_t on, const Expression& is, Place place) {
    if (!bodies_.bodies[on].turns_freely()) return;
    document["torques"].push_back({{"on", body_name(on)}, {"is", number(is, place)}});
  }

  const MechanismScene& scene_;
  const Mechanism& m_;
  const Bodies& bodies_;
  const std::vector<Frame> frames_;
  const ProblemMaker maker_;
  Evaluator<Rational> at_;
  const FrictionProblem problem_;
};

}  // namespace

}  // namespace bodies_in_motion

std::string bodies_json(const MechanismScene& scene) {
  const Mechanism& m = scene.mechanism;
  if (!m.bodies) {
    throw InputError({{m.file, 0, 0,
                       m.name + ": found a mechanism that is given by its equations, expected one with bodies "
                                "([[body]]), which an engine can have"}});
  }
  if (m.load && !scene.load) {
    throw InputError(
        {{m.file, 0, 0, "found no value of the load " + m.load->symbol + ", expected one: an engine has forces only"}});
  }
  return bodies_in_motion::BodiesExporter(scene).line();
}

}  // namespace slipproof
