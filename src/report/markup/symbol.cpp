#include "report/markup/symbol.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace slipproof {

std::string_view greek(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 24> letters{
      {{"xi", "ξ"},   {"eta", "η"},        {"sigma", "σ"}, {"mu", "μ"},     {"omega", "ω"}, {"om", "ω"},
       {"eps", "ε"},  {"varepsilon", "ε"}, {"phi", "φ"},   {"Delta", "Δ"},  {"delta", "δ"}, {"alpha", "α"},
       {"beta", "β"}, {"gamma", "γ"},      {"theta", "θ"}, {"lambda", "λ"}, {"kappa", "κ"}, {"tau", "τ"},
       {"nu", "ν"},   {"rho", "ρ"},        {"psi", "ψ"},   {"chi", "χ"},    {"zeta", "ζ"},  {"Omega", "Ω"}}};
  const auto found = std::find_if(letters.begin(), letters.end(), [&](const auto& l) { return l.first == name; });
  return found == letters.end() ? std::string_view() : found->second;
}

Symbol typeset_symbol(std::string_view name) {
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  Symbol symbol;
  std::string_view rest = name;
  if (const std::size_t bar = name.find('_'); bar != name.npos) {
    std::string_view index = name.substr(bar + 1);
    rest = name.substr(0, bar);
    const std::string_view letter = greek(index);
    // N2_1 has an index of its own and the number of the assertion.
    (!rest.empty() && is_digit(rest.back()) ? symbol.superscript : symbol.subscript) = letter.empty() ? index : letter;
  }
  std::size_t end = rest.size();
  while (end > 1 && is_digit(rest[end - 1])) --end;
  if (end < rest.size()) symbol.subscript = rest.substr(end);
  const std::string_view word = rest.substr(0, end), letter = greek(word);
  symbol.letter = letter.empty() ? word : letter;
  if (!letter.empty() || !symbol.subscript.empty()) return symbol;
  // lr is l_r, and muf is mu_f.
  const std::string_view stem = word.substr(0, word.size() - std::min<std::size_t>(word.size(), 1));
  const std::string_view of_stem = greek(stem);
  if (stem.size() != 1 && of_stem.empty()) return symbol;
  symbol.letter = of_stem.empty() ? stem : of_stem;
  symbol.subscript = word.substr(stem.size());
  return symbol;
}

std::string plain_symbol(std::string_view name) {
  if (const std::size_t space = name.find(' '); space != name.npos) {
    return plain_symbol(name.substr(0, space)) + " " + plain_symbol(name.substr(space + 1));
  }
  const Symbol symbol = typeset_symbol(name);
  const bool word = !symbol.subscript.empty() && std::isdigit(static_cast<unsigned char>(symbol.subscript[0])) == 0;
  return symbol.letter + (word ? "_" : "") + symbol.subscript +
         (symbol.superscript.empty() ? "" : "(" + symbol.superscript + ")");
}

void svg_symbol(const Element& text, std::string_view name) {
  for (std::size_t end = 0; !name.empty(); name.remove_prefix(std::min(end + 1, name.size()))) {
    end = std::min(name.find(' '), name.size());
    const Symbol symbol = typeset_symbol(name.substr(0, end));
    text.add("tspan").set("font-style", "italic").text(symbol.letter + (end < name.size() ? " " : ""));
    if (symbol.subscript.empty()) continue;
    text.add("tspan").set("dy", 3).set("font-size", "85%").text(symbol.subscript);
    text.add("tspan").set("dy", -3).text("\xE2\x80\x8B");  // returns to the baseline
  }
}

}  // namespace slipproof
