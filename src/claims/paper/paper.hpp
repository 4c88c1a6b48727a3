// What a claims file says of the paper itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace slipproof {

/// What stands in print; and, where the print is plainly a misprint, what was meant.
enum class Reading : std::uint8_t { printed, repaired };
inline constexpr std::array<Reading, 2> all_readings{Reading::printed, Reading::repaired};
std::string_view name(Reading reading);

struct Paper {
  std::string title;
  std::vector<std::string> authors;
  std::string reference;            ///< where it is published; may be empty
  std::string found;                ///< what the claims show of it, in a sentence; may be empty
  std::string source;               ///< file name of the text that line numbers refer to
  std::string question;             ///< what the paper asks, in a few sentences; may be empty
  std::vector<std::string> open;    ///< what it leaves open, a sentence or more each
  std::vector<std::string> scenes;  ///< scene files that its report has numbers of, relative to the claims file
  struct Equation {
    std::string number;
    std::size_t line = 0;
  };
  std::vector<Equation> equations;  ///< all that the paper numbers, in its order
  /// `Section 3`, `Assertion 5`: what a reader of the printed paper finds, and on which line it begins.
  std::map<std::size_t, std::string> headings;

  /// Where a line is for who has the paper and not its source: `Section 4.2, after (4.3)`; empty without headings.
  std::string place(std::size_t line) const;
  /// The same with the line: `Section 4.2, (4.3) (line 265)`; `Line 265` without headings.
  std::string where(std::size_t line) const;
};

/// A statement that no calculation can judge.
struct Unchecked {
  std::string id;
  std::size_t line = 0;
  std::string statement;
  std::string why;
};

}  // namespace slipproof
