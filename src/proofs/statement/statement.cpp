#include "proofs/statement/statement.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "base/input/diagnostic.hpp"

namespace slipproof::prove {
namespace {

void add_divisors(std::vector<Polynomial>& divisors, const std::vector<Polynomial>& more) {
  for (const Polynomial& divisor : more) {
    if (divisor.is_constant() || std::find(divisors.begin(), divisors.end(), divisor) != divisors.end()) continue;
    divisors.push_back(divisor);
  }
}

/// The checker refuses a statement beyond these limits: there is nothing to prove then, and no reason to run out of
/// memory.
constexpr std::size_t max_products = 200'000, max_degree = 255, max_bits = 8'192, max_atoms = 100'000, max_levels = 100;

const Polynomial& bounded(const Polynomial& p, std::size_t column) {
  if (p.coefficient_bits() > max_bits) throw ExpressionError(column, "a coefficient has more than 8192 bits");
  return p;
}

Polynomial product(const Polynomial& x, const Polynomial& y, std::size_t column) {
  if (x.length() * y.length() > max_products) throw ExpressionError(column, "a product has more than 200000 terms");
  for (const std::size_t variable : x.variables()) {
    if (x.degree(variable) + y.degree(variable) > max_degree) throw ExpressionError(column, "a degree exceeds 255");
  }
  return bounded(x * y, column);
}

ValueWithDivisors negated(ValueWithDivisors x) {
  x.numerator = -x.numerator;
  return x;
}

ValueWithDivisors sum(ValueWithDivisors x, const ValueWithDivisors& y, std::size_t column) {
  add_divisors(x.divisors, y.divisors);
  if (x.denominator == y.denominator) {
    x.numerator += y.numerator;
  } else {
    x.numerator = product(x.numerator, y.denominator, column) + product(y.numerator, x.denominator, column);
    x.denominator = product(x.denominator, y.denominator, column);
  }
  bounded(x.numerator, column);
  return x;
}

ValueWithDivisors times(ValueWithDivisors x, const ValueWithDivisors& y, std::size_t column) {
  x.numerator = product(x.numerator, y.numerator, column);
  x.denominator = product(x.denominator, y.denominator, column);
  add_divisors(x.divisors, y.divisors);
  return x;
}

Formula comparison(const ValueWithDivisors& x, const ValueWithDivisors& y, Relation relation, std::size_t column) {
  const ValueWithDivisors difference = sum(x, negated(y), column);
  std::vector<Formula> parts;
  for (const Polynomial& divisor : difference.divisors) parts.push_back(non_zero(divisor));
  if (relation == Relation::not_equal) {
    parts.push_back(non_zero(difference.numerator));
  } else if (relation == Relation::equal) {
    parts.push_back(atom(difference.numerator, Sign::zero));
  } else {
    const bool below = relation == Relation::less || relation == Relation::less_equal;
    const bool strict = relation == Relation::less || relation == Relation::greater;
    Polynomial p = product(difference.numerator, difference.denominator, column);
    if (below) p = -p;
    parts.push_back(atom(std::move(p), strict ? Sign::positive : Sign::non_negative));
  }
  return combine(Formula::Kind::conjunction, std::move(parts));
}

std::size_t atoms(const Formula& formula) {
  std::size_t result = formula.polynomial.size();
  for (const Formula& part : formula.parts) result += atoms(part);
  return result;
}

std::size_t levels(const Formula& formula) {
  std::size_t result = 0;
  for (const Formula& part : formula.parts) result = std::max(result, levels(part) + 1);
  return result;
}

Formula combine(Formula::Kind kind, std::vector<Formula> parts, std::size_t column) {
  Formula result = combine(kind, std::move(parts));
  if (atoms(result) > max_atoms) throw ExpressionError(column, "a formula of more than 100000 comparisons");
  if (levels(result) > max_levels) throw ExpressionError(column, "a formula of more than 100 levels");
  return result;
}

}  // namespace

/// Interprets the lines of a statement in their order; names mean what earlier lines gave them.
struct Statement::Meaning {
  const Ring& ring;
  std::map<std::string, ValueWithDivisors> values;
  std::map<std::string, Formula> formulas;

  ValueWithDivisors number(const Expression& e) const {
    const auto operand = [&](std::size_t i) { return number(e->operands[i]); };
    switch (e->operation) {
      case Operation::number:
        return {bounded(Polynomial(ring, e->number), e->column), Polynomial(ring, 1), {}};
      case Operation::symbol:
        return values.at(e->symbol);
      case Operation::negate:
        return negated(operand(0));
      case Operation::add:
        return sum(operand(0), operand(1), e->column);
      case Operation::subtract:
        return sum(operand(0), negated(operand(1)), e->column);
      case Operation::multiply:
        return times(operand(0), operand(1), e->column);
      case Operation::divide: {
        const ValueWithDivisors divisor = operand(1);
        if (divisor.numerator.is_zero()) throw ExpressionError(e->column, "division by zero");
        ValueWithDivisors result =
            times(operand(0), {divisor.denominator, divisor.numerator, divisor.divisors}, e->column);
        add_divisors(result.divisors, {divisor.numerator});
        return result;
      }
      case Operation::power: {
        const ValueWithDivisors base = operand(0);
        ValueWithDivisors result = base;
        for (int n = e->exponent; n > 1; --n) result = times(std::move(result), base, e->column);
        return result;
      }
      default:
        throw std::logic_error("statements have no such operation");
    }
  }

  Formula formula(const Expression& e) const {
    if (e->operation == Operation::truth) return {Formula::Kind::disjunction, {}, Sign::zero, {}};
    if (e->operation == Operation::symbol) return formulas.at(e->symbol);
    std::vector<Formula> parts;
    if (e->operation == Operation::compare) {
      for (std::size_t i = 0; i < e->relations.size(); ++i) {
        parts.push_back(comparison(number(e->operands[i]), number(e->operands[i + 1]), e->relations[i], e->column));
      }
      return combine(Formula::Kind::conjunction, std::move(parts), e->column);
    }
    for (const Expression& operand : joined_parts(e)) parts.push_back(formula(operand));
    const bool conjunction = e->operation == Operation::logical_and;
    return combine(conjunction ? Formula::Kind::conjunction : Formula::Kind::disjunction, std::move(parts), e->column);
  }

  void introduce(const Directive& line) {
    if (line.kind == Directive::Kind::let) values.insert_or_assign(line.names.front(), number(line.body));
    if (line.kind == Directive::Kind::define) formulas.insert_or_assign(line.names.front(), formula(line.body));
  }
};

Statement::Statement(const std::string& name, const std::string& text)
    : file_(name), text_(read_statement(name, text)) {
  std::vector<std::string> names;
  bool assumed = false;
  for (const Directive& line : text_.directives) {
    const bool unknowns = line.kind == Directive::Kind::exists;
    assumed = assumed || line.kind == Directive::Kind::assume;
    if (assumed && first_unknown_ == 0 && (unknowns || line.kind == Directive::Kind::real)) {
      first_unknown_ = names.size();
    }
    for (const std::string& variable : line.names) {
      if (unknowns) unknowns_.push_back(names.size());
      if (unknowns || line.kind == Directive::Kind::real) names.push_back(variable);
    }
  }
  ring_ = std::make_unique<Ring>(names);
  Meaning meaning = variables();
  std::size_t place = 0;
  try {
    for (const Directive& line : text_.directives) {
      place = line.line;
      meaning.introduce(line);
      if (line.kind == Directive::Kind::assume) {
        assumptions_.emplace_back(line.names.front(), meaning.formula(line.body));
      }
    }
    for (const SplitHint& hint : text_.hints) {
      place = hint.line;
      hints_.push_back(meaning.number(hint.expression).numerator);
    }
  } catch (const ExpressionError& error) {
    throw InputError({{file_, place, error.column(), error.what()}});
  }
  shown();
}

Statement::Meaning Statement::variables() const {
  Meaning meaning{*ring_, {}, {}};
  for (std::size_t i = 0; i < ring_->size(); ++i) {
    meaning.values.insert_or_assign(ring_->name(i),
                                    ValueWithDivisors{Polynomial::variable(*ring_, i), Polynomial(*ring_, 1), {}});
  }
  return meaning;
}

Statement::Meaning Statement::before_unknowns() const {
  Meaning meaning = variables();
  for (const Directive& line : text_.directives) {
    if (line.kind == Directive::Kind::exists) break;
    meaning.introduce(line);
  }
  return meaning;
}

std::vector<Polynomial> Statement::divisors(const std::vector<std::string>& witness) const {
  const Meaning meaning = before_unknowns();
  std::vector<Polynomial> result;
  for (const std::string& value : witness) {
    for (const Polynomial& divisor : meaning.number(parse_witness_value(text_, value)).divisors) {
      result.push_back(divisor);
    }
  }
  return result;
}

Formula Statement::shown(const std::vector<std::string>& witness) const {
  Meaning meaning = variables();
  if (!witness.empty()) {
    const Meaning given = before_unknowns();
    for (std::size_t i = 0; i < witness.size(); ++i) {
      meaning.values.insert_or_assign(ring_->name(unknowns_[i]), given.number(parse_witness_value(text_, witness[i])));
    }
  }
  std::size_t place = 0;
  try {
    for (const Directive& line : text_.directives) {
      place = line.line;
      meaning.introduce(line);
    }
    return meaning.formula(text_.directives.back().body);
  } catch (const ExpressionError& error) {
    throw InputError({{file_, place, error.column(), error.what()}});
  }
}

}  // namespace slipproof::prove
