#include "claims/meaning/second_judge/world.hpp"

#include <algorithm>

#include "support/bicycle/linear_form.hpp"

namespace slipproof::meaning {

namespace {

bool contains(const std::vector<Mode>& modes, const Mode& mode) {
  return std::find(modes.begin(), modes.end(), mode) != modes.end();
}

/// The force at which two motions that are affine in it have the same accelerations.
std::optional<Rational> meeting(const Solutions& p, const Solutions& q, const std::vector<std::string>& accelerations) {
  std::optional<Rational> x;
  for (const std::string& name : accelerations) {
    const Plane difference = p.motion.at(name) - q.motion.at(name);
    if (difference.x == 0 && difference.constant == 0) continue;
    if (difference.x == 0) return std::nullopt;
    const Rational zero = -difference.constant / difference.x;
    if (x && *x != zero) return std::nullopt;
    x = zero;
  }
  return x;
}

Row added(Row row, const Rational& factor, const Row& other) {
  for (std::size_t i = 0; i < row.size(); ++i) row[i] += factor * other[i];
  return row;
}

/// The mechanism's symbols replaced by what they are in the paper's.
Tree in_paper(const Tree& tree, const Setting& setting) {
  if (tree->op == Op::symbol) {
    const auto value = setting.scene.find(tree->symbol);
    if (value != setting.scene.end()) return value->second;
    for (const auto& [symbol, definition] : setting.mechanics->definitions) {
      if (symbol == tree->symbol) return in_paper(definition, setting);
    }
    return number(0);  // a parameter that is not given
  }
  Node node = *tree;
  for (Tree& part : node.parts) part = in_paper(part, setting);
  return std::make_shared<const Node>(std::move(node));
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

Motion Solutions::at(const Rational& x, const Rational& t) const {
  Motion result;
  for (const auto& [name, plane] : motion) result[name] = plane.at(x, t);
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

std::set<Rational> Solutions::ends() const {
  std::set<Rational> result;
  if (only_at) result.insert(*only_at);
  for (const Plane& p : conditions) {
    if (p.t == 0 && p.x != 0) result.insert(-p.constant / p.x);
    for (const Plane& q : conditions) {  // where they meet
      const Rational x = p.x * q.t - q.x * p.t;
      if (x != 0) result.insert((q.constant * p.t - p.constant * q.t) / x);
    }
  }
  return result;
}

std::size_t Motions::in(const Mode& mode) const {
  if (contains(continua, mode)) return 2;
  return static_cast<std::size_t>(
      std::count_if(single.begin(), single.end(), [&](const One& one) { return contains(one.modes, mode); }));
}

bool Motions::all_in(const std::vector<Mode>& modes) const {
  return continua.empty() && std::all_of(single.begin(), single.end(), [&](const One& one) {
           return std::any_of(modes.begin(), modes.end(), [&](const Mode& mode) { return contains(one.modes, mode); });
         });
}

World::World(const Setting& setting, const std::map<std::string, Rational>& values) : setting_(setting) {
  names_.values = values;
  names_.definitions = {setting.definitions.begin(), setting.definitions.end()};
  force_domain_ = setting.force_domain;
  if (setting.mechanics && setting.mechanics->load_domain) {
    force_domain_ = meaning::make(Op::conjunction, {force_domain_, in_paper(setting.mechanics->load_domain, setting)});
  }
  if (!setting.angle) return;
  const Rational t = values.at("beta"), below = 1 + t * t;
  names_.values["cb"] = (1 - t * t) / below;
  names_.values["sb"] = 2 * t / below;
}

std::unique_ptr<World> World::make(const Setting& setting, const std::map<std::string, Rational>& values) {
  std::unique_ptr<World> world(new World(setting, values));
  if (!world->read_point()) return nullptr;
  world->solve();
  return world;
}

bool World::is_bicycle(const Setting& setting, const std::map<std::string, Rational>& values) {
  return World(setting, values).read_point();
}

std::vector<Tree> World::of_points(const Setting& setting) {
  std::vector<Tree> result;
  for (const Parameter& parameter : setting.parameters) result.push_back(parameter.domain);
  if (setting.angle) result.push_back(setting.angle);
  const auto& scene = setting.scene;
  for (const auto& [symbol, value] : scene) {
    const bool load = symbol == (setting.mechanics ? setting.mechanics->load : "F");
    if (!load) result.push_back(setting.mechanics ? value : compare(value, ">", number(0)));
  }
  if (!setting.mechanics) {
    result.push_back(compare(plus(scene.at("h"), scene.at("R")), ">", number(0)));
    result.push_back(compare(plus(scene.at("b2"), scene.at("b3")), ">", number(0)));
    return result;
  }
  const Mechanics& mechanics = *setting.mechanics;
  for (const Parameter& parameter : mechanics.parameters) result.push_back(in_paper(parameter.domain, setting));
  if (mechanics.assume) result.push_back(in_paper(mechanics.assume, setting));
  for (const Tree& coefficient : mechanics.coefficients()) result.push_back(in_paper(coefficient, setting));
  if (mechanics.angle) {
    result.push_back(compare(plus(power(scene.at("c"), 2), power(scene.at("s"), 2)), "=", number(1)));
  }
  return result;
}

Names World::at(const Rational& x) const {
  Names names = names_;
  names.values[setting_.force] = x;
  return names;
}

bool World::is_unknown(const std::string& name) const {
  return std::find(unknowns_.begin(), unknowns_.end(), name) != unknowns_.end();
}

bool World::is_quantity(const std::string& name) const {
  return forms_.contains(name);
}

bool World::read_point() {
  for (const Parameter& parameter : setting_.parameters) {
    if (!is_true(truth_of(parameter.domain, names_))) return false;
  }
  if (setting_.angle && !is_true(truth_of(setting_.angle, names_))) return false;
  return setting_.mechanics ? read_mechanics() : read_bicycle();
}

/// Of degree 1 at most, as the random settings have it.
bool World::read_load(const Tree& load) {
  const Number at0 = number_of(load, at(0)), at1 = number_of(load, at(1));
  if (!at0 || !at1) return false;
  offset_ = *at0;
  slope_ = *at1 - *at0;
  return slope_ != 0;
}

/// "M > 0, R > 0, h > -R, b2 + b3 > 0, I1, I2, I3 >= 0, r1, r2 > 0, f >= 0, g > 0, and J > 0 where J is given"
bool World::read_bicycle() {
  std::map<std::string, Rational> values;
  for (const auto& [symbol, tree] : setting_.scene) {
    if (symbol == "F") continue;
    const Number value = number_of(tree, names_);
    if (!value) return false;
    values[symbol] = *value;
  }
  const auto of = [&](const char* symbol) { return values.at(symbol); };
  const bool J = values.contains("J");
  Bicycle<Rational> p = {of("M"),  of("R"),  of("h"),  of("b2"), of("b3"), of("I1"),
                         of("I2"), of("I3"), of("r1"), of("r2"), of("L"),  std::nullopt};
  if (J) p.J = of("J");
  const Road<Rational> road{of("f"), of("g")};
  const bool frame = p.M > 0 && p.R > 0 && p.h > -p.R && p.b2 + p.b3 > 0;
  const bool bodies = p.I1 >= 0 && p.I2 >= 0 && p.I3 >= 0 && p.r1 > 0 && p.r2 > 0 && (!p.J || *p.J > 0);
  if (!frame || !bodies || road.f < 0 || road.g <= 0 || !read_load(setting_.scene.at("F"))) return false;
  unknowns_ = {"a", "a_y", "phi", "eps1", "eps2", "eps3", "T", "S2", "S3", "N2", "N3"};
  accelerations_ = {"a", "a_y", "phi", "eps1", "eps2", "eps3"};
  for (const std::string& unknown : unknowns_) name_quantity(unknown, unit(unknown));
  const auto system = raw_system(p, road, setting_.external ? ForceKind::external : ForceKind::internal, ContactMode{});
  for (const auto& form : system) {
    Row row(form.coefficients.begin(), form.coefficients.end());
    row.push_back(form.constant + row.back() * offset_);
    row[force_column()] *= slope_;
    equations_.push_back(std::move(row));
  }
  for (const char* wheel : {"2", "3"}) {  // rolling: gap and slip of each
    Element& element = elements_.emplace_back();
    const std::size_t first = *wheel == '2' ? 7 : 9;
    element.gap = equations_[first];
    element.slip = equations_[first + 1];
    element.normal = unit(std::string("N") + wheel);
    element.tangent = unit(std::string("S") + wheel);
    element.static_limit = element.kinetic_limit = added(Row(constant_column() + 1), road.f, element.normal);
    using enum ElementState;
    element.states = {stick, slip_forward, slip_backward, lift};
    element.limited = true;
    element.lift_modelled = J;
    for (const auto& [what, row] : {std::pair{"gap", element.gap}, {"slip", element.slip}}) {
      name_quantity(std::string(what) + wheel, row);
      accelerations_.push_back(std::string(what) + wheel);
    }
  }
  equations_.resize(7);
  return true;
}

Row World::unit(const std::string& unknown) const {
  Row row(constant_column() + 1);
  row[static_cast<std::size_t>(std::find(unknowns_.begin(), unknowns_.end(), unknown) - unknowns_.begin())] = 1;
  return row;
}

void World::name_quantity(const std::string& name, const Row& row) {
  quantities_.push_back(name);
  forms_[name] = row;
}

std::optional<Row> World::row(const Sum& sum, const Names& names) const {
  Row result(constant_column() + 1);
  for (const auto& [coefficient, what] : sum) {
    const Number value = number_of(coefficient, names);
    if (!value) return std::nullopt;
    if (what.empty()) {
      result[constant_column()] += *value;
    } else if (what == setting_.mechanics->load) {
      result[force_column()] += *value * slope_;
      result[constant_column()] += *value * offset_;
    } else {
      result = added(std::move(result), *value, unit(what));
    }
  }
  return result;
}

/// "The expressions have values that satisfy the domains of its parameters and angles and all of [assume], every
/// coefficient has a value, and the load is of degree 1 in the force variable."
bool World::read_mechanics() {
  const Mechanics& mechanics = *setting_.mechanics;
  Names names;
  names.definitions = {mechanics.definitions.begin(), mechanics.definitions.end()};
  bool J = true;
  for (const auto& [symbol, tree] : setting_.scene) {
    if (symbol == mechanics.load) continue;
    const Number value = number_of(tree, names_);
    if (!value) return false;
    names.values[symbol] = *value;
  }
  for (const Parameter& parameter : mechanics.parameters) {
    if (!setting_.scene.contains(parameter.symbol)) {
      J = false;
      names.values[parameter.symbol] = 0;
    } else if (!is_true(truth_of(parameter.domain, names))) {
      return false;
    }
  }
  if (mechanics.angle) {
    const Rational c = names.values.at("c"), s = names.values.at("s");
    if (c * c + s * s != 1) return false;
  }
  if (mechanics.assume && !is_true(truth_of(mechanics.assume, names))) return false;
  if (!mechanics.load.empty() && !read_load(setting_.scene.at(mechanics.load))) return false;
  for (const Tree& coefficient : mechanics.coefficients()) {
    if (!number_of(coefficient, names)) return false;
  }
  unknowns_ = mechanics.unknowns();
  accelerations_ = mechanics.accelerations;
  for (const std::string& unknown : unknowns_) name_quantity(unknown, unit(unknown));
  for (std::size_t i = 0; i < mechanics.equations.size(); ++i) {
    Row equation = added(*row(mechanics.equations[i].left, names), -1, *row(mechanics.equations[i].right, names));
    equations_.push_back(added(std::move(equation), -1, *row(mechanics.contact_forces(i), names)));
  }
  for (const Mechanics::Link& link : mechanics.links) equations_.push_back(*row(link.zero, names));
  for (const Mechanics::Element& given : mechanics.elements) {
    Element element;
    element.contact = given.is_contact();
    element.limited = !given.is_contact() || given.static_friction;
    element.slides =
        given.start == ElementKind::Start::slides_forward || given.start == ElementKind::Start::slides_backward;
    element.starts_open = given.start == ElementKind::Start::open;
    element.lift_modelled = J || !given.lift_needs_J;
    element.states = states_of(given);
    element.gap = *row(given.gap, names);
    element.slip = *row(given.slip, names);
    if (given.is_contact()) element.normal = unit(given.normal());
    if (element.limited) element.tangent = unit(given.tangent());
    if (given.static_friction) {
      const Row none(constant_column() + 1);
      element.static_limit = added(none, *number_of(given.static_friction, names), element.normal);
      element.kinetic_limit = added(none, *number_of(given.kinetic_friction, names), element.normal);
    } else {
      element.static_limit = *row(given.static_limit, names);
      element.kinetic_limit = *row(given.kinetic_limit, names);
    }
    const auto add = [&](const std::string& name, const Row& form) {
      name_quantity(name, form);
      accelerations_.push_back(name);
    };
    if (!given.gap.empty()) add("gap_" + given.name, element.gap);
    if (!given.slip.empty()) add("slip_" + given.name, element.slip);
    elements_.push_back(std::move(element));
  }
  return true;
}

Rows World::equations(std::size_t index, ElementState state) const {
  const Element& e = elements_[index];
  Rows result;
  if (state == ElementState::lift) {
    result.push_back(e.normal);
    if (e.limited) result.push_back(e.tangent);
    return result;
  }
  if (e.contact) result.push_back(e.gap);
  if (!e.limited) return result;
  const int sign = slip_direction(state);
  if (sign == 0) {
    result.push_back(e.slip);
  } else {  // S = -mu N where it slips forwards; of a guide that pulls, with -N
    result.push_back(added(e.tangent, is_pulled(state) ? -sign : sign, e.kinetic_limit));
  }
  return result;
}

Rows World::conditions(std::size_t index, ElementState state) const {
  const Element& e = elements_[index];
  const bool bilateral = std::find(e.states.begin(), e.states.end(), ElementState::lift) == e.states.end();
  const Row none(constant_column() + 1);
  Rows result;
  if (state == ElementState::lift) return e.starts_open ? Rows{} : Rows{e.gap};
  const Rational pull = is_pulled(state) ? -1 : 1;
  if (e.contact && !(state == ElementState::touch && bilateral)) result.push_back(added(none, pull, e.normal));
  if (!e.limited) return result;
  const int sign = slip_direction(state);
  if (sign == 0) {
    const Row limit = added(none, pull, e.static_limit);
    result.insert(result.end(), {added(limit, -1, e.tangent), added(limit, 1, e.tangent)});
  } else if (!e.slides) {
    result.push_back(added(none, sign, e.slip));
  }
  if (!e.contact) result.insert(result.end(), {e.static_limit, e.kinetic_limit});
  return result;
}

Rows World::model_rows(const std::optional<Mode>& mode) const {
  Rows rows = equations_;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    if (mode) {
      for (Row& row : equations(i, (*mode)[i])) rows.push_back(std::move(row));
    } else if (elements_[i].contact && !elements_[i].starts_open) {
      rows.push_back(elements_[i].gap);
    }
  }
  return rows;
}

void World::solve() {
  all_modes_ = {Mode{}};
  for (const Element& element : elements_) {
    std::vector<Mode> longer;
    for (const Mode& mode : all_modes_) {
      for (const ElementState state : element.states) {
        longer.push_back(mode);
        longer.back().push_back(state);
      }
    }
    all_modes_ = std::move(longer);
  }
  for (const Mode& mode : all_modes_) {
    if (modelled(mode)) add(mode);
  }
  for (const Solutions& p : modes_) {
    for (const Solutions& q : modes_) {
      if (p.moves || q.moves || p.mode == q.mode) continue;
      if (const auto x = meeting(p, q, accelerations_)) ends_.insert(*x);
    }
  }
}

void World::add(const Mode& mode) {
  Solutions result{mode, {}, {}, false, false, {}};
  const Echelon echelon(model_rows(mode), first_columns(unknowns_.size()));
  for (const Row& row : echelon.rest()) {
    if (row[force_column()] == 0) return;
    const Rational x = -row[constant_column()] / row[force_column()];
    if (result.only_at && *result.only_at != x) return;
    result.only_at = x;
  }
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    if (echelon.begins_in(i) == nullptr) open.push_back(i);
  }
  if (open.size() > 1) throw OutOfReach("solutions of more than one parameter");
  result.free = !open.empty();
  std::vector<Plane> values;
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    const Row* row = echelon.begins_in(i);
    if (row == nullptr) {
      values.push_back({0, 0, 1});
    } else {
      const Rational t = open.empty() ? Rational(0) : Rational(-(*row)[open.front()]);
      values.push_back({-(*row)[constant_column()], -(*row)[force_column()], t});
    }
  }
  const auto plane = [&](const Row& row) {
    Plane sum{row[constant_column()], row[force_column()], 0};
    for (std::size_t i = 0; i < values.size(); ++i) sum = sum + row[i] * values[i];
    return sum;
  };
  for (const auto& [name, form] : forms_) result.motion[name] = plane(form);
  result.moves = std::any_of(accelerations_.begin(), accelerations_.end(),
                             [&](const std::string& name) { return result.motion.at(name).t != 0; });
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    for (const Row& condition : conditions(i, mode[i])) result.conditions.push_back(plane(condition));
  }
  const std::set<Rational> ends = result.ends();
  const std::vector<Rational> places = everywhere(ends);
  const bool any = std::any_of(places.begin(), places.end(), [&](const Rational& x) {
    const std::vector<Rational> all = result.parameters(x, {});
    return std::any_of(all.begin(), all.end(), [&](const Rational& t) { return result.meets(x, t, false); });
  });
  if (!any) return;
  ends_.insert(ends.begin(), ends.end());
  modes_.push_back(std::move(result));
}

bool World::modelled(const Mode& mode) const {
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    if (mode[i] == ElementState::lift && !elements_[i].lift_modelled) return false;
  }
  return true;
}

bool World::everything_modelled() const {
  return std::all_of(all_modes_.begin(), all_modes_.end(), [&](const Mode& mode) { return modelled(mode); });
}

const Solutions* World::solutions(const Mode& mode) const {
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
    if (mode.moves && (strict || met.size() > 1)) {
      result.continua.push_back(mode.mode);
      continue;
    }
    Motion accelerations;
    for (const std::string& name : accelerations_) accelerations[name] = mode.motion.at(name).at(x, met.front());
    const auto same = std::find_if(result.single.begin(), result.single.end(),
                                   [&](const Motions::One& one) { return one.accelerations == accelerations; });
    if (same != result.single.end()) {
      same->modes.push_back(mode.mode);
    } else {
      result.single.push_back({std::move(accelerations), {mode.mode}});
    }
  }
  return result;
}

bool World::has_motion(const Mode& mode, const Rational& x) const {
  const Solutions* found = solutions(mode);
  if (found == nullptr) return false;
  const std::vector<Rational> parameters = found->parameters(x, {});
  return std::any_of(parameters.begin(), parameters.end(),
                     [&](const Rational& t) { return found->meets(x, t, setting_.strict); });
}

}  // namespace slipproof::meaning
