#include "modes/continuum.hpp"

#include <array>

#include "model/conditions.hpp"
#include "model/linear_form.hpp"

namespace slipproof {

namespace {

/// Columns in the order of elimination: what a user would rather see as a free parameter comes last.
/// Indices into Unknowns: a, a_y, phi, eps1, eps2, eps3, T, S2, S3, N2, N3.
constexpr std::array<std::size_t, unknown_count> column_order{6, 3, 1, 2, 0, 7, 8, 4, 5, 9, 10};
constexpr std::array<Quantity, unknown_count> quantity_of_unknown{
    Quantity::a,  Quantity::a_y, Quantity::phi, Quantity::eps2, Quantity::eps2, Quantity::eps3,
    Quantity::S2, Quantity::S2,  Quantity::S3,  Quantity::N2,   Quantity::N3};

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

/// The conditions of a mode are linear in the unknowns: what each of them does alone.
std::vector<AffineForm> condition_forms(const Bicycle<Rational>& bicycle, const Rational& friction, ContactMode mode) {
  std::vector<AffineForm> forms;
  for (const Condition& condition : conditions(mode)) {
    AffineForm& form = forms.emplace_back();
    for (const std::size_t column : column_order) {
      std::array<Rational, unknown_count> alone;
      alone[column] = 1;
      form.coefficients.push_back(condition_value(condition, motion_of(bicycle, from_array(alone)), friction));
    }
    form.coefficients.emplace_back(0);
  }
  return forms;
}

}  // namespace

std::optional<Continuum> solve_singular(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind,
                                        ContactMode mode) {
  AffineSpace space(unknown_count, true);
  for (const LinearForm<Rational>& form : raw_system(bicycle, road, kind, mode)) {
    if (!space.require(to_form(form))) return std::nullopt;
  }
  Continuum result;
  result.mode = mode;
  if (!space.load_is_free()) result.solvable = ForceInterval::point(space.load());

  std::array<AffineForm, unknown_count> solution;
  std::array<Affine<Rational>, unknown_count> base;
  for (std::size_t column = 0; column < unknown_count; ++column) {
    solution[column] = space.on(unknown(column));
    base[column_order[column]] = {solution[column].constant, solution[column].coefficients.back()};
  }
  result.base = motion_of(bicycle, from_array(base));
  for (const std::size_t free : space.free_unknowns()) {
    std::array<Rational, unknown_count> direction;
    for (std::size_t column = 0; column < unknown_count; ++column) {
      direction[column_order[column]] = solution[column].coefficients[free];
    }
    result.directions.push_back(motion_of(bicycle, from_array(direction)));
    result.parameters.push_back(quantity_of_unknown[column_order[free]]);
    result.free_.push_back(unknown(free));
  }

  for (const AffineForm& form : condition_forms(bicycle, road.f, mode)) result.conditions_.push_back(space.on(form));
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
