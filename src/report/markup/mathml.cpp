#include "report/markup/mathml.hpp"

#include <array>

#include "base/input/utf8.hpp"
#include "base/number/format.hpp"
#include "report/markup/symbol.hpp"

namespace slipproof {

namespace {

// A fraction and an exponent show their extent by their layout, so they need no parentheses.
Binding laid_out(Operation operation) {
  return operation == Operation::divide || operation == Operation::power ? Binding::primary : binding(operation);
}

std::string_view sign_of(Relation relation) {
  constexpr std::array<std::string_view, 6> signs{"<", "≤", ">", "≥", "=", "≠"};
  return signs[static_cast<std::size_t>(relation)];
}

void put(const Element& row, const Expression& expression, Binding at_least);

bool is_word(std::string_view symbol) {
  return utf8_count(typeset_symbol(symbol).letter) > 1;
}

/// Whether what is written of an expression ends, or begins, with a name of several letters.
bool ends_with_word(const Expression& e) {
  if (e->operation == Operation::symbol) return typeset_symbol(e->symbol).subscript.empty() && is_word(e->symbol);
  return e->operation == Operation::multiply && ends_with_word(e->operands[1]);
}
bool begins_with_word(const Expression& e) {
  switch (e->operation) {
    case Operation::symbol:
      return is_word(e->symbol);
    case Operation::signum:
    case Operation::minimum:
    case Operation::maximum:
      return true;
    case Operation::multiply:
    case Operation::power:
      return begins_with_word(e->operands[0]);
    default:
      return false;
  }
}

/// Without a sign, two numbers side by side would read as one, and so would a name of several letters and its
/// neighbour.
std::string_view times_sign(const Node& product) {
  const auto &left = product.operands[0], &right = product.operands[1];
  const bool needed = right->operation == Operation::number || ends_with_word(left) || begins_with_word(right);
  return needed ? "·" : "\xE2\x81\xA2";
}

void infix(const Element& row, const Node& node, std::string_view sign, Binding right) {
  put(row, node.operands[0], laid_out(node.operation));
  add_operator(row, sign);
  put(row, node.operands[1], right);
}

void word(const Element& row, const Node& node, std::string_view between, Binding right) {
  put(row, node.operands[0], laid_out(node.operation));
  row.add("mtext").text(between);
  put(row, node.operands[1], right);
}

void call(const Element& row, const Node& node, std::string_view function) {
  row.add("mi").text(function);
  add_operator(row, "\xE2\x81\xA1");  // function application
  const Element inside = row.add("mrow");
  add_operator(inside, "(");
  for (std::size_t i = 0; i < node.operands.size(); ++i) {
    if (i > 0) add_operator(inside, ",");
    put(inside, node.operands[i], Binding::loosest);
  }
  add_operator(inside, ")");
}

void put_bare(const Element& row, const Node& node) {
  switch (node.operation) {
    case Operation::number:
      add_number(row, node.number);
      break;
    case Operation::symbol:
      add_symbol(row, node.symbol);
      break;
    case Operation::truth:
      row.add("mtext").text(node.truth ? "true" : "false");
      break;
    case Operation::negate:
      add_operator(row, "−");
      put(row, node.operands[0], Binding::product);
      break;
    case Operation::add:
      infix(row, node, "+", Binding::product);
      break;
    case Operation::subtract:
      infix(row, node, "−", Binding::product);
      break;
    case Operation::multiply:
      infix(row, node, times_sign(node), Binding::unary);
      break;
    case Operation::divide: {
      const Element fraction = row.add("mfrac");
      put(fraction.add("mrow"), node.operands[0], Binding::loosest);
      put(fraction.add("mrow"), node.operands[1], Binding::loosest);
      break;
    }
    case Operation::power: {
      const Element power = row.add("msup");
      const bool fraction = node.operands[0]->operation == Operation::divide;
      const Element base = power.add("mrow");
      if (fraction) add_operator(base, "(");
      put(base, node.operands[0], Binding::primary);
      if (fraction) add_operator(base, ")");
      add_number(power, Rational(node.exponent));
      break;
    }
    case Operation::absolute: {
      add_operator(row, "|");
      put(row, node.operands[0], Binding::loosest);
      add_operator(row, "|");
      break;
    }
    case Operation::signum:
      call(row, node, "sign");
      break;
    case Operation::minimum:
      call(row, node, "min");
      break;
    case Operation::maximum:
      call(row, node, "max");
      break;
    case Operation::compare:
      for (std::size_t i = 0; i < node.operands.size(); ++i) {
        if (i > 0) add_operator(row, sign_of(node.relations[i - 1]));
        put(row, node.operands[i], Binding::sum);
      }
      break;
    case Operation::logical_not:
      row.add("mtext").text("not ");
      put(row, node.operands[0], Binding::negation);
      break;
    case Operation::logical_and:
      word(row, node, " and ", Binding::negation);
      break;
    case Operation::logical_or:
      word(row, node, " or ", Binding::conjunction);
      break;
  }
}

void put(const Element& row, const Expression& expression, Binding at_least) {
  const bool parentheses = laid_out(expression->operation) < at_least;
  const Element inside = parentheses ? row.add("mrow") : row;
  if (parentheses) add_operator(inside, "(");
  put_bare(inside, *expression);
  if (parentheses) add_operator(inside, ")");
}

/// MathML does not break lines. Therefore a formula becomes several adjacent <math>, cut where printers break lines:
/// before relations and the signs of sums.
class Pieces {
 public:
  explicit Pieces(const Element& parent) : parent_(parent) {}

  void add(const Expression& expression) {
    const Operation operation = expression->operation;
    if (operation == Operation::logical_and || operation == Operation::logical_or) {
      const Binding own = laid_out(expression->operation);
      part(expression->operands[0], own);
      parent_.text(operation == Operation::logical_and ? " and " : " or ");
      part(expression->operands[1], tighter(own));
    } else if (operation == Operation::compare) {
      for (std::size_t i = 0; i < expression->operands.size(); ++i) {
        sum(i == 0 ? std::string_view() : sign_of(expression->relations[i - 1]), expression->operands[i]);
      }
    } else {
      sum({}, expression);
    }
  }

 private:
  void part(const Expression& expression, Binding at_least) {
    if (laid_out(expression->operation) >= at_least) return add(expression);
    piece({}, expression, at_least);
  }

  void sum(std::string_view sign, const Expression& expression) {
    const Operation operation = expression->operation;
    if (operation != Operation::add && operation != Operation::subtract) return piece(sign, expression, Binding::sum);
    sum(sign, expression->operands[0]);
    piece(operation == Operation::add ? "+" : "−", expression->operands[1], Binding::product);
  }

  void piece(std::string_view sign, const Expression& expression, Binding at_least) {
    const Element row = parent_.add("math").add("mrow");
    if (!sign.empty()) row.add("mo").set("form", "infix").text(sign);
    put(row, expression, at_least);
  }

  const Element parent_;
};

}  // namespace

Element add_math(const Element& parent) {
  return parent.add("math");
}

void add_operator(const Element& row, std::string_view sign) {
  row.add("mo").text(sign);
}

void add_symbol(const Element& row, std::string_view name) {
  const Symbol symbol = typeset_symbol(name);
  const bool index = !symbol.subscript.empty(), upper = !symbol.superscript.empty();
  const Element whole = index && upper ? row.add("msubsup") : index ? row.add("msub") : upper ? row.add("msup") : row;
  whole.add("mi").text(symbol.letter);
  const bool digits = index && symbol.subscript[0] >= '0' && symbol.subscript[0] <= '9';
  if (index) whole.add(digits ? "mn" : "mi").text(symbol.subscript);
  if (upper) whole.add("mtext").text("(" + symbol.superscript + ")");
}

void add_number(const Element& row, const Rational& value) {
  const Element inside = value < 0 ? row.add("mrow") : row;
  if (value < 0) add_operator(inside, "−");
  const Rational size = abs(value);
  const std::string dividend = numerator(size).str();
  if (denominator(size) == 1) {
    inside.add("mn").text(dividend);
    return;
  }
  const Element fraction = inside.add("mfrac");
  fraction.add("mn").text(dividend);
  fraction.add("mn").text(denominator(size).str());
}

void add_math(const Element& parent, const Expression& expression) {
  Pieces(parent).add(expression);
}

void add_definition(const Element& parent, std::string_view symbol, const Expression& expression) {
  Pieces(parent).add(make_comparison({make_symbol(std::string(symbol)), expression}, {Relation::equal}));
}

}  // namespace slipproof
