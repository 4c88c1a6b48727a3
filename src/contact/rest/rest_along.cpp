#include <algorithm>
#include <stdexcept>

#include "base/input/diagnostic.hpp"
#include "base/number/simplest.hpp"
#include "contact/rest/rest.hpp"
#include "mechanics/mechanism/names.hpp"

namespace slipproof {

namespace {

const Rational& wanted() {  // relative
  static const Rational value(Integer(1), Integer(1'000'000'000));
  return value;
}

/// Whether a parameter is the coefficient of friction of contacts, alone, and stands nowhere else.
bool is_only_friction(const Mechanism& m, const std::string& name) {
  const std::vector<bool> definitions = definitions_with(m, MechanismNames(m), name);
  if (std::ranges::find(definitions, true) != definitions.end()) return false;
  const auto free_of = [&](const Expression& expression) {
    if (!expression) return true;
    const std::vector<std::string> used = symbols(expression);
    return std::ranges::find(used, name) == used.end();
  };
  const auto form_free = [&](const SymbolicForm& form) {
    return free_of(form.load) && free_of(form.constant) &&
           std::ranges::all_of(form.terms, [&](const auto& term) { return free_of(term.second); });
  };
  bool rubs = false;
  for (const MechanismContact& c : m.contacts) {
    for (const PlacedExpression* friction : {&c.static_friction, &c.kinetic_friction}) {
      rubs = rubs || (*friction && is_symbol(friction->expression, name));
      if (*friction && !is_symbol(friction->expression, name) && !free_of(friction->expression)) return false;
    }
    if (!form_free(c.gap_form) || !form_free(c.slip_form) || (c.second && !form_free(c.second->form))) return false;
  }
  const auto all_free = [&](const auto& items) {
    return std::ranges::all_of(items, [&](const auto& item) { return form_free(item.form); });
  };
  return rubs && all_free(m.equations) && all_free(m.links) &&
         std::ranges::all_of(m.friction, [&](const MechanismFriction& f) {
           return form_free(f.slip_form) && form_free(f.static_form);
         });
}

class ParameterSearch {
 public:
  ParameterSearch(const MechanismScene& scene, const RestProblemMaker& maker, RestParameter& result, Effort& effort,
                  std::size_t& programs)
      : scene_(scene), maker_(maker), result_(result), effort_(effort), programs_(programs) {}

  void run() {
    const auto here = can(result_.value);
    if (here && *here) {
      result_.from = towards(-1);
      if (!result_.monotone) result_.to = towards(1);
      return;
    }
    result_.none = true;
    if (!here || !result_.monotone) return;
    Rational last = result_.value, step = first_step();
    for (int i = 0; i < doublings; ++i, step *= 2) {
      const Rational next = last + step;
      const auto there = can(next);
      if (!there) return;
      if (*there) {
        result_.none = false;
        result_.from = between(next, last);
        return;
      }
      last = next;
    }
  }

 private:
  static constexpr int doublings = 40;

  Rational first_step() const { return result_.value.is_zero() ? Rational(1) : abs(result_.value) / 8; }

  /// Undecided outside of the domain.
  RestDecision decide(const Rational& value, const std::vector<std::size_t>& without = {}) {
    try {
      const MechanismScene there = with_values(scene_, {{result_.name, value}});
      RestProblem problem = maker_.problem(there);
      for (auto k = without.rbegin(); k != without.rend(); ++k) {
        problem.contacts.erase(problem.contacts.begin() + static_cast<std::ptrdiff_t>(*k));
      }
      RestSolver solver(problem, effort_);
      RestDecision decision = solver.decide(push_at(problem, there.load ? *there.load : Rational(0)));
      programs_ += solver.programs();
      return decision;
    } catch (const std::invalid_argument&) {
    } catch (const InputError&) {
    }
    return {};
  }

  std::optional<bool> can(const Rational& value) {
    const RestDecision decision = decide(value);
    touches_ = decision.touching;
    return decision.can;
  }

  /// The first end in a direction: nothing if all places that are tried can rest, up to the domain's end.
  std::optional<ProvedEnd> towards(int direction) {
    Rational good = result_.value, step = first_step();
    for (int i = 0; i < doublings; ++i) {
      const Rational next = good + direction * step;
      const auto there = can(next);
      if (there && !*there) return between(good, next);
      if (there) {
        good = next;
        step *= 2;
      } else {
        step /= 4;  // the domain's end is near
      }
    }
    return std::nullopt;
  }

  ProvedEnd between(Rational good, Rational bad) {
    if (is_end(good)) return {good, good};
    while (true) {
      const Rational gap = abs(Rational(good - bad));
      const Rational size = std::max({abs(good), abs(bad), Rational(first_step() / 1000)});
      if (gap <= size / 1000) {
        const Rational simple = simplest_between(std::min(good, bad), std::max(good, bad));
        if (tried_ != simple) {
          if (is_end(simple)) return {simple, simple};
          if (touches_) good = simple;
        }
      }
      if (gap <= wanted() * size) break;
      const Rational middle = (good + bad) / 2;
      const auto there = can(middle);
      if (!there) break;
      if (*there && touches_ && is_end(middle)) return {middle, middle};
      (*there ? good : bad) = middle;
    }
    return {std::min(good, bad), std::max(good, bad)};
  }

  /// Whether a value is the end of a coefficient of friction: there it only just rests, and where the motion at that
  /// border slips nothing may push with less friction, without which it cannot rest.
  bool is_end(const Rational& value) {
    tried_ = value;
    const RestDecision decision = decide(value);
    touches_ = decision.can == true && decision.touching;
    if (!touches_ || !result_.monotone) return false;
    const std::vector<std::size_t> slipping = contacts_that_slip(value, *decision.border);
    return !slipping.empty() && decide(value, slipping).can == false;
  }

  std::vector<std::size_t> contacts_that_slip(const Rational& value, const VirtualMotion& motion) {
    const RestProblem problem = maker_.problem(with_values(scene_, {{result_.name, value}}));
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
      const bool varies = std::ranges::any_of(scene_.mechanism.contacts, [&](const MechanismContact& c) {
        return c.name == problem.contacts[k].name && c.static_friction &&
               is_symbol(c.static_friction.expression, result_.name);
      });
      const bool slips = std::ranges::any_of(problem.contacts[k].tangents, [&](std::size_t force) {
        return !problem.rate_along(force, motion.rates).is_zero();
      });
      if (varies && slips) result.push_back(k);
    }
    return result;
  }

  const MechanismScene& scene_;
  const RestProblemMaker& maker_;
  RestParameter& result_;
  Effort& effort_;
  std::size_t& programs_;
  std::optional<Rational> tried_;  ///< the last value that might be an end
  bool touches_ = false;           ///< whether it only just rests at the last value
};

std::optional<Rational> value_of(const MechanismScene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.mechanism.parameters.size(); ++i) {
    if (scene.mechanism.parameters[i].symbol == name) return scene.values.parameters[i];
  }
  if (scene.mechanism.load && scene.mechanism.load->symbol == name) return scene.load;
  for (std::size_t i = 0; i < scene.mechanism.angles.size(); ++i) {
    const MechanismValues::Circle& angle = scene.values.angles[i];
    if (scene.mechanism.angles[i].name != name) continue;
    if (angle.cosine == -1) return std::nullopt;
    return Rational(angle.sine / (1 + angle.cosine));
  }
  return std::nullopt;
}

}  // namespace

RestParameter rest_along(const MechanismScene& scene, const RestProblemMaker& maker, const std::string& parameter,
                         Effort& effort, std::size_t& programs) {
  const auto value = value_of(scene, parameter);
  if (!value) {
    throw InputError(
        {{scene.mechanism.file, 0, 0,
          unknown_name("parameter", parameter, value_names(scene.mechanism)) +
              (scene.mechanism.load && scene.mechanism.load->symbol == parameter ? ": it has no value" : "")}});
  }
  RestParameter result{parameter, *value, is_only_friction(scene.mechanism, parameter), false, {}, {}};
  ParameterSearch(scene, maker, result, effort, programs).run();
  return result;
}

}  // namespace slipproof
