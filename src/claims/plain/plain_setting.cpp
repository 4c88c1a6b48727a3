#include "claims/plain/plain_setting.hpp"

#include <algorithm>
#include <functional>

#include "base/expression/logic.hpp"

namespace slipproof {

namespace {

/// Whether the expression as written is 0 where the symbol is 0: the symbol itself, a product with it, or its quotient.
bool has_no_constant(const Expression& e, const std::string& symbol) {
  switch (e->operation) {
    case Operation::symbol:
      return e->symbol == symbol;
    case Operation::negate:
    case Operation::divide:
      return has_no_constant(e->operands[0], symbol);
    case Operation::multiply:
      return has_no_constant(e->operands[0], symbol) || has_no_constant(e->operands[1], symbol);
    default:
      return false;
  }
}

}  // namespace

std::optional<std::vector<Expression>> PlainSetting::point_conditions() const {
  const Family::PointConditions conditions = setting_.point_conditions();
  std::vector<Expression> result;
  for (const FreeAngle& angle : setting_.angles) {
    const Expression c = make_power(make_symbol(angle.cosine), 2), s = make_power(make_symbol(angle.sine), 2);
    result.push_back(make_comparison({make(Operation::add, {c, s}), make_number(1)}, {Relation::equal}));
  }
  for (const Expression& e : conditions.truths) {
    if (!signs_.true_everywhere(e)) result.push_back(e);
  }
  for (const Expression& e : conditions.defined) {
    if (!signs_.defined(e)) result.push_back(make_comparison({e, e}, {Relation::equal}));
  }
  const auto& load = setting_.mechanism->load;
  if (!load) return result;
  if (!conditions.slope) return std::nullopt;
  // The force variable itself, and its product or quotient with a plainly positive number, needs no explanation.
  const Expression& F = setting_.scene.find(load->symbol)->second;
  const std::string& x = setting_.force.symbol;
  const bool plain = signs_.defined(F) && signs_.positive(substitute(F, x, make_number(1))) && has_no_constant(F, x);
  if (!plain) result.push_back(make_comparison({conditions.slope, make_number(0)}, {Relation::not_equal}));
  return result;
}

bool PlainSetting::has_interval_of_forces() const {
  const std::function<bool(const Expression&)> convex = [&](const Expression& e) {
    if (e->operation == Operation::logical_and) return convex(e->operands[0]) && convex(e->operands[1]);
    if (e->operation == Operation::truth) return true;
    if (e->operation != Operation::compare) return false;
    const auto linear = [&](const Expression& x) { return is_linear_in(x, setting_.force.symbol); };
    return std::all_of(e->operands.begin(), e->operands.end(), linear) &&
           std::find(e->relations.begin(), e->relations.end(), Relation::not_equal) == e->relations.end();
  };
  return convex(setting_.force.domain) && signs_.defined(setting_.force.domain);
}

bool PlainSetting::varies(const Expression& e) const {
  const auto occurs = [&](const std::string& symbol) { return names_.depends(e, reading_, symbol); };
  const std::vector<std::string> quantities = setting_.quantities();
  return depends_on_force(e) || std::any_of(quantities.begin(), quantities.end(), occurs);
}

bool PlainSetting::is_linear(const Expression& e) const {
  if (!varies(e)) return true;
  const auto linear = [&](const Expression& x) { return is_linear(x); };
  switch (e->operation) {
    case Operation::symbol: {
      const auto entry = names_.find(e->symbol);
      return !entry || entry->kind != SettingNames::Kind::definition ||
             is_linear(names_.definition(entry->index, reading_));
    }
    case Operation::multiply:
      if (varies(e->operands[0]) && varies(e->operands[1])) return false;
      break;
    case Operation::divide:
      if (varies(e->operands[1])) return false;
      break;
    case Operation::power:
      if (e->exponent != 0 && e->exponent != 1) return false;
      break;
    case Operation::minimum:
    case Operation::maximum:
    case Operation::absolute:
    case Operation::signum:
      return false;
    default:
      break;
  }
  return std::all_of(e->operands.begin(), e->operands.end(), linear);
}

bool PlainSetting::is_bounded(const std::string& parameter) const {
  const auto has = [&](const Expression& e) {
    const auto names = symbols(e);
    return std::find(names.begin(), names.end(), parameter) != names.end();
  };
  for (const FreeParameter& given : setting_.parameters) {
    const Expression& domain = given.domain;
    if (!has(domain)) continue;
    const bool lower_end =
        given.symbol == parameter && domain->operation == Operation::compare && domain->relations.size() == 1 &&
        is_symbol(domain->operands[0], parameter) && !has(domain->operands[1]) &&
        (domain->relations[0] == Relation::greater || domain->relations[0] == Relation::greater_equal);
    if (!lower_end) return true;
  }
  const auto conditions = point_conditions();
  return !conditions || std::any_of(conditions->begin(), conditions->end(), has);
}

}  // namespace slipproof
