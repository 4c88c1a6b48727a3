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
    if (m_.load && !scene_.load) {
      mistakes_.add({}, "found no value of the load " + m_.load->symbol + ", expected one: a scene in space has one");
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
    if (!kind.lifts) mistakes_.add(c.place, c.name + ": found a contact whose lift is not modelled, expected a value of "
                                                     "what its lift needs");
    SpaceContact contact{i, 0, std::nullopt};
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
      contact.sliding = {number(compiled.sliding[0], what), number(compiled.sliding[1], what)};
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

/// The unknowns v and lambda as affine functions of r: M v - G lambda = H r + f and G^T v = -b, reduced.
class Elimination {
 public:
  Elimination(const SpaceProblem& problem, const Mechanism& mechanism)
      : p_(problem.global), m_(mechanism), v_(p_.f.size()), held_(p_.b.size()), r_(p_.w.size()) {
    RationalMatrix rows(v_ + held_, std::vector<Rational>(v_ + held_ + r_ + 1));
    for (std::size_t i = 0; i < v_; ++i) {
      for (std::size_t j = 0; j < v_; ++j) rows[i][j] = p_.M[i][j];
      for (std::size_t j = 0; j < held_; ++j) {
        rows[i][v_ + j] = -p_.G[i][j];
        rows[v_ + j][i] = p_.G[i][j];
      }
      for (std::size_t j = 0; j < r_; ++j) rows[i][v_ + held_ + j] = p_.H[i][j];
      rows[i].back() = p_.f[i];
    }
    for (std::size_t j = 0; j < held_; ++j) rows[v_ + j].back() = -p_.b[j];
    echelon_ = eliminate(rows);
  }

  ReducedSpace result() {
    const std::size_t unknowns = v_ + held_;
    if (echelon_.rank() > echelon_.rank(unknowns)) refuse_contradiction();
    row_of_.assign(unknowns, std::nullopt);
    for (std::size_t i = 0; i < echelon_.rank(); ++i) row_of_[echelon_.pivot_columns[i]] = i;
    ReducedSpace result;
    for (std::size_t j = 0; j < unknowns; ++j) {
      const bool known = is_determined(j);
      if (j < v_ && !known) refuse_free(j);
      if (j >= v_) result.determined.push_back(known);
      std::vector<Rational> over(r_);
      for (std::size_t k = 0; k < r_ && row_of_[j]; ++k) over[k] = entry(j, unknowns + k);
      (j < v_ ? result.V : result.L).push_back(std::move(over));
      (j < v_ ? result.v0 : result.l0).push_back(row_of_[j] ? entry(j, unknowns + r_) : Rational(0));
    }
    return result;
  }

 private:
  Rational entry(std::size_t unknown, std::size_t column) const {
    return {echelon_.rows[*row_of_[unknown]][column], echelon_.pivot};
  }
  /// By a row in which no unknown stands that may be anything.
  bool is_determined(std::size_t unknown) const {
    if (!row_of_[unknown]) return false;
    for (std::size_t j = 0; j < v_ + held_; ++j) {
      if (!row_of_[j] && !echelon_.rows[*row_of_[unknown]][j].is_zero()) return false;
    }
    return true;
  }
  [[noreturn]] void refuse(Place place, const std::string& message) const {
    throw InputError({{m_.file, place.line, place.column, message}});
  }
  [[noreturn]] void refuse_contradiction() const {
    refuse({}, "found joints that no accelerations satisfy: they contradict each other, or force a prescribed motion, "
               "expected joints that fit");
  }
  [[noreturn]] void refuse_free(std::size_t unknown) const {
    const MechanismUnknown& one = m_.unknowns[unknown];
    refuse(one.place, "found that neither a mass nor an inertia nor a joint determines " + one.symbol +
                          ", expected bodies that forces move in one way");
  }

  const GlobalProblem& p_;
  const Mechanism& m_;
  std::size_t v_, held_, r_;
  Echelon echelon_;
  std::vector<std::optional<std::size_t>> row_of_;  ///< of each unknown that is a pivot
};

/// Column N of a contact that slides becomes N - mu (d1 T1 + d2 T2), and T1 and T2 are none.
void slide(RationalMatrix& matrix, const std::vector<SpaceContact>& contacts) {
  for (auto& row : matrix) {
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      if (!contacts[k].sliding) continue;
      const auto& d = *contacts[k].sliding;
      row[3 * k] -= contacts[k].mu * (d[0] * row[3 * k + 1] + d[1] * row[3 * k + 2]);
      row[3 * k + 1] = row[3 * k + 2] = 0;
    }
  }
}

}  // namespace

SpaceProblem space_problem(const MechanismScene& scene) {
  return SpaceProblemMaker(scene).problem();
}

ReducedSpace reduced(const SpaceProblem& problem, const Mechanism& mechanism) {
  ReducedSpace result = Elimination(problem, mechanism).result();
  slide(result.V, problem.contacts);
  slide(result.L, problem.contacts);
  const GlobalProblem& p = problem.global;
  ExactContacts& contacts = result.contacts;
  contacts.W.assign(p.w.size(), std::vector<Rational>(p.w.size()));
  contacts.q = p.w;
  for (const SpaceContact& one : problem.contacts) contacts.mu.push_back(one.sliding ? Rational(0) : one.mu);
  for (std::size_t v = 0; v < result.V.size(); ++v) {
    for (std::size_t i = 0; i < p.w.size(); ++i) {
      const Rational& weight = p.H[v][i];
      if (weight.is_zero()) continue;
      for (std::size_t j = 0; j < p.w.size(); ++j) {
        if (!result.V[v][j].is_zero()) contacts.W[i][j] += weight * result.V[v][j];
      }
      contacts.q[i] += weight * result.v0[v];
    }
  }
  return result;
}

GlobalProblem exported(const SpaceProblem& problem, const Mechanism& mechanism) {
  const auto slides = [](const SpaceContact& contact) { return contact.sliding.has_value(); };
  if (std::ranges::none_of(problem.contacts, slides)) return problem.global;
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
