#include "mechanism/domain_sampler.hpp"

#include <algorithm>
#include <utility>

#include "mechanism/degrees.hpp"

namespace slipproof {

DomainSampler::DomainSampler(const Mechanism& mechanism, const ProblemMaker& maker, PointsOf points)
    : mechanism_(&mechanism), compiled_(&maker.compiled()), points_(points) {
  for (const MechanismParameter& parameter : mechanism.parameters) add_comparisons(parameter.domain.expression);
  for (const MechanismCondition& one : mechanism.assume) add_comparisons(one.condition.expression);
  if (points == PointsOf::domain) return;
  for (const MechanismCondition& one : mechanism.realisable) add_comparisons(one.condition.expression);
}

void DomainSampler::add_comparisons(const Expression& condition, bool required) {
  const Node& node = *condition;
  if (node.operation != Operation::compare) {
    if (node.operation == Operation::truth) return;
    required = required && node.operation == Operation::logical_and;
    for (const Expression& operand : node.operands) add_comparisons(operand, required);
    return;
  }
  for (std::size_t i = 0; i < node.relations.size(); ++i) {
    const Expression difference = make(Operation::subtract, {node.operands[i], node.operands[i + 1]});
    comparisons_.push_back({compiled_->compile(difference), required && node.relations[i] == Relation::equal});
  }
}

std::vector<const Program*> DomainSampler::conditions(const std::vector<bool>& given) const {
  std::vector<const Program*> result;
  for (const Program& program : compiled_->angle_domains) result.push_back(&program);
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (given[i]) result.push_back(&compiled_->parameter_domains[i]);
  }
  for (const Program& program : compiled_->assume) result.push_back(&program);
  if (points_ == PointsOf::domain) return result;
  for (const Program& program : compiled_->realisable) result.push_back(&program);
  return result;
}

Evaluator<Rational> DomainSampler::evaluator(const MechanismValues& values, std::size_t angles,
                                             std::size_t parameters) const {
  Evaluator<Rational> at(compiled_->scope());
  for (std::size_t i = 0; i < parameters; ++i) at.set(compiled_->parameter(i), values.parameters[i]);
  for (std::size_t i = 0; i < angles; ++i) {
    at.set(compiled_->cosine(i), values.angles[i].cosine);
    at.set(compiled_->sine(i), values.angles[i].sine);
  }
  return at;
}

bool DomainSampler::contains(const MechanismValues& values) const {
  Evaluator<Rational> at = evaluator(values, values.angles.size(), values.parameters.size());
  const auto all = conditions(values.given);
  return std::all_of(all.begin(), all.end(), [&](const Program* one) { return at.truth(*one) == Truth::yes; });
}

/// Where a difference that is affine in a parameter vanishes, of those before `parameters` all but `unknown` known.
std::optional<Rational> DomainSampler::root(const Program& difference, const MechanismValues& values,
                                            std::size_t parameters, std::size_t unknown) const {
  std::vector<Rational> at;
  for (int x = 0; x <= 2; ++x) {
    Evaluator<Rational> evaluator = this->evaluator(values, values.angles.size(), parameters);
    evaluator.set(compiled_->parameter(unknown), x);
    const auto value = evaluator.number(difference);
    if (!value.number) return std::nullopt;
    at.push_back(*value.number);
  }
  const Rational slope = at[1] - at[0];
  if (slope.is_zero() || Rational(at[2] - at[1]) != slope) return std::nullopt;
  return Rational(-at[0] / slope);
}

DomainSampler::Roots DomainSampler::roots(const MechanismValues& values, std::size_t parameter) const {
  Roots result;
  for (const Comparison& comparison : comparisons_) {
    auto found = root(comparison.difference, values, parameter, parameter);
    if (!found) continue;
    const auto place = comparison.equation ? result.values.begin() : result.values.end();
    result.values.insert(place, std::move(*found));
    result.fixed = result.fixed || comparison.equation;
  }
  return result;
}

void DomainSampler::restore(MechanismValues& values, std::size_t kept) const {
  const std::size_t count = values.parameters.size();
  for (const Comparison& comparison : comparisons_) {
    if (!comparison.equation) continue;
    const auto difference = evaluator(values, values.angles.size(), count).number(comparison.difference);
    if (!difference.number || difference.number->is_zero()) continue;
    for (std::size_t i = count; i-- > 0;) {
      if (i == kept || !values.given[i]) continue;
      auto value = root(comparison.difference, values, count, i);
      if (!value) continue;
      values.parameters[i] = std::move(*value);
      break;
    }
  }
}

/// The drawing of one point.
class DomainSampler::Run {
 public:
  Run(const DomainSampler& sampler, const std::vector<bool>& given, const Draw& draw)
      : sampler_(sampler), draw_(draw), values_(default_values(*sampler.mechanism_)) {
    values_.given = given;
    pending_ = sampler.conditions(given);
  }

  std::optional<MechanismValues> point() {
    for (std::size_t i = 0; i < values_.angles.size(); ++i) {
      if (!choose_angle(i)) return std::nullopt;
    }
    for (std::size_t i = 0; i < values_.parameters.size(); ++i) {
      if (!choose_parameter(i)) return std::nullopt;
    }
    return std::move(values_);
  }

 private:
  static constexpr int tries = 40;

  bool choose_angle(std::size_t index) {
    static const std::vector<Rational> none;
    for (int attempt = 0; attempt < tries; ++attempt) {
      values_.angles[index] = point_of_tan_half(draw_({attempt, index, 0, true, &values_, &none, false}));
      if (possible(index + 1, 0)) return true;
    }
    return false;
  }

  bool choose_parameter(std::size_t index) {
    const std::size_t angles = values_.angles.size();
    if (!values_.given[index]) return possible(angles, index + 1);
    const Roots roots = sampler_.roots(values_, index);
    for (int attempt = 0; attempt < tries; ++attempt) {
      values_.parameters[index] = draw_({attempt, angles, index, false, &values_, &roots.values, roots.fixed});
      if (possible(angles, index + 1)) return true;
    }
    return false;
  }

  bool possible(std::size_t angles, std::size_t parameters) {
    Evaluator<Rational> at = sampler_.evaluator(values_, angles, parameters);
    std::vector<const Program*> open;
    for (const Program* condition : pending_) {
      const Truth truth = at.truth(*condition);
      if (truth == Truth::undecided) open.push_back(condition);
      if (truth == Truth::no || truth == Truth::undefined) return false;
    }
    pending_ = std::move(open);
    return true;
  }

  const DomainSampler& sampler_;
  const Draw& draw_;
  MechanismValues values_;
  std::vector<const Program*> pending_;
};

std::optional<MechanismValues> DomainSampler::sample(const std::vector<bool>& given, const Draw& draw) const {
  return Run(*this, given, draw).point();
}

}  // namespace slipproof
