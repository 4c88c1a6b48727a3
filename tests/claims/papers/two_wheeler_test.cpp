// The theorems of proofs/two-wheeler, as its claims file states them, against all motions of random bicycles.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "claims/paper/compiled.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "support/bicycle/motions.hpp"
#include "support/how_many.hpp"
#include "support/scenes/random_scene.hpp"

using namespace slipproof;
using slipproof::test::RandomScenes;

namespace {

/// A bicycle as proofs/two-wheeler has it: sprocket and turning of the wheels eliminated, by its README.
struct TwoWheeler {
  TwoWheeler(const Bicycle<Rational>& p, const Road<Rational>& road, ForceKind kind)
      : M(p.M), R(p.R), h(p.h), b2(p.b2), b3(p.b3), f(road.f), g(road.g) {
    const Rational mu = p.r2 / p.r1, I0 = mu * mu * p.I1 + p.I2;
    m2 = I0 / (R * R);
    m3 = p.I3 / (R * R);
    r = R * (p.I2 + mu * p.I1) / I0;
    h0 = h + R;
    h2 = h0 - r;
    J = *p.J + (1 - mu) * (1 - mu) * p.I1 * p.I2 / I0;
    drive = sigma(p);
    push = kind == ForceKind::external ? 1 : 0;
    arm = push * (p.L + h) - r * drive;
  }

  /// x and what points along it change their signs; slip+ and slip- change places.
  TwoWheeler mirrored() const {
    TwoWheeler result = *this;
    result.h = -h;
    result.h2 = -h2;
    result.arm = -arm;
    return result;
  }

  const Rational* find(std::string_view symbol) const {
    if (symbol == "sigma") return &drive;
    const std::pair<std::string_view, const Rational*> all[] = {
        {"M", &M}, {"m2", &m2}, {"m3", &m3}, {"J", &J}, {"R", &R}, {"h0", &h0},     {"h", &h},     {"h2", &h2},
        {"r", &r}, {"b2", &b2}, {"b3", &b3}, {"f", &f}, {"g", &g}, {"push", &push}, {"arm", &arm}, {"drive", &drive}};
    for (const auto& [name, value] : all) {
      if (name == symbol) return value;
    }
    return nullptr;
  }

  Rational M, m2, m3, J, R, h0, h, h2, r, b2, b3, f, g, push, arm, drive;
};

/// With the centre of mass above the axles; an internal force is not mirrored, as its claims know both.
TwoWheeler upright(const Bicycle<Rational>& p, const Road<Rational>& road, ForceKind kind) {
  const TwoWheeler result(p, road, kind);
  return kind == ForceKind::external && sign(p.h) < 0 ? result.mirrored() : result;
}

/// The conditions of a setting's claims, by their ids.
class Theorems {
 public:
  explicit Theorems(std::string_view setting)
      : file_(read_claims(SLIPPROOF_SOURCE_DIR "/proofs/two-wheeler/claims.toml")), compiled_(file_) {
    while (file_.settings[setting_].id != setting) ++setting_;
  }

  Evaluator<Rational> at(const TwoWheeler& values, const Rational& force = {}) const {
    Evaluator<Rational> result(compiled_.settings[setting_].scope());
    result.set(CompiledSetting::force_slot(), force);
    const auto& parameters = file_.settings[setting_].parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const Rational* value = values.find(parameters[i].symbol);
      REQUIRE(value != nullptr);
      result.set(CompiledSetting::parameter_slot(i), *value);
    }
    return result;
  }

  /// Whether a bicycle is in the region of a claim, and with `with_force` the force among those of it.
  bool met(std::string_view id, Evaluator<Rational>& values, bool with_force = false) const {
    const std::size_t claim = static_cast<std::size_t>(file_.find(id) - file_.claims.data());
    const CompiledBody& body = compiled_.claims[claim].printed;
    return values.truth(body.region) == Truth::yes && (!with_force || values.truth(body.forces) == Truth::yes);
  }
  bool any(const std::vector<std::string_view>& ids, Evaluator<Rational>& values) const {
    for (const std::string_view id : ids) {
      if (met(id, values)) return true;
    }
    return false;
  }

  /// The values of f at which something changes, where they are positive.
  std::vector<Rational> thresholds(const TwoWheeler& values) const {
    std::vector<Rational> result;
    Evaluator<Rational> evaluator = at(values);
    for (const auto& boundary : compiled_.settings[setting_].boundaries()) {
      if (file_.settings[setting_].parameters[boundary.parameter].symbol != "f") continue;
      const auto value = evaluator.number(boundary.value).number;
      if (value && sign(*value) > 0) result.push_back(*value);
    }
    return result;
  }

 private:
  ClaimsFile file_;
  CompiledClaims compiled_;
  std::size_t setting_ = 0;
};

bool several(const std::vector<Cell>& cells) {
  for (const Cell& cell : cells) {
    if (cell.motions.size() != 1 || !cell.continua.empty()) return true;
  }
  return false;
}

/// SLIPPROOF_TWO_WHEELERS: how many bicycles and coefficients of friction for each kind of force.
int wanted() {
  return test::how_many("SLIPPROOF_TWO_WHEELERS", 1200);
}

/// A bicycle with some friction, then on one of its thresholds and a millionth to each side: visit(bicycle, road).
template <class Visit>
void on_and_beside(const Theorems& theorems, const Bicycle<Rational>& p, Road<Rational> road, ForceKind kind,
                   RandomScenes& random, Visit&& visit) {
  visit(p, road);
  const auto thresholds = theorems.thresholds(upright(p, road, kind));
  if (thresholds.empty()) return;
  const Rational on = thresholds[static_cast<std::size_t>(random.integer(0, static_cast<int>(thresholds.size()) - 1))];
  for (const int side : {0, 1, -1}) {
    road.f = on * (1 + Rational(side, 1000000));
    visit(p, road);
  }
}

/// Its centre of mass between the wheels. One in three has small numbers, so that several thresholds meet.
Bicycle<Rational> between_the_wheels(RandomScenes& random) {
  Bicycle<Rational> p = random.bicycle(true);
  p.b2 = random.positive();
  switch (random.integer(0, 5)) {
    case 0:
      p.I3 = p.I3 * 100;
      break;
    case 1:
    case 2:
      p.R = 1;
      for (Rational* number : {&p.M, &p.b2, &p.b3, &p.I2, &p.I3, &p.r1, &*p.J}) *number = random.integer(1, 3);
      for (Rational* number : {&p.h, &p.L, &p.I1}) *number = random.integer(0, 3);
      break;
    default:
      break;
  }
  return p;
}

}  // namespace

TEST_CASE("a force of the rider makes several motions where the two-wheeler's theorem says so") {
  const Theorems theorems("internal force");
  const std::vector<std::string_view> says{"T1.some", "T1.equal", "T2.some", "T2.equal",
                                           "T3.some", "T3.equal", "T4.some", "T4.equal"};
  RandomScenes random(1);
  int ambiguous = 0, unique = 0;
  for (int i = 0; i < wanted() / 4; ++i) {
    Bicycle<Rational> p = between_the_wheels(random);
    if (sign(p.L) == 0) continue;
    if (i % 3 == 0) p.r2 = p.r1;
    on_and_beside(theorems, p, random.road(), ForceKind::internal, random, [&](const auto& q, const auto& road) {
      const ModeTable table(q, road, ForceKind::internal);
      Evaluator<Rational> values = theorems.at(TwoWheeler(q, road, ForceKind::internal));
      const bool expected = theorems.any(says, values);
      CHECK(several(partition(table)) == expected);
      ++(expected ? ambiguous : unique);
    });
  }
  CHECK(ambiguous > wanted() / 10);
  CHECK(unique > wanted() / 10);
}

TEST_CASE("a force from outside makes several motions where the two-wheeler's theorem says so") {
  const Theorems theorems("external force");
  const std::vector<std::string_view> says{"X1.some",    "X2.some",   "X3.some.1",    "X3.some.2",
                                           "X3.touch.1", "X3.wall.1", "X3.continuum", "X4.some"};
  RandomScenes random(2);
  int ambiguous = 0, unique = 0;
  for (int i = 0; i < wanted() / 4; ++i) {
    Bicycle<Rational> p = between_the_wheels(random);
    p.r2 = p.r1;
    if (sign(p.h) == 0) continue;
    if (i % 4 == 0) p.L = p.R * random.fraction(-20, 20) / 20;
    if (i % 7 == 0) p.L = p.R;
    on_and_beside(theorems, p, random.road(), ForceKind::external, random, [&](const auto& q, const auto& road) {
      const ModeTable table(q, road, ForceKind::external);
      Evaluator<Rational> values = theorems.at(upright(q, road, ForceKind::external));
      const bool expected = theorems.any(says, values);
      CHECK(several(partition(table)) == expected);
      ++(expected ? ambiguous : unique);
    });
  }
  CHECK(ambiguous > wanted() / 10);
  CHECK(unique > wanted() / 10);
}

TEST_CASE("between the ends of its modes a two-wheeler has a motion more than twice its negative modes") {
  const Theorems theorems("any load");
  const std::vector<std::string_view> negative{"S1.negative", "S2.negative", "S3.negative",
                                               "S4.negative", "S5.negative", "S6.negative"};
  RandomScenes random(3);
  std::vector<int> found(8);
  int on_border = 0;
  for (int i = 0; i < wanted() / 4; ++i) {
    const ForceKind kind = i % 2 == 0 ? ForceKind::internal : ForceKind::external;
    Bicycle<Rational> p = random.bicycle(true);
    p.b3 = p.b3 - random.fraction(0, 1);
    if (sign(Rational(p.b2 + p.b3)) <= 0) continue;
    on_and_beside(theorems, p, random.road(), kind, random, [&](const auto& q, const auto& road) {
      const TwoWheeler reduced(q, road, kind);
      const ModeTable table(q, road, kind);
      for (const Cell& cell : partition(table)) {
        if (cell.forces.is_point()) continue;
        // On a border of its cone a motion counts as often as there are modes that have it. At an interval of forces
        // one stays there where forces do nothing and a wheel at rest bears nothing, or along a wall (X3.wall).
        if (std::any_of(cell.motions.begin(), cell.motions.end(), [](const auto& motion) { return !motion.strict; })) {
          ++on_border;
          continue;
        }
        const Rational force = cell.forces.sample();
        Evaluator<Rational> values = theorems.at(reduced, force), mirror = theorems.at(reduced.mirrored(), -force);
        std::size_t modes = 0;
        for (const std::string_view id : negative) {
          modes += theorems.met(id, values, true) + theorems.met(id, mirror, true);
        }
        CHECK(cell.continua.empty());
        CHECK(cell.motions.size() == 1 + 2 * modes);
        ++found[cell.motions.size()];
      }
    });
  }
  CHECK(found[1] > wanted());
  CHECK(found[3] > wanted() / 10);
  CHECK(found[5] > 0);
  CHECK(on_border < wanted() / 100);
}

TEST_CASE("motions occur together as the two-wheeler's theorems list them, and in all of these sets") {
  const ClaimsFile file = read_claims(SLIPPROOF_SOURCE_DIR "/proofs/two-wheeler/claims.toml");
  using Modes = std::set<std::string>;
  const auto listed = [&](std::string_view prefix) {
    std::set<Modes> sets;
    for (const Claim& claim : file.claims) {
      if (!claim.id.starts_with(prefix)) continue;
      Modes modes;
      for (const MechanismMode& mode : claim.printed.modes) modes.insert(name(mode));
      sets.insert(modes);
    }
    return sets;
  };
  const std::set<Modes> riders = listed("L5."), outside = listed("O10.");
  CHECK(riders.size() == 22);
  CHECK(outside.size() == 21);
  const Theorems internal("internal force"), external("external force");
  RandomScenes random(4);
  std::set<Modes> met;
  for (int i = 0; i < wanted() / 4; ++i) {
    const ForceKind kind = i % 2 == 0 ? ForceKind::internal : ForceKind::external;
    Bicycle<Rational> p = between_the_wheels(random);
    if (kind == ForceKind::external) {
      p.r2 = p.r1;
      p.L = p.L * random.integer(1, 4);
      if (sign(p.h) <= 0) continue;
    }
    const bool rider = kind == ForceKind::internal;
    on_and_beside(rider ? internal : external, p, random.road(), kind, random, [&](const auto& q, const auto& road) {
      for (const Cell& cell : partition(ModeTable(q, road, kind))) {
        const bool border =
            std::any_of(cell.motions.begin(), cell.motions.end(), [](const auto& m) { return !m.strict; });
        if (cell.forces.is_point() || border) continue;
        Modes modes;
        for (const auto& motion : cell.motions) modes.insert(name(motion.modes.front()));
        CHECK(modes.size() == cell.motions.size());
        if (modes.size() == 1) continue;
        CHECK((rider ? riders : outside).contains(modes));
        met.insert(modes);
      }
    });
  }
  CHECK(met.size() > 12);
}
