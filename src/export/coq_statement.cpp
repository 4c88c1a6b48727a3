#include "export/coq_statement.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

#include "claims/parser.hpp"

namespace slipproof::coq {

using prove::Polynomial;

std::string text(Expression e) {
  for (const std::string& symbol : symbols(e)) {
    if (name(symbol) != symbol) e = substitute(e, symbol, make_symbol(name(symbol)));
  }
  return to_string(e);
}

std::vector<Line> read_lines(const std::string& text) {
  std::vector<Line> result;
  std::set<std::string> formulas;
  std::string line;
  for (std::istringstream lines(text); std::getline(lines, line);) {
    std::istringstream words(line);
    std::string directive;
    words >> directive;
    constexpr std::array<const char*, 6> directives{"real", "let", "define", "assume", "exists", "show"};
    const auto found = std::find(directives.begin(), directives.end(), directive);
    if (found == directives.end()) continue;
    Line& entry = result.emplace_back();
    entry.kind = static_cast<Line::Kind>(found - directives.begin());
    if (entry.kind == Line::Kind::real || entry.kind == Line::Kind::exists) {
      for (std::string name; words >> name;) entry.names.push_back(name);
      continue;
    }
    if (entry.kind != Line::Kind::show) {
      std::string name;
      std::getline(words >> std::ws, name, entry.kind == Line::Kind::let ? '=' : ':');
      name.erase(name.find_last_not_of(' ') + 1);
      entry.names.push_back(name);
    }
    std::string body;
    std::getline(words, body);
    entry.body = entry.kind == Line::Kind::let
                     ? parse_expression(body, Sort::number)
                     : prove::parse_formula(body, [&](const std::string& name) { return formulas.contains(name); });
    if (entry.kind == Line::Kind::define) formulas.insert(entry.names.front());
  }
  return result;
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

bool Normalizer::names_formula(const Expression& comparison) const {
  const Expression& left = comparison->operands[0];
  return left->operation == Operation::symbol && formulas_.contains(left->symbol);
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
  std::vector<Formula> parts;
  if (e->operation == Operation::compare) {
    if (names_formula(e)) return formulas_.at(e->operands[0]->symbol);
    for (const Link& link : links(e)) parts.push_back(normal(link));
    return combine(Formula::Kind::conjunction, std::move(parts));
  }
  for (const Expression& part : prove::parts(e)) parts.push_back(normal(part));
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
  std::vector<std::string> parts;
  if (e->operation == Operation::compare) {
    if (names_formula(e)) return name(e->operands[0]->symbol);
    const std::vector<Link> chain = links(e);
    for (const Link& link : chain) {
      const std::string part = proposition(link);
      parts.push_back(chain.size() > 1 && part.find("/\\") != std::string::npos ? "(" + part + ")" : part);
    }
  } else {
    for (const Expression& part : prove::parts(e)) parts.push_back(proposition(part, true));
  }
  const std::string result =
      fmt::format("{}", fmt::join(parts, e->operation == Operation::logical_or ? " \\/ " : " /\\ "));
  return inner && result.find('/') != std::string::npos ? "(" + result + ")" : result;
}

std::string theorem(const prove::Statement& statement, const std::vector<Line>& lines) {
  Normalizer normalizer(statement);
  std::string identifier = statement.theorem();
  std::replace_if(
      identifier.begin(), identifier.end(), [](char c) { return c == '.' || c == '-'; }, '_');
  std::string result = "Theorem " + identifier + " :\n";
  for (const Line& line : lines) {
    std::vector<std::string> names;
    for (const std::string& symbol : line.names) names.push_back(name(symbol));
    switch (line.kind) {
      case Line::Kind::real:
        result += fmt::format("  forall {} : real,\n", fmt::join(names, " "));
        break;
      case Line::Kind::exists:
        result += fmt::format("  exists {} : real,\n", fmt::join(names, " "));
        break;
      case Line::Kind::let:
        result += fmt::format("  let {} := {} in\n", names.front(), text(line.body));
        break;
      case Line::Kind::define:
        result += fmt::format("  let {} := {} in\n", names.front(), normalizer.proposition(line.body));
        break;
      case Line::Kind::assume:
        result += fmt::format("  (* {} *) {} ->\n", names.front(), normalizer.proposition(line.body, true));
        break;
      case Line::Kind::show:
        result += fmt::format("  {}.\n", normalizer.proposition(line.body));
        break;
    }
    if (line.kind == Line::Kind::let || line.kind == Line::Kind::define) normalizer.introduce(line);
  }
  return result;
}

}  // namespace slipproof::coq
