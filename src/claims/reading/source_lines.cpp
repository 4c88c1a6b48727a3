#include "claims/reading/source_lines.hpp"

#include <sstream>

#include "base/input/text_file.hpp"

namespace slipproof {

std::optional<SourceLines> read_source_lines(const std::filesystem::path& claims, const Paper& paper) {
  SourceLines result{claims.parent_path() / paper.source, {}, {}};
  std::error_code error;
  if (paper.source.empty() || !std::filesystem::is_regular_file(result.file, error)) return std::nullopt;
  std::istringstream text(read_text_file(result.file));
  bool goes_on = false;  // the line continues a paragraph
  for (std::string line; std::getline(text, line);) {
    const std::string number = std::to_string(result.lines.size() + 1) + ". ";
    if (result.about.empty() && line.starts_with(number)) {
      result.lines.emplace(result.lines.size() + 1, line.substr(number.size()));
    } else if (line.empty()) {
      goes_on = false;
    } else {
      if (!goes_on) result.about.emplace_back();
      result.about.back() += (goes_on ? " " : "") + line;
      goes_on = true;
    }
  }
  return result.lines.empty() ? std::nullopt : std::optional(std::move(result));
}

}  // namespace slipproof
