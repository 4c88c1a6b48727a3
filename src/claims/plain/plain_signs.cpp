#include "claims/plain/plain_signs.hpp"

#include <algorithm>

namespace slipproof {

PlainSigns::PlainSigns(const Setting& setting, Reading reading) : reading_(reading), names_(setting) {
  for (const FreeParameter& parameter : setting.parameters) {
    if (parameter.domain) add_fact(parameter.domain);
  }
}

void PlainSigns::add_fact(const Expression& domain) {
  if (domain->operation == Operation::logical_and) {
    for (const Expression& operand : domain->operands) add_fact(operand);
  }
  if (domain->operation != Operation::compare) return;
  for (std::size_t i = 0; i < domain->relations.size(); ++i) {
    const Relation relation = domain->relations[i];
    const bool greater = relation == Relation::greater || relation == Relation::greater_equal;
    const bool less = relation == Relation::less || relation == Relation::less_equal;
    if (!greater && !less) continue;
    const bool strict = relation == Relation::greater || relation == Relation::less;
    Fact fact{{}, strict ? Sign::positive : Sign::not_negative};
    add_terms(domain->operands[i], greater ? 1 : -1, fact.terms);
    add_terms(domain->operands[i + 1], greater ? -1 : 1, fact.terms);
    std::erase_if(fact.terms, [](const auto& term) { return term.second.is_zero(); });
    const auto constant = fact.terms.find("");
    if (fact.terms.size() == 2 && constant != fact.terms.end() && constant->second < 0) {  // P > 1 also gives P > 0
      fact.terms.erase(constant);
      fact.sign = Sign::positive;
    }
    if (fact.terms.size() == 1 && fact.terms.begin()->second > 0) {
      Sign& known = signs_[fact.terms.begin()->first];
      known = std::max(known, fact.sign);
    }
    facts_.push_back(std::move(fact));
  }
}

void PlainSigns::add_terms(const Expression& e, const Rational& factor, Terms& terms) const {
  switch (e->operation) {
    case Operation::number:
      terms[""] += factor * e->number;
      return;
    case Operation::negate:
      return add_terms(e->operands[0], -factor, terms);
    case Operation::add:
    case Operation::subtract:
      add_terms(e->operands[0], factor, terms);
      return add_terms(e->operands[1], e->operation == Operation::add ? factor : Rational(-factor), terms);
    case Operation::multiply:
      for (const std::size_t side : {0U, 1U}) {
        if (e->operands[side]->operation == Operation::number) {
          return add_terms(e->operands[1 - side], factor * e->operands[side]->number, terms);
        }
      }
      break;
    default:
      break;
  }
  terms[to_string(e)] += factor;
}

PlainSigns::Sign PlainSigns::sign_of_symbol(const std::string& symbol) const {
  const auto entry = names_.find(symbol);
  if (entry && entry->kind == SettingNames::Kind::definition) return sign(names_.definition(entry->index, reading_));
  const auto known = signs_.find(symbol);
  return known == signs_.end() ? Sign::unknown : known->second;
}

PlainSigns::Sign PlainSigns::sign_of_sum(const Expression& sum) const {
  if (sum->operation == Operation::add) {
    const Sign x = sign(sum->operands[0]), y = sign(sum->operands[1]);
    if (x != Sign::unknown && y != Sign::unknown) return std::max(x, y);
  }
  Terms terms;
  add_terms(sum, 1, terms);
  Sign best = Sign::unknown;
  for (const Fact& fact : facts_) {
    Terms rest = terms;
    for (const auto& [text, coefficient] : fact.terms) rest[text] -= coefficient;
    const Sign others = sign_of_terms(std::move(rest));
    if (others != Sign::unknown) best = std::max(best, std::max(others, fact.sign));
  }
  return std::max(best, sign_of_terms(std::move(terms)));
}

PlainSigns::Sign PlainSigns::sign_of_terms(Terms terms) const {
  Sign result = Sign::not_negative;
  for (const auto& [text, coefficient] : terms) {
    if (coefficient.is_zero()) continue;
    const auto known = signs_.find(text);
    const Sign here = text.empty() ? Sign::positive : known == signs_.end() ? Sign::unknown : known->second;
    if (coefficient < 0 || here == Sign::unknown) return Sign::unknown;
    result = std::max(result, here);
  }
  return result;
}

PlainSigns::Sign PlainSigns::sign(const Expression& e) const {
  switch (e->operation) {
    case Operation::number:
      return e->number.is_zero() ? Sign::not_negative : Sign::positive;
    case Operation::symbol:
      return sign_of_symbol(e->symbol);
    case Operation::negate:
    case Operation::add:
    case Operation::subtract:
      return sign_of_sum(e);
    case Operation::multiply:
      return std::min(sign(e->operands[0]), sign(e->operands[1]));
    case Operation::divide:
      return positive(e->operands[1]) ? sign(e->operands[0]) : Sign::unknown;
    case Operation::power: {
      const Sign base = sign(e->operands[0]);
      if (e->exponent > 0) return base;
      return base == Sign::positive ? base : Sign::unknown;
    }
    case Operation::minimum:
      return std::min(sign(e->operands[0]), sign(e->operands[1]));
    case Operation::maximum:
      return defined(e) ? std::max(sign(e->operands[0]), sign(e->operands[1])) : Sign::unknown;
    case Operation::absolute:
      return defined(e) ? std::max(sign(e->operands[0]), Sign::not_negative) : Sign::unknown;
    default:
      return Sign::unknown;
  }
}

bool PlainSigns::true_everywhere(const Expression& truth) const {
  const auto& parts = truth->operands;
  const auto holds = [&](const Expression& e) { return true_everywhere(e); };
  switch (truth->operation) {
    case Operation::truth:
      return truth->truth;
    case Operation::logical_and:
      return std::all_of(parts.begin(), parts.end(), holds);
    case Operation::logical_or:
      return defined(truth) && std::any_of(parts.begin(), parts.end(), holds);
    case Operation::compare:
      for (std::size_t i = 0; i < truth->relations.size(); ++i) {
        if (!link_holds(parts[i], truth->relations[i], parts[i + 1])) return false;
      }
      return defined(truth);
    default:
      return false;
  }
}

bool PlainSigns::link_holds(const Expression& left, Relation relation, const Expression& right) const {
  const auto is_number = [](const Expression& e) { return e->operation == Operation::number; };
  if (is_number(left) && is_number(right))
    return holds(relation, slipproof::sign(Rational(left->number - right->number)));
  const auto minus = [&](const Expression& x, const Expression& y) {
    return is_number(y) && y->number.is_zero() ? x : make(Operation::subtract, {x, y});
  };
  switch (relation) {
    case Relation::greater:
      return positive(minus(left, right));
    case Relation::greater_equal:
      return not_negative(minus(left, right));
    case Relation::less:
      return positive(minus(right, left));
    case Relation::less_equal:
      return not_negative(minus(right, left));
    case Relation::equal:
      return same(left, right);
    case Relation::not_equal:
      break;
  }
  return positive(minus(left, right)) || positive(minus(right, left));
}

bool PlainSigns::never_zero(const Expression& number) const {
  return positive(number) || positive(make(Operation::negate, {number}));
}

bool PlainSigns::defined(const Expression& e) const {
  if (e->operation == Operation::symbol) {
    const auto entry = names_.find(e->symbol);
    return !entry || entry->kind != SettingNames::Kind::definition ||
           defined(names_.definition(entry->index, reading_));
  }
  if (e->operation == Operation::divide && !never_zero(e->operands[1])) return false;
  if (e->operation == Operation::power && e->exponent < 0 && !never_zero(e->operands[0])) return false;
  return std::all_of(e->operands.begin(), e->operands.end(), [&](const Expression& x) { return defined(x); });
}

}  // namespace slipproof
