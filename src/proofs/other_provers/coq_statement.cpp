#include "proofs/other_provers/coq_statement.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace slipproof::coq {

using prove::Polynomial;

namespace {

/// All at once: a new name of one symbol may be the old one of another.
Expression renamed(const Expression& e) {
  Node node = *e;
  for (Expression& operand : node.operands) operand = renamed(operand);
  if (node.operation == Operation::symbol) node.symbol = name(node.symbol);
  return std::make_shared<const Node>(std::move(node));
}

}  // namespace

std::string text(const Expression& e) {
  return to_string(renamed(e));
}

Normalizer::Normalizer(const prove::Statement& statement) : statement_(statement) {
  const prove::Ring& ring = statement.ring();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    values_.insert_or_assign(ring.name(i), Value{Polynomial::variable(ring, i), Polynomial(ring, 1), {}});
  }
}

void Normalizer::merge(std::vector<Divisor>& divisors, const std::vector<Divisor>& more) {
  for (const Divisor& divisor : more) {
    if (divisor.polynomial.is_constant()) continue;
    const auto same = std::find_if(divisors.begin(), divisors.end(),
                                   [&](const Divisor& d) { return d.polynomial == divisor.polynomial; });
    if (same == divisors.end()) {
      divisors.push_back(divisor);
    } else if (!same->expression) {
      *same = divisor;
    }
  }
}

Normalizer::Value Normalizer::value(const Expression& e, bool in_theorem) const {
  const prove::Ring& ring = statement_.ring();
  const auto operand = [&](std::size_t i) { return value(e->operands[i], in_theorem); };
  switch (e->operation) {
    case Operation::number:
      if (denominator(e->number) != 1) throw ExpressionError(e->column, "a number that is not an integer");
      return {Polynomial(ring, e->number), Polynomial(ring, 1), {}};
    case Operation::symbol:
      return (in_theorem && theorem_values_.contains(e->symbol) ? theorem_values_ : values_).at(e->symbol);
    case Operation::negate: {
      Value result = operand(0);
      result.numerator = -result.numerator;
      return result;
    }
    case Operation::add:
    case Operation::subtract: {
      Value x = operand(0), y = operand(1);
      if (e->operation == Operation::subtract) y.numerator = -y.numerator;
      x.divides = x.divides || y.divides;
      merge(x.divisors, y.divisors);
      if (x.denominator == y.denominator) {
        x.numerator += y.numerator;
      } else {
        x.numerator = x.numerator * y.denominator + y.numerator * x.denominator;
        x.denominator *= y.denominator;
      }
      return x;
    }
    case Operation::multiply: {
      Value x = operand(0);
      const Value y = operand(1);
      x.numerator *= y.numerator;
      x.denominator *= y.denominator;
      x.divides = x.divides || y.divides;
      merge(x.divisors, y.divisors);
      return x;
    }
    case Operation::divide: {
      Value x = operand(0);
      const Value y = operand(1);
      x.numerator *= y.denominator;
      x.denominator *= y.numerator;
      x.divides = true;
      merge(x.divisors, y.divisors);
      merge(x.divisors, {{y.numerator, y.denominator, e->operands[1]}});
      return x;
    }
    case Operation::power: {
      Value x = operand(0);
      const auto n = static_cast<std::size_t>(e->exponent);
      x.numerator = power(x.numerator, n);
      x.denominator = power(x.denominator, n);
      return x;
    }
    default:
      throw ExpressionError(e->column, "statements have no such function");
  }
}

std::vector<Normalizer::Link> Normalizer::links(const Expression& comparison) {
  std::vector<Link> result;
  for (std::size_t i = 0; i < comparison->relations.size(); ++i) {
    result.push_back({comparison->operands[i], comparison->operands[i + 1], comparison->relations[i]});
  }
  return result;
}

Formula Normalizer::normal(const Link& link) const {
  const Value difference = value(make(Operation::subtract, {link.left, link.right}));
  std::vector<Formula> parts;
  for (const Divisor& divisor : difference.divisors) parts.push_back(coq::non_zero(coq::text(divisor.polynomial)));
  if (link.relation == Relation::equal) {
    parts.push_back(atom(coq::text(difference.numerator), prove::Sign::zero));
  } else if (link.relation == Relation::not_equal) {
    parts.push_back(coq::non_zero(coq::text(difference.numerator)));
  } else {
    const bool below = link.relation == Relation::less || link.relation == Relation::less_equal;
    const bool strict = link.relation == Relation::less || link.relation == Relation::greater;
    const Polynomial p = difference.numerator * difference.denominator;
    parts.push_back(atom(coq::text(below ? -p : p), strict ? prove::Sign::positive : prove::Sign::non_negative));
  }
  return combine(Formula::Kind::conjunction, std::move(parts));
}

Formula Normalizer::normal(const Expression& e) const {
  if (e->operation == Operation::truth) return {Formula::Kind::disjunction, {}, prove::Sign::zero, {}};
  if (e->operation == Operation::symbol) return formulas_.at(e->symbol);
  std::vector<Formula> parts;
  if (e->operation == Operation::compare) {
    for (const Link& link : links(e)) parts.push_back(normal(link));
    return combine(Formula::Kind::conjunction, std::move(parts));
  }
  for (const Expression& part : joined_parts(e)) parts.push_back(normal(part));
  return combine(e->operation == Operation::logical_and ? Formula::Kind::conjunction : Formula::Kind::disjunction,
                 std::move(parts));
}

std::vector<Polynomial> Normalizer::divisors(const Expression& expression) const {
  std::vector<Polynomial> result;
  for (const Divisor& divisor : value(expression).divisors) result.push_back(divisor.polynomial);
  return result;
}

std::string Normalizer::proposition(const Link& link) const {
  std::string result;
  for (const Divisor& divisor : value(make(Operation::subtract, {link.left, link.right})).divisors) {
    result += text(divisor.expression) + " <> 0 /\\ ";
  }
  return fmt::format("{}{} {} {}", result, text(link.left),
                     link.relation == Relation::not_equal ? "<>" : spelling(link.relation), text(link.right));
}

std::string Normalizer::proposition(const Expression& e, bool inner) const {
  if (e->operation == Operation::truth) return "False";
  if (e->operation == Operation::symbol) return name(e->symbol);
  std::vector<std::string> parts;
  if (e->operation == Operation::compare) {
    const std::vector<Link> chain = links(e);
    for (const Link& link : chain) {
      const std::string part = proposition(link);
      parts.push_back(chain.size() > 1 && part.find("/\\") != std::string::npos ? "(" + part + ")" : part);
    }
  } else {
    for (const Expression& part : joined_parts(e)) parts.push_back(proposition(part, true));
  }
  const std::string result =
      fmt::format("{}", fmt::join(parts, e->operation == Operation::logical_or ? " \\/ " : " /\\ "));
  return inner && result.find('/') != std::string::npos ? "(" + result + ")" : result;
}

std::string theorem(const prove::Statement& statement) {
  Normalizer normalizer(statement);
  std::string identifier = statement.theorem();
  std::replace_if(
      identifier.begin(), identifier.end(), [](unsigned char c) { return c >= 0x80 || std::isalnum(c) == 0; }, '_');
  if (identifier.empty() || std::isalpha(static_cast<unsigned char>(identifier.front())) == 0)
    identifier = "T" + identifier;
  std::string result = "Theorem " + identifier + " :\n";
  for (const Directive& line : statement.text().directives) {
    std::vector<std::string> names;
    for (const std::string& symbol : line.names) names.push_back(name(symbol));
    switch (line.kind) {
      case Directive::Kind::real:
        result += fmt::format("  forall {} : real,\n", fmt::join(names, " "));
        break;
      case Directive::Kind::exists:
        result += fmt::format("  exists {} : real,\n", fmt::join(names, " "));
        break;
      case Directive::Kind::let:
        result += fmt::format("  let {} := {} in\n", names.front(), text(line.body));
        break;
      case Directive::Kind::define:
        result += fmt::format("  let {} := {} in\n", names.front(), normalizer.proposition(line.body));
        break;
      case Directive::Kind::assume:
        result += fmt::format("  (* {} *) {} ->\n", line.names.front(), normalizer.proposition(line.body, true));
        break;
      case Directive::Kind::show:
        result += fmt::format("  {}.\n", normalizer.proposition(line.body));
        break;
    }
    if (line.kind == Directive::Kind::let || line.kind == Directive::Kind::define) normalizer.introduce(line);
  }
  return result;
}

}  // namespace slipproof::coq
