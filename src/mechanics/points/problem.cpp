#include "mechanics/points/problem.hpp"

#include <fmt/format.h>

#include "base/input/diagnostic.hpp"
#include "base/number/affine.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "mechanics/mechanism/system.hpp"

namespace slipproof {

namespace {

/// The forms of one mechanism at one point.
class ProblemForms {
 public:
  ProblemForms(const Mechanism& mechanism, Evaluator<Rational>& at) : rows_(mechanism, at) {}

  AffineForm form(const CompiledForm& compiled, const std::string& what) { return valued(rows_.form(compiled, what)); }
  AffineForm unit(std::size_t unknown) { return valued(rows_.unit(unknown)); }
  AffineForm limit(const Program& friction, std::size_t normal, const std::string& what) {
    return valued(rows_.limit(friction, normal, what));
  }

 private:
  AffineForm valued(FormRow<Rational> row) const {
    const std::string& without = rows_.without_value();
    if (!without.empty()) throw NoValue(without + " has no value: it divides by zero");
    AffineForm result{std::move(row.entries.back()), {}};
    row.entries.pop_back();
    result.coefficients = std::move(row.entries);
    return result;
  }

  RowForms<Rational, FieldOf<Rational>> rows_;
};

/// Forms have a coefficient for each unknown, and modes are many.
void refuse_too_many_elements(const Mechanism& mechanism) {
  constexpr std::size_t most = 64, most_in_space = 150;
  const std::size_t limit = mechanism.dimension == 2 ? most : most_in_space;
  if (mechanism.elements() <= limit) return;
  throw InputError({{mechanism.file, 0, 0,
                     fmt::format("found {} contacts and friction elements, expected at most {} where motions are asked "
                                 "for: `slipproof rest` takes more",
                                 mechanism.elements(), limit)}});
}

}  // namespace

MechanismValues default_values(const Mechanism& mechanism) {
  return {std::vector<Rational>(mechanism.parameters.size()), std::vector<bool>(mechanism.parameters.size(), true),
          std::vector<MechanismValues::Circle>(mechanism.angles.size()), starts(mechanism)};
}

Evaluator<Rational> ProblemMaker::at(const MechanismValues& values) const {
  Evaluator<Rational> at(compiled_.scope());
  for (std::size_t i = 0; i < values.parameters.size(); ++i) at.set(compiled_.parameter(i), values.parameters[i]);
  for (std::size_t i = 0; i < values.angles.size(); ++i) {
    at.set(compiled_.cosine(i), values.angles[i].cosine);
    at.set(compiled_.sine(i), values.angles[i].sine);
  }
  return at;
}

FrictionProblem ProblemMaker::problem(const MechanismValues& values) const {
  refuse_too_many_elements(*mechanism_);
  Evaluator<Rational> evaluator = at(values);
  ProblemForms forms(*mechanism_, evaluator);
  FrictionProblem problem;
  assemble(*mechanism_, compiled_, element_kinds(*mechanism_, values.starts, values.given), forms, problem);
  problem.has_load = mechanism_->load.has_value();
  problem.load_domain = load_domain(values);
  return problem;
}

ForceInterval ProblemMaker::load_domain(const MechanismValues& values) const {
  ForceInterval domain;
  Evaluator<Rational> evaluator = at(values);
  for (const CompiledBound& bound : compiled_.load_domain) {
    const auto numbers = coefficients(bound.form, evaluator, 0);
    if (!numbers) return ForceInterval::nothing();
    const Affine<Rational> condition((*numbers)[1], (*numbers)[0]);
    domain.restrict_to(condition, bound.relation == Relation::greater);
    if (bound.relation == Relation::equal) domain.restrict_to(-condition, false);
  }
  return domain;
}

std::vector<ProblemMaker::Broken> ProblemMaker::broken(const MechanismValues& values) const {
  std::vector<Broken> result;
  Evaluator<Rational> evaluator = at(values);
  const auto check = [&](Broken::What what, std::size_t index, const Program& program,
                         const PlacedExpression& condition) {
    if (evaluator.truth(program) != Truth::yes) result.push_back({what, index, &condition});
  };
  for (std::size_t i = 0; i < values.parameters.size(); ++i) {
    if (!values.given[i]) continue;
    check(Broken::What::parameter, i, compiled_.parameter_domains[i], mechanism_->parameters[i].domain);
  }
  for (std::size_t i = 0; i < values.angles.size(); ++i) {
    check(Broken::What::angle, i, compiled_.angle_domains[i], mechanism_->angles[i].domain);
  }
  for (std::size_t i = 0; i < compiled_.assume.size(); ++i) {
    check(Broken::What::assumption, i, compiled_.assume[i], mechanism_->assume[i].condition);
  }
  return result;
}

std::string too_many_modes(double modes) {
  return fmt::format(
      "found {:.3g} contact modes, among which the motions are not found with the effort that is made, expected fewer "
      "contacts: `slipproof export` writes the contact problem, and `slipproof certify` judges an answer to it",
      modes);
}

void refuse_too_many_modes(const Mechanism& mechanism, const std::vector<ElementKind>& kinds) {
  const double modes = mode_count(kinds);
  if (modes <= static_cast<double>(max_modes)) return;
  throw InputError(
      {{mechanism.file, 0, 0,
        fmt::format("found {} modes, expected at most {}: {} contacts and friction elements",
                    modes > 1e19 ? "more than 10^19" : fmt::format("{:.0f}", modes), max_modes, kinds.size())}});
}

FrictionProblem friction_problem(const Mechanism& mechanism, const MechanismValues& values) {
  return ProblemMaker(mechanism).problem(values);
}

}  // namespace slipproof
