// What a report says, as a small tree of blocks: made once, and written for a terminal, as Markdown and as HTML.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/expression/expression.hpp"
#include "report/markup/element.hpp"

namespace slipproof {

/// A piece of a line.
struct Span {
  enum class Kind : std::uint8_t { text, strong, code, link };
  Kind kind = Kind::text;
  std::string text;
  std::string target = {};                              ///< of a link
  std::function<void(const Element&)> drawn = nullptr;  ///< what HTML has in place of the text; null: the text

  Span(std::string words) : text(std::move(words)) {}
  Span(std::string_view words) : text(words) {}
  Span(const char* words) : text(words) {}
  Span(Kind what, std::string words) : kind(what), text(std::move(words)) {}
};

Span strong(std::string text);
/// What is typed or read by programs.
Span code(std::string text);
/// `target` is an address or, within a page, `#id`: Markdown and text have the words alone of the second.
Span link(std::string text, std::string target);
/// An expression; with `symbol`, its definition. HTML typesets it.
Span formula(const Expression& expression, const std::string& symbol = "");
/// A text for which HTML has something of its own.
Span drawn(std::string text, std::function<void(const Element&)> html);

/// What stands in one line: a string, a span or a list of spans.
class Line {
 public:
  Line() = default;
  Line(std::string text) { *this += Span(std::move(text)); }
  Line(std::string_view text) : Line(std::string(text)) {}
  Line(const char* text) : Line(std::string(text)) {}
  Line(Span span) { *this += std::move(span); }
  Line(std::initializer_list<Span> spans) : spans_(spans) { std::erase_if(spans_, is_empty); }

  Line& operator+=(Span span);
  Line& operator+=(const Line& other);
  bool empty() const { return spans_.empty(); }
  const std::vector<Span>& spans() const { return spans_; }
  /// All texts one after the other.
  std::string text() const;

 private:
  static bool is_empty(const Span& span) { return span.text.empty() && !span.drawn; }
  std::vector<Span> spans_;
};

struct Block;

/// Blocks one below the other. What is returned by reference is good for as long as the document is.
class Document {
 public:
  /// What the whole is about: its first line.
  void title(Line text);
  /// Broken into lines of 80 columns; nothing where the text is empty.
  void paragraph(Line text);
  /// Never broken, as the lines that somebody searches for; nothing where it is empty.
  void line(Line text);
  /// `term: value`, never broken; nothing where the value is empty.
  void fact(std::string term, Line value);
  /// A heading; what stands below is returned.
  Document& section(Line heading);
  /// An entry of a list; what stands below it is returned.
  Document& item(Line text);
  /// What HTML shows when it is asked for.
  Document& details(Line summary);
  struct Table& table(struct Table table);
  void verbatim(std::string text);
  /// `s VERIFIED ...`: what happened, for programs.
  void status(std::string text);

  const std::list<Block>& blocks() const { return blocks_; }

 private:
  std::list<Block> blocks_;
};

struct Column {
  Line name;
  bool number = false;    ///< stands to the right
  std::size_t width = 0;  ///< at least, in text

  Column(Line text, bool is_number = false, std::size_t least = 0)
      : name(std::move(text)), number(is_number), width(least) {}
  Column(std::string text, bool is_number = false) : Column(Line(std::move(text)), is_number) {}
  Column(const char* text, bool is_number = false) : Column(Line(text), is_number) {}
};

struct Cell : Line {
  using Line::Line;
  Cell(Line line) : Line(std::move(line)) {}
  /// A number of which 0 is of no interest; in HTML what is alarming is marked.
  static Cell count(std::uint64_t n, bool alarming = false);
  std::string css_class = {};
};

struct TableRow {
  std::vector<Cell> cells;  ///< the first says what the row is about; a last one may have no column
  Document below = {};
};

struct Table {
  std::vector<Column> columns;  ///< all without a name: there is no head
  std::vector<TableRow> rows = {};
  std::string label = {};      ///< what it is about, for those who have a page read out
  std::string caption = {};    ///< in HTML
  std::string css_class = {};  ///< in HTML

  /// What stands below the row is returned; it is good until the next row.
  Document& row(std::vector<Cell> cells);
  bool has_head() const;
};

struct Block {
  enum class Kind : std::uint8_t { title, paragraph, line, fact, section, item, details, table, verbatim, status };
  Kind kind;
  Line line = {};         ///< also of a heading, an item, a summary; the value of a fact
  std::string term = {};  ///< of a fact
  Document inside = {};   ///< of a section, an item, details
  Table table = {};
};

/// For a terminal of 80 columns: what stands below a heading or an entry is indented.
std::string text_of(const Document& document);
/// GitHub's Markdown. Formulas between dollar signs stay as they are.
std::string markdown_of(const Document& document);
/// Adds the blocks to an element; headings begin at h`level`.
void add_document(const Element& parent, const Document& document, int level = 3);
/// One line of them.
void add_line(const Element& parent, const Line& line);
/// The table in a region that scrolls by itself.
void add_table(const Element& parent, const Table& table);

}  // namespace slipproof
