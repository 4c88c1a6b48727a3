#include "records/judging/explanation.hpp"

#include "base/number/format.hpp"
#include "mechanics/mechanism/words.hpp"

namespace slipproof {

namespace {

Json names_of(const std::vector<MechanismMode>& modes) {
  Json names = Json::array();
  for (const MechanismMode& mode : modes) names.push_back(name(mode));
  return names;
}

Json end_of(const std::optional<Rational>& end) {
  return end ? Json(exact_text(*end)) : Json(nullptr);
}

}  // namespace

void Explanation::add_motions(Json& details) const {
  Json motions = Json::array();
  for (const MotionAtLoad& motion : found_.motions) motions.push_back(motion_of(motion));
  details["found"] = std::move(motions);
  Json continua = Json::array();
  for (const ContinuumAtLoad& continuum : found_.continua) continua.push_back(name(continuum.mode));
  if (!continua.empty()) details["continua"] = std::move(continua);
  if (!found_.hysteresis.empty()) details["hysteresis"] = names_of(found_.hysteresis);
}

Json Explanation::motion_of(const MotionAtLoad& motion) const {
  const auto& fields = setting_.fields;
  Json accelerations = Json::object(), forces = Json::object(), undetermined = Json::object();
  for (std::size_t i = 0; i < motion.accelerations.size(); ++i) {
    accelerations[fields.name(fields.first_answer() + i)] = exact_text(motion.accelerations[i]);
  }
  for (std::size_t i = 0; i < motion.forces.size(); ++i) {
    const std::string& name = fields.name(fields.first_answer() + fields.accelerations() + i);
    const Range& range = motion.forces[i];
    if (range.is_point()) {
      forces[name] = exact_text(*range.lower);
    } else {
      undetermined[name] = Json::array({end_of(range.lower), end_of(range.upper)});
    }
  }
  Json result{{"modes", names_of(motion.modes)}, {"boundary_modes", names_of(motion.boundary_modes)}};
  result["status"] = motion.strict() ? "strict" : "boundary";
  result["accelerations"] = std::move(accelerations);
  result["forces"] = std::move(forces);
  result["force_ranges"] = std::move(undetermined);
  return result;
}

/// Why a mode does not exist at this point; empty if it exists.
std::string Explanation::not_modelled(const MechanismMode& mode, const MechanismValues& values) const {
  const Mechanism& mechanism = setting_.certified.mechanism;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    if (has_state(problem_.elements[i].kind, mode[i])) continue;
    std::string text =
        "the mode is not modelled: " + element_name(mechanism, i) + " has no " + std::string(name(mode[i])) + " here";
    if (mode[i] != ElementState::lift || i >= mechanism.contacts.size()) return text;
    for (const std::size_t need : missing_for_lift(mechanism.contacts[i], values.given)) {
      text += " without " + mechanism.parameters[need].symbol;
    }
    return text;
  }
  if (!go_together(kinds_of(problem_), mode)) return "the mode is not modelled: a friction element follows its contact";
  return {};
}

void Explanation::add_against(Json& details, const MechanismMode& mode, const MechanismValues& values) const {
  details["violated"] = nullptr;
  if (std::string missing = not_modelled(mode, values); !missing.empty()) {
    details["reason"] = missing;
    return;
  }
  const ModesOf own = mode_of(problem_, mode, load_);
  if (own.rejected.empty()) {
    details["reason"] = own.consistent.front().determined
                            ? "the mode is right, its numbers are not"
                            : "the mode has a continuum of motions, and none of them is near";
    return;
  }
  const RejectedMode& rejected = own.rejected.front();
  std::vector<std::string> because;
  for (const ViolatedCondition& c : rejected.because) {
    std::string text = condition_name(setting_.certified.mechanism, c.element, c.state, c.condition);
    if (because.empty() || because.back() != text) because.push_back(std::move(text));
  }
  if (rejected.margin) {
    details["violated"] = because.front();
    details["margin"] = exact_text(*rejected.margin);
  } else if (because.empty()) {
    details["reason"] = "its equations have no solution";
  } else {
    details["because"] = because;
  }
}

void Explanation::add_claimed(Json& details, const MechanismMode& mode, const MechanismValues& values) const {
  details["claimed"] = name(mode);
  add_against(details, mode, values);
}

void Explanation::add_likely(Json& details, const Record& record, const MechanismValues& values) const {
  const auto mode = guess_mode(record);
  if (!mode) {
    details["reason"] = found_.motions.empty() && found_.continua.empty() ? "there is no motion" : "no motion is near";
    return;
  }
  details["looks_like"] = name(*mode);
  add_against(details, *mode, values);
}

std::optional<MechanismMode> Explanation::guess_mode(const Record& record) const {
  const auto& fields = setting_.fields;
  if (problem_.elements.size() != setting_.certified.mechanism.contacts.size()) return std::nullopt;
  const std::size_t accelerations = setting_.kinds.unknown_accelerations;
  const auto field_of = [&](std::size_t unknown) {
    return fields.first_answer() +
           (unknown < accelerations ? unknown : fields.accelerations() + unknown - accelerations);
  };
  const auto at = [&](const AffineForm& form) -> std::optional<Rational> {
    if (form.coefficients.empty()) return std::nullopt;
    Rational value = load_ ? Rational(form.constant + form.coefficients.back() * *load_) : form.constant;
    for (std::size_t i = 0; i < problem_.unknowns; ++i) {
      if (form.coefficients[i].is_zero()) continue;
      if (!record.present[field_of(i)]) return std::nullopt;
      value += form.coefficients[i] * record.exactly(field_of(i));
    }
    return value;
  };
  MechanismMode mode;
  for (const auto& element : problem_.elements) {
    const auto normal = at(element.normal), tangent = at(element.tangent), limit = at(element.static_limit);
    if (!normal || !tangent || !limit) return std::nullopt;
    const bool sticks = abs(*tangent) < *limit * Rational(999999, 1000000);
    mode.push_back(normal->is_zero() && tangent->is_zero() ? ElementState::lift
                   : sticks                                ? ElementState::stick
                   : sign(*tangent) < 0                    ? ElementState::slip_forward
                                                           : ElementState::slip_backward);
  }
  return mode;
}

}  // namespace slipproof
