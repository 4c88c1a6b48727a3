#include "contact/exchange/export_scene.hpp"

#include <algorithm>

#include "contact/problem/every_load.hpp"
#include "contact/space/space_problem.hpp"
#include "mechanics/points/problem.hpp"

namespace slipproof {

namespace {

class Exporter {
 public:
  explicit Exporter(const MechanismScene& scene)
      : scene_(scene), m_(scene.mechanism), mistakes_(m_.file), problem_(friction_problem(m_, scene.values)) {}

  GlobalProblem problem() {
    refuse();
    result_.title = scene_.name.empty() ? m_.name : scene_.name;
    result_.dimension = 2;
    if (m_.forces > 0 || !m_.by_virtual_work) return local();
    add_rows();
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) add_contact(i);
    for (std::size_t i = 0; i < m_.links.size(); ++i) add_link(i);
    mistakes_.refuse_if_any();
    return std::move(result_);
  }

 private:
  void refuse() {
    if (m_.load && !scene_.load) {
      mistakes_.add({}, "found no value of the load " + m_.load->symbol + ", expected one: a contact problem has one");
    }
    for (const MechanismFriction& friction : m_.friction) {
      mistakes_.add(friction.place,
                    friction.name + ": found a friction element with a limit of its own, expected contacts");
    }
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) {
      const MechanismContact& c = m_.contacts[i];
      const ElementKind& kind = problem_.elements[i].kind;
      if (kind.bilateral && !c.frictionless()) mistakes_.add(c.place, c.name + ": found a guide with friction");
      if (kind.slides()) mistakes_.add(c.place, c.name + ": found a contact that slides already, expected it at rest");
      if (!kind.bilateral && !kind.lifts)
        mistakes_.add(c.place, c.name + ": found a contact whose lift is not modelled");
    }
    mistakes_.refuse_if_any();
  }

  /// What a form is without unknown forces: over the accelerations, and its constant with the load in it.
  Rational constant(const AffineForm& form) const {
    return problem_.has_load ? form.constant + form.coefficients[problem_.load_index()] * *scene_.load : form.constant;
  }
  std::vector<Rational> over_accelerations(const AffineForm& form) const {
    return {form.coefficients.begin(), form.coefficients.begin() + static_cast<std::ptrdiff_t>(m_.accelerations)};
  }

  GlobalProblem local() {
    FrictionProblem at_load = problem_;
    const auto fold = [&](AffineForm& form) {
      if (form.coefficients.empty() || !problem_.has_load) return;
      form.constant = constant(form);
      form.coefficients[problem_.load_index()] = 0;
    };
    std::ranges::for_each(at_load.equations, fold);
    for (ProblemElement& e : at_load.elements) {
      for (AffineForm* form : {&e.gap, &e.slip}) fold(*form);
    }
    const auto solved = contact_problem(at_load);
    if (!solved) {
      mistakes_.add({},
                    "found equations that contact forces do not determine, or contacts that are not all at rest and "
                    "with one coefficient each, expected a Delassus matrix");
    }
    mistakes_.refuse_if_any();
    result_.W = solved->W;
    result_.q = solved->q;
    result_.mu = solved->mu;
    for (const MechanismContact& c : m_.contacts) result_.contacts.push_back(c.name);
    return std::move(result_);
  }

  void add_rows() {
    for (std::size_t i = 0; i < m_.accelerations; ++i) {
      result_.M.push_back(over_accelerations(problem_.equations[i]));
      result_.f.push_back(-constant(problem_.equations[i]));
    }
    result_.H.resize(m_.accelerations);
    result_.G.resize(m_.accelerations);
    for (std::size_t i = 0; i < m_.accelerations; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (result_.M[i][j] != result_.M[j][i])
          return mistakes_.add({}, "found a matrix of inertia that is not symmetric");
      }
    }
  }

  /// A column: the motion that a force works along, which must be the one that it appears with.
  void add_column(RationalMatrix& to, const AffineForm& motion, std::optional<std::size_t> force,
                  const std::string& name) {
    const std::vector<Rational> along = over_accelerations(motion);
    for (std::size_t i = 0; i < m_.accelerations; ++i) {
      if (force && problem_.equations[i].coefficients[*force] != -along[i]) {
        return mistakes_.add({}, name + ": found equations in which its force is not that of virtual work");
      }
      to[i].push_back(along[i]);
    }
  }

  void add_contact(std::size_t i) {
    const MechanismContact& c = m_.contacts[i];
    const ProblemElement& e = problem_.elements[i];
    if (e.kind.start == ElementKind::Start::open) return;
    if (e.kind.bilateral) {
      add_column(result_.G, e.gap, c.normal, c.name);
      result_.b.push_back(constant(e.gap));
      return;
    }
    add_column(result_.H, e.gap, c.normal, c.name);
    result_.w.push_back(constant(e.gap));
    if (c.frictionless()) {
      for (auto& row : result_.H) row.emplace_back(0);
      result_.w.emplace_back(0);
      result_.mu.emplace_back(0);
    } else {
      add_column(result_.H, e.slip, c.tangent, c.name);
      result_.w.push_back(constant(e.slip));
      result_.mu.push_back(coefficient(e, c));
    }
    result_.contacts.push_back(c.name);
  }

  Rational coefficient(const ProblemElement& e, const MechanismContact& c) {
    if (e.static_limit.coefficients != e.kinetic_limit.coefficients) {
      mistakes_.add(c.place, c.name + ": found a static coefficient of its own, expected one coefficient");
    }
    return e.kinetic_limit.coefficients[c.normal];
  }

  void add_link(std::size_t i) {
    const AffineForm& form = problem_.equations[m_.accelerations + i];
    add_column(result_.G, form, m_.links[i].force, m_.links[i].name);
    result_.b.push_back(constant(form));
  }

  const MechanismScene& scene_;
  const Mechanism& m_;
  Mistakes mistakes_;
  FrictionProblem problem_;
  GlobalProblem result_;
};

}  // namespace

GlobalProblem global_problem(const MechanismScene& scene) {
  if (scene.mechanism.dimension == 3) return exported(space_problem(scene), scene.mechanism);
  return Exporter(scene).problem();
}

}  // namespace slipproof
