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
        at_(maker_.at(scene.values)) {
    if (scene.load) at_.set(maker_.compiled().load(), *scene.load);
  }

  std::string line() {
    Json document{{"schema", "slipproof/bodies/1"}, {"name", scene_.name.empty() ? m_.name : scene_.name}};
    if (m_.impact) document["impact"] = name(m_.impact->law);
    document["gravity"] = coordinates(unplaced(bodies_.gravity), bodies_.gravity.place);
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
  bool in_space() const { return bodies_.dimension == 3; }
  Json coordinates(const SceneVector& vector, Place place) {
    Json result = Json::array({number(vector.x, place), number(vector.y, place)});
    if (in_space()) result.push_back(number(vector.z, place));
    return result;
  }
  /// A turn, a spin or a couple: in the plane one number.
  Json turning(const SceneVector& vector, Place place) {
    return in_space() ? coordinates(vector, place) : number(vector.z, place);
  }
  Json coordinates(const PlacedVector& given) { return coordinates(unplaced(given), given.place); }
  void put(Json& object, const char* key, const PlacedExpression& given) {
    if (given) object[key] = number(given);
  }
  void put(Json& object, const char* key, const PlacedVector& given) {
    if (given) object[key] = coordinates(given);
  }
  const std::string& body_name(std::size_t index) const { return bodies_.bodies[index].name; }
  const std::string& unknown(std::size_t index) const { return m_.unknowns[index].symbol; }

  Json body(const Body& body) {
    Json entry{{"name", body.name}};
    const Frame frame(body);
    put(entry, "mass", body.mass);
    if (body.inertia) entry["inertia"] = inertia(body.inertia);
    // An impact has velocities before it in place of accelerations, and nothing accelerates.
    const SceneVector none = unplaced(PlacedVector{});
    const bool impact = m_.impact.has_value();
    if (body.is_prescribed()) entry["acceleration"] = coordinates(impact ? none : frame.acceleration, body.place);
    if (!body.inertia) entry["turning"] = turning(impact ? none : frame.turning, body.place);
    entry["at"] = coordinates(frame.at, body.at.place);
    entry[in_space() ? "turn" : "angle"] = turn(frame, body.place);
    entry["velocity"] = coordinates(impact ? unplaced(body.acceleration) : frame.velocity, body.velocity.place);
    entry["spin"] = turning(impact ? unplaced(body.turning) : frame.spin, body.place);
    entry["shapes"] = list(body.shapes, &BodiesExporter::shape);
    entry["unknowns"] = Json::array();
    for (const Body::Unknown& one : body.unknowns) {
      if (!one.symbol.empty()) entry["unknowns"].push_back({one.symbol, one.negated ? -1 : 1});
    }
    return entry;
  }

  Json inertia(const PlacedInertia& given) {
    if (!in_space()) return number(given.entries[2]);
    Json result = Json::array();
    for (const PlacedExpression& entry : given.entries) result.push_back(entry ? number(entry) : Json(0.0));
    return result;
  }

  /// In the plane a cosine and a sine, in space the rows of the rotation from the body's axes into those of the scene.
  Json turn(const Frame& frame, Place place) {
    const auto entry = [&](std::size_t i, std::size_t j) { return number(frame.turn.entry(i, j), place); };
    if (!in_space()) return Json::array({entry(0, 0), entry(1, 0)});
    Json rows = Json::array();
    for (std::size_t i = 0; i < 3; ++i) rows.push_back({entry(i, 0), entry(i, 1), entry(i, 2)});
    return rows;
  }

  Json solid(const BodyShape& shape, const SceneVector& centre) {
    using Kind = BodyShape::Kind;
    if (shape.kind == Kind::hull) {
      Json points = Json::array();
      for (const PlacedVector& point : shape.points) points.push_back(coordinates(point));
      return {{"hull", std::move(points)}};
    }
    Json sizes = Json::array();
    if (shape.kind == Kind::box) sizes = {number(shape.width), number(shape.depth), number(shape.height)};
    if (shape.kind == Kind::sphere) sizes = number(shape.radius);
    if (shape.kind == Kind::cylinder || shape.kind == Kind::capsule)
      sizes = {number(shape.radius), number(shape.height)};
    constexpr std::array<std::string_view, 8> words{"", "", "box", "", "sphere", "cylinder", "capsule", "hull"};
    Json entry{{words[static_cast<std::size_t>(shape.kind)], std::move(sizes)},
               {"at", coordinates(centre, shape.place)}};
    put(entry, "axis", shape.axis);
    return entry;
  }

  Json shape(const BodyShape& shape) {
    const SceneVector centre = shape.points.empty() ? unplaced(PlacedVector{}) : unplaced(shape.points.front());
    if (in_space()) return solid(shape, centre);
    if (shape.kind == BodyShape::Kind::circle) {
      return {{"circle", number(shape.radius)}, {"at", coordinates(centre, shape.place)}};
    }
    Json points = Json::array();
    if (shape.kind == BodyShape::Kind::box) {
      const Expression x = over(unplaced(shape.width), make_number(2)),
                       y = over(unplaced(shape.height), make_number(2));
      const Expression left = negative_of(x), low = negative_of(y);
      for (const SceneVector& corner : {SceneVector{left, low}, {x, low}, {x, y}, {left, y}}) {
        points.push_back(coordinates(centre + corner, shape.place));
      }
    } else {
      for (const PlacedVector& point : shape.points) points.push_back(coordinates(point));
    }
    return {{shape.kind == BodyShape::Kind::line ? "line" : "polygon", std::move(points)}};
  }

  Json contact(const BodyContact& contact) {
    const MechanismContact& given = m_.contacts[contact.contact];
    Json entry{{"name", given.name}, {"of", body_name(contact.of)}, {"on", body_name(contact.on)}};
    entry["point"] = coordinates(contact.point);
    entry["radius"] = number(contact.radius);
    put(entry, "normal", contact.normal);
    put(entry, "through", contact.through);
    put(entry, "on_point", contact.on_point);
    put(entry, "on_radius", contact.on_radius);
    entry["friction"] = given.kinetic_friction ? number(given.kinetic_friction) : Json(0.0);
    if (given.static_friction && !same(given.static_friction.expression, given.kinetic_friction.expression)) {
      put(entry, "static_friction", given.static_friction);
    }
    entry["bilateral"] = given.bilateral;
    if (m_.impact) put(entry, "restitution", contact.restitution);
    if (m_.impact) put(entry, "tangential_restitution", contact.tangential_restitution);
    put(entry, "slip_direction", contact.slip_direction);
    entry["forces"] = Json::array({unknown(given.normal)});
    if (given.tangent) entry["forces"].push_back(unknown(*given.tangent));
    if (given.second) {
      entry["forces"].push_back(unknown(given.second->force));
      entry["tangents"] = {along(given.slip_direction), along(given.second->direction)};
    }
    if (contact.rolling) {
      put(entry, "rolling_resistance", contact.rolling_resistance);
      entry["rolling_force"] = unknown(m_.friction[*contact.rolling].force);
    }
    put_state(entry, contact.contact);
    return entry;
  }

  Json along(const std::vector<PlacedExpression>& direction) {
    Json result = Json::array();
    for (const PlacedExpression& component : direction) result.push_back(number(component));
    return result;
  }

  /// Elements that do not start at rest.
  void put_state(Json& entry, std::size_t element) const {
    const ElementKind::Start start = scene_.values.starts[element];
    if (start != ElementKind::Start::rest) entry["state"] = name(start, m_.dimension);
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
      entry["at"] = coordinates(at, joint.place);
      entry["to"] = joint.to ? coordinates(joint.to) : coordinates(same_place, joint.place);
    }
    if (joint.armature) refuse(joint.armature.place(), joint.name + ": found an armature, expected none in a plane");
    put(entry, "axis", joint.axis);
    put(entry, "to_axis", joint.to_axis);
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
    const FrictionProblem problem = maker_.problem(scene_.values);
    AffineForm limit = problem.elements[element].kinetic_limit;
    if (problem.has_load) {
      limit.constant += limit.coefficients[problem.load_index()] * *scene_.load;
      limit.coefficients[problem.load_index()] = 0;
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
      const SceneVector given = unplaced(torque.is);
      const SceneVector is = torque.follows ? frames_[torque.on].in_scene(given) : given;
      put_torque(document, torque.on, is, torque.place);
      if (torque.back_on) put_torque(document, *torque.back_on, -is, torque.place);
    }
  }

  /// Nothing for what is prescribed, the ground among it: no force moves that.
  void put_force(Json& document, std::size_t on, const SceneVector& at, const SceneVector& is, Place place) {
    if (bodies_.bodies[on].is_prescribed()) return;
    document["forces"].push_back(
        {{"on", body_name(on)}, {"at", coordinates(at, place)}, {"is", coordinates(is, place)}});
  }
  void put_torque(Json& document, std::size_t on, const SceneVector& is, Place place) {
    if (!bodies_.bodies[on].turns_freely()) return;
    document["torques"].push_back({{"on", body_name(on)}, {"is", turning(is, place)}});
  }

  const MechanismScene& scene_;
  const Mechanism& m_;
  const Bodies& bodies_;
  const std::vector<Frame> frames_;
  const ProblemMaker maker_;
  Evaluator<Rational> at_;
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
