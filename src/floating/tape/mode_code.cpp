#include "floating/tape/mode_code.hpp"

#include <cmath>

#include "base/number/binary64.hpp"

namespace slipproof {

namespace {

void add_form(std::vector<TapeRef>& wanted, const SolvedForm& form) {
  wanted.push_back(form.constant);
  wanted.insert(wanted.end(), form.core.begin(), form.core.end());
  wanted.insert(wanted.end(), form.free.begin(), form.free.end());
}

void add_truths(std::vector<TapeRef>& wanted, const std::vector<TruthProgram>& truths) {
  for (const TruthProgram& truth : truths) {
    for (const auto& step : truth.steps) {
      if (step.operation == Operation::compare) wanted.push_back(step.difference);
    }
  }
}

/// The results that the decisions need.
std::vector<TapeRef> decision_of(const ModePrograms& programs) {
  std::vector<TapeRef> wanted = programs.divisors;
  add_truths(wanted, programs.domain);
  add_truths(wanted, programs.loads);
  for (const ModeProgram& program : programs.programs) {
    wanted.insert(wanted.end(), program.pivots.begin(), program.pivots.end());
    wanted.insert(wanted.end(), program.residuals.begin(), program.residuals.end());
    for (const SolvedForm& form : program.core) add_form(wanted, form);
    for (const SolvedForm& form : program.conditions) add_form(wanted, form);
  }
  return wanted;
}

std::vector<TapeRef> scales_of(const ModePrograms& programs) {
  std::vector<TapeRef> wanted = programs.line_constants;
  for (const auto* divisors : {&programs.inertias, &programs.levers}) {
    for (const auto& refs : *divisors) wanted.insert(wanted.end(), refs.begin(), refs.end());
  }
  return wanted;
}

RunningError rounded(const Rational& value) {
  const double nearest = nearest_binary64(value);
  if (!std::isfinite(nearest)) return {Lanes{}, Lanes{} + HUGE_VAL};
  const bool exact = to_rational(nearest) == value;
  return {Lanes{} + nearest, Lanes{} + (exact ? 0 : std::fabs(nearest) * batch_rounding + batch_underflow)};
}

}  // namespace

ModeCode::ModeCode(ModePrograms programs) : programs_(std::move(programs)) {
  TapeCompiler compiler(programs_.nodes, programs_.inputs());
  const auto alone = [&](const std::vector<TapeRef>& wanted) {
    compiler.forget();  // each code runs without the others
    return compiler.code_for(wanted);
  };
  decision_ = alone(decision_of(programs_));
  scales_ = alone(scales_of(programs_));
  for (const ModeProgram& program : programs_.programs) {
    std::vector<TapeRef> wanted;
    for (const auto* forms : {&program.core, &program.conditions, &program.accelerations, &program.forces}) {
      for (const SolvedForm& form : *forms) add_form(wanted, form);
    }
    values_.push_back(alone(wanted));
  }
  for (std::size_t i = 0; i < programs_.nodes.size(); ++i) places_.push_back(compiler.place(static_cast<TapeRef>(i)));
  for (const auto& [place, ref] : compiler.literals()) {
    literals_.emplace_back(place, rounded(programs_.constants[programs_.nodes[ref].first]));
  }
  count_ = compiler.places();
}

}  // namespace slipproof
