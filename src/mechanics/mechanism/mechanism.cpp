#include "mechanics/mechanism/mechanism.hpp"

#include <algorithm>
#include <array>

#include "base/input/diagnostic.hpp"
#include "mechanics/mechanism/algebra.hpp"
#include "mechanics/mechanism/extraction.hpp"
#include "mechanics/mechanism/forms.hpp"

namespace slipproof {

std::string_view name(MechanismShape::Kind kind) {
  constexpr std::array<std::string_view, 8> names{"polygon", "line",  "circle",  "point",
                                                  "arrow",   "label", "measure", "turn"};
  return names[static_cast<std::size_t>(kind)];
}

namespace {

constexpr std::array<std::string_view, 3> impact_laws{"newton", "moreau", "poisson"};

}  // namespace

std::string_view name(ImpactLaw law) {
  return impact_laws[static_cast<std::size_t>(law)];
}

std::optional<ImpactLaw> parse_impact_law(std::string_view text) {
  const auto found = std::find(impact_laws.begin(), impact_laws.end(), text);
  if (found == impact_laws.end()) return std::nullopt;
  return static_cast<ImpactLaw>(found - impact_laws.begin());
}

Expression MechanismEquation::whole_right() const {
  return contact_forces ? appended(right.expression, contact_forces) : right.expression;
}

void refuse_other(const Mechanism& mechanism, Dimensions dimensions) {
  if (mechanism.dimension == 2 || dimensions == Dimensions::any) return;
  const Place place = mechanism.dimension_place;
  throw InputError(
      {{mechanism.file, place.line, place.column,
        "dimension: found a mechanism in space, expected one in the plane: in space motions are not known over ranges "
        "of loads or parameters. `solve` finds all motions at one point, `search --within` at samples; `certify`, "
        "`expect`, `draw`, `export` and `show` take scenes in space, too"}});
}

std::vector<std::string_view> value_names(const Mechanism& mechanism) {
  std::vector<std::string_view> names;
  for (const MechanismParameter& parameter : mechanism.parameters) names.push_back(parameter.symbol);
  for (const MechanismAngle& angle : mechanism.angles) names.push_back(angle.name);
  if (mechanism.load) names.push_back(mechanism.load->symbol);
  return names;
}

std::vector<std::string> acceleration_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < mechanism.accelerations; ++i) names.push_back(mechanism.unknowns[i].symbol);
  for (const MechanismContact& contact : mechanism.contacts) {
    names.push_back(contact.gap_name);
    if (contact.slip) names.push_back(contact.slip_name);
    if (contact.second) names.push_back(contact.second->name);
  }
  for (const MechanismFriction& friction : mechanism.friction) names.push_back(friction.slip_name);
  return names;
}

std::vector<std::string> force_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (std::size_t i = mechanism.accelerations; i < mechanism.unknowns.size(); ++i) {
    names.push_back(mechanism.unknowns[i].symbol);
  }
  return names;
}

const std::string& element_name(const Mechanism& mechanism, std::size_t element) {
  const std::size_t contacts = mechanism.contacts.size();
  return element < contacts ? mechanism.contacts[element].name : mechanism.friction[element - contacts].name;
}

std::vector<std::size_t> missing_for_lift(const MechanismContact& contact, const std::vector<bool>& given) {
  std::vector<std::size_t> missing = contact.lift_needs;
  std::erase_if(missing, [&](std::size_t parameter) { return given[parameter]; });
  return missing;
}

std::vector<ElementKind::Start> starts(const Mechanism& mechanism) {
  std::vector<ElementKind::Start> result;
  for (const MechanismContact& contact : mechanism.contacts) result.push_back(contact.start);
  for (const MechanismFriction& friction : mechanism.friction) result.push_back(friction.start);
  return result;
}

std::vector<ElementKind> element_kinds(const Mechanism& mechanism, const std::vector<ElementKind::Start>& starts,
                                       const std::vector<bool>& given) {
  std::vector<ElementKind> kinds;
  for (const MechanismContact& contact : mechanism.contacts) {
    ElementKind kind;
    kind.law = contact.frictionless() ? ElementKind::Law::frictionless
               : contact.second       ? ElementKind::Law::cone
                                      : ElementKind::Law::coulomb;
    kind.slips = !contact.second;
    kind.start = starts[kinds.size()];
    kind.bilateral = contact.bilateral;
    kind.lifts = missing_for_lift(contact, given).empty();
    kinds.push_back(kind);
  }
  for (const MechanismFriction& friction : mechanism.friction) {
    ElementKind kind;
    kind.law = ElementKind::Law::limited;
    kind.start = starts[kinds.size()];
    if (friction.contact) {
      const ElementKind& contact = kinds[*friction.contact];
      kind.contact = friction.contact;
      kind.bilateral = contact.bilateral;
      kind.lifts = contact.lifts;
      if (contact.start == ElementKind::Start::open) kind.start = contact.start;
    }
    kinds.push_back(kind);
  }
  return kinds;
}

std::vector<ElementKind> element_kinds(const Mechanism& mechanism) {
  return element_kinds(mechanism, starts(mechanism), std::vector<bool>(mechanism.parameters.size(), true));
}

Expression drag_factor(const MechanismContact& contact, const PlacedExpression& along) {
  return product_of(contact.kinetic_friction.expression, along.expression);
}

const Expression& SymbolicForm::coefficient(std::size_t unknown) const {
  static const Expression zero = zero_literal();
  const auto at = std::ranges::lower_bound(terms, unknown, {}, &std::pair<std::size_t, Expression>::first);
  return at != terms.end() && at->first == unknown ? at->second : zero;
}

bool is_literal_zero(const Expression& expression) {
  return expression->operation == Operation::number && expression->number.is_zero();
}

namespace {

using mechanism_forms::Extraction;

/// Moves the conditions about the load out of the list, and returns them.
std::vector<PlacedExpression> taken_about_load(const Extraction& extraction,
                                               std::vector<MechanismCondition>& conditions) {
  std::vector<PlacedExpression> taken;
  std::vector<MechanismCondition> kept;
  for (MechanismCondition& condition : conditions) {
    if (extraction.has_load(condition.condition.expression)) {
      taken.push_back(condition.condition);
    } else {
      kept.push_back(std::move(condition));
    }
  }
  conditions = std::move(kept);
  return taken;
}

/// Moves what the mechanism asks of the new load into the load's domain.
void collect_load_domain(Mechanism& mechanism) {
  const Extraction extraction(mechanism);
  const auto take = [&](PlacedExpression& domain) {
    if (!extraction.has_load(domain.expression)) return;
    mechanism.load->domain.push_back(domain);
    domain.expression = make_truth(true);
  };
  for (MechanismParameter& parameter : mechanism.parameters) take(parameter.domain);
  for (MechanismAngle& angle : mechanism.angles) take(angle.domain);
  for (PlacedExpression& condition : taken_about_load(extraction, mechanism.assume)) {
    mechanism.load->domain.push_back(std::move(condition));
  }
}

void load_becomes_parameter(Mechanism& mechanism) {
  if (!mechanism.load) return;
  MechanismLoad& old = *mechanism.load;
  PlacedExpression domain{make_truth(true), {}};
  for (const PlacedExpression& condition : old.domain) {
    const bool first = domain.expression->operation == Operation::truth;
    domain = {first ? condition.expression : make(Operation::logical_and, {domain.expression, condition.expression}),
              condition.text};
  }
  mechanism.parameters.push_back({old.symbol, std::move(domain), old.unit, old.meaning, false, old.place});
  mechanism.load.reset();
}

void parameter_becomes_load(Mechanism& mechanism, std::size_t index) {
  MechanismParameter parameter = mechanism.parameters[index];
  mechanism.parameters.erase(mechanism.parameters.begin() + static_cast<std::ptrdiff_t>(index));
  for (MechanismContact& contact : mechanism.contacts) {
    std::erase(contact.lift_needs, index);  // every motion is asked about with a value of the load
    for (std::size_t& needed : contact.lift_needs) needed -= needed > index ? 1 : 0;
  }
  load_becomes_parameter(mechanism);
  mechanism.load =
      MechanismLoad{parameter.symbol, {parameter.domain}, parameter.unit, parameter.meaning, parameter.place};
}

}  // namespace

Mechanism with_load(const Mechanism& mechanism, std::string_view parameter) {
  if (mechanism.load && mechanism.load->symbol == parameter) return mechanism;
  Mistakes mistakes(mechanism.file);
  const auto found = std::find_if(mechanism.parameters.begin(), mechanism.parameters.end(),
                                  [&](const MechanismParameter& p) { return p.symbol == parameter; });
  if (found == mechanism.parameters.end()) {
    std::vector<std::string_view> known;
    for (const MechanismParameter& p : mechanism.parameters) known.push_back(p.symbol);
    mistakes.add({}, unknown_name("parameter", parameter, known));
    mistakes.refuse_if_any();
  }
  Mechanism changed = mechanism;
  changed.shipped = false;  // what the tests check has its own load
  parameter_becomes_load(changed, static_cast<std::size_t>(found - mechanism.parameters.begin()));
  collect_load_domain(changed);
  derive_forms(changed, mistakes);
  load_bounds(changed, mistakes);
  mistakes.refuse_if_any();
  return changed;
}

Mechanism without_load(const Mechanism& mechanism) {
  if (!mechanism.load) return mechanism;
  Mistakes mistakes(mechanism.file);
  Mechanism changed = mechanism;
  changed.shipped = false;
  load_becomes_parameter(changed);
  derive_forms(changed, mistakes);
  mistakes.refuse_if_any();
  return changed;
}

}  // namespace slipproof
