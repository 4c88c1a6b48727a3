// Theorem files: statements and their certificates after each other in one file (proofs/FORMAT.md).
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace slipproof::check {

inline constexpr std::string_view kTheorems = ".theorems";  ///< how the name of such a file ends

/// A part of the file, and the number of its first line; 0: there is no such part.
struct Part {
  std::string text;
  std::size_t line = 0;
};

struct StatedTheorem {
  Part statement, certificate;
};

struct TheoremFile {
  Part claims;
  std::map<std::string, StatedTheorem> theorems;  ///< by the names that the statements give
  std::string problem;                            ///< `LINE: parts: what is wrong`; then the rest does not count
};

/// Splits the text before each line that begins a part. Judges no part.
TheoremFile split_theorems(std::string_view text);

}  // namespace slipproof::check
