#include "mechanics/checks/free_motion.hpp"

#include <algorithm>
#include <cstdint>

#include "base/algebra/elimination.hpp"
#include "mechanics/points/sampling.hpp"

namespace slipproof::mechanism_checks {

std::optional<Matrix> solve(const std::vector<Row>& rows, std::size_t unknowns) {
  RationalMatrix matrix;
  for (const Row& row : rows) {
    matrix.push_back(row.coefficients);
    matrix.back().insert(matrix.back().end(), row.right.begin(), row.right.end());
  }
  const Echelon echelon = eliminate(matrix);
  if (rows.size() != unknowns || echelon.rank(unknowns) < unknowns) return std::nullopt;
  Matrix solution;
  for (std::size_t i = 0; i < unknowns; ++i) {
    std::vector<Rational> values;
    for (std::size_t k = unknowns; k < echelon.rows[i].size(); ++k) {
      values.emplace_back(echelon.rows[i][k], echelon.pivot);
    }
    solution.push_back(std::move(values));
  }
  return solution;
}

std::vector<Pairing> pairings(const Mechanism& mechanism, const FrictionProblem& problem) {
  std::vector<Pairing> result;
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    const MechanismContact& contact = mechanism.contacts[i];
    result.push_back({problem.elements[i].gap, contact.normal, contact.gap_name, contact.gap.place()});
    if (contact.frictionless()) continue;
    result.push_back({problem.elements[i].slip, *contact.tangent, contact.slip_name, contact.slip.place()});
  }
  for (std::size_t i = 0; i < mechanism.friction.size(); ++i) {
    const MechanismFriction& friction = mechanism.friction[i];
    const AffineForm& slip = problem.elements[mechanism.contacts.size() + i].slip;
    result.push_back({slip, friction.force, friction.slip_name, friction.slip.place()});
  }
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
    const MechanismLink& link = mechanism.links[i];
    result.push_back({problem.equations[mechanism.equations.size() + i], link.force, link.name, link.zero.place()});
  }
  return result;
}

std::optional<Matrix> delassus(const Mechanism& mechanism, const FrictionProblem& problem,
                               const std::vector<Pairing>& pairings) {
  const std::size_t own = mechanism.accelerations + mechanism.forces;
  std::vector<Row> rows;
  for (std::size_t i = 0; i < mechanism.equations.size(); ++i) {
    const auto& coefficients = problem.equations[i].coefficients;
    Row row{{coefficients.begin(), coefficients.begin() + static_cast<std::ptrdiff_t>(own)}, {}};
    for (const Pairing& pairing : pairings) row.right.push_back(-coefficients[pairing.force]);
    rows.push_back(std::move(row));
  }
  const auto motions = solve(rows, own);
  if (!motions) return std::nullopt;
  Matrix result(pairings.size(), std::vector<Rational>(pairings.size()));
  for (std::size_t i = 0; i < pairings.size(); ++i) {
    for (std::size_t k = 0; k < pairings.size(); ++k) {
      for (std::size_t x = 0; x < own; ++x) {
        result[i][k] += pairings[i].motion.coefficients[x] * (*motions)[x][k];
      }
    }
  }
  return result;
}

std::optional<FreeMotion> free_motion(const Mechanism& mechanism, const FrictionProblem& problem) {
  std::vector<std::size_t> variables;
  for (std::size_t i = 0; i < mechanism.unknowns.size(); ++i) {
    using Role = MechanismUnknown::Role;
    const Role role = mechanism.unknowns[i].role;
    if (role == Role::acceleration || role == Role::force || role == Role::link) variables.push_back(i);
  }
  std::vector<Row> rows;
  for (const AffineForm& equation : problem.equations) {
    Row row{{}, {Rational(-equation.constant)}};
    for (const std::size_t variable : variables) row.coefficients.push_back(equation.coefficients[variable]);
    rows.push_back(std::move(row));
  }
  const auto motion = solve(rows, variables.size());
  if (!motion) return std::nullopt;
  FreeMotion result;
  for (std::size_t i = 0; i < mechanism.accelerations; ++i) result.moves = result.moves || !(*motion)[i][0].is_zero();
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    const AffineForm& form = problem.elements[i].gap;
    Rational gap = form.constant;
    for (std::size_t k = 0; k < variables.size(); ++k) gap += form.coefficients[variables[k]] * (*motion)[k][0];
    result.gaps.push_back(std::move(gap));
  }
  return result;
}

namespace {

/// The links, from the first, whose accelerations are a combination of those before them.
std::vector<std::size_t> dependent_links(const Mechanism& mechanism, const FrictionProblem& problem) {
  RationalMatrix columns(mechanism.accelerations);
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
    const AffineForm& form = problem.equations[mechanism.equations.size() + i];
    for (std::size_t j = 0; j < columns.size(); ++j) columns[j].push_back(form.coefficients[j]);
  }
  const Echelon echelon = eliminate(columns);
  std::vector<std::size_t> dependent;
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
    if (!std::ranges::binary_search(echelon.pivot_columns, i)) dependent.push_back(i);
  }
  return dependent;
}

}  // namespace

std::optional<Freedom> freedom(const Mechanism& mechanism) {
  constexpr std::size_t enough = 4;
  constexpr std::uint64_t seed = 1;
  const ProblemMaker maker(mechanism);
  std::optional<std::vector<std::size_t>> dependent;
  for (const MechanismValues& values : sample_values(mechanism, maker, enough, seed)) {
    try {
      auto found = dependent_links(mechanism, maker.problem(values));
      if (dependent && *dependent != found) return std::nullopt;
      dependent = std::move(found);
    } catch (const NoValue&) {  // another point may have one
    }
  }
  if (!dependent) return std::nullopt;
  return Freedom{mechanism.accelerations + dependent->size() - mechanism.links.size(), std::move(*dependent)};
}

}  // namespace slipproof::mechanism_checks
