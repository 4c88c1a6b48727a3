// One bicycle: its motions by the mechanics' own modes (src/modes), each mode over all forces at once.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "meaning/claims.hpp"
#include "meaning/critical.hpp"
#include "modes/mode_table.hpp"

namespace slipproof::meaning {

/// constant + x X + t T, in the force variable X and the free parameter T of a continuum.
struct Plane {
  Rational constant, x, t;

  Rational at(const Rational& X, const Rational& T) const { return constant + x * X + t * T; }
  Polynomial polynomial(const std::string& X, const std::string& T) const;
  friend Plane operator+(const Plane& p, const Plane& q) { return {p.constant + q.constant, p.x + q.x, p.t + q.t}; }
  friend Plane operator*(const Rational& s, const Plane& p) { return {s * p.constant, s * p.x, s * p.t}; }
  friend Plane operator-(const Plane& p) { return Rational(-1) * p; }
  friend Plane operator-(const Plane& p, const Plane& q) { return p + -q; }
};

/// What meets a mode's equations.
struct Solutions {
  ContactMode mode;
  Motion<Plane> motion;
  std::vector<Plane> conditions;    ///< > 0 or >= 0 of what is a motion in the mode
  bool free = false;                ///< a solution for each T
  std::optional<Rational> only_at;  ///< the only force with solutions

  bool meets(const Rational& x, const Rational& t, bool strict) const;
  Motion<Rational> at(const Rational& x, const Rational& t) const;
  /// All T, or enough of them: zeros of conditions and of `more` (planes that matter beside), and what lies between.
  std::vector<Rational> parameters(const Rational& x, const std::vector<Plane>& more) const;
};

/// The motions at a force.
struct Motions {
  struct One {
    Motion<Rational> motion;
    std::vector<ContactMode> modes;  ///< in all of which it is
  };
  std::vector<One> single;
  std::vector<ContactMode> continua;  ///< modes with more than one

  /// 0, 1, or 2 for more.
  std::size_t in(ContactMode mode) const;
  /// Whether every motion is in one of these, each of which has no continuum.
  bool all_in(const std::vector<ContactMode>& modes) const;
  bool exactly_one() const { return continua.empty() && single.size() == 1; }
  bool none() const { return continua.empty() && single.empty(); }
};

class World {
 public:
  /// Nothing if the values are no bicycle of the setting.
  static std::unique_ptr<World> make(const Setting& setting, const std::map<std::string, Rational>& values);
  static bool is_bicycle(const Setting& setting, const std::map<std::string, Rational>& values);

  const Setting& setting() const { return setting_; }
  const Names& names() const { return names_; }
  const Bicycle<Rational>& bicycle() const { return bicycle_; }
  const Road<Rational>& road() const { return road_; }
  ForceKind kind() const { return setting_.external ? ForceKind::external : ForceKind::internal; }
  Rational pedal_force(const Rational& x) const { return offset_ + slope_ * x; }
  Names at(const Rational& x) const;

  /// Forces at which the motions can change.
  const std::set<Rational>& ends() const { return ends_; }
  bool modelled(ContactMode mode) const { return bicycle_.J || mode.on_road(); }
  /// Nothing if there are none, or the mode is not modelled.
  const Solutions* solutions(ContactMode mode) const;
  Motions motions(const Rational& x, bool strict) const;
  bool has_motion(ContactMode mode, const Rational& x) const;

 private:
  World(const Setting& setting, const std::map<std::string, Rational>& values) : setting_(setting) {
    names_.values = values;
    names_.definitions = {setting.definitions.begin(), setting.definitions.end()};
  }
  bool read_scene();  ///< false unless it is a bicycle
  void solve();
  void add(const ModeSolution& solution);
  void add_ends(const ForceInterval& pedal_forces);
  Rational variable(const Rational& F) const { return (F - offset_) / slope_; }
  Plane plane(const Affine<Rational>& value, const Rational& t = 0) const;

  const Setting& setting_;
  Names names_;
  Bicycle<Rational> bicycle_;
  Road<Rational> road_;
  Rational offset_, slope_;
  std::vector<Solutions> modes_;
  std::set<Rational> ends_;
};

}  // namespace slipproof::meaning
