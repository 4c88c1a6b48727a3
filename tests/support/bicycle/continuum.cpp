#include "support/bicycle/continuum.hpp"

#include <algorithm>
#include <array>

#include "support/bicycle/conditions.hpp"
#include "support/bicycle/linear_form.hpp"

namespace slipproof {

namespace {

/// Columns in the order of elimination: what a user would rather see as a free parameter comes last.
/// Indices into Unknowns: a, a_y, phi, eps1, eps2, eps3, T, S2, S3, N2, N3.
constexpr std::array<std::size_t, unknown_count> column_order{6, 3, 1, 2, 0, 7, 8, 4, 5, 9, 10};

/// Over the unknowns in column order.
AffineForm to_form(const LinearForm<Rational>& form) {
  AffineForm result{form.constant, {}};
  for (const std::size_t column : column_order) result.coefficients.push_back(form.coefficients[column]);
  result.coefficients.push_back(form.coefficients[unknown_count]);
  return result;
}

AffineForm unknown(std::size_t column) {
  AffineForm result{0, std::vector<Rational>(unknown_count + 1)};
  result.coefficients[column] = 1;
  return result;
}

template <class V>
Unknowns<V> from_array(std::array<V, unknown_count> x) {
  return {x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10]};
}

}  // namespace

SingularModes::SingularModes(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind)
    : bicycle_(bicycle), road_(road), in_every_mode_(unknown_count, true) {
  const auto equations = equations_of_motion(bicycle, road, kind, unknown_forms<Rational>(), force_form<Rational>());
  solvable_ = std::all_of(equations.begin(), equations.end(),
                          [&](const LinearForm<Rational>& form) { return in_every_mode_.require(to_form(form)); });
}

std::optional<Continuum> SingularModes::solve(ContactMode mode) const {
  if (!solvable_) return std::nullopt;
  const auto unknowns = unknown_forms<Rational>();
  AffineSpace space = in_every_mode_;
  for (const Wheel wheel : {Wheel::rear, Wheel::front}) {
    for (const auto& form : contact_equations(bicycle_, road_, unknowns, wheel, mode[wheel])) {
      if (!space.require(to_form(form))) return std::nullopt;
    }
  }
  Continuum result;
  result.mode = mode;

  std::array<AffineForm, unknown_count> solution;
  std::array<Affine<Rational>, unknown_count> base;
  for (std::size_t column = 0; column < unknown_count; ++column) {
    solution[column] = space.on(unknown(column));
    base[column_order[column]] = {solution[column].constant, solution[column].coefficients.back()};
  }
  result.base = motion_of(bicycle_, from_array(base));
  for (const std::size_t free : space.free_unknowns()) {
    std::array<Rational, unknown_count> direction;
    for (std::size_t column = 0; column < unknown_count; ++column) {
      direction[column_order[column]] = solution[column].coefficients[free];
    }
    result.directions.push_back(motion_of(bicycle_, from_array(direction)));
    result.free_.push_back(unknown(free));
  }

  const Motion<LinearForm<Rational>> motion = motion_of(bicycle_, unknowns);
  for (const Condition& condition : slipproof::conditions(mode)) {
    result.conditions_.push_back(space.on(to_form(condition_value(condition, motion, road_.f))));
  }
  Narrowed narrowed = narrow(std::move(space), result.conditions_, ForceInterval());
  if (auto* solutions = std::get_if<Polyhedron>(&narrowed)) {
    result.closed = solutions->loads;
    result.strict = strict_loads(*solutions);
    result.solutions_ = std::move(*solutions);
  } else {
    result.closed = result.strict = ForceInterval::nothing();
  }
  return result;
}

std::optional<std::vector<ForceInterval>> Continuum::parameter_ranges(const Rational& force) const {
  const auto consistent = solutions_ ? at_load(*solutions_, force) : std::nullopt;
  if (!consistent) return std::nullopt;
  std::vector<ForceInterval> result;
  for (const Range& range : ranges(*consistent, free_)) {
    result.push_back(ForceInterval::between(range.lower, true, range.upper, true));
  }
  return result;
}

}  // namespace slipproof
