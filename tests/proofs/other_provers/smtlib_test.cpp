// The exported text, evaluated by a reader of its own, says at every point what the statement says there according to
// the checker's reader.
#include "proofs/other_provers/smtlib.hpp"

#include <doctest/doctest.h>

#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "base/number/rational.hpp"
#include "proofs/check/theorem.hpp"
#include "proofs/statement/statement.hpp"
#include "support/papers/shipped.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using test::read_file;
using test::shipped_certificates;

namespace {

using Point = std::map<std::string, Rational>;

/// An S-expression: a word, or a list.
struct Sexp {
  std::string word;
  std::vector<Sexp> list;
};

Sexp read_sexp(std::istream& in) {
  Sexp node;
  char c = 0;
  in >> c;
  if (c == '(') {
    while ((in >> std::ws).peek() != ')') node.list.push_back(read_sexp(in));
    in.get();
    return node;
  }
  for (in.unget(); in.peek() != EOF && std::string("() \n").find(static_cast<char>(in.peek())) == std::string::npos;) {
    node.word += static_cast<char>(in.get());
  }
  return node;
}

std::vector<Sexp> read_script(const std::string& text) {
  std::string code, line;
  for (std::istringstream lines(text); std::getline(lines, line);) {
    if (!line.starts_with(";")) code += line + '\n';
  }
  std::vector<Sexp> script;
  for (std::istringstream in(code); (in >> std::ws).peek() != EOF;) script.push_back(read_sexp(in));
  return script;
}

Rational number(const Sexp& node, const Point& point) {
  if (node.list.empty()) {
    return std::isdigit(static_cast<unsigned char>(node.word[0])) != 0 ? Rational(node.word) : point.at(node.word);
  }
  const std::string& operation = node.list[0].word;
  Rational result = number(node.list[1], point);
  if (operation == "-" && node.list.size() == 2) return -result;
  for (std::size_t i = 2; i < node.list.size(); ++i) {
    const Rational operand = number(node.list[i], point);
    if (operation == "+") {
      result += operand;
    } else {
      REQUIRE(operation == "*");
      result *= operand;
    }
  }
  return result;
}

/// A sentence; what `forall` binds has the values of the point.
bool truth(const Sexp& node, const Point& point) {
  if (node.list.empty()) {
    REQUIRE((node.word == "true" || node.word == "false"));
    return node.word == "true";
  }
  const std::string& operation = node.list[0].word;
  if (operation == "forall") return truth(node.list[2], point);
  if (operation == "and" || operation == "or") {
    for (std::size_t i = 1; i < node.list.size(); ++i) {
      if (truth(node.list[i], point) == (operation == "or")) return operation == "or";
    }
    return operation == "and";
  }
  REQUIRE(node.list.size() == 3);
  const Rational left = number(node.list[1], point), right = number(node.list[2], point);
  if (operation == "=") return left == right;
  if (operation == ">=") return left >= right;
  REQUIRE(operation == ">");
  return left > right;
}

bool truth(const check::Formula& formula) {
  using enum check::Kind;
  if (formula.kind != conjunction && formula.kind != disjunction) {
    REQUIRE(formula.polynomial.is_constant());
    const int s = sgn(formula.polynomial.constant());
    return formula.kind == zero ? s == 0 : s > 0 || (formula.kind == non_negative && s == 0);
  }
  for (const check::Formula& part : formula.parts) {
    if (truth(part) == (formula.kind == disjunction)) return formula.kind == disjunction;
  }
  return formula.kind == conjunction;
}

/// The lines of the certificate's witness, as values of the unknowns.
std::vector<std::pair<std::string, std::string>> witness(const std::string& theorem) {
  std::vector<std::pair<std::string, std::string>> values;
  std::string line;
  for (std::istringstream lines(read_file(shipped_certificates / (theorem + ".cert"))); std::getline(lines, line);) {
    if (!line.starts_with("set ")) continue;
    const auto equal = line.find(" = ");
    values.emplace_back(line.substr(4, equal - 4), line.substr(equal + 3));
  }
  REQUIRE(values.size() == 11);
  return values;
}

/// A motion of A2.1 and the like: the parameters, and the unknowns as the witness of a certificate gives them.
Point motion(const Point& parameters, const std::vector<std::pair<std::string, std::string>>& values) {
  check::Names names;
  for (const auto& [name, value] : parameters) {
    names.values[name] = {check::Polynomial(mpz_class(numerator(value).str())),
                          check::Polynomial(mpz_class(denominator(value).str()))};
  }
  Point point = parameters;
  for (const auto& [name, text] : values) {
    check::FormulaReader reader(text);
    reader.names = names;
    reader.need_line();
    const check::Fraction value = reader.value();
    const mpz_class below = value.denominator.value_or(check::Polynomial(1)).constant();
    point[name] = Rational(value.numerator.constant().get_str()) / Rational(below.get_str());
  }
  return point;
}

/// The statement with numbers for its variables and unknowns.
struct Numbers {
  explicit Numbers(const std::string& text) : reader(text), statement(reader) {}
  check::FormulaReader reader;
  check::Statement statement;
};

Numbers at(const std::string& statement, const Point& point) {
  std::string text, line;
  for (std::istringstream lines(statement); std::getline(lines, line);) {
    if (!line.starts_with("real ") && !line.starts_with("exists ")) {
      text += line + '\n';
      continue;
    }
    std::istringstream words(line.substr(line.find(' ')));
    for (std::string name; words >> name;) text += "let " + name + " = " + point.at(name).str() + '\n';
  }
  return Numbers(text);
}

/// Compares both readings at the point; how many assertions are true there, of how many.
std::pair<std::size_t, std::size_t> compare(const std::string& statement, const std::vector<Sexp>& script,
                                            const Point& point) {
  const Numbers numbers = at(statement, point);
  std::vector<bool> expected;
  for (const auto& [name, formula] : numbers.statement.assumptions) expected.push_back(truth(formula));
  expected.push_back(!truth(numbers.statement.shown));
  std::size_t assertion = 0, count = 0;
  for (const Sexp& command : script) {
    if (command.list[0].word != "assert") continue;
    REQUIRE(assertion < expected.size());
    const bool here = truth(command.list[1], point);
    CHECK(here == expected[assertion++]);
    count += here;
  }
  CHECK(assertion == expected.size());
  return {count, assertion};
}

}  // namespace

TEST_CASE("an exported statement is true where the statement is") {
  std::mt19937 random(4);
  const auto positive = [&] {
    return Rational(std::uniform_int_distribution(1, 997)(random), 1 << std::uniform_int_distribution(4, 12)(random));
  };
  for (const std::string claim : {"A1.1", "A2.1.repaired", "A2.2.repaired", "A3.1", "A4.1", "A5.1.repaired.1"}) {
    CAPTURE(claim);
    const bool interval = !claim.starts_with("A5");
    const std::string theorem = claim + (interval ? ".always" : "");
    const auto values = witness(theorem);
    std::vector<std::string> texts{read_file(shipped_certificates / (theorem + ".statement"))};
    if (interval) texts.push_back(read_file(shipped_certificates / (claim + ".only-then.statement")));
    const std::vector<Sexp> with_values = read_script(
        smtlib_witness_text(theorem, texts.front(), "cert", read_file(shipped_certificates / (theorem + ".cert"))));
    for (const std::string& statement : texts) {
      const std::vector<Sexp> script = read_script(smtlib_text(theorem, statement));
      // Points beside motions, and beside others: a motion meets all assumptions, and the conclusion.
      std::map<bool, int> seen;
      for (int sample = 0; sample < 400 && (seen[true] < 3 || seen[false] < 3); ++sample) {
        Point parameters;
        for (const char* name : {"R", "h", "b", "M2", "M3", "f", "g", "sigma", "J", "F"}) parameters[name] = positive();
        const Point point = motion(parameters, values);
        const auto [met, assertions] = compare(statement, script, point);
        if (&statement == texts.data()) compare(statement, with_values, point);
        if (++seen[met + 1 == assertions] > 3) continue;
        for (const auto& [name, value] : point) {
          Point beside = point;
          beside[name] -= Rational(1, 1000);
          compare(statement, script, beside);
          beside[name] = -value;
          compare(statement, script, beside);
        }
      }
      CHECK(seen[true] >= 3);
      CHECK(seen[false] >= 3);
    }
  }
}

TEST_CASE("the text of a small statement") {
  const std::string statement =
      "slipproof-statement 1\ntheorem small\nreal x lett e\nassume domain: e > 0 and x <= lett/e\nshow x*e/2 < lett or "
      "x != 3\n";
  const std::string text = smtlib_text("small", statement);
  CHECK(
      text.substr(text.find("(set-logic")) ==
      "(set-logic QF_NRA)\n"
      "(declare-const x Real)\n"
      "(declare-const lett Real)\n"
      "(declare-const |the variable e| Real)\n"
      "; domain\n"
      "(assert (and (> |the variable e| 0) (and (or (> |the variable e| 0) (> (* (- 1) |the variable e|) 0)) (>= (+ (* "
      "(- 1) x |the variable e| |the variable e|) (* lett |the variable e|)) 0))))\n"
      "; not what is shown\n"
      "(assert (and (>= (+ (* 2 x |the variable e|) (* (- 4) lett)) 0) (and (>= (+ (* (- 1) x) 3) 0) (>= (+ x (- 3)) "
      "0))))\n"
      "(check-sat)\n");
}

TEST_CASE("commands of the language are no names of variables") {
  for (const std::string name : {"push", "pop", "echo", "exit", "reset", "assert"}) {
    CAPTURE(name);
    const std::string text =
        smtlib_text("command", "slipproof-statement 1\ntheorem command\nreal " + name + "\nshow " + name + " >= 0\n");
    CHECK(text.find("(declare-const |the variable " + name + "| Real)\n") != std::string::npos);
    CHECK(text.find("(> (* (- 1) |the variable " + name + "|) 0)") != std::string::npos);
  }
}

TEST_CASE("existence is a quantifier over the unknowns") {
  const std::string text = smtlib_text(
      "exists", "slipproof-statement 1\ntheorem t\nreal x\nassume a: x > 0\nexists y z\nshow y*z = x and y > 0\n");
  CHECK(text.substr(text.find("(set-logic")) ==
        "(set-logic NRA)\n(declare-const x Real)\n; a\n(assert (> x 0))\n; not what is shown\n(assert (forall ((y "
        "Real) (z "
        "Real)) (or (or (> (+ (* (- 1) x) (* y z)) 0) (> (+ x (* (- 1) y z)) 0)) (>= (* (- 1) y) 0))))\n(check-sat)\n");
}

TEST_CASE("existence with the values of a certificate needs no quantifier") {
  const std::string statement = "slipproof-statement 1\ntheorem t\nreal x\nassume a: x > 0\nexists y\nshow y*x = 1\n";
  const std::string begin =
      "slipproof-certificate 1\ntheorem t " + prove::Statement("t", statement).fingerprint() + '\n';
  const std::string proof =
      "cases w\nbranch 1\ncontradiction\nterm 1 a\nequation w.1: -1\nqed\nbranch 2\ncases w.2\n"
      "branch 1\ncontradiction\nterm 1\nqed\nbranch 2\ncontradiction\nterm 1\nqed\nend\nend\n";
  const std::string text = smtlib_witness_text("t", statement, "cert", begin + "witness w\nset y = 1/x\n" + proof);
  CHECK(text.find(";   y = 1/x\n") != std::string::npos);
  CHECK(
      text.substr(text.find("(set-logic")) ==
      "(set-logic QF_NRA)\n(declare-const x Real)\n; a\n(assert (> x 0))\n; not what is shown\n(assert (or (= x 0) (or "
      "(and (>= (* (- 1) x) 0) (>= x 0)) (or (> 0 0) (> 0 0)))))\n(check-sat)\n");
  const std::string in_branches =
      "split s: x\nbranch negative\ncontradiction\nterm 1 s a\nqed\nbranch zero\ncontradiction\nterm 1 a\nqed\n"
      "branch positive\nwitness w\nset y = 1/x\n" +
      proof + "end\n";
  CHECK(smtlib_witness_text("t", statement, "cert", begin + in_branches).empty());
  CHECK(smtlib_witness_text("t", "slipproof-statement 1\ntheorem t\nreal x\nshow x*x >= 0\n", "cert", "").empty());
}
