// A statement: real variables, assumptions and what is to be shown. proofs/FORMAT.md gives the syntax and meaning.
#pragma once

#include <cstdint>
#include <istream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "check/reader.hpp"

namespace slipproof::check {

inline constexpr std::size_t kMaxLineLength = 1 << 20;
inline constexpr std::size_t kMaxStatementLines = 10'000;

/// Where and why a statement or certificate cannot be accepted; `rule` is the name of the rule or directive.
struct Failure : std::runtime_error {
  Failure(std::string rule_, std::size_t line_, const std::string& message)
      : std::runtime_error(message), rule(std::move(rule_)), line(line_) {}
  std::string rule;
  std::size_t line;
};

/// The next line that is neither empty nor a comment (#); counts lines; false at the end of the input.
bool next_line(std::istream& input, std::string& line, std::size_t& number);

/// For all values of the variables: if the assumptions hold, the formula `shown` holds; where unknowns are
/// declared, there are values of them for which it holds.
class Statement {
 public:
  /// Throws Failure.
  explicit Statement(std::istream& input);

  const std::string& theorem() const { return theorem_; }
  std::uint64_t fingerprint() const { return fingerprint_; }       ///< FNV-1a of the lines that count
  const Environment& environment() const { return environment_; }  ///< of the universal part
  const std::vector<std::pair<std::string, Formula>>& assumptions() const { return assumptions_; }
  const std::vector<std::string>& unknowns() const { return unknowns_; }

  /// The formula to show, with the unknowns replaced by `witness` (one value each).
  Formula shown(const std::vector<Fraction>& witness) const;

 private:
  void read_universal(LineReader& reader, const std::string& directive);
  Formula read_conclusion(Environment environment) const;
  void declare_variables(LineReader& reader, std::vector<std::string>& names, Environment& environment);

  std::string theorem_;
  std::uint64_t fingerprint_ = 14695981039346656037U;
  Environment environment_;
  std::size_t variables_ = 0;
  std::set<std::string> names_;
  std::vector<std::pair<std::string, Formula>> assumptions_;
  std::vector<std::string> unknowns_;
  std::vector<std::pair<std::size_t, std::string>> conclusion_;  ///< lines from `exists` or `show` on
};

}  // namespace slipproof::check
