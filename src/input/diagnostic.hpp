// What is wrong with an input, and where: every reader reports all mistakes of a file in one go.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace slipproof {

/// One mistake. Lines and columns count from 1; 0 where there is no place.
struct Diagnostic {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
  std::string message;  ///< what was found and what was expected

  bool operator==(const Diagnostic&) const = default;
};

/// `file:line:column: message`.
std::string to_string(const Diagnostic& diagnostic);

/// All mistakes of one input, in the order of their places; the program's exit code is 3.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Diagnostic> diagnostics);
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace slipproof
