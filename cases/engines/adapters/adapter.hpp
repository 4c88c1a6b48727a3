// What adapters in C++ share: reads the lines, gives each scene to the engine, writes the answers. A scene comes as the
// driver's `world` (asking/world.py, asking/space.py): everything in the axes of the scene; body 0 is the ground. In
// the plane the third component of a vector is 0.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace engines {

using Json = nlohmann::json;
using Vector = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  ///< w x y z

struct Body {
  std::string name;
  Vector at{}, velocity{}, acceleration{}, force{};
  double spin = 0, turning = 0, mass = 0, inertia = 0, torque = 0;  ///< in the plane
  /// In space; moments about the principal axes, which `turn` brings into the scene.
  Vector spins{}, turnings{}, torques{}, moments{};
  Quaternion turn{1, 0, 0, 0};
  bool is_free = false;  ///< has a mass; if not, moves by `acceleration`
  bool turns = false;    ///< has an inertia; if not, turns by `turning`
  Json names{};

  bool is_ground() const { return name == "ground"; }
  bool is_prescribed() const { return !is_free && !turns; }
  /// How a body that moves as prescribed moves at the end of a step.
  Vector velocity_after(double step) const {
    return {velocity[0] + step * acceleration[0], velocity[1] + step * acceleration[1],
            velocity[2] + step * acceleration[2]};
  }
  double spin_after(double step) const { return spin + step * turning; }
};

struct Contact {
  std::string name;
  std::size_t of = 0, on = 0;
  Vector at{}, normal{}, tangent{}, second{};  ///< `second`: of the tangents, in space
  double radius = 0, friction = 0;
  std::vector<std::string> forces;
  double restitution = 0;  ///< of an impact
};

struct Joint {
  std::string name, kind;
  std::size_t first = 0, second = 0, carrier = 0;
  Vector at{}, to{}, axis{};
  double length = 0, ratio = 0;
  bool one_sided = false;
  std::vector<std::string> forces{};
};

/// A brake or a clutch.
struct Friction {
  std::size_t first = 0, second = 0;
  double limit = 0;
  std::string force;
};

/// A whole shape of the one body on the floor: a box or a sphere, in the axes of the scene from the centre of mass.
struct Shape {
  Vector box{};  ///< its sides; 0 of a sphere
  double radius = 0;
  Vector at{};
  Quaternion turn{1, 0, 0, 0};
};

struct Question {
  bool in_space = false;
  Vector gravity{};
  double size = 1, step = 0;
  int iterations = 0;  ///< 0: the engine's default
  std::vector<Body> bodies{};
  std::vector<Contact> contacts{};
  std::vector<Joint> joints{};
  std::vector<Friction> friction{};
  std::vector<Shape> shapes{};  ///< empty: the contacts are those of the scene
  bool impact = false;          ///< contacts approach: asks for velocities after the step and impulses
  std::string watch;            ///< `drift`, `energy`: asks for that over many steps, not for an acceleration

  /// For engines that find contacts themselves: a disc of the contact's own radius, or a small one, touches a square of
  /// half the width `half` in the middle of its upper side.
  double disc(const Contact& c) const { return c.radius > 0 ? c.radius : std::max(0.05 * size, 0.001); }
  double half(const Contact& c) const { return std::max(disc(c), 0.01); }

  Vector arm(std::size_t body, const Vector& point) const {
    const Vector& at = bodies[body].at;
    return {point[0] - at[0], point[1] - at[1], point[2] - at[2]};
  }
};

struct Answer {
  /// Of each body after the step: x, y, counterclockwise; in space x, y, z, and the spin about these.
  std::vector<std::array<double, 6>> velocity;
  std::map<std::string, double> forces;
  bool tells_forces = true;
  std::map<std::string, double> watched;  ///< by the number of steps
  Json settings = Json::object();

  /// Of a contact: along its normal and its tangent.
  void push(const Contact& contact, double normal, double tangent) {
    if (!contact.forces.empty()) forces[contact.forces[0]] += normal;
    if (contact.forces.size() > 1) forces[contact.forces[1]] += tangent;
  }
  /// In space.
  void push(const Contact& contact, const Vector& force);
};

/// Why an engine cannot have a scene.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Engine {
  std::string name, version, law;
  std::function<Answer(const Question&)> ask;
  std::string law_in_space = {};  ///< empty: it refuses scenes in space
};

inline Vector vector(const Json& given) {
  return {given[0], given[1], given.size() > 2 ? given[2].get<double>() : 0};
}
inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// A vector in the axes of the scene, in those of a body; with `back` the other way.
inline Vector in_body(const Body& body, const Vector& v, bool back = false) {
  const double sign = back ? 1 : -1, w = body.turn[0];
  const Vector axis{sign * body.turn[1], sign * body.turn[2], sign * body.turn[3]};
  const Vector once = cross(axis, v), twice = cross(axis, once);
  return {v[0] + 2 * (w * once[0] + twice[0]), v[1] + 2 * (w * once[1] + twice[1]),
          v[2] + 2 * (w * once[2] + twice[2])};
}

/// Where a body is, and how it moves.
struct Pose {
  Vector at{};
  Quaternion turn{1, 0, 0, 0};  ///< brings its principal axes into the scene
  Vector velocity{}, spin{};
};

/// Kinetic energy and potential energy above the place at the start.
inline double energy(const Question& q, const Body& body, const Pose& pose) {
  Body now = body;
  now.turn = pose.turn;
  const Vector w = in_body(now, pose.spin), &m = body.moments, &at = body.at;
  const Vector moved{pose.at[0] - at[0], pose.at[1] - at[1], pose.at[2] - at[2]};
  return 0.5 * (body.mass * dot(pose.velocity, pose.velocity) + m[0] * w[0] * w[0] + m[1] * w[1] * w[1] +
                m[2] * w[2] * w[2]) -
         body.mass * dot(q.gravity, moved);
}

/// Over steps of which the first is made. `drift`: how far a body is from where it began after 1, 10 and 100 steps,
/// over the size. `energy`: by how much it has risen at most above that of an earlier step or the start, up to 1, 10,
/// 100 and 1,000 steps, over that at the start and what would lift all bodies by the size. `step()` makes one more
/// step, pushes included, and `pose(i)` is that of a body.
template <class Step, class PoseOf>
void watch(const Question& q, Answer& answer, const Step& step, const PoseOf& pose) {
  const bool of_energy = q.watch == "energy";
  double before = 0, lift = 0, rise = 0;
  for (const Body& body : q.bodies) {
    before += energy(q, body, {body.at, body.turn, body.velocity, body.spins});
    lift += body.mass * std::sqrt(dot(q.gravity, q.gravity)) * q.size;
  }
  double lowest = before;
  for (int n = 1; n <= (of_energy ? 1000 : 100); ++n) {
    if (n > 1) step();
    double total = 0, farthest = 0;
    for (std::size_t i = 1; i < q.bodies.size(); ++i) {
      const Pose now = pose(i);
      const Vector& was = q.bodies[i].at;
      total += energy(q, q.bodies[i], now);
      farthest = std::max(farthest, std::hypot(now.at[0] - was[0], now.at[1] - was[1], now.at[2] - was[2]) / q.size);
    }
    rise = std::isfinite(total) ? std::max(rise, total - lowest) : total;  // not a number stays one
    lowest = std::min(lowest, total);
    if (n == 1 || n == 10 || n == 100 || n == 1000)
      answer.watched[std::to_string(n)] = of_energy ? rise / (before + lift) : farthest;
  }
}

inline void Answer::push(const Contact& contact, const Vector& force) {
  push(contact, dot(force, contact.normal), dot(force, contact.tangent));
  if (contact.forces.size() > 2) forces[contact.forces[2]] += dot(force, contact.second);
}

inline Body read_body(const Json& given) {
  Body body{given["name"], vector(given["at"]), vector(given["velocity"])};
  body.force = vector(given["force"]);
  body.names = given["names"];
  if ((body.is_free = given.contains("mass"))) body.mass = given["mass"];
  body.turns = given.contains("inertia");
  if (!body.is_free) body.acceleration = vector(given["acceleration"]);
  if (given["spin"].is_array()) {
    body.spins = vector(given["spin"]), body.torques = vector(given["torque"]), body.turn = given["turn"];
    (body.turns ? body.moments : body.turnings) = vector(given[body.turns ? "inertia" : "turning"]);
  } else {
    body.spin = given["spin"], body.torque = given["torque"];
    (body.turns ? body.inertia : body.turning) = given[body.turns ? "inertia" : "turning"];
  }
  return body;
}

inline Contact read_contact(const Json& given) {
  return {given["name"],
          given["of"],
          given["on"],
          vector(given["at"]),
          vector(given["normal"]),
          vector(given["tangent"]),
          given.contains("second") ? vector(given["second"]) : Vector{},
          given["radius"],
          given["friction"],
          given["forces"],
          given.value("restitution", 0.0)};
}

inline Joint read_joint(const Json& given) {
  Joint joint{given["name"], given["kind"], given["first"], given["second"]};
  joint.forces = given["forces"];
  if (joint.kind == "gear") {
    joint.ratio = given["ratio"], joint.carrier = given["carrier"], joint.one_sided = given["one_sided"];
  }
  joint.at = vector(given["at"]), joint.to = vector(given["to"]);
  if (given.contains("axis")) joint.axis = vector(given["axis"]);
  if (given.contains("length")) joint.length = given["length"];
  return joint;
}

inline Shape read_shape(const Json& given) {
  if (given.contains("hull")) throw Refused("the adapter has no hulls");
  Shape shape{{}, given.value("sphere", 0.0), vector(given["at"]), given["turn"]};
  if (given.contains("box")) shape.box = vector(given["box"]);
  return shape;
}

inline Question read_question(const Json& line) {
  const Json &ask = line.at("ask"), &world = ask.at("world");
  Question q{world["gravity"].size() == 3, vector(world["gravity"]), world["size"], ask["step"]};
  q.watch = ask.value("watch", "");
  q.impact = line.contains("impact");
  if (!ask["iterations"].is_null()) q.iterations = ask["iterations"];
  for (const Json& one : world["bodies"]) q.bodies.push_back(read_body(one));
  for (const Json& one : world["contacts"]) q.contacts.push_back(read_contact(one));
  for (const Json& one : world.value("shapes", Json::array())) q.shapes.push_back(read_shape(one));
  for (const Json& one : world["joints"]) q.joints.push_back(read_joint(one));
  for (const Json& one : world["friction"])
    q.friction.push_back({one["first"], one["second"], one["limit"], one["force"]});
  return q;
}

/// Accelerations by the names of the unknowns; of an impact velocities after.
inline Json motion(const Question& q, const Answer& answer) {
  Json result = Json::object();
  for (std::size_t i = 1; i < q.bodies.size(); ++i) {
    const Body& body = q.bodies[i];
    const Vector &v = body.velocity, &w = body.spins;
    const std::array<double, 6> before = q.in_space ? std::array<double, 6>{v[0], v[1], v[2], w[0], w[1], w[2]}
                                                    : std::array<double, 6>{v[0], v[1], body.spin};
    for (std::size_t k = 0; k < body.names.size(); ++k) {
      if (body.names[k].is_null()) continue;
      const double of_unknown = q.impact ? answer.velocity[i][k] : (answer.velocity[i][k] - before[k]) / q.step;
      result[body.names[k][0]] = body.names[k][1].get<double>() * of_unknown;
    }
  }
  return result;
}

inline Json answer_to(const Engine& engine, const Json& line) {
  Json result{{"schema", "slipproof/engine-answer/1"}, {"engine", engine.name}, {"version", engine.version}};
  result["scene"] = line["name"];
  try {
    const Question question = read_question(line);
    if (question.in_space && engine.law_in_space.empty()) throw Refused("a scene in space");
    Answer answer = engine.ask(question);
    if (question.impact) {  // adapters tell impulses over the step
      for (auto& [name, force] : answer.forces) force *= question.step;
    }
    result["settings"] = answer.settings;
    result["settings"]["step"] = question.step;
    if (!question.watch.empty()) {
      if (answer.watched.empty()) throw Refused("the adapter makes one step only");
      result[question.watch] = answer.watched;
      result["law"] = question.in_space ? engine.law_in_space : engine.law;
      return result;
    }
    result["motion"] = motion(question, answer);
    result["forces"] = answer.tells_forces ? Json(answer.forces) : Json();
    result["law"] = question.in_space ? engine.law_in_space : engine.law;
  } catch (const Refused& refused) {
    result["refused"] = refused.what();
  }
  return result;
}

/// Answers all lines of standard input; for `main`.
inline int run(const Engine& engine) {
  for (std::string line; std::getline(std::cin, line);) {
    std::cout << answer_to(engine, Json::parse(line)).dump() << std::endl;
  }
  return 0;
}

}  // namespace engines
