// Reads one line of a statement or certificate: names, numbers, expressions, formulas (grammar: proofs/FORMAT.md).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "check/formula.hpp"

namespace slipproof::check {

inline constexpr int kMaxNesting = 100;
inline constexpr unsigned kMaxExponent = 64;
inline constexpr std::size_t kMaxDigits = 1'000, kMaxFormulaSize = 10'000, kMaxDivisors = 1'000;

struct SyntaxError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// numerator / denominator, defined where no polynomial in `divisors` is zero; the denominator is a product of those.
struct Fraction {
  Polynomial numerator;
  Polynomial denominator{mpq_class(1)};
  std::vector<Polynomial> divisors{};
};

/// What names stand for.
struct Environment {
  std::map<std::string, Fraction, std::less<>> values;
  std::map<std::string, Formula, std::less<>> formulas;
};

/// A cursor over one line. Every function skips blanks first and throws SyntaxError or LimitError.
class LineReader {
 public:
  explicit LineReader(std::string_view line) : rest_(line) {}

  bool at_end();
  void expect_end();
  bool accept(std::string_view symbol);
  void expect(std::string_view symbol);
  bool accept_word(std::string_view word);
  std::string word() { return name("_'"); }     ///< a letter, then letters, digits, `_`, `'`
  std::string label() { return name("_'.-"); }  ///< the name of a hypothesis: also with `.` and `-`
  mpz_class natural();
  Fraction expression(const Environment& environment);
  Polynomial polynomial(const Environment& environment);  ///< an expression that divides by constants only
  Formula formula(const Environment& environment);

 private:
  [[noreturn]] void fail_expecting(const std::string& what) const;
  std::string name(std::string_view also);
  Fraction product(const Environment& environment);
  Fraction power(const Environment& environment);
  Formula conjunction(const Environment& environment);
  Formula comparison_chain(const Environment& environment);
  void descend();

  std::string_view rest_;
  int nesting_ = 0;
  std::size_t formula_size_ = 0;  ///< of the named formulas used so far
};

}  // namespace slipproof::check
