#include "mechanics/points/domain_sampler.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/algebra/integer_polynomial.hpp"
#include "base/algebra/rational_function.hpp"
#include "base/algebra/real_roots.hpp"
#include "mechanics/points/degrees.hpp"

namespace slipproof {

DomainSampler::DomainSampler(const Mechanism& mechanism, const ProblemMaker& maker, PointsOf points)
    : mechanism_(&mechanism), compiled_(&maker.compiled()), points_(points) {
  for (const MechanismParameter& parameter : mechanism.parameters) add_comparisons(parameter.domain.expression);
  for (const MechanismAngle& angle : mechanism.angles) add_comparisons(angle.domain.expression);
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

DomainSampler::Known DomainSampler::all_known(const MechanismValues& values) const {
  return {values.angles.size(), std::vector<bool>(values.parameters.size(), true)};
}

template <class T, class Field>
Evaluator<T, Field> DomainSampler::evaluator(const MechanismValues& values, const Known& known) const {
  Evaluator<T, Field> at(compiled_->scope());
  for (std::size_t i = 0; i < known.parameters.size(); ++i) {
    if (known.parameters[i]) at.set(compiled_->parameter(i), T(values.parameters[i]));
  }
  for (std::size_t i = 0; i < known.angles; ++i) {
    at.set(compiled_->cosine(i), T(values.angles[i].cosine));
    at.set(compiled_->sine(i), T(values.angles[i].sine));
  }
  return at;
}

bool DomainSampler::contains(const MechanismValues& values) const {
  auto at = evaluator<Rational>(values, all_known(values));
  const auto all = conditions(values.given);
  return std::all_of(all.begin(), all.end(), [&](const Program* one) { return at.truth(*one) == Truth::yes; });
}

/// Where a difference that is affine in a parameter vanishes, for given values of the others.
std::optional<Rational> DomainSampler::root(const Program& difference, const MechanismValues& values,
                                            const Known& known, std::size_t unknown) const {
  std::vector<Rational> at;
  for (int x = 0; x <= 2; ++x) {
    auto evaluator = this->evaluator<Rational>(values, known);
    evaluator.set(compiled_->parameter(unknown), x);
    const auto value = evaluator.number(difference);
    if (!value.number) return std::nullopt;
    at.push_back(*value.number);
  }
  const Rational slope = at[1] - at[0];
  if (slope.is_zero() || Rational(at[2] - at[1]) != slope) return std::nullopt;
  return Rational(-at[0] / slope);
}

DomainSampler::Roots DomainSampler::roots(const MechanismValues& values, const Known& known,
                                          std::size_t parameter) const {
  Roots result;
  for (const Comparison& comparison : comparisons_) {
    auto found = root(comparison.difference, values, known, parameter);
    if (!found) continue;
    const auto place = comparison.equation ? result.values.begin() : result.values.end();
    result.values.insert(place, std::move(*found));
    result.fixed = result.fixed || comparison.equation;
  }
  return result;
}

namespace {

/// Quotients of polynomials in a symbol; which of two is greater is not known, as the symbol has no value.
struct SymbolField {
  RationalFunction constant(const Rational& value) const { return {value}; }
  bool is_zero(const RationalFunction& x) const { return x.numerator().is_zero(); }
  std::optional<int> compare(const RationalFunction& x, const RationalFunction& y) const {
    const RationalFunction difference = x - y;
    if (difference.numerator().degree() > 0 || difference.denominator().degree() > 0) return std::nullopt;
    return (difference.numerator().coefficient(0) / difference.denominator().coefficient(0)).sign();
  }
};

}  // namespace

std::vector<DomainSampler::Place> DomainSampler::places(const MechanismValues& values, const Known& known,
                                                        std::optional<std::size_t> parameter) const {
  auto at = evaluator<RationalFunction, SymbolField>(values, known);
  const Polynomial t({Rational(0), Rational(1)}), square = t * t, one({Rational(1)});
  if (parameter) {
    at.set(compiled_->parameter(*parameter), RationalFunction(t));
  } else {
    at.set(compiled_->cosine(known.angles), RationalFunction(one + -square, one + square));
    at.set(compiled_->sine(known.angles), RationalFunction(t + t, one + square));
  }
  std::set<IntegerPolynomial> polynomials;
  for (const Comparison& comparison : comparisons_) {
    const auto difference = at.number(comparison.difference).number;
    if (!difference) continue;
    for (const Polynomial* p : {&difference->numerator(), &difference->denominator()}) {
      if (p->degree() > 0) polynomials.insert(IntegerPolynomial::proportional_to(p->coefficients()).primitive());
    }
  }
  std::vector<Place> result;
  for (LineCell& cell : line_cells(real_roots(polynomials))) {
    if (!cell.sample) continue;
    result.push_back({cell.lower ? std::optional(cell.lower->upper) : std::nullopt,
                      cell.upper ? std::optional(cell.upper->lower) : std::nullopt, std::move(*cell.sample)});
  }
  return result;
}

void DomainSampler::restore(MechanismValues& values, std::size_t kept) const {
  const std::size_t count = values.parameters.size();
  const Known known = all_known(values);
  for (const Comparison& comparison : comparisons_) {
    if (!comparison.equation) continue;
    const auto difference = evaluator<Rational>(values, known).number(comparison.difference);
    if (!difference.number || difference.number->is_zero()) continue;
    for (std::size_t i = count; i-- > 0;) {
      if (i == kept || !values.given[i]) continue;
      auto value = root(comparison.difference, values, known, i);
      if (!value) continue;
      values.parameters[i] = std::move(*value);
      break;
    }
  }
}

/// The drawing of one point.
class DomainSampler::Run {
 public:
  Run(const DomainSampler& sampler, const std::vector<bool>& given, const Draw& draw, Way way)
      : sampler_(sampler), draw_(draw), way_(way), values_(default_values(*sampler.mechanism_)) {
    values_.given = given;
    known_.parameters.assign(given.size(), false);
    pending_ = sampler.conditions(given);
  }

  std::optional<MechanismValues> point() {
    for (std::size_t i = 0; i < values_.angles.size(); ++i) {
      if (!choose_angle(i)) return std::nullopt;
    }
    const std::size_t count = values_.parameters.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t index = way_ == Way::draw ? i : count - 1 - i;
      if (!choose_parameter(index)) return std::nullopt;
      known_.parameters[index] = true;
    }
    return std::move(values_);
  }

 private:
  static constexpr int tries = 40;

  bool choose_angle(std::size_t index) {
    static const std::vector<Rational> none;
    const auto drawn = [&](int attempt) { return draw_({attempt, index, 0, true, &values_, &none, false}); };
    const auto take = [&](const Rational& tan_half) { values_.angles[index] = point_of_tan_half(tan_half); };
    Known with = known_;
    ++with.angles;
    if (!choose(drawn, take, with) && !choose_inside(drawn, take, std::nullopt, with)) return false;
    known_ = std::move(with);
    return true;
  }

  bool choose_parameter(std::size_t index) {
    Known with = known_;
    with.parameters[index] = true;
    if (!values_.given[index]) return holds_open(with);
    const std::size_t angles = values_.angles.size(), before = way_ == Way::draw ? index : 0;
    const Roots roots = sampler_.roots(values_, known_, index);
    const auto drawn = [&](int attempt) {
      return draw_({attempt, angles, before, false, &values_, &roots.values, roots.fixed});
    };
    const auto take = [&](const Rational& value) { values_.parameters[index] = value; };
    return choose(drawn, take, with) || choose_inside(drawn, take, index, with);
  }

  /// A value as it is drawn, if one is possible.
  template <class Drawn, class Take>
  bool choose(const Drawn& drawn, const Take& take, const Known& with) {
    if (way_ == Way::solve) return false;
    for (int attempt = 0; attempt < tries; ++attempt) {
      take(drawn(attempt));
      if (holds_open(with)) return true;
    }
    return false;
  }

  /// A value in one of the possible places, however narrow they are.
  template <class Drawn, class Take>
  bool choose_inside(const Drawn& drawn, const Take& take, std::optional<std::size_t> parameter, const Known& with) {
    std::vector<Place> places = sampler_.places(values_, known_, parameter);
    std::erase_if(places, [&](const Place& place) { return take(place.inside), !undecided(with); });
    if (places.empty()) return false;
    for (int attempt = 0; attempt < tries; ++attempt) {
      const Rational which = share(drawn(tries)) * Rational(places.size());
      const Integer index = numerator(which) / denominator(which);
      take(moved_into(places[static_cast<std::size_t>(index.to_long())], drawn(tries)));
      if (holds_open(with)) return true;
    }
    return false;
  }

  /// Any number moved to between 0 and 1.
  static Rational share(const Rational& x) { return x.is_zero() ? Rational(1, 2) : Rational(abs(x) / (1 + abs(x))); }

  static Rational moved_into(const Place& place, const Rational& x) {
    const auto &lower = place.lower, &upper = place.upper;
    if (lower && upper) return *lower < *upper ? Rational(*lower + (*upper - *lower) * share(x)) : place.inside;
    const Rational step = x.is_zero() ? Rational(1) : Rational(abs(x));
    return lower ? Rational(*lower + step) : upper ? Rational(*upper - step) : x;
  }

  /// The conditions that are still undecided; nothing if one does not hold.
  std::optional<std::vector<const Program*>> undecided(const Known& known) const {
    auto at = sampler_.evaluator<Rational>(values_, known);
    std::vector<const Program*> open;
    for (const Program* condition : pending_) {
      const Truth truth = at.truth(*condition);
      if (truth == Truth::undecided) open.push_back(condition);
      if (truth == Truth::no || truth == Truth::undefined) return std::nullopt;
    }
    return open;
  }

  bool holds_open(const Known& known) {
    auto open = undecided(known);
    if (open) pending_ = std::move(*open);
    return open.has_value();
  }

  const DomainSampler& sampler_;
  const Draw& draw_;
  const Way way_;
  MechanismValues values_;
  Known known_;
  std::vector<const Program*> pending_;
};

std::optional<MechanismValues> DomainSampler::sample(const std::vector<bool>& given, const Draw& draw, Way way) const {
  return Run(*this, given, draw, way).point();
}

}  // namespace slipproof
