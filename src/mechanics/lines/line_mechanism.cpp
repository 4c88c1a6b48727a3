#include "mechanics/lines/line_mechanism.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace slipproof {

namespace {

/// A form over the force variable instead of the load, times the common denominator of its coefficients, which is
/// critical.
LineMechanism::ScaledRow to_polynomials(const FormRow<LineFunction>& form, const LineFunction& load,
                                        CriticalSet& found) {
  const std::size_t unknowns = form.entries.size() - 2;
  LineFunction slope, constant = form.entries[unknowns + 1];
  if (!form.entries[unknowns].is_zero()) {
    const LineFunction of_load = form.entries[unknowns] * load;  // alpha + beta x, without x in its denominator
    const auto part = [&](std::size_t power) {
      if (power >= of_load.numerator().size()) return LineFunction();
      return LineFunction(ForcePolynomial{of_load.numerator()[power]}, ForcePolynomial{of_load.denominator().front()});
    };
    slope = part(1);
    constant = constant + part(0);
  }
  std::vector<const LineFunction*> all;
  for (std::size_t j = 0; j < unknowns; ++j) all.push_back(&form.entries[j]);
  all.insert(all.end(), {&slope, &constant});
  IntegerPolynomial common(1);
  for (const LineFunction* x : all) common = least_common_multiple(common, x->denominator().front());
  found.add(common);
  PolynomialRow row;
  for (const LineFunction* x : all) {
    row.push_back(x->is_zero() ? IntegerPolynomial(0)
                               : scaled(x->numerator().front(), common, x->denominator().front()));
  }
  return {std::move(row), std::move(common)};
}

Affine<IntegerPolynomial> over_force(const PolynomialRow& row) {
  return {row[row.size() - 1], row[row.size() - 2]};
}

}  // namespace

LineEvaluator evaluator_along(const Line& line, const CompiledFamily& family, LineField field,
                              std::optional<std::size_t> grows) {
  LineEvaluator evaluator(family.scope(), std::move(field));
  for (std::size_t k = 0; k < line.origin.size(); ++k) {
    evaluator.set(CompiledFamily::parameter_slot(k),
                  grows == k ? LineFunction::force() : LineFunction::linear(line.origin[k], line.direction[k]));
  }
  if (!grows) evaluator.set(CompiledFamily::force_slot(), LineFunction::force());
  return evaluator;
}

LineMechanism::LineMechanism(const CompiledFamily& family, LineEvaluator& symbols)
    : family_(family), symbols_(symbols), found_(*symbols.field().found) {
  const CompiledMechanism& compiled = family.maker().compiled();
  const CompiledScene& scene = family.scene();
  LineEvaluator at(compiled.scope(), symbols.field());
  if (!put_scene(family, symbols, at, [](const LineFunction& value) { return value.without_force(); })) return;
  if (scene.load) {
    auto load = symbols.number(*scene.load).number;
    if (!load || load->numerator().size() > 2 || load->denominator().size() != 1) return;
    load_ = std::move(*load);
  }
  system_ = system_of(family.mechanism(), compiled, family.kinds(), at);
  if (system_) rows_.resize(system_->elements.size());
}

std::vector<PolynomialRow> LineMechanism::equations(const MechanismMode& mode) const {
  std::vector<PolynomialRow> rows;
  const auto add = [&](const FormRow<LineFunction>& form) { rows.push_back(to_polynomials(form, load_, found_).row); };
  for (const auto& equation : system_->equations) add(equation);
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const auto& element = system_->elements[i];
    for (const StateEquation e : slipproof::equations(element.kind, mode[i])) add(form_of(element, mode[i], e));
  }
  return rows;
}

const SolvedRows& LineMechanism::in_every_mode() {
  if (!in_every_mode_) {
    std::vector<PolynomialRow> rows;
    for (const auto& equation : system_->equations) rows.push_back(to_polynomials(equation, load_, found_).row);
    in_every_mode_.emplace(std::move(rows), family_.unknowns(), found_);
  }
  return *in_every_mode_;
}

LineMechanism::ScaledRow LineMechanism::reduced(const FormRow<LineFunction>& form) {
  auto [row, factor] = to_polynomials(form, load_, found_);
  factor = factor * in_every_mode().reduce(row);
  PolynomialRow left;
  for (const std::size_t unknown : in_every_mode().free()) left.push_back(std::move(row[unknown]));
  left.insert(left.end(), std::make_move_iterator(row.end() - 2), std::make_move_iterator(row.end()));
  return {std::move(left), std::move(factor)};
}

const LineMechanism::StateRows& LineMechanism::rows_of(std::size_t index, ElementState state) {
  const auto [place, is_new] = rows_[index].try_emplace(state);
  StateRows& rows = place->second;
  if (!is_new) return rows;
  const auto& element = system_->elements[index];
  for (const StateEquation e : slipproof::equations(element.kind, state)) {
    rows.equations.push_back(reduced(form_of(element, state, e)).row);
  }
  for (const StateCondition c : slipproof::conditions(element.kind, state)) {
    rows.conditions.push_back(reduced(form_of(element, state, c)).row);
  }
  if (!holds_in_cone(element.kind, state)) return rows;
  for (const auto* form : {&element.tangent, &element.second_tangent, &element.static_limit})
    rows.cone.push_back(reduced(*form));
  return rows;
}

/// The ends of a mode's forces are among the forms without other unknowns; where two of them meet, what is left of
/// them without the force vanishes, and is critical as any common factor of a row is.
bool LineMechanism::add_conditions(Conditions conditions, const std::vector<std::size_t>& free) {
  for (const std::size_t unknown : free) {
    if (!conditions.eliminate(unknown)) return false;
  }
  const std::vector<PolynomialRow> ends = conditions.rows();
  if (!conditions.eliminate(in_every_mode().free().size())) return false;
  found_.begin_mode();
  for (const PolynomialRow& end : ends) found_.add_end(over_force(end));
  return true;
}

bool LineMechanism::add_cone(std::vector<ScaledRow> cone, const SolvedRows& solved) {
  const std::size_t unknowns = in_every_mode().free().size();
  std::vector<IntegerPolynomial> squares;  // of the three, over the square of their common denominator
  IntegerPolynomial common(1);
  for (ScaledRow& one : cone) {
    one.factor = one.factor * solved.reduce(one.row);
    for (std::size_t i = 0; i < unknowns; ++i) {
      if (!one.row[i].is_zero()) return false;
    }
    common = least_common_multiple(common, one.factor);
  }
  for (const ScaledRow& one : cone) {
    const IntegerPolynomial value = scaled(one.row.back(), common, one.factor);
    squares.push_back(value * value);
  }
  found_.add(squares[0] + squares[1] - squares[2]);
  return true;
}

bool LineMechanism::add_mode(const MechanismMode& mode, const std::vector<std::size_t>& wanted) {
  if (!in_every_mode().solvable()) return false;
  std::vector<PolynomialRow> equations, conditions;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    if (mode[i] == ElementState::slip && !has_state(system_->elements[i].kind, mode[i])) return false;  // no equations
    const StateRows& rows = rows_of(i, mode[i]);
    equations.insert(equations.end(), rows.equations.begin(), rows.equations.end());
    conditions.insert(conditions.end(), rows.conditions.begin(), rows.conditions.end());
  }
  const std::size_t unknowns = in_every_mode().free().size();
  const SolvedRows solved(std::move(equations), unknowns, found_);
  if (!solved.solvable()) return false;
  for (PolynomialRow& condition : conditions) solved.reduce(condition);
  bool complete = add_conditions(Conditions(std::move(conditions), found_), solved.free());
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const std::vector<ScaledRow>& cone = rows_of(i, mode[i]).cone;
    if (!cone.empty()) complete = add_cone(cone, solved) && complete;
  }
  for (const std::size_t slot : wanted) {
    const std::size_t quantity = slot - family_.quantity_slot(0), first = system_->accelerations.size();
    auto [value, factor] =
        reduced(quantity < first ? system_->accelerations[quantity] : system_->forces[quantity - first]);
    const IntegerPolynomial denominator = factor * solved.reduce(value);
    const bool determined = std::all_of(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(unknowns),
                                        [](const auto& x) { return x.is_zero(); });
    if (determined) symbols_.set(slot, LineFunction(over_force(value), denominator));
  }
  return complete;
}

}  // namespace slipproof
