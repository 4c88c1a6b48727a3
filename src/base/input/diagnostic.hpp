// What is wrong with an input, and where: every reader reports all mistakes of a file in one go.
#pragma once

#include <compare>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slipproof {

/// A place in a text: line, and column in characters (code points), from 1; 0 where there is no place.
struct Place {
  std::size_t line = 0;
  std::size_t column = 0;
  auto operator<=>(const Place&) const = default;
};

/// One mistake. Lines and columns count from 1; 0 where there is no place.
struct Diagnostic {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
  std::string message;  ///< found ..., expected ...

  bool operator==(const Diagnostic&) const = default;
};

/// `file:line:column: message`.
std::string to_string(const Diagnostic& diagnostic);

/// The two parts of a message `found ..., expected ...`, without the text before them; empty if it has none.
struct FoundAndExpected {
  std::string_view found, expected;
};
FoundAndExpected found_and_expected(std::string_view message);

/// All mistakes of one input, in the order of their places; the program's exit code is 3.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Diagnostic> diagnostics);
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// The mistakes found in one file so far: a reader adds to them, continues, and refuses the file at the end.
class Mistakes {
 public:
  explicit Mistakes(std::string file) : file_(std::move(file)) {}
  void add(Place place, std::string message);
  bool empty() const { return diagnostics_.empty(); }
  /// Throws InputError with all mistakes in the order of their places, if there are any.
  void refuse_if_any() const;

 private:
  std::string file_;
  std::vector<Diagnostic> diagnostics_;
};

/// 'text' as a message may show it: control characters escaped, long texts cut.
std::string in_quotes(std::string_view text);

}  // namespace slipproof
