#include "mechanics/checks/check_points.hpp"

#include <algorithm>
#include <set>

#include "mechanics/bodies/bodies.hpp"
#include "mechanics/bodies/sure_sign.hpp"
#include "mechanics/points/degrees.hpp"
#include "mechanics/points/domain_sampler.hpp"
#include "mechanics/points/sampling.hpp"

namespace slipproof::mechanism_checks {

namespace {

constexpr std::size_t points_tried = 48;
constexpr std::uint64_t sampling_seed = 1;

/// Symbols, those in definitions included.
class Symbols {
 public:
  explicit Symbols(const Mechanism& mechanism) : mechanism_(mechanism), names_(mechanism) {}

  void add(const Expression& expression) {
    for (const std::string& symbol : symbols(expression)) {
      if (!found_.insert(symbol).second) continue;
      const auto entry = names_.find(symbol);
      const bool derived = entry && entry->kind == NameKind::definition;
      if (derived) add(mechanism_.definitions[entry->index].expression.expression);
    }
  }
  bool has(const std::string& symbol) const { return found_.count(symbol) != 0; }

 private:
  const Mechanism& mechanism_;
  MechanismNames names_;
  std::set<std::string> found_;
};

}  // namespace

bool is_gravity(const Mechanism& mechanism, const MechanismParameter& parameter) {
  if (parameter.symbol == "g") return true;
  const auto signs = bodies_in_motion::sure_signs(mechanism, make_symbol(parameter.symbol));
  return (parameter.unit == "m/s^2" || parameter.unit == "m s^-2") && !signs.negative && !signs.zero;
}

bool has_gravity(const Mechanism& mechanism) {
  const auto gravity = [&](const MechanismParameter& one) { return is_gravity(mechanism, one); };
  return (mechanism.bodies && mechanism.bodies->gravity) || std::ranges::any_of(mechanism.parameters, gravity);
}

CheckPoints::CheckPoints(const Mechanism& mechanism)
    : mechanism_(&mechanism), maker_(mechanism), pushes_(find_pushes()) {
  for (MechanismValues& values : sample_values(mechanism, maker_, points_tried, sampling_seed)) {
    try {
      FrictionProblem problem = maker_.problem(values);
      points_.push_back({std::move(values), std::move(problem)});
    } catch (const NoValue&) {
      continue;
    }
  }
}

std::optional<Rational> CheckPoints::at(const MechanismValues& values, const Quantity& quantity) const {
  try {
    return quantity({values, maker_.problem(values)});
  } catch (const NoValue&) {
    return std::nullopt;
  }
}

std::string CheckPoints::where(const CheckPoint& point, const Quantity& quantity) const {
  const MechanismValues& values = point.values;
  const auto here = at(values, quantity);
  const auto differs = [&](const MechanismValues& there) { return at(there, quantity) != here; };
  ShownValues shown;
  for (std::size_t i = 0; i < values.parameters.size(); ++i) {
    MechanismValues more = values, less = values;
    more.parameters[i] += Rational(3, 2);
    less.parameters[i] -= Rational(5, 3);
    shown.parameters.push_back(values.given[i] && (differs(more) || differs(less)));
  }
  for (std::size_t i = 0; i < values.angles.size(); ++i) {
    MechanismValues other = values;
    other.angles[i] = point_of_tan_half(Rational(3, 7));
    shown.angles.push_back(differs(other));
  }
  const std::string text = values_text(*mechanism_, values, shown);
  return text.empty() ? text : ", at " + text;
}

std::vector<std::size_t> CheckPoints::find_pushes() const {
  Symbols constants(*mechanism_), others(*mechanism_);
  const auto add = [&](const SymbolicForm& form) {
    if (form.constant) constants.add(form.constant);
    if (form.load) others.add(form.load);
    for (const auto& [unknown, coefficient] : form.terms) others.add(coefficient);
  };
  for (const MechanismEquation& equation : mechanism_->equations) add(equation.form);
  for (const MechanismLink& link : mechanism_->links) add(link.form);
  for (const MechanismFriction& friction : mechanism_->friction) add(friction.slip_form);
  for (const MechanismContact& contact : mechanism_->contacts) {
    add(contact.gap_form);
    add(contact.slip_form);
  }
  std::vector<std::size_t> pushes;
  for (std::size_t i = 0; i < mechanism_->parameters.size(); ++i) {
    const MechanismParameter& parameter = mechanism_->parameters[i];
    const std::string& symbol = parameter.symbol;
    if (!is_gravity(*mechanism_, parameter) && constants.has(symbol) && !others.has(symbol)) pushes.push_back(i);
  }
  return pushes;
}

bool CheckPoints::is_pushed(const CheckPoint& point) const {
  return std::ranges::any_of(pushes_, [&](std::size_t i) { return !point.values.parameters[i].is_zero(); });
}

CheckPoint CheckPoints::without_pushes(const CheckPoint& point) const {
  if (pushes_.empty()) return point;
  const DomainSampler sampler(*mechanism_, maker_);
  MechanismValues values = point.values;
  for (const std::size_t push : pushes_) {
    const Rational before = values.parameters[push];
    values.parameters[push] = 0;
    if (!sampler.contains(values)) values.parameters[push] = before;
  }
  try {
    FrictionProblem problem = maker_.problem(values);
    return {std::move(values), std::move(problem)};
  } catch (const NoValue&) {
    return point;
  }
}

}  // namespace slipproof::mechanism_checks
