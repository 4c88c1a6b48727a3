// A line of `slipproof/bodies/1` as an engine reads it: Newton's and Euler's equations, gaps and slips in floating
// point, from the document alone.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace slipproof::test {

class EngineScene {
 public:
  using Json = nlohmann::json;
  using Vector = std::array<double, 2>;
  using Values = std::map<std::string, double>;  ///< accelerations and forces by their names

  explicit EngineScene(const std::string& line) : document(Json::parse(line)) {
    body_["ground"] = Json{{"at", {0, 0}}, {"angle", {1, 0}}, {"acceleration", {0, 0}}, {"turning", 0}};
    for (const Json& body : document["bodies"]) body_[body["name"]] = body;
  }

  /// The largest difference of both sides of an equation of motion, over the largest of its terms.
  double residual(const Values& x) const {
    std::map<std::string, Push> pushes;
    for (const auto& [name, body] : body_) pushes[name] = {};
    add_contacts(x, pushes);
    add_joints(x, pushes);
    for (const Json& f : document["forces"])
      push(pushes, f["on"], scene_arm(f["on"], vector(f["at"])), vector(f["is"]));
    for (const Json& t : document["torques"]) pushes[t["on"]].add(2, t["is"]);
    for (const Json& f : document["friction"]) turn(pushes, f["between"][0], f["between"][1], x.at(f["force"]));
    double worst = 0;
    for (const auto& [name, body] : body_) {
      if (!body.contains("mass")) continue;
      Push& p = pushes[name];
      const Vector gravity = vector(document["gravity"]);
      const auto motion = motion_of(name, x);
      const double mass = body["mass"];
      for (std::size_t i = 0; i < 2; ++i) p.add(i, mass * gravity[i]), p.add(i, -mass * motion[i]);
      if (body.contains("inertia")) p.add(2, -body["inertia"].get<double>() * motion[2]);
      for (std::size_t i = 0; i < (body.contains("inertia") ? 3U : 2U); ++i) {
        if (p.largest[i] > 0) worst = std::max(worst, std::abs(p.sum[i]) / p.largest[i]);
      }
    }
    return worst;
  }

  /// Gap and slip of a contact, from rest.
  Vector gap_and_slip(const Json& contact, const Values& x) const {
    const Touch touch = touch_of(contact);
    const Vector a = acceleration_of(contact["of"], touch.of_arm, x),
                 b = acceleration_of(contact["on"], touch.on_arm, x);
    const Vector relative{a[0] - b[0], a[1] - b[1]};
    return {dot(touch.normal, relative), dot(touch.along, relative)};
  }

  const Json document;

 private:
  struct Push {
    std::array<double, 3> sum{}, largest{};  ///< along x, along y, about the centre of mass
    void add(std::size_t i, double value) {
      sum[i] += value;
      largest[i] = std::max(largest[i], std::abs(value));
    }
  };
  struct Touch {
    Vector normal, along, of_arm, on_arm;  ///< directions, and the place from each body's centre of mass
  };

  static Vector vector(const Json& pair) { return {pair[0], pair[1]}; }
  static double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1]; }
  static Vector along(double s, const Vector& a, double t, const Vector& b) {
    return {s * a[0] + t * b[0], s * a[1] + t * b[1]};
  }
  /// A vector of a body's axes in those of the scene.
  Vector scene_arm(const std::string& body, const Vector& own) const {
    const Vector turn = vector(body_.at(body)["angle"]);
    return {turn[0] * own[0] - turn[1] * own[1], turn[1] * own[0] + turn[0] * own[1]};
  }
  Vector at(const std::string& body) const { return vector(body_.at(body)["at"]); }
  Vector place(const std::string& body, const Json& own) const {
    return along(1, at(body), 1, scene_arm(body, vector(own)));
  }

  Touch touch_of(const Json& c) const {
    const std::string of = c["of"], on = c["on"];
    const Vector centre = place(of, c["point"]);
    Touch touch;
    if (c.contains("normal")) {
      touch.normal = scene_arm(on, vector(c["normal"]));
    } else {
      const Vector apart = along(1, centre, -1, place(on, c["on_point"]));
      const double distance = c["radius"].get<double>() + c["on_radius"].get<double>();
      touch.normal = {apart[0] / distance, apart[1] / distance};
    }
    touch.along = c.contains("slip_direction") ? scene_arm(on, vector(c["slip_direction"]))
                                               : Vector{touch.normal[1], -touch.normal[0]};
    const Vector where = along(1, centre, -c["radius"].get<double>(), touch.normal);
    touch.of_arm = along(1, where, -1, at(of));
    touch.on_arm = along(1, where, -1, at(on));
    return touch;
  }

  std::array<double, 3> motion_of(const std::string& name, const Values& x) const {
    const Json& body = body_.at(name);
    std::array<double, 3> result{};
    std::size_t next = 0;
    if (body.contains("acceleration")) {
      result = {body["acceleration"][0], body["acceleration"][1], 0};
      next = 2;
    }
    if (body.contains("turning")) result[2] = body["turning"];
    if (!body.contains("unknowns")) return result;
    for (const Json& unknown : body["unknowns"]) {
      result[next++] = x.at(unknown[0]) * unknown[1].get<double>();
    }
    return result;
  }
  Vector acceleration_of(const std::string& body, const Vector& arm, const Values& x) const {
    const auto motion = motion_of(body, x);
    return {motion[0] - motion[2] * arm[1], motion[1] + motion[2] * arm[0]};
  }

  static void push(std::map<std::string, Push>& pushes, const std::string& body, const Vector& arm,
                   const Vector& force) {
    Push& p = pushes[body];
    p.add(0, force[0]), p.add(1, force[1]);
    p.add(2, arm[0] * force[1]), p.add(2, -arm[1] * force[0]);
  }
  static void turn(std::map<std::string, Push>& pushes, const std::string& first, const std::string& second,
                   double couple) {
    pushes[first].add(2, couple), pushes[second].add(2, -couple);
  }

  void add_contacts(const Values& x, std::map<std::string, Push>& pushes) const {
    for (const Json& c : document["contacts"]) {
      const Touch touch = touch_of(c);
      const double n = x.at(c["forces"][0]), s = c["forces"].size() > 1 ? x.at(c["forces"][1]) : 0;
      const Vector force = along(n, touch.normal, s, touch.along);
      push(pushes, c["of"], touch.of_arm, force);
      push(pushes, c["on"], touch.on_arm, {-force[0], -force[1]});
      if (c.contains("rolling_force")) turn(pushes, c["of"], c["on"], x.at(c["rolling_force"]));
    }
  }

  /// Forces act on the first body, and back on the second; those of rods, ropes and springs pull.
  void add_joints(const Values& x, std::map<std::string, Push>& pushes) const {
    for (const Json& j : document["joints"]) {
      const std::string first = j["between"][0], second = j["between"][1], kind = j["kind"];
      const auto force = [&](std::size_t i) { return i < j["forces"].size() ? x.at(j["forces"][i]) : 0; };
      if (kind == "gear") {
        const double t = force(0), ratio = j["ratio"];
        pushes[second].add(2, t), pushes[first].add(2, -ratio * t);
        pushes[j["carrier"]].add(2, (ratio - 1) * t);
        continue;
      }
      const Vector end = place(first, j["at"]), other = place(second, j["to"]);
      Vector pushed{force(0), force(1)}, where = end;
      if (kind == "pin" || kind == "weld") {
        if (kind == "weld") turn(pushes, first, second, force(2));
      } else if (kind == "slider") {
        const Vector axis = scene_arm(first, vector(j["axis"]));
        pushed = {-force(0) * axis[1], force(0) * axis[0]};
        where = other;
        turn(pushes, first, second, force(1));
      } else {
        const double length = j["length"], pull = kind == "spring" ? j["force"].get<double>() : force(0);
        pushed = along(pull / length, other, -pull / length, end);
      }
      push(pushes, first, along(1, where, -1, at(first)), pushed);
      push(pushes, second, along(1, kind == "slider" ? where : other, -1, at(second)), {-pushed[0], -pushed[1]});
    }
  }

  std::map<std::string, Json> body_;
};

}  // namespace slipproof::test
