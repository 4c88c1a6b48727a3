#include "base/output/terminal.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "base/input/utf8.hpp"

namespace slipproof {

bool is_terminal(int descriptor) {
  return isatty(descriptor) != 0;
}

bool takes_colours(int descriptor) {
  const char *const off = std::getenv("NO_COLOR"), *const terminal = std::getenv("TERM");
  if (off != nullptr && *off != '\0') return false;
  return is_terminal(descriptor) && terminal != nullptr && std::string_view(terminal) != "dumb";
}

std::string emphasised(std::string_view text, Emphasis emphasis) {
  constexpr std::array<std::string_view, 4> begins{"\033[1m", "\033[1;32m", "\033[1;31m", "\033[1;33m"};
  return std::string(begins[static_cast<std::size_t>(emphasis)]).append(text).append("\033[0m");
}

std::string narrow(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (utf8_count(line) <= 80) {
      result.append(line) += '\n';
      continue;
    }
    const std::size_t indent = line.find_first_not_of(' ');
    // Further lines are indented by two columns more than the first, which the start of the text makes room for.
    const std::string start(indent + 2, ' ');
    result += wrapped(start, std::string(line.substr(indent))).substr(2);
  }
  return result;
}

}  // namespace slipproof
