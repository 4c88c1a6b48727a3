#include "claims/paper/setting.hpp"

#include <algorithm>
#include <set>

#include "base/expression/cases.hpp"
#include "mechanics/mechanism/coefficients.hpp"

namespace slipproof {

namespace {

Expression square(const Expression& x) {
  return make_power(x, 2);
}

/// The divisors in the coefficients of its mechanism, each once, without nonzero numbers.
std::vector<Expression> divisors_of_coefficients(const PaperScene& scene) {
  std::vector<Expression> result;
  std::set<std::string> known;
  for (const Expression& coefficient : coefficients(*scene.mechanism)) {
    for (const Expression& divisor : divisors(scene.in_paper(coefficient))) {
      const bool plain = divisor->operation == Operation::number && !divisor->number.is_zero();
      if (!plain && known.insert(to_string(divisor)).second) result.push_back(divisor);
    }
  }
  return result;
}

}  // namespace

Setting::PointConditions Setting::point_conditions() const {
  PointConditions result;
  const auto add = [&](const PlacedExpression& condition) {
    if (condition) result.truths.push_back(in_paper(condition.expression));
  };
  for (const MechanismParameter& parameter : mechanism->parameters) {
    const auto value = scene.find(parameter.symbol);
    if (value == scene.end()) continue;
    add(parameter.domain);
    result.defined.push_back(value->second);
  }
  for (const MechanismAngle& angle : mechanism->angles) {
    const Expression &c = scene.find(angle.cosine)->second, &s = scene.find(angle.sine)->second;
    const bool of_paper = std::any_of(angles.begin(), angles.end(), [&](const PaperAngle& own) {
      return is_symbol(c, own.cosine) && is_symbol(s, own.sine);
    });
    add(angle.domain);
    result.defined.insert(result.defined.end(), {c, s});
    if (of_paper) continue;
    const Expression sum = make(Operation::add, {square(c), square(s)});
    result.truths.push_back(make_comparison({sum, make_number(1)}, {Relation::equal}));
  }
  for (const MechanismCondition& condition : mechanism->assume) add(condition.condition);
  for (const Expression& divisor : divisors_of_coefficients(*this)) {
    result.truths.push_back(make_comparison({divisor, make_number(0)}, {Relation::not_equal}));
  }
  if (!mechanism->load) return result;
  const Expression& load = scene.find(mechanism->load->symbol)->second;
  const auto at = [&](int x) { return substitute(load, force.symbol, make_number(x)); };
  if (is_linear_in(load, force.symbol)) result.slope = make(Operation::subtract, {at(1), at(0)});
  return result;
}

}  // namespace slipproof
