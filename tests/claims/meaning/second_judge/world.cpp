#include "claims/meaning/second_judge/world.hpp"

#include <algorithm>

namespace slipproof::meaning {

namespace {

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
