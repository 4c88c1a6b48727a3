#include "base/input/diagnostic.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace slipproof {

std::string to_string(const Diagnostic& diagnostic) {
  std::string text = diagnostic.file;
  if (diagnostic.line != 0) {
    text += ":" + std::to_string(diagnostic.line);
    if (diagnostic.column != 0) text += ":" + std::to_string(diagnostic.column);
  }
  if (!text.empty()) text += ": ";
  return text + diagnostic.message;
}

FoundAndExpected found_and_expected(std::string_view message) {
  constexpr std::string_view found = "found ", expected = "expected ";
  FoundAndExpected parts;
  const std::size_t second = message.rfind(expected);
  if (second != std::string_view::npos) {
    parts.expected = message.substr(second + expected.size());
    message = message.substr(0, second);
  }
  const std::size_t first = message.find(found);
  if (first == std::string_view::npos) return parts;
  parts.found = message.substr(first + found.size());
  if (parts.found.ends_with(", ")) parts.found.remove_suffix(2);
  return parts;
}

namespace {

std::string joined(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const auto& diagnostic : diagnostics) {
    if (!text.empty()) text += '\n';
    text += to_string(diagnostic);
  }
  return text;
}

}  // namespace

InputError::InputError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(joined(diagnostics)), diagnostics_(std::move(diagnostics)) {}

void Mistakes::add(Place place, std::string message) {
  diagnostics_.push_back({file_, place.line, place.column, std::move(message)});
}

void Mistakes::refuse_if_any() const {
  if (diagnostics_.empty()) return;
  auto sorted = diagnostics_;
  std::ranges::stable_sort(sorted, {}, [](const Diagnostic& d) { return std::tuple(d.line, d.column); });
  // What is read twice, as settings that others inherit from are, is wrong once.
  const auto same = [](const Diagnostic& x, const Diagnostic& y) {
    return x.line == y.line && x.column == y.column && x.message == y.message;
  };
  sorted.erase(std::unique(sorted.begin(), sorted.end(), same), sorted.end());
  throw InputError(std::move(sorted));
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 60;
  constexpr std::string_view hex = "0123456789abcdef";
  std::string result = "'";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool starts_character = (byte & 0xc0) != 0x80;
    if (i >= longest && starts_character) return result + "...'";
    if (byte < 0x20 || byte == 0x7f) {
      result += {'\\', 'x', hex[byte >> 4], hex[byte & 15]};
    } else {
      result += text[i];
    }
  }
  return result + "'";
}

}  // namespace slipproof
