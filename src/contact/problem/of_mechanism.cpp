// The contacts of a mechanism as a contact problem: its equations solved for contact forces.
#include <algorithm>

#include "contact/problem/every_load.hpp"

namespace slipproof {

namespace {

bool fits(const ProblemElement& e, bool frictional) {
  const auto law = frictional ? ElementKind::Law::coulomb : ElementKind::Law::frictionless;
  return e.kind.law == law && e.kind.start == ElementKind::Start::rest && !e.kind.bilateral && e.kind.lifts;
}

/// mu, where both limits are mu N.
std::optional<Rational> coefficient(const ProblemElement& e) {
  const auto& normal = e.normal.coefficients;
  const auto entry = std::find_if(normal.begin(), normal.end(), [](const Rational& x) { return !x.is_zero(); });
  if (entry == normal.end()) return std::nullopt;
  const Rational mu = e.kinetic_limit.coefficients[static_cast<std::size_t>(entry - normal.begin())] / *entry;
  for (const AffineForm* limit : {&e.static_limit, &e.kinetic_limit}) {
    for (std::size_t i = 0; i < normal.size(); ++i) {
      if (limit->coefficients[i] != mu * normal[i]) return std::nullopt;
    }
  }
  return mu;
}

}  // namespace

std::optional<ContactProblem> contact_problem(const FrictionProblem& problem) {
  if (problem.elements.empty()) return std::nullopt;
  const bool frictional = problem.elements.front().kind.law == ElementKind::Law::coulomb;
  ContactProblem result;
  std::vector<const AffineForm*> forces, motions;
  for (const ProblemElement& e : problem.elements) {
    if (!fits(e, frictional)) return std::nullopt;
    forces.push_back(&e.normal), motions.push_back(&e.gap);
    if (!frictional) continue;
    forces.push_back(&e.tangent), motions.push_back(&e.slip);
    const auto mu = coefficient(e);
    if (!mu) return std::nullopt;
    result.mu.push_back(*mu);
  }
  // The equations, and forces = z, over the unknowns; right-hand sides: z, and 1.
  const std::size_t n = problem.unknowns, right = forces.size() + 1;
  RationalMatrix rows;
  const auto add = [&](const AffineForm& form, std::optional<std::size_t> force) {
    std::vector<Rational> row(form.coefficients.begin(), form.coefficients.begin() + static_cast<std::ptrdiff_t>(n));
    row.resize(n + right);
    if (force) row[n + *force] = 1;
    row.back() = -form.constant;
    rows.push_back(std::move(row));
  };
  for (const AffineForm& equation : problem.equations) add(equation, std::nullopt);
  for (std::size_t k = 0; k < forces.size(); ++k) add(*forces[k], k);
  const Echelon echelon = eliminate(rows);
  // Equations that are left over tie the forces to each other: then they are no unknowns of their own.
  if (echelon.rank(n) < n || echelon.rank() > n) return std::nullopt;
  for (const AffineForm* form : motions) {
    std::vector<Rational> row(right);
    row.back() = form->constant;
    for (std::size_t j = 0; j < n; ++j) {
      if (form->coefficients[j].is_zero()) continue;
      const Rational share = form->coefficients[j] / Rational(echelon.pivot);
      for (std::size_t k = 0; k < right; ++k) row[k] += share * Rational(echelon.rows[j][n + k]);
    }
    result.q.push_back(row.back());
    row.pop_back();
    result.W.push_back(std::move(row));
  }
  return result;
}

}  // namespace slipproof
