#include <set>
#include <utility>

#include "base/expression/extent.hpp"
#include "mechanics/reading/reader.hpp"

namespace slipproof::mechanism_reader {

namespace {

using Kind = NameKind;
constexpr NameKinds constants = Kind::parameter | Kind::angle;
constexpr NameKinds derived = constants | Kind::definition;
constexpr NameKinds velocities = derived | Kind::acceleration;
constexpr NameKinds motion = derived | Kind::load | Kind::acceleration;
constexpr NameKinds limit = derived | Kind::load | Kind::force | Kind::element_force;
constexpr NameKinds pushes = derived | Kind::load;
constexpr NameKinds applied = motion | Kind::force;
constexpr NameKinds anything = applied | Kind::element_force;

std::string_view allowed_words(NameKinds allowed) {
  if (allowed == constants) return "parameters and angles";
  if (allowed == derived) return "parameters, angles and definitions";
  if (allowed == velocities) return "accelerations and parameters";
  if (allowed == motion) return "accelerations, the load and parameters";
  if (allowed == pushes) return "parameters, angles, definitions and the load";
  if (allowed == limit) return "forces, the load and parameters";
  if (allowed == applied || allowed == anything) return "unknowns, the load and parameters";
  return "parameters, angles and the load";
}

class UseCheck {
 public:
  explicit UseCheck(Context& context)
      : context_(context), names_(context.mechanism), extents_(context.mechanism.definitions.size()) {
    for (const MechanismDefinition& definition : context.mechanism.definitions) {
      uses_.emplace_back();
      if (!definition.expression) continue;
      for (const std::string& symbol : symbols(definition.expression.expression)) {
        const auto entry = names_.find(symbol);
        if (entry && entry->kind == Kind::definition) uses_.back().push_back(entry->index);
      }
    }
  }

  void check() {
    Mechanism& m = context_.mechanism;
    for (MechanismParameter& parameter : m.parameters) one(parameter.domain, "domain", constants);
    for (MechanismAngle& angle : m.angles) one(angle.domain, "domain", constants);
    for (std::size_t i = 0; i < m.definitions.size(); ++i) definition(i);
    for (MechanismCondition& condition : m.assume) one(condition.condition, condition.name, derived);
    for (MechanismCondition& condition : m.realisable) one(condition.condition, condition.name, derived);
    if (m.load) {
      for (PlacedExpression& domain : m.load->domain) one(domain, "domain", constants | Kind::definition | Kind::load);
    }
    for (MechanismContact& contact : m.contacts) check(contact);
    for (MechanismFriction& friction : m.friction) {
      one(friction.slip, "slip", motion);
      two(friction.static_limit, friction.kinetic_limit, "limit", limit);
    }
    for (MechanismLink& link : m.links) one(link.zero, "zero", motion);
    for (MechanismEquation& equation : m.equations) {
      one(equation.left, equation.name, m.by_virtual_work ? applied : anything);
      one(equation.right, equation.name, m.by_virtual_work ? applied : anything);
    }
    one(m.energy, "energy", velocities);
    for (MechanismShape& shape : m.shapes) {
      for (auto& point : shape.points) all(point, "points");
      one(shape.radius, "radius", derived);
      one(shape.force, "force", pushes);
      if (!shape.acceleration.empty()) check_shown(shape);
    }
  }

  /// What equations follow from.
  void check(Bodies& scene) {
    visit_expressions(scene, [&](PlacedExpression& placed, std::string_view key, bool load) {
      one(placed, key, load ? pushes : derived);
    });
  }

 private:
  void check(MechanismContact& contact) {
    one(contact.gap, "gap", motion);
    one(contact.slip, "slip", motion);
    if (contact.second) one(contact.second->slip, "slip", motion);
    two(contact.static_friction, contact.kinetic_friction, "friction", derived);
    all(contact.at, "at");
    all(contact.direction, "direction");
    all(contact.slip_direction, "slip_direction");
  }
  void check_shown(const MechanismShape& shape) {
    constexpr NameKinds shown = Kind::acceleration | Kind::quantity;
    const auto entry = names_.find(shape.acceleration);
    if (entry && contains(shown, entry->kind)) return;
    context_.mistakes.add(shape.place,
                          "acceleration: " + unknown_name("acceleration", shape.acceleration, names_.names(shown)));
  }
  void all(std::vector<PlacedExpression>& list, std::string_view key) {
    for (PlacedExpression& item : list) one(item, key, derived);
  }
  /// Two that are the same where the file gives one.
  void two(PlacedExpression& first, PlacedExpression& second, std::string_view key, NameKinds allowed) {
    const bool both = first.expression == second.expression;
    one(first, key, allowed);
    if (both) {
      second = first;
    } else {
      one(second, key, allowed);
    }
  }

  /// A definition may use those before it.
  void definition(std::size_t index) {
    MechanismDefinition& definition = context_.mechanism.definitions[index];
    PlacedExpression& placed = definition.expression;
    const bool below = placed && uses_below(index);
    one(placed, definition.symbol, derived);
    if (below) placed.expression = nullptr;
    extents_[index] = placed ? extent(placed.expression) : Extent{};
  }

  /// Reports the first definition in this one that is not above it.
  bool uses_below(std::size_t index) {
    const MechanismDefinition& definition = context_.mechanism.definitions[index];
    for (const std::size_t used : uses_[index]) {
      if (used < index) continue;
      const std::string& symbol = context_.mechanism.definitions[used].symbol;
      std::string message = "found the definition " + symbol + ", which stands below, expected those above only";
      if (in_circle(index, used)) {
        message = "defines " + definition.symbol + " in a circle, by " + (used == index ? "itself" : symbol);
      }
      refuse(definition.expression, find(definition.expression.expression, symbol), definition.symbol, message);
      uses_[index].clear();  // report a circle once
      return true;
    }
    return false;
  }

  /// Whether definition `from` is needed by definition `by`, directly or through others.
  bool in_circle(std::size_t from, std::size_t by) const {
    std::vector<std::size_t> open{by};
    std::vector<bool> seen(context_.mechanism.definitions.size());
    while (!open.empty()) {
      const std::size_t next = open.back();
      open.pop_back();
      if (next == from) return true;
      if (seen[next]) continue;
      seen[next] = true;
      open.insert(open.end(), uses_[next].begin(), uses_[next].end());
    }
    return false;
  }

  static Expression find(const Expression& expression, const std::string& symbol) {
    if (is_symbol(expression, symbol)) return expression;
    for (const Expression& operand : expression->operands) {
      if (Expression found = find(operand, symbol)) return found;
    }
    return nullptr;
  }

  void refuse(const PlacedExpression& placed, const Expression& part, std::string_view key,
              const std::string& message) {
    context_.refuse(placed, part, key, message);
    context_.sound = false;
  }

  void one(PlacedExpression& placed, std::string_view key, NameKinds allowed) {
    if (!placed) return;
    bool fine = walk(placed, placed.expression, key, allowed);
    const std::string message = fine ? too_large(extent(placed.expression)) : std::string();
    if (!message.empty()) {
      refuse(placed, placed.expression, key, message);
      fine = false;
    }
    if (!fine) placed.expression = nullptr;
  }

  bool walk(const PlacedExpression& placed, const Expression& expression, std::string_view key, NameKinds allowed) {
    bool fine = true;
    for (const Expression& operand : expression->operands) fine = walk(placed, operand, key, allowed) && fine;
    if (expression->operation != Operation::symbol) return fine;
    const std::string& symbol = expression->symbol;
    const auto entry = names_.find(symbol);
    if (entry && contains(allowed, entry->kind)) return fine;
    if (entry && allowed == applied && entry->kind == Kind::element_force) {
      refuse(placed, expression, key,
             "found " + std::string(describe(entry->kind)) + " " + symbol +
                 ", expected the equation without it: it is added by virtual work");
    } else if (entry) {
      refuse(placed, expression, key,
             "found " + std::string(describe(entry->kind)) + " " + symbol + ", expected " +
                 std::string(allowed_words(allowed)));
    } else {
      constexpr std::size_t enough = 200;  // to look for near names takes its time
      const bool search = ++unknown_ <= enough;
      const auto known = search ? names_.names(allowed) : std::vector<std::string_view>{};
      refuse(placed, expression, key, unknown_name("symbol", symbol, known));
    }
    return false;
  }

  Extent extent(const Expression& expression) const {
    return slipproof::extent(expression, [&](const std::string& symbol) -> std::optional<Extent> {
      const auto entry = names_.find(symbol);
      if (!entry || entry->kind != Kind::definition) return std::nullopt;
      return extents_[entry->index];
    });
  }

  Context& context_;
  MechanismNames names_;
  std::vector<Extent> extents_;                 ///< by definition
  std::vector<std::vector<std::size_t>> uses_;  ///< by definition, the definitions in it
  std::size_t unknown_ = 0;                     ///< symbols so far
};

void collect(const PlacedExpression& placed, std::set<std::string>& used) {
  if (!placed) return;
  for (std::string& symbol : symbols(placed.expression)) used.insert(std::move(symbol));
}

/// The symbols in equations, gaps, slips and zeros.
std::set<std::string> symbols_of_motion(const Mechanism& mechanism) {
  std::set<std::string> used;
  for (const MechanismEquation& equation : mechanism.equations) {
    collect(equation.left, used);
    collect(equation.right, used);
  }
  for (const MechanismContact& contact : mechanism.contacts) {
    collect(contact.gap, used);
    collect(contact.slip, used);
    if (contact.second) collect(contact.second->slip, used);
  }
  for (const MechanismFriction& friction : mechanism.friction) collect(friction.slip, used);
  for (const MechanismLink& link : mechanism.links) collect(link.zero, used);
  return used;
}

}  // namespace

void check_uses(Context& context) {
  UseCheck(context).check();
}

void check_uses(Bodies& bodies, Context& context) {
  UseCheck(context).check(bodies);
}

void check_whole(Context& context) {
  const Mechanism& mechanism = context.mechanism;
  if (!context.sound) return;  // the missing use may be where a mistake is
  const std::set<std::string> used = symbols_of_motion(mechanism);
  for (std::size_t i = 0; i < mechanism.accelerations; ++i) {
    const MechanismUnknown& unknown = mechanism.unknowns[i];
    if (used.count(unknown.symbol) != 0) continue;
    context.mistakes.add(unknown.place, "accelerations: " + unknown.symbol +
                                            " occurs in no equation, gap, slip or zero, expected it in one");
  }
}

}  // namespace slipproof::mechanism_reader
