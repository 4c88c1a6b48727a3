#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string>

#include "html/sections.hpp"
#include "typeset/latex.hpp"
#include "typeset/mathml.hpp"

namespace slipproof {

namespace {

std::set<std::string, std::less<>> symbols_of(const ClaimsFile& claims) {
  std::set<std::string, std::less<>> symbols;
  for (const Quantity quantity : all_quantities()) symbols.emplace(name(quantity));
  for (const Setting& setting : claims.settings) {
    symbols.insert(setting.force.symbol);
    for (const Parameter& parameter : setting.parameters) symbols.insert(parameter.symbol);
    for (const Definition& definition : setting.definitions) symbols.insert(definition.symbol);
  }
  return symbols;
}

/// Whether the word at [from, to) stands in a formula, `a = 0` or `F in (0, 1)`, and not in a sentence, `a motion`.
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

/// Relations and products as they are printed.
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

void add_prose(const Element& parent, const PageInput& input, const std::string& text) {
  if (text.find('$') != text.npos) return add_sentence(parent, text);
  const auto symbols = symbols_of(*input.claims);
  const auto is_letter = [&](std::size_t i) {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_');
  };
  std::size_t plain = 0;  // what is not written yet begins here
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (is_letter(end)) ++end;
    if (end == at) {
      ++at;
      continue;
    }
    if (symbols.contains(std::string_view(text).substr(at, end - at)) && in_formula(text, at, end)) {
      parent.text(printed_operators(text.substr(plain, at - plain)));
      add_symbol(add_math(parent), text.substr(at, end - at));
      plain = end;
    }
    at = end;
  }
  parent.text(printed_operators(text.substr(plain)));
}

}  // namespace slipproof
