#include "contact/space/space_problem.hpp"

#include <algorithm>

#include "mechanics/points/problem.hpp"

namespace slipproof {

namespace {

class SpaceProblemMaker {
 public:
  explicit SpaceProblemMaker(const MechanismScene& scene)
      : scene_(scene),
        m_(scene.mechanism),
        mistakes_(m_.file),
        maker_(m_),
        compiled_(maker_.compiled()),
        at_(maker_.at(scene.values)),
        kinds_(element_kinds(m_, scene.values.starts, scene.values.given)) {}

  SpaceProblem problem() {
    refuse_poisson_in_space(m_);
    if (m_.load && !scene_.load) {
      mistakes_.add(m_.load->place,
                    "found no value of the load " + m_.load->symbol + ", expected one: a scene in space has one");
      mistakes_.refuse_if_any();
    }
    result_.global.title = scene_.name.empty() ? m_.name : scene_.name;
    add_equations();
    result_.global.H.resize(m_.accelerations);
    result_.global.G.resize(m_.accelerations);
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) add_contact(i);
    for (std::size_t i = 0; i < m_.links.size(); ++i) {
      hold(row(compiled_.equations[m_.equations.size() + i], m_.links[i].name), m_.links[i].force);
    }
    mistakes_.refuse_if_any();
    return std::move(result_);
  }

 private:
  Rational number(const Program& program, const std::string& what) {
    auto value = at_.number(program);
    if (value.number) return std::move(*value.number);
    mistakes_.add({}, what + " has no value: it divides by zero");
    return 0;
  }

  /// Over the accelerations, with the load in its constant. Forces are left out: they come in by virtual work.
  SpaceRow row(const CompiledForm& form, const std::string& what) {
    SpaceRow row;
    if (form.constant) row.constant = number(*form.constant, what);
    for (const auto& [unknown, program] : form.terms) {
      if (unknown < m_.accelerations) row.terms.emplace_back(unknown, number(program, what));
      if (unknown == m_.unknowns.size()) row.constant += number(program, what) * *scene_.load;
    }
    return row;
  }

  void add_equations() {
    const std::size_t size = m_.accelerations;
    result_.global.M.assign(size, std::vector<Rational>(size));
    for (std::size_t i = 0; i < size; ++i) {
      const SpaceRow equation = row(compiled_.equations[i], "the equation " + m_.equations[i].name);
      for (const auto& [j, entry] : equation.terms) result_.global.M[i][j] = entry;
      result_.global.f.push_back(-equation.constant);
    }
  }

  static void add_column(RationalMatrix& to, const SpaceRow* motion) {
    for (auto& row : to) row.emplace_back(0);
    if (motion == nullptr) return;
    for (const auto& [i, entry] : motion->terms) to[i].back() = entry;
  }
  void hold(const SpaceRow& motion, std::size_t force) {
    add_column(result_.global.G, &motion);
    result_.global.b.push_back(motion.constant);
    result_.held.push_back(force);
  }

  void add_contact(std::size_t i) {
    const MechanismContact& c = m_.contacts[i];
    const ElementKind& kind = kinds_[i];
    std::vector<SpaceRow> motions{row(compiled_.contacts[i].gap, c.gap_name)};
    if (c.second) {
      motions.push_back(row(compiled_.contacts[i].slip, c.slip_name));
      motions.push_back(row(compiled_.contacts[i].second, c.second->name));
    }
    result_.rows.insert(result_.rows.end(), motions.begin(), motions.end());
    if (kind.start == ElementKind::Start::open) return;
    if (kind.bilateral && !c.frictionless()) {
      return mistakes_.add(c.place, c.name + ": found a guide with friction, expected one without in space");
    }
    if (kind.bilateral) return hold(motions[0], c.normal);
    if (!kind.lifts)
      mistakes_.add(c.place, c.name +
                                 ": found a contact whose lift is not modelled, expected a value of "
                                 "what its lift needs");
    SpaceContact contact{i, 0, std::nullopt, std::nullopt};
    if (!c.frictionless()) read_friction(c, compiled_.contacts[i], kind.slides(), contact);
    for (std::size_t t = 0; t < 3; ++t) {
      const SpaceRow* motion = t < motions.size() ? &motions[t] : nullptr;
      add_column(result_.global.H, motion);
      result_.global.w.push_back(motion == nullptr ? Rational(0) : motion->constant);
    }
    result_.global.mu.push_back(contact.mu);
    result_.global.contacts.push_back(c.name);
    result_.contacts.push_back(std::move(contact));
  }

  void read_friction(const MechanismContact& c, const CompiledContact& compiled, bool slides, SpaceContact& contact) {
    const std::string what = "the friction of " + c.name;
    contact.mu = number(*compiled.kinetic_friction, what);
    if (slides) {
      const std::array<Rational, 2> along{number(compiled.sliding[0], what), number(compiled.sliding[1], what)};
      const auto length = exact_root(Rational(along[0] * along[0] + along[1] * along[1]));
      if (!length) {
        contact.toward = along;
      } else if (!length->is_zero()) {  // 0 has been refused: the scene is outside of its domain
        contact.sliding = {along[0] / *length, along[1] / *length};
      }
    } else if (number(*compiled.static_friction, what) != contact.mu) {
      mistakes_.add(c.place, c.name + ": found a static coefficient of its own, expected one coefficient in space");
    }
  }

  const MechanismScene& scene_;
  const Mechanism& m_;
  Mistakes mistakes_;
  const ProblemMaker maker_;
  const CompiledMechanism& compiled_;
  Evaluator<Rational> at_;
  const std::vector<ElementKind> kinds_;
  SpaceProblem result_;
};

}  // namespace

void refuse_poisson_in_space(const Mechanism& mechanism) {
  if (!mechanism.impact || mechanism.impact->law != ImpactLaw::poisson) return;
  throw InputError({{mechanism.file, 0, 0,
                     "found an impact in space by Poisson's law, whose two phases only `slipproof impact` solves, "
                     "expected \"newton\" or \"moreau\""}});
}

SpaceProblem space_problem(const MechanismScene& scene) {
  return SpaceProblemMaker(scene).problem();
}

GlobalProblem exported(const SpaceProblem& problem, const Mechanism& mechanism) {
  if (std::ranges::none_of(problem.contacts, &SpaceContact::slides)) return problem.global;
  ReducedSpace local = reduced(problem, mechanism);
  GlobalProblem result;
  result.title = problem.global.title;
  result.contacts = problem.global.contacts;
  result.W = std::move(local.contacts.W);
  result.q = std::move(local.contacts.q);
  result.mu = std::move(local.contacts.mu);
  return result;
}

}  // namespace slipproof
