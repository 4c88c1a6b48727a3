#include "check/reader.hpp"

#include <algorithm>

namespace slipproof::check {
namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

void add_divisors(std::vector<Polynomial>& divisors, const std::vector<Polynomial>& more) {
  for (const Polynomial& divisor : more) {
    if (divisor.is_constant() || std::find(divisors.begin(), divisors.end(), divisor) != divisors.end()) continue;
    if (divisors.size() >= kMaxDivisors) throw LimitError("too many divisions");
    divisors.push_back(divisor);
  }
}

Fraction sum(Fraction x, const Fraction& y, bool minus) {
  const Polynomial numerator = minus ? -y.numerator : y.numerator;
  add_divisors(x.divisors, y.divisors);
  if (x.denominator == y.denominator) return {x.numerator + numerator, x.denominator, x.divisors};
  return {x.numerator * y.denominator + numerator * x.denominator, x.denominator * y.denominator, x.divisors};
}

Fraction times(const Fraction& x, const Fraction& y) {
  Fraction result{x.numerator * y.numerator, x.denominator * y.denominator, x.divisors};
  add_divisors(result.divisors, y.divisors);
  return result;
}

Fraction quotient(const Fraction& x, const Fraction& y) {
  if (y.numerator.is_zero()) throw SyntaxError("division by zero");
  Fraction result = times(x, {y.denominator, y.numerator, y.divisors});
  add_divisors(result.divisors, {y.numerator});
  return result;
}

/// x - y = n/d, and where d is not zero, n/d > 0 says n d > 0. The divisors come first, each as a condition.
Formula comparison(const Fraction& x, const Fraction& y, std::string_view symbol) {
  const Fraction difference = sum(x, y, true);
  std::vector<Formula> parts;
  for (const Polynomial& divisor : difference.divisors) parts.push_back(non_zero(divisor));
  if (symbol == "!=") {
    parts.push_back(non_zero(difference.numerator));
  } else if (symbol == "=") {
    parts.push_back(atom(difference.numerator, Relation::zero));
  } else {
    const Polynomial sign = difference.numerator * difference.denominator;
    const Relation relation = symbol.size() == 2 ? Relation::non_negative : Relation::positive;
    parts.push_back(atom(symbol.front() == '<' ? -sign : sign, relation));
  }
  return combine(Formula::Kind::conjunction, std::move(parts));
}

}  // namespace

void LineReader::fail_expecting(const std::string& what) const {
  throw SyntaxError("expected " + what + " at '" + std::string(rest_.substr(0, 20)) + "'");
}

bool LineReader::at_end() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
  return rest_.empty();
}

void LineReader::expect_end() {
  if (!at_end()) fail_expecting("the end of the line");
}

bool LineReader::accept(std::string_view symbol) {
  if (at_end() || !rest_.starts_with(symbol)) return false;
  rest_.remove_prefix(symbol.size());
  return true;
}

void LineReader::expect(std::string_view symbol) {
  if (!accept(symbol)) fail_expecting("'" + std::string(symbol) + "'");
}

bool LineReader::accept_word(std::string_view word) {
  const std::string_view before = rest_;
  if (!at_end() && is_letter(rest_.front()) && this->word() == word) return true;
  rest_ = before;
  return false;
}

std::string LineReader::name(std::string_view also) {
  if (at_end() || !is_letter(rest_.front())) fail_expecting("a name");
  const auto end = std::find_if(rest_.begin(), rest_.end(),
                                [&](char c) { return !is_letter(c) && !is_digit(c) && also.find(c) == also.npos; });
  const std::string result(rest_.begin(), end);
  rest_.remove_prefix(result.size());
  return result;
}

mpz_class LineReader::natural() {
  if (at_end() || !is_digit(rest_.front())) fail_expecting("a number");
  const std::string digits(rest_.begin(), std::find_if_not(rest_.begin(), rest_.end(), is_digit));
  if (digits.size() > kMaxDigits) throw LimitError("a number has too many digits");
  rest_.remove_prefix(digits.size());
  return mpz_class(digits, 10);
}

/// Every recursion passes here. A failure ends the line, so the depth need not come down after one.
void LineReader::descend() {
  if (++nesting_ > kMaxNesting) throw LimitError("nested too deeply");
}

Fraction LineReader::expression(const Environment& environment) {
  descend();
  Fraction result = product(environment);
  while (true) {
    const bool minus = accept("-");
    if (!minus && !accept("+")) break;
    result = sum(std::move(result), product(environment), minus);
  }
  --nesting_;
  return result;
}

Fraction LineReader::product(const Environment& environment) {
  Fraction result = power(environment);
  while (true) {
    const bool divide = accept("/");
    if (!divide && !accept("*")) return result;
    result = divide ? quotient(result, power(environment)) : times(result, power(environment));
  }
}

Fraction LineReader::power(const Environment& environment) {
  bool negative = false;
  while (accept("-")) negative = !negative;
  Fraction base;
  if (accept("(")) {
    base = expression(environment);
    expect(")");
  } else if (!at_end() && is_digit(rest_.front())) {
    base.numerator = Polynomial(mpq_class(natural()));
  } else {
    const std::string name = word();
    const auto value = environment.values.find(name);
    if (value == environment.values.end()) throw SyntaxError("unknown name '" + name + "'");
    base = value->second;
  }
  if (accept("^")) {
    const mpz_class exponent = natural();
    if (exponent > kMaxExponent) throw LimitError("an exponent is too large");
    const unsigned n = static_cast<unsigned>(exponent.get_ui());
    base = {base.numerator.power(n), base.denominator.power(n), base.divisors};
  }
  if (negative) base.numerator = -base.numerator;
  return base;
}

Polynomial LineReader::polynomial(const Environment& environment) {
  const Fraction value = expression(environment);
  if (!value.divisors.empty()) throw SyntaxError("expected a polynomial, found a division");
  return value.numerator * Polynomial(1 / value.denominator.constant());
}

Formula LineReader::formula(const Environment& environment) {
  descend();
  std::vector<Formula> parts;
  do {
    parts.push_back(conjunction(environment));
  } while (accept_word("or"));
  Formula result = combine(Formula::Kind::disjunction, std::move(parts));
  --nesting_;
  return result;
}

Formula LineReader::conjunction(const Environment& environment) {
  std::vector<Formula> parts;
  do {
    parts.push_back(comparison_chain(environment));
  } while (accept_word("and"));
  return combine(Formula::Kind::conjunction, std::move(parts));
}

Formula LineReader::comparison_chain(const Environment& environment) {
  if (accept("{")) {
    Formula result = formula(environment);
    expect("}");
    return result;
  }
  if (accept_word("false")) return {Formula::Kind::disjunction, {}, {}, {}};
  for (const auto& [name, formula] : environment.formulas) {
    if (!accept_word(name)) continue;
    formula_size_ += size(formula);
    if (formula_size_ > kMaxFormulaSize) throw LimitError("a formula is too large");
    return formula;
  }
  std::vector<Formula> parts;
  Fraction left = expression(environment);
  constexpr std::array<std::string_view, 6> kSymbols{"<=", ">=", "!=", "<", ">", "="};
  while (true) {
    const auto symbol =
        std::find_if(kSymbols.begin(), kSymbols.end(), [&](auto candidate) { return accept(candidate); });
    if (symbol == kSymbols.end()) break;
    Fraction right = expression(environment);
    parts.push_back(comparison(left, right, *symbol));
    left = std::move(right);
  }
  if (parts.empty()) fail_expecting("a comparison");
  return combine(Formula::Kind::conjunction, std::move(parts));
}

}  // namespace slipproof::check
