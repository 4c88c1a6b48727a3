#include "meaning/world.hpp"

#include <algorithm>

#include "model/conditions.hpp"

namespace slipproof::meaning {

namespace {

bool contains(const std::vector<ContactMode>& modes, ContactMode mode) {
  return std::find(modes.begin(), modes.end(), mode) != modes.end();
}

/// "M > 0, R > 0, h > -R, b2 + b3 > 0, I1, I2, I3 >= 0, r1, r2 > 0, f >= 0, g > 0, and J > 0 where J is given"
bool in_domain(const Bicycle<Rational>& p, const Road<Rational>& road) {
  const bool frame = p.M > 0 && p.R > 0 && p.h > -p.R && p.b2 + p.b3 > 0;
  const bool bodies = p.I1 >= 0 && p.I2 >= 0 && p.I3 >= 0 && p.r1 > 0 && p.r2 > 0 && (!p.J || *p.J > 0);
  return frame && bodies && road.f >= 0 && road.g > 0;
}

/// The force at which two motions that are affine in it are the same.
std::optional<Rational> meeting(const Motion<Plane>& p, const Motion<Plane>& q) {
  std::optional<Rational> x;
  for (const Quantity quantity : all_quantities()) {
    const Plane difference = p[quantity] - q[quantity];
    if (difference.x == 0 && difference.constant == 0) continue;
    if (difference.x == 0) return std::nullopt;
    const Rational zero = -difference.constant / difference.x;
    if (x && *x != zero) return std::nullopt;
    x = zero;
  }
  return x;
}

}  // namespace

Polynomial Plane::polynomial(const std::string& X, const std::string& T) const {
  return Polynomial(constant) + Polynomial(x) * Polynomial::variable(X) + Polynomial(t) * Polynomial::variable(T);
}

bool Solutions::meets(const Rational& X, const Rational& t, bool strict) const {
  if (only_at && *only_at != X) return false;
  return std::all_of(conditions.begin(), conditions.end(), [&](const Plane& condition) {
    const Rational value = condition.at(X, t);
    return strict ? value > 0 : value >= 0;
  });
}

Motion<Rational> Solutions::at(const Rational& x, const Rational& t) const {
  Motion<Rational> result;
  for (const Quantity q : all_quantities()) result[q] = motion[q].at(x, t);
  return result;
}

std::vector<Rational> Solutions::parameters(const Rational& x, const std::vector<Plane>& more) const {
  if (!free) return {Rational(0)};
  std::set<Rational> points = {Rational(0)};
  std::vector<Plane> planes = conditions;
  planes.insert(planes.end(), more.begin(), more.end());
  for (const Plane& plane : planes) {
    if (plane.t != 0) points.insert(-(plane.constant + plane.x * x) / plane.t);
  }
  const std::vector<Rational> once = everywhere(points);
  return everywhere({once.begin(), once.end()});  // two motions at least between each two
}

std::size_t Motions::in(ContactMode mode) const {
  if (contains(continua, mode)) return 2;
  return static_cast<std::size_t>(
      std::count_if(single.begin(), single.end(), [&](const One& one) { return contains(one.modes, mode); }));
}

bool Motions::all_in(const std::vector<ContactMode>& modes) const {
  return continua.empty() && std::all_of(single.begin(), single.end(), [&](const One& one) {
           return std::any_of(modes.begin(), modes.end(), [&](ContactMode mode) { return contains(one.modes, mode); });
         });
}

std::unique_ptr<World> World::make(const Setting& setting, const std::map<std::string, Rational>& values) {
  std::unique_ptr<World> world(new World(setting, values));
  if (!world->read_scene()) return nullptr;
  world->solve();
  return world;
}

bool World::is_bicycle(const Setting& setting, const std::map<std::string, Rational>& values) {
  return World(setting, values).read_scene();
}

Names World::at(const Rational& x) const {
  Names names = names_;
  names.values[setting_.force] = x;
  return names;
}

bool World::read_scene() {
  for (const Parameter& parameter : setting_.parameters) {
    if (!is_true(truth_of(parameter.domain, names_))) return false;
  }
  std::map<std::string, Rational> values;
  for (const auto& [symbol, tree] : setting_.scene) {
    if (symbol == "F") continue;
    const Number value = number_of(tree, names_);
    if (!value) return false;
    values[symbol] = *value;
  }
  const auto of = [&](const char* symbol) { return values.at(symbol); };
  bicycle_ = {of("M"),  of("R"),  of("h"),  of("b2"), of("b3"), of("I1"),
              of("I2"), of("I3"), of("r1"), of("r2"), of("L"),  std::nullopt};
  if (values.contains("J")) bicycle_.J = of("J");
  road_ = {of("f"), of("g")};
  const Tree& force = setting_.scene.at("F");  // of degree 1 at most, as the random settings have it
  const Number at0 = number_of(force, at(0)), at1 = number_of(force, at(1));
  if (!at0 || !at1) return false;
  offset_ = *at0;
  slope_ = *at1 - *at0;
  return slope_ != 0 && in_domain(bicycle_, road_);
}

void World::solve() {
  const ModeTable table(bicycle_, road_, kind());
  for (const ModeSolution& solution : table.solutions()) add(solution);
  for (const Solutions& p : modes_) {
    for (const Solutions& q : modes_) {
      if (p.free || q.free || p.mode == q.mode) continue;
      if (const auto x = meeting(p.motion, q.motion)) ends_.insert(*x);
    }
  }
}

Plane World::plane(const Affine<Rational>& value, const Rational& t) const {
  return {value.alpha + value.beta * offset_, value.beta * slope_, t};
}

void World::add(const ModeSolution& solution) {
  if (solution.kind() == ModeSolution::Kind::none || solution.closed().empty()) return;
  add_ends(solution.closed());
  add_ends(solution.strict());
  Solutions result{solution.mode(), {}, {}, false, {}};
  if (solution.kind() == ModeSolution::Kind::regular) {
    for (const Quantity q : all_quantities()) result.motion[q] = plane(solution.quantity(q));
  } else {
    const Continuum& continuum = solution.continuum();
    if (continuum.directions.size() > 1) throw OutOfReach("a continuum of more than one parameter");
    result.free = !continuum.directions.empty();
    if (continuum.solvable.is_point()) result.only_at = variable(*continuum.solvable.lower());
    for (const Quantity q : all_quantities()) {
      result.motion[q] = plane(continuum.base[q], result.free ? continuum.directions[0][q] : Rational(0));
    }
  }
  for (const Condition& condition : slipproof::conditions(result.mode)) {
    result.conditions.push_back(condition_value(condition, result.motion, road_.f));
  }
  modes_.push_back(std::move(result));
}

void World::add_ends(const ForceInterval& pedal_forces) {
  for (const auto& end : {pedal_forces.lower(), pedal_forces.upper()}) {
    if (end) ends_.insert(variable(*end));
  }
}

const Solutions* World::solutions(ContactMode mode) const {
  const auto found = std::find_if(modes_.begin(), modes_.end(), [&](const Solutions& s) { return s.mode == mode; });
  return found == modes_.end() ? nullptr : &*found;
}

Motions World::motions(const Rational& x, bool strict) const {
  Motions result;
  for (const Solutions& mode : modes_) {
    std::vector<Rational> met;
    for (const Rational& t : mode.parameters(x, {})) {
      if (mode.meets(x, t, strict)) met.push_back(t);
    }
    if (met.empty()) continue;
    // What meets strict conditions still does nearby; of an interval with its ends more than one T was met.
    if (mode.free && (strict || met.size() > 1)) {
      result.continua.push_back(mode.mode);
      continue;
    }
    const Motion<Rational> motion = mode.at(x, met.front());
    const auto same = std::find_if(result.single.begin(), result.single.end(),
                                   [&](const Motions::One& one) { return one.motion == motion; });
    if (same != result.single.end()) {
      same->modes.push_back(mode.mode);
    } else {
      result.single.push_back({motion, {mode.mode}});
    }
  }
  return result;
}

bool World::has_motion(ContactMode mode, const Rational& x) const {
  const Solutions* found = solutions(mode);
  if (found == nullptr) return false;
  const std::vector<Rational> parameters = found->parameters(x, {});
  return std::any_of(parameters.begin(), parameters.end(),
                     [&](const Rational& t) { return found->meets(x, t, setting_.strict); });
}

}  // namespace slipproof::meaning
