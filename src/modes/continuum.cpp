#include "modes/continuum.hpp"

#include <array>

#include "model/conditions.hpp"
#include "model/linear_form.hpp"
#include "number/bareiss.hpp"

namespace slipproof {

namespace {

/// Columns in the order of elimination: what a user would rather see as a free parameter comes last.
/// Indices into Unknowns: a, a_y, phi, eps1, eps2, eps3, T, S2, S3, N2, N3.
constexpr std::array<std::size_t, unknown_count> column_order{6, 3, 1, 2, 0, 7, 8, 4, 5, 9, 10};
constexpr std::array<Quantity, unknown_count> quantity_of_unknown{
    Quantity::a,  Quantity::a_y, Quantity::phi, Quantity::eps2, Quantity::eps2, Quantity::eps3,
    Quantity::S2, Quantity::S2,  Quantity::S3,  Quantity::N2,   Quantity::N3};

using Inequality = std::vector<Rational>;  // constant, then coefficients; >= 0

/// Integer rows: the eleven unknowns in column order, then -constant and -F coefficient as right-hand sides.
IntegerMatrix integer_rows(const std::array<LinearForm<Rational>, unknown_count>& system) {
  IntegerMatrix rows;
  for (const auto& form : system) {
    std::vector<Rational> row;
    for (const std::size_t column : column_order) row.push_back(form.coefficients[column]);
    row.push_back(-form.constant);
    row.push_back(-form.coefficients[unknown_count]);
    rows.push_back(clear_denominators(row));
  }
  return rows;
}

template <class V>
Unknowns<V> from_array(std::array<V, unknown_count> x) {
  return {x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10]};
}

/// Fourier-Motzkin: removes the last variable. The inequalities are all strict or all not, so sums keep the kind.
std::vector<Inequality> project_last(const std::vector<Inequality>& system) {
  std::vector<Inequality> result;
  for (const Inequality& x : system) {
    if (sign(x.back()) == 0) result.emplace_back(x.begin(), x.end() - 1);
  }
  for (const Inequality& up : system) {
    if (sign(up.back()) <= 0) continue;
    for (const Inequality& down : system) {
      if (sign(down.back()) >= 0) continue;
      Inequality sum;
      for (std::size_t i = 0; i + 1 < up.size(); ++i) sum.push_back(up[i] * -down.back() + down[i] * up.back());
      result.push_back(std::move(sum));
    }
  }
  return result;
}

/// The set of values of the first variable over all the others.
ForceInterval project_to_first(std::vector<Inequality> system, bool strict) {
  if (system.empty()) return {};
  while (system.front().size() > 2) {
    system = project_last(system);
    if (system.empty()) return {};
  }
  ForceInterval interval;
  for (const Inequality& x : system) interval.restrict_to({x[0], x[1]}, strict);
  return interval;
}

}  // namespace

std::optional<Continuum> solve_singular(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind,
                                        ContactMode mode) {
  const Echelon echelon = eliminate(integer_rows(raw_system(bicycle, road, kind, mode)), unknown_count);
  Continuum result;
  result.mode = mode;
  for (std::size_t i = echelon.rank(); i < echelon.rows.size(); ++i) {
    const Affine<Rational> residual(Rational(echelon.rows[i][unknown_count]),
                                    Rational(echelon.rows[i][unknown_count + 1]));
    result.solvable.restrict_to(residual, false);
    result.solvable.restrict_to(-residual, false);
  }
  if (result.solvable.empty()) return std::nullopt;

  std::array<Affine<Rational>, unknown_count> base;
  std::vector<bool> pivot(unknown_count, false);
  for (std::size_t i = 0; i < echelon.rank(); ++i) {
    const std::size_t column = echelon.pivot_columns[i];
    pivot[column] = true;
    base[column_order[column]] = {Rational(echelon.rows[i][unknown_count], echelon.pivot),
                                  Rational(echelon.rows[i][unknown_count + 1], echelon.pivot)};
  }
  result.base = motion_of(bicycle, from_array(base));
  for (std::size_t column = 0; column < unknown_count; ++column) {
    if (pivot[column]) continue;
    std::array<Rational, unknown_count> direction;
    direction[column_order[column]] = 1;
    for (std::size_t i = 0; i < echelon.rank(); ++i) {
      direction[column_order[echelon.pivot_columns[i]]] = Rational(-echelon.rows[i][column], echelon.pivot);
    }
    result.directions.push_back(motion_of(bicycle, from_array(direction)));
    result.parameters.push_back(quantity_of_unknown[column_order[column]]);
  }

  for (const Condition& condition : slipproof::conditions(mode)) {
    const Affine<Rational> constant = condition_value(condition, result.base, road.f);
    Inequality row{constant.alpha, constant.beta};
    for (const auto& direction : result.directions) row.push_back(condition_value(condition, direction, road.f));
    result.conditions_.push_back(std::move(row));
  }
  const auto forces = [&](bool strict) {
    if (!result.solvable.is_point()) return project_to_first(result.conditions_, strict);
    return result.parameter_ranges(*result.solvable.lower(), strict) ? result.solvable : ForceInterval::nothing();
  };
  result.closed = forces(false);
  result.strict = forces(true);
  return result;
}

std::optional<std::vector<ForceInterval>> Continuum::parameter_ranges(const Rational& force,
                                                                      bool strict_conditions) const {
  if (!solvable.contains(force)) return std::nullopt;
  std::vector<Inequality> system;
  for (const auto& row : conditions_) {
    Inequality at_force{row[0] + row[1] * force};
    at_force.insert(at_force.end(), row.begin() + 2, row.end());
    system.push_back(std::move(at_force));
  }
  std::vector<ForceInterval> ranges;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    std::vector<Inequality> turned = system;
    for (Inequality& row : turned) std::swap(row[1], row[k + 1]);
    ranges.push_back(project_to_first(std::move(turned), strict_conditions));
    if (ranges.back().empty()) return std::nullopt;
  }
  if (directions.empty()) {
    for (const Inequality& row : system) {
      if (sign(row[0]) < (strict_conditions ? 1 : 0)) return std::nullopt;
    }
  }
  return ranges;
}

std::vector<Quantity> Continuum::undetermined() const {
  std::vector<Quantity> result;
  for (const Quantity q : all_quantities()) {
    for (const auto& direction : directions) {
      if (sign(direction[q]) != 0) {
        result.push_back(q);
        break;
      }
    }
  }
  return result;
}

}  // namespace slipproof
