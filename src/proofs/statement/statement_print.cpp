#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "proofs/statement/statement_text.hpp"

namespace slipproof {

namespace {

// Brackets are nodes that a reader never makes: a conjunction, a sum, or a product of one operand.
bool is_bracket(const Expression& e) {
  constexpr std::array operations{Operation::logical_and, Operation::add, Operation::multiply};
  return e->operands.size() == 1 && std::ranges::find(operations, e->operation) != operations.end();
}

bool is_joined(const Expression& e) {
  return e->operation == Operation::logical_and || e->operation == Operation::logical_or;
}

/// A side of a comparison, or a hint: brackets are its sign's, its subtrahend's, or around all of it.
std::string side(const Expression& e) {
  const auto part = [&](std::size_t i) { return side(e->operands[i]); };
  if (e->operation == Operation::negate && is_bracket(e->operands[0])) return "-" + part(0);
  if (e->operation == Operation::subtract && is_bracket(e->operands[1])) return part(0) + " - " + part(1);
  if (!is_bracket(e)) return to_string(e);
  if (e->operation == Operation::add) return "(" + part(0) + ")";
  const std::vector<Expression>& factors = e->operands[0]->operands;
  return side(factors[0]) + "*" + side(factors[1]);
}

std::string print(const Expression& e, bool inner) {
  if (e->operation == Operation::logical_and && is_bracket(e)) return "{" + print(e->operands[0], false) + "}";
  if (e->operation == Operation::compare) {
    std::string result = side(e->operands[0]);
    for (std::size_t i = 0; i < e->relations.size(); ++i)
      result.append(" ").append(spelling(e->relations[i])).append(" ").append(side(e->operands[i + 1]));
    return result;
  }
  if (!is_joined(e)) return to_string(e);
  std::string result;
  for (const Expression& part : e->operands) {
    if (!result.empty()) result += e->operation == Operation::logical_and ? " and " : " or ";
    result += print(part, true);
  }
  return inner ? "{" + result + "}" : result;
}

std::string line_text(const Directive& line) {
  switch (line.kind) {
    case Directive::Kind::real:
      return fmt::format("real {}", fmt::join(line.names, " "));
    case Directive::Kind::exists:
      return fmt::format("exists {}", fmt::join(line.names, " "));
    case Directive::Kind::let:
      return fmt::format("let {} = {}", line.names.front(), to_string(line.body));
    case Directive::Kind::define:
      return fmt::format("define {}: {}", line.names.front(), formula_text(line.body));
    case Directive::Kind::assume:
      return fmt::format("assume {}: {}", line.names.front(), formula_text(line.body));
    case Directive::Kind::show:
      break;
  }
  return fmt::format("{}{}", formula_prefix, formula_text(line.body));
}

std::string line_text(const SplitHint& hint) {
  return "# split: " + side(hint.expression);
}

}  // namespace

Expression joined_by(Operation word, const std::vector<Expression>& parts) {
  std::vector<Expression> operands;
  for (const Expression& part : parts) {
    if (!part) continue;
    if (part->operation == word && !is_bracket(part)) {
      operands.insert(operands.end(), part->operands.begin(), part->operands.end());
    } else {
      operands.push_back(part);
    }
  }
  if (operands.empty()) return nullptr;
  return operands.size() == 1 ? operands.front() : make(word, std::move(operands));
}

Expression braced(const Expression& formula) {
  return formula ? make(Operation::logical_and, {formula}) : nullptr;
}

Expression bracketed(const Expression& number) {
  return make(Operation::add, {number});
}

Expression tight_product(const Expression& x, const Expression& y) {
  return make(Operation::multiply, {make(Operation::multiply, {x, y})});
}

bool has_cases(const Expression& formula) {
  return formula->operation == Operation::logical_or ||
         (is_joined(formula) && std::ranges::any_of(formula->operands, has_cases));
}

std::string formula_text(const Expression& formula) {
  return print(formula, false);
}

void WrittenStatement::declare(Directive::Kind kind, std::vector<std::string> names) {
  if (!names.empty()) lines_.emplace_back(Directive{kind, 0, std::move(names), nullptr});
}

void WrittenStatement::add_hints(const std::vector<Expression>& hints) {
  for (const Expression& hint : hints) {
    if (hint) lines_.emplace_back(SplitHint{0, hint});
  }
}

std::size_t WrittenStatement::variables() const {
  std::size_t count = 0;
  for (const auto& line : lines_) {
    const auto* directive = std::get_if<Directive>(&line);
    if (directive != nullptr && !directive->body) count += directive->names.size();
  }
  return count;
}

std::string WrittenStatement::text() const {
  std::string result = fmt::format("slipproof-statement 1\ntheorem {}\n# {}\n", theorem_, comment_);
  for (const auto& line : lines_) result += std::visit([](const auto& x) { return line_text(x); }, line) + '\n';
  return result;
}

}  // namespace slipproof
