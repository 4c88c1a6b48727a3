#include "contact/rest/rest_problem.hpp"

#include "base/input/diagnostic.hpp"
#include "mechanics/bodies/bodies.hpp"
#include "mechanics/points/problem.hpp"

namespace slipproof {

namespace {

/// A form where all accelerations are 0: over the forces.
struct RestForm {
  std::vector<std::pair<std::size_t, Rational>> terms;
  Rational constant, load;

  bool vanishes() const { return terms.empty() && constant.is_zero() && load.is_zero(); }
};

class RestReader {
 public:
  RestReader(const Mechanism& mechanism, const ProblemMaker& maker, const MechanismScene& scene)
      : scene_(scene),
        m_(mechanism),
        compiled_(maker.compiled()),
        mistakes_(m_.file),
        at_(maker.at(scene.values)),
        kinds_(element_kinds(m_, scene.values.starts, scene.values.given)) {}

  RestProblem problem() {
    result_.title = scene_.name.empty() ? m_.name : scene_.name;
    result_.file = m_.file;
    result_.by_virtual_work = m_.by_virtual_work;
    if (m_.load) result_.load = m_.load->symbol;
    refuse_what_moves();
    mistakes_.refuse_if_any();
    result_.forces = force_names(m_);
    add_equations();
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) add_contact(i);
    for (std::size_t i = 0; i < m_.friction.size(); ++i) add_friction(i);
    for (std::size_t i = 0; i < m_.links.size(); ++i) {
      must_rest(compiled_.equations[m_.equations.size() + i], m_.links[i].name, m_.links[i].place);
      result_.free.push_back(force(m_.links[i].force));
    }
    for (std::size_t i = m_.accelerations; i < m_.accelerations + m_.forces; ++i) {
      result_.free.push_back(force(i));
      result_.only_links_are_free = false;
    }
    mistakes_.refuse_if_any();
    return std::move(result_);
  }

 private:
  std::size_t force(std::size_t unknown) const { return unknown - m_.accelerations; }

  Rational number(const Program& program, const std::string& what) {
    auto value = at_.number(program);
    if (value.number) return std::move(*value.number);
    throw InputError({{m_.file, 0, 0, what + " has no value: it divides by zero"}});
  }

  RestForm form(const CompiledForm& compiled, const std::string& what) {
    RestForm result;
    if (compiled.constant) result.constant = number(*compiled.constant, what);
    for (const auto& [unknown, program] : compiled.terms) {
      if (unknown < m_.accelerations) continue;
      Rational value = number(program, what);
      if (unknown == m_.unknowns.size()) {
        result.load = std::move(value);
      } else if (!value.is_zero()) {
        result.terms.emplace_back(force(unknown), std::move(value));
      }
    }
    return result;
  }

  void refuse_what_moves() {
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) {
      if (kinds_[i].slides()) {
        mistakes_.add(m_.contacts[i].place,
                      m_.contacts[i].name + ": found a contact that slides: the scene moves, expected one at rest");
      }
    }
    for (std::size_t i = 0; i < m_.friction.size(); ++i) {
      if (kinds_[m_.contacts.size() + i].slides()) {
        mistakes_.add(m_.friction[i].place,
                      m_.friction[i].name + ": found what slides: the scene moves, expected one at rest");
      }
    }
    if (!m_.bodies) return;
    for (const Body& body : m_.bodies->bodies) {
      refuse_speed(body.name, "velocity", body.velocity);
      refuse_speed(body.name, "spin", body.spin);
    }
  }

  void refuse_speed(const std::string& body, const char* what, const PlacedVector& vector) {
    for (const PlacedExpression* component : {&vector.x, &vector.y, &vector.z}) {
      if (!*component) continue;
      const Rational value =
          number(compiled_.compile(component->expression), "the " + std::string(what) + " of " + body);
      if (value.is_zero()) continue;
      return mistakes_.add(vector.place, "body " + body + ": found a " + what + " of " + value.str() +
                                             ": the scene moves, expected one at rest");
    }
  }

  void add_equations() {
    result_.along.resize(result_.forces.size());
    for (std::uint32_t i = 0; i < m_.equations.size(); ++i) {
      const RestForm equation = form(compiled_.equations[i], "the equation " + m_.equations[i].name);
      result_.rows.push_back(m_.by_virtual_work ? m_.unknowns[i].symbol : m_.equations[i].name);
      result_.f.push_back(-equation.constant);
      result_.f_load.push_back(-equation.load);
      for (const auto& [j, value] : equation.terms) result_.along[j].emplace_back(i, -value);
    }
  }

  /// What is 0 where all accelerations are.
  void must_rest(const CompiledForm& compiled, const std::string& name, Place place) {
    if (form(compiled, name).vanishes()) return;
    mistakes_.add(place, name +
                             ": found an acceleration where all unknown ones are 0, expected none: what is "
                             "prescribed must rest");
  }

  void add_contact(std::size_t i) {
    const MechanismContact& c = m_.contacts[i];
    const CompiledContact& compiled = compiled_.contacts[i];
    if (kinds_[i].start == ElementKind::Start::open) return;
    must_rest(compiled.gap, c.gap_name, c.place);
    if (kinds_[i].bilateral) {
      if (c.frictionless()) return result_.free.push_back(force(c.normal));
      return mistakes_.add(c.place, c.name +
                                        ": found a guide with friction, whose N has either sign, so that |S| <= mu |N| "
                                        "is two cones and not one, expected contacts or a guide without");
    }
    RestProblem::Contact contact{c.name, force(c.normal), {}, 0};
    if (!c.frictionless()) {
      must_rest(compiled.slip, c.slip_name, c.place);
      if (c.second) must_rest(compiled.second, c.second->name, c.place);
      contact.mu = number(*compiled.static_friction, "the friction of " + c.name);
      if (contact.mu.sign() < 0) mistakes_.add(c.place, c.name + ": found friction below 0, expected 0 or more");
      if (contact.mu.sign() > 0) {
        contact.tangents.push_back(force(*c.tangent));
        if (c.second) contact.tangents.push_back(force(c.second->force));
      }
    }
    result_.contacts.push_back(std::move(contact));
  }

  void add_friction(std::size_t i) {
    const MechanismFriction& friction = m_.friction[i];
    const ElementKind& kind = kinds_[m_.contacts.size() + i];
    if (kind.contact && kinds_[*kind.contact].start == ElementKind::Start::open) return;
    if (kind.contact && kinds_[*kind.contact].bilateral) {
      return mistakes_.add(friction.place, friction.name +
                                               ": found friction in a guide, whose N has either sign, so that what it "
                                               "bears is two cones and not one, expected a contact or a guide without");
    }
    must_rest(compiled_.friction[i].slip, friction.slip_name, friction.place);
    const RestForm limit = form(compiled_.friction[i].static_limit, "the limit of " + friction.name);
    result_.limits.push_back({friction.name, force(friction.force), limit.terms, limit.constant, limit.load});
  }

  const MechanismScene& scene_;
  const Mechanism& m_;
  const CompiledMechanism& compiled_;
  Mistakes mistakes_;
  Evaluator<Rational> at_;
  const std::vector<ElementKind> kinds_;
  RestProblem result_;
};

}  // namespace

std::vector<Rational> RestProblem::push_at(const Rational& load_value) const {
  std::vector<Rational> push = f;
  for (std::size_t i = 0; i < push.size(); ++i) push[i] += load_value * f_load[i];
  return push;
}

Rational RestProblem::rate_along(std::size_t force, const std::vector<Rational>& rates) const {
  Rational rate;
  for (const auto& [row, value] : along[force]) rate += value * rates[row];
  return rate;
}

RestProblem RestProblemMaker::problem(const MechanismScene& scene) const {
  return RestReader(m_, maker_, scene).problem();
}

}  // namespace slipproof
