// One point of a mechanism: its motions, each mode over all forces at once, by elimination.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "claims/meaning/second_judge/claims.hpp"
#include "claims/meaning/second_judge/critical.hpp"
#include "claims/meaning/second_judge/linear.hpp"

namespace slipproof::meaning {

/// constant + x X + t T, in the force variable X and the free parameter T of a mode.
struct Plane {
  Rational constant, x, t;

  Rational at(const Rational& X, const Rational& T) const { return constant + x * X + t * T; }
  Polynomial polynomial(const std::string& X, const std::string& T) const;
  friend Plane operator+(const Plane& p, const Plane& q) { return {p.constant + q.constant, p.x + q.x, p.t + q.t}; }
  friend Plane operator*(const Rational& s, const Plane& p) { return {s * p.constant, s * p.x, s * p.t}; }
  friend Plane operator-(const Plane& p, const Plane& q) { return p + Rational(-1) * q; }
};

/// The quantities of a motion, by name.
using Motion = std::map<std::string, Rational>;

/// What meets a mode's equations.
struct Solutions {
  Mode mode;
  std::map<std::string, Plane> motion;
  std::vector<Plane> conditions;    ///< > 0 or >= 0 of what is a motion in the mode
  bool free = false;                ///< a solution for each T
  bool moves = false;               ///< accelerations vary with T: a continuum; else only forces do
  std::optional<Rational> only_at;  ///< the only force with solutions

  bool meets(const Rational& x, const Rational& t, bool strict) const;
  Motion at(const Rational& x, const Rational& t) const;
  /// All T, or enough of them: zeros of conditions and of `more` (planes that matter beside), and what lies between.
  std::vector<Rational> parameters(const Rational& x, const std::vector<Plane>& more) const;
  /// Forces at which it can change whether there is a motion.
  std::set<Rational> ends() const;
};

/// The motions at a force.
struct Motions {
  struct One {
    Motion accelerations;     ///< a motion is its accelerations
    std::vector<Mode> modes;  ///< in all of which it is
  };
  std::vector<One> single;
  std::vector<Mode> continua;  ///< modes with more than one

  /// 0, 1, or 2 for more.
  std::size_t in(const Mode& mode) const;
  /// Whether every motion is in one of these, each of which has no continuum.
  bool all_in(const std::vector<Mode>& modes) const;
  bool exactly_one() const { return continua.empty() && single.size() == 1; }
  bool none() const { return continua.empty() && single.empty(); }
};

class World {
 public:
  /// Nothing if the values are no point of the setting.
  static std::unique_ptr<World> make(const Setting& setting, const std::map<std::string, Rational>& values);
  static bool is_bicycle(const Setting& setting, const std::map<std::string, Rational>& values);
  /// Numbers and conditions, over the setting's symbols, that make a point of the mechanism.
  static std::vector<Tree> of_points(const Setting& setting);

  const Setting& setting() const { return setting_; }
  const Names& names() const { return names_; }
  Names at(const Rational& x) const;
  /// The setting's, and that of the mechanism's load.
  const Tree& force_domain() const { return force_domain_; }

  const std::vector<std::string>& unknowns() const { return unknowns_; }
  bool is_unknown(const std::string& name) const;
  /// Names that `holds` knows: unknowns, gaps, slips.
  const std::vector<std::string>& quantities() const { return quantities_; }
  bool is_quantity(const std::string& name) const;
  std::size_t force_column() const { return unknowns_.size(); }
  std::size_t constant_column() const { return unknowns_.size() + 1; }
  /// The mechanism's equations with no contact open; with a mode, those of its elements, too.
  Rows model_rows(const std::optional<Mode>& mode) const;

  /// Forces at which the motions can change.
  const std::set<Rational>& ends() const { return ends_; }
  const std::vector<Mode>& modes() const { return all_modes_; }
  bool modelled(const Mode& mode) const;
  bool everything_modelled() const;
  /// Nothing if there are none, or the mode is not modelled.
  const Solutions* solutions(const Mode& mode) const;
  Motions motions(const Rational& x, bool strict) const;
  bool has_motion(const Mode& mode, const Rational& x) const;

 private:
  /// An element at this point.
  struct Element {
    Row gap, slip, normal, tangent, static_limit, kinetic_limit;
    std::vector<ElementState> states;
    bool contact = true, limited = false, slides = false, starts_open = false, lift_modelled = true;
  };

  World(const Setting& setting, const std::map<std::string, Rational>& values);
  bool read_point();  ///< false unless it is one
  bool read_load(const Tree& load);
  bool read_bicycle();
  bool read_mechanics();
  std::optional<Row> row(const Sum& sum, const Names& names) const;
  Row unit(const std::string& unknown) const;
  void name_quantity(const std::string& name, const Row& row);
  void solve();
  void add(const Mode& mode);
  Rows equations(std::size_t element, ElementState state) const;
  Rows conditions(std::size_t element, ElementState state) const;

  const Setting& setting_;
  Names names_;
  Tree force_domain_;
  Rational offset_ = 0, slope_ = 0;  ///< of the load in the force variable
  std::vector<std::string> unknowns_, accelerations_, quantities_;
  std::map<std::string, Row> forms_;  ///< of quantities
  Rows equations_;
  std::vector<Element> elements_;
  std::vector<Mode> all_modes_;
  std::vector<Solutions> modes_;
  std::set<Rational> ends_;
};

}  // namespace slipproof::meaning
