#include "proofs/statement/zero_divisors.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "base/algebra/polynomial.hpp"
#include "base/input/diagnostic.hpp"
#include "proofs/statement/statement_text.hpp"

namespace slipproof {

namespace {

using Kind = Directive::Kind;

/// Beyond it nothing is said of a divisor; readers of statements have limits of their own.
constexpr std::uint64_t max_steps = 10'000'000;

/// Whether something is divided by anything but a number from 1 on.
bool divides(const std::string& text) {
  for (std::size_t i = text.find('/'); i != std::string::npos; i = text.find('/', i + 1)) {
    if (i + 1 == text.size() || text[i + 1] < '1' || text[i + 1] > '9') return true;
  }
  return false;
}

class Divisors {
 public:
  explicit Divisors(const StatementText& statement) : ring_(variables(statement)) {
    ring_.budget().renew(max_steps);
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      values_.emplace(ring_.name(i), Fraction{MultiPolynomial::variable(ring_, i), MultiPolynomial(ring_, 1)});
    }
  }

  /// In what stands before, names mean what they were given.
  void give(const Directive& let) {
    if (vanish_in(let.body)) {
      undefined_.insert(let.names.front());
    } else {
      bodies_.insert_or_assign(let.names.front(), let.body);
    }
  }

  /// Whether one of an expression's divisors, or of a comparison's, is the zero polynomial.
  bool vanish_in(const Expression& e) {
    if (e->operation == Operation::symbol) return undefined_.contains(e->symbol);
    const auto& parts = e->operands;
    if (std::any_of(parts.begin(), parts.end(), [this](const Expression& part) { return vanish_in(part); }))
      return true;
    return e->operation == Operation::divide && fraction(parts[1]).numerator.is_zero();
  }

 private:
  struct Fraction {
    MultiPolynomial numerator, denominator;
  };

  static std::vector<std::string> variables(const StatementText& statement) {
    std::vector<std::string> names;
    for (const Directive& line : statement.directives) {
      if (line.kind != Kind::real && line.kind != Kind::exists) continue;
      names.insert(names.end(), line.names.begin(), line.names.end());
    }
    return names;
  }

  /// Of what has no divisor that vanishes.
  Fraction fraction(const Expression& e) {
    const auto part = [&](std::size_t i) { return fraction(e->operands[i]); };
    switch (e->operation) {
      case Operation::number:
        return {MultiPolynomial(ring_, e->number), MultiPolynomial(ring_, 1)};
      case Operation::symbol:
        return of_symbol(e->symbol);
      case Operation::negate: {
        Fraction x = part(0);
        return {-x.numerator, std::move(x.denominator)};
      }
      case Operation::multiply:
      case Operation::divide: {
        const Fraction x = part(0), y = part(1);
        if (e->operation == Operation::multiply) return {x.numerator * y.numerator, x.denominator * y.denominator};
        return {x.numerator * y.denominator, x.denominator * y.numerator};
      }
      case Operation::power: {
        const Fraction x = part(0);
        const auto exponent = static_cast<std::size_t>(e->exponent);
        return {power(x.numerator, exponent), power(x.denominator, exponent)};
      }
      default:
        break;
    }
    const Fraction x = part(0), y = part(1);
    const MultiPolynomial other = y.numerator * x.denominator;
    const bool minus = e->operation == Operation::subtract;
    return {x.numerator * y.denominator + (minus ? -other : other), x.denominator * y.denominator};
  }

  const Fraction& of_symbol(const std::string& symbol) {
    const auto known = values_.find(symbol);
    if (known != values_.end()) return known->second;
    return values_.emplace(symbol, fraction(bodies_.at(symbol))).first->second;
  }

  PolynomialRing ring_;
  std::map<std::string, Fraction> values_;
  std::map<std::string, Expression> bodies_;  ///< of `let`
  std::set<std::string> undefined_;
};

class Rewriter {
 public:
  explicit Rewriter(const std::string& text) : statement_(read_statement("statement", text)), divisors_(statement_) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) lines_.push_back(line);
  }

  std::string rewritten() {
    std::set<std::size_t> left_out;
    for (const Directive& directive : statement_.directives) {
      if (directive.kind == Kind::let) {
        divisors_.give(directive);
        if (divisors_.vanish_in(directive.body)) left_out.insert(directive.line);
      } else if (directive.body && occurs(directive.body)) {
        std::string& line = lines_[directive.line - 1];
        line = line.substr(0, directive.kind == Kind::show ? line.find("show") + 4 : line.find(':') + 1) + ' ' +
               formula_text(replaced(directive.body));
      }
    }
    for (const SplitHint& hint : statement_.hints) {
      if (divisors_.vanish_in(hint.expression)) left_out.insert(hint.line);
    }
    std::string result;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (!left_out.contains(i + 1)) result += lines_[i] + '\n';
    }
    return result;
  }

 private:
  static bool is_joined(const Expression& e) {
    return e->operation == Operation::logical_and || e->operation == Operation::logical_or;
  }

  bool occurs(const Expression& e) {
    if (e->operation == Operation::compare) return divisors_.vanish_in(e);
    return is_joined(e) &&
           std::any_of(e->operands.begin(), e->operands.end(), [this](const Expression& part) { return occurs(part); });
  }

  /// The formula with `false` for each comparison that divides by the zero polynomial.
  Expression replaced(const Expression& e) {
    if (!is_joined(e)) return occurs(e) ? make_truth(false) : e;
    std::vector<Expression> parts;
    for (const Expression& part : e->operands) parts.push_back(replaced(part));
    return make(e->operation, std::move(parts));
  }

  StatementText statement_;
  Divisors divisors_;
  std::vector<std::string> lines_;
};

}  // namespace

std::string without_zero_divisors(std::string text) {
  if (!divides(text)) return text;
  try {
    return Rewriter(text).rewritten();
  } catch (const InputError&) {
  } catch (const Budget::Spent&) {
  }
  return text;
}

}  // namespace slipproof
