#include "report/markup/latex.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>
#include <vector>

#include "report/markup/symbol.hpp"

namespace slipproof {

namespace {

struct NotUnderstood {};

std::string_view sign_of(std::string_view command) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 12> signs{{{"leq", "≤"},
                                                                                 {"geq", "≥"},
                                                                                 {"neq", "≠"},
                                                                                 {"pm", "±"},
                                                                                 {"in", "∈"},
                                                                                 {"rightarrow", "→"},
                                                                                 {"cdot", "·"},
                                                                                 {"infty", "∞"},
                                                                                 {"left", ""},
                                                                                 {"right", ""},
                                                                                 {"ldots", "…"},
                                                                                 {",", ""}}};
  const auto found = std::find_if(signs.begin(), signs.end(), [&](const auto& s) { return s.first == command; });
  if (found == signs.end()) throw NotUnderstood{};
  return found->second;
}

/// Parses a formula by recursive descent. Throws NotUnderstood for a formula that it does not support.
class Formula {
 public:
  explicit Formula(std::string_view text) : text_(text) {}

  void all(const Element& row) {
    items(row);
    if (!text_.empty()) throw NotUnderstood{};
  }

 private:
  char peek() const { return text_.empty() ? '\0' : text_.front(); }
  char take() {
    if (text_.empty()) throw NotUnderstood{};
    const char c = text_.front();
    text_.remove_prefix(1);
    return c;
  }
  void skip_space() {
    while (peek() == ' ') take();
  }
  static bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
  static bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

  void items(const Element& row) {
    if (++depth_ > 32) throw NotUnderstood{};
    for (skip_space(); !text_.empty() && peek() != '}'; skip_space()) scripted(row);
    --depth_;
  }

  /// The text inside {...}.
  std::string_view raw_group() {
    if (take() != '{') throw NotUnderstood{};
    const std::size_t end = text_.find_first_of("{}");
    if (end == text_.npos || text_[end] != '}') throw NotUnderstood{};
    const std::string_view inside = text_.substr(0, end);
    text_.remove_prefix(end + 1);
    return inside;
  }

  void group(const Element& parent) {
    skip_space();
    const Element row = parent.add("mrow");
    if (peek() != '{') return single(row);
    take();
    items(row);
    if (take() != '}') throw NotUnderstood{};
  }

  /// One item with its subscripts and superscripts. The base is built in a document of its own, because MathML wants it
  /// inside its scripts.
  void scripted(const Element& parent) {
    const ElementTree scratch("mrow");
    atom(scratch.root());
    skip_space();
    const char first = peek();
    if (first != '_' && first != '^') {
      parent.add_children_of(scratch.root());
      return;
    }
    take();
    const ElementTree index("mrow");
    group(index.root());
    skip_space();
    const bool both = (peek() == '_' || peek() == '^') && peek() != first;
    const Element whole = parent.add(both ? "msubsup" : first == '_' ? "msub" : "msup");
    whole.add(scratch.root());
    if (!both) {
      whole.add(index.root());
      return;
    }
    take();
    if (first == '_') whole.add(index.root());
    group(whole);
    if (first == '^') whole.add(index.root());
  }

  /// The single character or command that TeX takes as an argument without braces.
  void single(const Element& row) {
    if (++depth_ > 32) throw NotUnderstood{};
    atom(row);
    --depth_;
  }

  void atom(const Element& row) {
    const char c = take();
    if (is_letter(c)) {
      row.add("mi").text(std::string(1, c));
    } else if (is_digit(c)) {
      std::string number(1, c);
      while (is_digit(peek()) || (peek() == '.' && text_.size() > 1 && is_digit(text_[1]))) number += take();
      row.add("mn").text(number);
    } else if (c == '{') {
      items(row.add("mrow"));
      if (take() != '}') throw NotUnderstood{};
    } else if (c == '\\') {
      command(row);
    } else if (std::string_view("+-=<>()|/,.;:'").find(c) != std::string_view::npos) {
      const Element mo = row.add("mo");
      mo.text(c == '-' ? "−" : std::string(1, c));
      if (c == '(' || c == ')' || c == '|') mo.set("stretchy", "true");
    } else if (static_cast<unsigned char>(c) >= 0x80) {
      std::string character(1, c);
      while ((static_cast<unsigned char>(peek()) & 0xC0U) == 0x80U) character += take();
      row.add("mtext").text(character);
    } else {
      throw NotUnderstood{};
    }
  }

  void command(const Element& row) {
    std::string name;
    while (is_letter(peek())) name += take();
    if (name.empty()) name = take();
    if (name == "frac") {
      const Element fraction = row.add("mfrac");
      group(fraction);
      group(fraction);
    } else if (name == "text" || name == "operatorname" || name == "mathrm") {
      std::string inside(raw_group());
      if (name == "operatorname") inside += "\xE2\x80\x89";  // a thin space before the argument
      if (name == "text") {                                  // MathML removes blanks at the ends
        constexpr std::string_view no_break_space = "\xC2\xA0";
        if (inside.starts_with(' ')) inside.replace(0, 1, no_break_space);
        if (inside.ends_with(' ')) inside.replace(inside.size() - 1, 1, no_break_space);
      }
      row.add(name == "text" ? "mtext" : "mi").text(inside);
    } else if (name == "quad") {
      row.add("mspace").set("width", "1em");
    } else if (const std::string_view letter = greek(name); !letter.empty()) {
      row.add("mi").text(letter);
    } else if (const std::string_view sign = sign_of(name); !sign.empty()) {
      row.add("mo").text(sign);
    }
  }

  std::string_view text_;
  int depth_ = 0;
};

struct Piece {
  std::string_view text;
  bool after_space = false;  ///< after a \quad
};

/// A formula in pieces between which a line may end, since MathML does not break lines. It is cut at spaces (\quad),
/// and before relations and signs outside all brackets.
std::vector<Piece> pieces_of(std::string_view latex) {
  constexpr std::string_view quad = "\\quad";
  std::vector<Piece> pieces;
  std::size_t begin = 0;
  bool after_space = false;
  int depth = 0;
  char before = '(';  // the last character that is not a space
  const auto cut = [&](std::size_t end) { pieces.push_back({latex.substr(begin, end - begin), after_space}); };
  for (std::size_t i = 0; i < latex.size(); ++i) {
    const std::string_view rest = latex.substr(i);
    const char c = latex[i];
    if (depth == 0 && rest.starts_with(quad)) {
      cut(i);
      begin = i + quad.size();
      i = begin - 1;
      after_space = true;
      before = '(';
      continue;
    }
    // |...| of \left| and \right| counts as a bracket, too.
    depth +=
        (c == '{' || c == '(' || rest.starts_with("\\left|")) - (c == '}' || c == ')' || rest.starts_with("\\right|"));
    const bool sign = std::string_view("+-=<>").find(c) != std::string_view::npos;
    const bool binary = sign && std::string_view("=<>+-(,{").find(before) == std::string_view::npos;
    if (depth == 0 && binary && i > begin) {
      cut(i);
      begin = i;
      after_space = false;
    }
    if (c != ' ') before = c;
  }
  cut(latex.size());
  return pieces;
}

void add_formula(const Element& parent, std::string_view latex) {
  try {
    const ElementTree scratch("p");
    for (const Piece& piece : pieces_of(latex)) {
      if (piece.after_space) scratch.root().text(" \xE2\x80\x83");
      std::string_view text = piece.text;
      const Element row = scratch.root().add("math").add("mrow");
      const bool first = text.data() == latex.data();
      if (!first && !piece.after_space) {
        row.add("mo").set("form", "infix").text(text[0] == '-' ? "−" : text.substr(0, 1));
        text.remove_prefix(1);
      }
      Formula(text).all(row);
    }
    parent.add_children_of(scratch.root());
  } catch (const NotUnderstood&) {
    parent.add("code").text(latex);
  }
}

}  // namespace

void add_sentence(const Element& parent, std::string_view text) {
  for (bool formula = false; !text.empty(); formula = !formula) {
    const std::size_t end = std::min(text.find('$'), text.size());
    if (formula && end == text.size()) {  // a single dollar sign
      parent.text("$").text(text);
      return;
    }
    if (formula) {
      add_formula(parent, text.substr(0, end));
    } else if (end > 0) {
      parent.text(text.substr(0, end));
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace slipproof
