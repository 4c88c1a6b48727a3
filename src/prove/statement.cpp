#include "prove/statement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "claims/parser.hpp"
#include "input/diagnostic.hpp"

namespace slipproof::prove {
namespace {

void add_divisors(std::vector<Polynomial>& divisors, const std::vector<Polynomial>& more) {
  for (const Polynomial& divisor : more) {
    if (divisor.is_constant() || std::find(divisors.begin(), divisors.end(), divisor) != divisors.end()) continue;
    divisors.push_back(divisor);
  }
}

Fraction sum(Fraction x, Fraction y, bool minus) {
  if (minus) y.numerator = -y.numerator;
  add_divisors(x.divisors, y.divisors);
  if (x.denominator == y.denominator) {
    x.numerator += y.numerator;
  } else {
    x.numerator = x.numerator * y.denominator + y.numerator * x.denominator;
    x.denominator *= y.denominator;
  }
  return x;
}

Fraction times(Fraction x, const Fraction& y) {
  x.numerator *= y.numerator;
  x.denominator *= y.denominator;
  add_divisors(x.divisors, y.divisors);
  return x;
}

Formula comparison(const Fraction& x, const Fraction& y, Relation relation) {
  const Fraction difference = sum(x, y, true);
  std::vector<Formula> parts;
  for (const Polynomial& divisor : difference.divisors) parts.push_back(non_zero(divisor));
  if (relation == Relation::not_equal) {
    parts.push_back(non_zero(difference.numerator));
  } else if (relation == Relation::equal) {
    parts.push_back(atom(difference.numerator, Sign::zero));
  } else {
    const bool below = relation == Relation::less || relation == Relation::less_equal;
    const bool strict = relation == Relation::less || relation == Relation::greater;
    Polynomial p = difference.numerator * difference.denominator;
    if (below) p = -p;
    parts.push_back(atom(std::move(p), strict ? Sign::positive : Sign::non_negative));
  }
  return combine(Formula::Kind::conjunction, std::move(parts));
}

/// Conjunctions and disjunctions of as many parts as the text joins; braces, read as two negations, keep theirs apart.
Expression grouped(const Expression& e) {
  if (e->operation == Operation::logical_not && e->operands[0]->operation == Operation::logical_not) {
    return grouped(e->operands[0]->operands[0]);
  }
  if (e->operation != Operation::logical_and && e->operation != Operation::logical_or) return e;
  std::vector<Expression> parts;
  for (Expression rest = e; rest; rest = rest->operation == e->operation ? rest->operands[0] : nullptr) {
    parts.push_back(grouped(rest->operation == e->operation ? rest->operands[1] : rest));
  }
  std::reverse(parts.begin(), parts.end());
  return make(e->operation, std::move(parts), e->column);
}

}  // namespace

std::vector<Expression> parts(const Expression& expression) {
  const bool joined = expression->operation == Operation::logical_and || expression->operation == Operation::logical_or;
  return joined ? expression->operands : std::vector{expression};
}

Expression parse_formula(const std::string& text, const std::function<bool(const std::string&)>& names_formula) {
  std::string translated;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_')) ++end;
    const std::string word = text.substr(i, end - i);
    if (word.empty()) {
      translated += text[i] == '{' ? "(not not (" : text[i] == '}' ? "))" : std::string(1, text[i]);
      ++i;
    } else {
      translated += names_formula(word) ? "(" + word + "=0)" : word;
      i = end;
    }
  }
  return grouped(parse_expression(translated, Sort::truth));
}

/// Reads the lines of a statement in their order; names mean what the lines before gave them.
struct Statement::Reader {
  const Ring& ring;
  std::map<std::string, Fraction> values;
  std::map<std::string, Formula> formulas;

  Fraction number(const Expression& e) const {
    const auto operand = [&](std::size_t i) { return number(e->operands[i]); };
    switch (e->operation) {
      case Operation::number:
        return {Polynomial(ring, e->number), Polynomial(ring, 1), {}};
      case Operation::symbol: {
        const auto value = values.find(e->symbol);
        if (value == values.end()) throw ExpressionError(e->column, "unknown name `" + e->symbol + "`");
        return value->second;
      }
      case Operation::negate: {
        Fraction result = operand(0);
        result.numerator = -result.numerator;
        return result;
      }
      case Operation::add:
        return sum(operand(0), operand(1), false);
      case Operation::subtract:
        return sum(operand(0), operand(1), true);
      case Operation::multiply:
        return times(operand(0), operand(1));
      case Operation::divide: {
        const Fraction divisor = operand(1);
        if (divisor.numerator.is_zero()) throw ExpressionError(e->column, "division by zero");
        Fraction result = times(operand(0), {divisor.denominator, divisor.numerator, divisor.divisors});
        add_divisors(result.divisors, {divisor.numerator});
        return result;
      }
      case Operation::power: {
        const Fraction base = operand(0);
        if (e->exponent < 0) throw ExpressionError(e->column, "a negative exponent");
        const auto n = static_cast<std::size_t>(e->exponent);
        return {power(base.numerator, n), power(base.denominator, n), base.divisors};
      }
      default:
        throw ExpressionError(e->column, "statements have no such function");
    }
  }

  Formula formula(const Expression& e) const {
    const bool conjunction = e->operation == Operation::logical_and;
    if (conjunction || e->operation == Operation::logical_or) {
      std::vector<Formula> parts;
      for (const Expression& operand : prove::parts(e)) parts.push_back(formula(operand));
      return combine(conjunction ? Formula::Kind::conjunction : Formula::Kind::disjunction, std::move(parts));
    }
    if (e->operation == Operation::truth && !e->truth) return {Formula::Kind::disjunction, {}, Sign::zero, {}};
    if (e->operation != Operation::compare) throw ExpressionError(e->column, "expected a comparison");
    if (e->operands[0]->operation == Operation::symbol && formulas.contains(e->operands[0]->symbol)) {
      return formulas.at(e->operands[0]->symbol);
    }
    std::vector<Formula> parts;
    for (std::size_t i = 0; i < e->relations.size(); ++i) {
      parts.push_back(comparison(number(e->operands[i]), number(e->operands[i + 1]), e->relations[i]));
    }
    return combine(Formula::Kind::conjunction, std::move(parts));
  }

  Formula formula(const std::string& text) const {
    return formula(parse_formula(text, [&](const std::string& name) { return formulas.contains(name); }));
  }

  Fraction expression(const std::string& text) const { return number(parse_expression(text, Sort::number)); }

  void abbreviation(const std::string& directive, std::istringstream& rest) {
    std::string name;
    std::getline(rest >> std::ws, name, directive == "let" ? '=' : ':');
    name.erase(name.find_last_not_of(' ') + 1);
    std::string body;
    std::getline(rest, body);
    if (directive == "let") {
      values.insert_or_assign(name, expression(body));
    } else {
      formulas.insert_or_assign(name, formula(body));
    }
  }
};

Statement::Statement(const std::string& name, const std::string& text) : file_(name), text_(text) {
  std::vector<std::string> names;
  std::size_t first_assumption = std::string::npos;
  std::string line;
  for (std::istringstream lines(text); std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word.empty() || word.front() == '#') continue;
    for (const char c : line + '\n') fingerprint_ = (fingerprint_ ^ static_cast<unsigned char>(c)) * 1099511628211U;
    if (word == "theorem") words >> theorem_;
    if (word == "assume" && first_assumption == std::string::npos) first_assumption = names.size();
    if ((word == "real" || word == "exists") && first_assumption != std::string::npos && !first_unknown_) {
      first_unknown_ = names.size();
    }
    if (word != "real" && word != "exists") continue;
    for (std::string variable; words >> variable; names.push_back(variable)) {
      if (word == "exists") unknowns_.push_back(names.size());
    }
  }
  ring_ = std::make_unique<Ring>(names);
  Reader reader = variables();
  std::size_t number = 0;
  for (std::istringstream lines(text); std::getline(lines, line);) {
    ++number;
    std::istringstream words(line);
    std::string word;
    words >> word;
    try {
      if (line.starts_with("# split:")) {
        hints_.push_back(reader.expression(line.substr(8)).numerator);
      } else if (word == "let" || word == "define") {
        reader.abbreviation(word, words);
      } else if (word == "assume") {
        std::string label;
        std::getline(words >> std::ws, label, ':');
        std::string body;
        std::getline(words, body);
        assumptions_.emplace_back(label, reader.formula(body));
      }
    } catch (const ExpressionError& error) {
      throw InputError({{file_, number, error.column(), error.what()}});
    }
  }
  shown();
}

std::string Statement::fingerprint() const {
  return fmt::format("{:016x}", fingerprint_);
}

Statement::Reader Statement::variables() const {
  Reader reader{*ring_, {}, {}};
  for (std::size_t i = 0; i < ring_->size(); ++i) {
    reader.values.insert_or_assign(ring_->name(i),
                                   Fraction{Polynomial::variable(*ring_, i), Polynomial(*ring_, 1), {}});
  }
  return reader;
}

std::vector<Polynomial> Statement::divisors(const std::vector<std::string>& witness) const {
  const Reader reader = variables();
  std::vector<Polynomial> result;
  for (const std::string& value : witness) {
    for (const Polynomial& divisor : reader.expression(value).divisors) result.push_back(divisor);
  }
  return result;
}

Formula Statement::shown(const std::vector<std::string>& witness) const {
  Reader reader = variables();
  for (std::size_t i = 0; i < witness.size(); ++i) {
    reader.values.insert_or_assign(ring_->name(unknowns_[i]), reader.expression(witness[i]));
  }
  std::size_t number = 0;
  std::string line;
  for (std::istringstream lines(text_); std::getline(lines, line);) {
    ++number;
    std::istringstream words(line);
    std::string word;
    words >> word;
    try {
      if (word == "let" || word == "define") reader.abbreviation(word, words);
      if (word == "show") {
        std::string body;
        std::getline(words, body);
        return reader.formula(body);
      }
    } catch (const ExpressionError& error) {
      throw InputError({{file_, number, error.column(), error.what()}});
    }
  }
  throw InputError({{file_, number, 0, "the statement ends without `show`"}});
}

}  // namespace slipproof::prove
