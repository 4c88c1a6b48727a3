#include "report/papers/prose.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string>

#include "report/markup/latex.hpp"
#include "report/markup/mathml.hpp"
#include "report/markup/symbol.hpp"

namespace slipproof {

namespace {

std::set<std::string, std::less<>> symbols_of(const ClaimsFile& claims) {
  std::set<std::string, std::less<>> symbols;
  for (const Setting& setting : claims.settings) {
    for (std::string& quantity : setting.quantities()) symbols.insert(std::move(quantity));
    symbols.insert(setting.force.symbol);
    for (const FreeParameter& parameter : setting.parameters) symbols.insert(parameter.symbol);
    for (const FreeAngle& angle : setting.angles) symbols.insert({angle.cosine, angle.sine});
    for (const Definition& definition : setting.definitions) symbols.insert(definition.symbol);
  }
  return symbols;
}

/// Whether the word at [from, to) is in a formula, `a = 0` or `F in (0, 1)`, and not in a sentence, `a motion`.
bool in_formula(std::string_view text, std::size_t from, std::size_t to) {
  constexpr std::string_view operators = "=<>!*/+^";
  const std::size_t before = text.substr(0, from).find_last_not_of(' '), after = text.find_first_not_of(' ', to);
  if (before != text.npos && operators.find(text[before]) != operators.npos) return true;
  if (after == text.npos) return false;
  if (operators.find(text[after]) != operators.npos ||
      (text[after] == '-' && after + 1 < text.size() && text[after + 1] == ' '))
    return true;
  const std::string_view rest = text.substr(to);
  return rest.starts_with(" in (") || rest.starts_with(" in [") || rest.starts_with(" in {");
}

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// `F_1`, `delta_3`: an index in typewriter notation, of a symbol that occurs only in the paper.
bool has_written_index(std::string_view word) {
  const std::size_t bar = word.find('_');
  if (bar == word.npos || bar == 0 || bar + 1 == word.size()) return false;
  return std::all_of(word.begin() + static_cast<std::ptrdiff_t>(bar) + 1, word.end(), is_digit) &&
         (bar == 1 ? is_letter(word[0]) : !greek(word.substr(0, bar)).empty());
}

/// Whether a word of this form is always a symbol: `f`, `sigma` and `b11` are never words of a sentence, but `a` is.
bool is_no_word(std::string_view symbol) {
  if (symbol.size() == 1) return symbol != "a" && symbol != "A" && symbol != "I";
  return is_digit(symbol.back()) || !greek(symbol).empty();
}

/// Whether the word at [from, to) is part of something longer, as in `A2.4`, `e.g.` and `isn't`.
bool is_part(std::string_view text, std::size_t from, std::size_t to) {
  if (from > 0 && (text[from - 1] == '.' || text[from - 1] == '\'')) return true;
  return to + 1 < text.size() && text[to] == '.' && (is_letter(text[to + 1]) || is_digit(text[to + 1]));
}

/// Replaces relations and products by the signs used in print.
std::string printed_operators(std::string text) {
  constexpr std::array<std::array<std::string_view, 2>, 4> signs{
      {{">=", "≥"}, {"<=", "≤"}, {"!=", "≠"}, {" * ", " · "}}};
  for (const auto& [typed, sign] : signs) {
    for (std::size_t at = text.find(typed); at != text.npos; at = text.find(typed, at + sign.size())) {
      text.replace(at, typed.size(), sign);
    }
  }
  return text;
}

}  // namespace

void add_prose(const Element& parent, const ClaimsFile& claims, const std::string& text) {
  if (text.find('$') != text.npos) return add_sentence(parent, text);
  const auto symbols = symbols_of(claims);
  const auto in_word = [&](std::size_t i) {
    return i < text.size() && (is_letter(text[i]) || is_digit(text[i]) || text[i] == '_');
  };
  std::size_t plain = 0;  // start of the text that is not written yet
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (in_word(end)) ++end;
    if (end == at) {
      ++at;
      continue;
    }
    const std::string_view word = std::string_view(text).substr(at, end - at);
    const bool known = symbols.contains(word);
    if ((known && in_formula(text, at, end)) ||
        (!is_part(text, at, end) && (has_written_index(word) || (known && is_no_word(word))))) {
      parent.text(printed_operators(text.substr(plain, at - plain)));
      add_symbol(add_math(parent), word);
      plain = end;
    }
    at = end;
  }
  parent.text(printed_operators(text.substr(plain)));
}

ReportSpan prose(const ClaimsFile& claims, const std::string& text) {
  if (text.empty()) return text;
  return drawn(text, [&claims, text](const Element& parent) { add_prose(parent, claims, text); });
}

}  // namespace slipproof
