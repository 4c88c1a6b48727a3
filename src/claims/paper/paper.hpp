// The part of a claims file about the paper itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace slipproof {

/// The printed text; and, if the print is plainly a misprint, what was meant.
enum class Reading : std::uint8_t { printed, repaired };
inline constexpr std::array<Reading, 2> all_readings{Reading::printed, Reading::repaired};
std::string_view name(Reading reading);

/// Whose claim it is: one that others print or share, or one of the authors of the claims file.
enum class Origin : std::uint8_t { printed, ours };
inline constexpr std::array<Origin, 2> all_origins{Origin::printed, Origin::ours};
std::string_view name(Origin origin);

struct Paper {
  std::string title;
  std::vector<std::string> authors;
  std::string reference;            ///< where it is published; may be empty
  std::string found;                ///< a sentence about what the claims show about the paper; may be empty
  std::string source;               ///< file name of the text that the line numbers refer to
  std::string question;             ///< the question that the paper asks, in a few sentences; may be empty
  std::vector<std::string> open;    ///< questions that it leaves open, one or more sentences each
  Origin origin = Origin::printed;  ///< of the claims that do not say theirs
  std::vector<std::string> scenes;  ///< scene files whose numbers its report shows, relative to the claims file
  struct Equation {
    std::string number;
    std::size_t line = 0;
  };
  std::vector<Equation> equations;  ///< all equations with numbers, in the paper's order
  /// `Section 3`, `Assertion 5`: headings that a reader of the printed paper finds, by the line on which they begin.
  std::map<std::size_t, std::string> headings;

  /// The place of a line for readers who have the paper but not its source: `Section 4.2, after (4.3)`; empty without
  /// headings.
  std::string place(std::size_t line) const;
  /// The place with the line: `Section 4.2, (4.3) (line 265)`; `Line 265` without headings.
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
