// Scenes in space as engines read them: Newton's and Euler's equations hold from the document alone.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "base/number/binary64.hpp"
#include "contact/exchange/export_bodies.hpp"
#include "contact/space/solve_space.hpp"

using namespace slipproof;
using BodiesJson = nlohmann::json;

namespace {

using Vector3 = std::array<double, 3>;

Vector3 vector_of(const BodiesJson& given) {
  return {given[0], given[1], given[2]};
}
Vector3 crossed(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// R v, or the transposed R v.
Vector3 turned(const BodiesJson& R, const Vector3& v, bool back = false) {
  Vector3 result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i] += (back ? R[j][i] : R[i][j]).get<double>() * v[j];
  }
  return result;
}
Vector3 by_inertia(const BodiesJson& I, const Vector3& v) {
  return {I[0].get<double>() * v[0] + I[3].get<double>() * v[1] + I[4].get<double>() * v[2],
          I[3].get<double>() * v[0] + I[1].get<double>() * v[1] + I[5].get<double>() * v[2],
          I[4].get<double>() * v[0] + I[5].get<double>() * v[1] + I[2].get<double>() * v[2]};
}

/// The sums of force and couple, and the largest that is added.
struct Balance {
  Vector3 force{}, couple{};
  double largest = 0;

  void push(const Vector3& f, const Vector3& arm, double sign = 1) {
    const Vector3 moment = crossed(arm, f);
    for (std::size_t i = 0; i < 3; ++i) {
      force[i] += sign * f[i], couple[i] += sign * moment[i];
      largest = std::max({largest, std::abs(f[i]), std::abs(moment[i])});
    }
  }
  void turn(const Vector3& m, double sign = 1) {
    for (std::size_t i = 0; i < 3; ++i) couple[i] += sign * m[i];
  }
};

double residual(const BodiesJson& document, const std::map<std::string, double>& x) {
  const BodiesJson& body = document["bodies"].at(0);
  const BodiesJson& R = body["turn"];
  const double mass = body["mass"];
  Balance balance;
  const auto scaled = [](const Vector3& v, double factor) {
    return Vector3{factor * v[0], factor * v[1], factor * v[2]};
  };
  balance.push(scaled(vector_of(document["gravity"]), mass), {});
  for (const BodiesJson& force : document["forces"]) {
    balance.push(vector_of(force["is"]), turned(R, vector_of(force["at"])));
  }
  for (const BodiesJson& contact : document["contacts"]) {
    REQUIRE(contact["on"] == "ground");
    const Vector3 arm = turned(R, vector_of(contact["point"]));
    const Vector3 normal = vector_of(contact["normal"]);
    const Vector3 rim = scaled(normal, -contact["radius"].get<double>());
    const Vector3 at{arm[0] + rim[0], arm[1] + rim[1], arm[2] + rim[2]};
    const BodiesJson& forces = contact["forces"];
    balance.push(scaled(normal, x.at(forces[0])), at);
    for (std::size_t t = 0; t < 2; ++t)
      balance.push(scaled(vector_of(contact["tangents"][t]), x.at(forces[1 + t])), at);
  }
  Vector3 a{}, alpha{};
  for (std::size_t i = 0; i < 3; ++i) {
    a[i] = x.at(body["unknowns"][i][0]), alpha[i] = x.at(body["unknowns"][3 + i][0]);
  }
  balance.push(scaled(a, mass), {}, -1);
  const auto spun = [&](const Vector3& spin) { return turned(R, by_inertia(body["inertia"], turned(R, spin, true))); };
  const Vector3 spin = vector_of(body["spin"]);
  balance.turn(spun(alpha), -1);
  balance.turn(crossed(spin, spun(spin)), -1);
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i)
    worst = std::max({worst, std::abs(balance.force[i]), std::abs(balance.couple[i])});
  return worst / balance.largest;
}

}  // namespace

TEST_CASE("motions in space balance the forces of the scene that an engine reads") {
  for (const char* name : {"domino", "cube-pushed-obliquely", "box-on-slope-pulled-sideways", "screwdriver-at-wall"}) {
    CAPTURE(name);
    const SolvedSpace solved =
        solve_space(read_scene(SLIPPROOF_SOURCE_DIR "/cases/space/" + std::string(name) + ".toml", Dimensions::any));
    const Mechanism& m = solved.scene.mechanism;
    const BodiesJson document = BodiesJson::parse(bodies_json(solved.scene));
    const auto accelerations = acceleration_names(m), forces = force_names(m);
    for (const SpaceMotion& motion : solved.motions) {
      std::map<std::string, double> x;
      for (std::size_t i = 0; i < accelerations.size(); ++i) {
        x[accelerations[i]] = nearest_binary64(*motion.accelerations[i].lower);
      }
      for (std::size_t i = 0; i < forces.size(); ++i) x[forces[i]] = nearest_binary64(*motion.forces[i]->lower);
      CHECK(residual(document, x) < 1e-8);
      x[accelerations[4]] += 1;
      CHECK(residual(document, x) > 1e-6);
    }
  }
}

TEST_CASE("a body in space has its turn as a rotation, and shapes by their sizes") {
  const MechanismScene scene =
      read_scene(SLIPPROOF_SOURCE_DIR "/cases/space/screwdriver-at-wall.toml", Dimensions::any);
  const BodiesJson body = BodiesJson::parse(bodies_json(scene))["bodies"].at(0);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      double product = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        product += body["turn"][i][k].get<double>() * body["turn"][j][k].get<double>();
      }
      CHECK(product == doctest::Approx(i == j ? 1 : 0));
    }
  }
  CHECK(body["inertia"].size() == 6);
  CHECK(body["shapes"][0]["hull"].size() == 4);
  CHECK(body["shapes"][1]["sphere"] == 0.015);
}
