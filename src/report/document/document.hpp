// A report as a small tree of blocks. It is built once and written as text, as Markdown or as HTML.
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
struct ReportSpan {
  enum class Kind : std::uint8_t { text, strong, code, link };
  Kind kind = Kind::text;
  std::string text;
  std::string target = {};                              ///< of a link
  std::function<void(const Element&)> drawn = nullptr;  ///< writes the HTML in place of the text; null: the text

  ReportSpan(std::string words) : text(std::move(words)) {}
  ReportSpan(std::string_view words) : text(words) {}
  ReportSpan(const char* words) : text(words) {}
  ReportSpan(Kind what, std::string words) : kind(what), text(std::move(words)) {}
};

ReportSpan strong(std::string text);
/// Text that people type or programs read.
ReportSpan code(std::string text);
/// `target` is an address or, within a page, `#id`. Markdown has no link for the second.
ReportSpan link_to(std::string text, std::string target);
/// An expression, or with `symbol` its definition. HTML typesets it.
ReportSpan formula(const Expression& expression, const std::string& symbol = "");
/// A text that HTML writes in its own way.
ReportSpan drawn(std::string text, std::function<void(const Element&)> html);

/// The content of a line: a string, a span or a list of spans.
class ReportLine {
 public:
  ReportLine() = default;
  ReportLine(std::string text) { *this += ReportSpan(std::move(text)); }
  ReportLine(std::string_view text) : ReportLine(std::string(text)) {}
  ReportLine(const char* text) : ReportLine(std::string(text)) {}
  ReportLine(ReportSpan span) { *this += std::move(span); }
  ReportLine(std::initializer_list<ReportSpan> spans) : spans_(spans) { std::erase_if(spans_, is_empty); }

  ReportLine& operator+=(ReportSpan span);
  bool empty() const { return spans_.empty(); }
  const std::vector<ReportSpan>& spans() const { return spans_; }
  /// The texts of all spans, joined.
  std::string text() const;

 private:
  static bool is_empty(const ReportSpan& span) { return span.text.empty() && !span.drawn; }
  std::vector<ReportSpan> spans_;
};

struct ReportBlock;
struct ReportTable;

/// Where a block begins in text, in columns from what it belongs to, and where its content begins, from its own first
/// column.
struct TextIndent {
  std::size_t own = 0, inside = 2;
};

/// Blocks, one below the other. References that are returned stay valid as long as the document.
class Document {
 public:
  /// The first line: the subject of the report.
  void title(ReportLine text);
  /// Text that is broken into lines of 80 columns. Without text, adds nothing.
  void paragraph(ReportLine text, std::size_t indent = 0);
  /// Text that is never broken, so that it can be searched for. Without text, adds nothing.
  void line(ReportLine text, std::size_t indent = 0);
  /// `term: value`, never broken. Without a value, adds nothing.
  void fact(std::string term, ReportLine value);
  /// A heading. Returns what is below it.
  Document& section(ReportLine heading, TextIndent indent = {});
  /// An entry of a list, broken into lines of 80 columns. Returns what is below it.
  Document& item(ReportLine text, TextIndent indent = {});
  /// Content that HTML shows on demand. Returns the content.
  Document& details(ReportLine summary);
  ReportTable& table(ReportTable table);
  void verbatim(std::string text);
  /// `s VERIFIED ...`: the result, for programs.
  void status(std::string text);

  const std::list<ReportBlock>& blocks() const { return blocks_; }
  /// The same without its title and status: as a part of another report.
  Document as_part() &&;

 private:
  std::list<ReportBlock> blocks_;
};

struct ReportColumn {
  ReportLine name;
  bool number = false;    ///< aligned to the right
  std::size_t width = 0;  ///< the least width in text

  ReportColumn(ReportLine text, bool is_number = false, std::size_t least = 0)
      : name(std::move(text)), number(is_number), width(least) {}
  ReportColumn(std::string text, bool is_number = false) : ReportColumn(ReportLine(std::move(text)), is_number) {}
  ReportColumn(const char* text, bool is_number = false) : ReportColumn(ReportLine(text), is_number) {}
};

struct ReportCell : ReportLine {
  using ReportLine::ReportLine;
  ReportCell(ReportLine line) : ReportLine(std::move(line)) {}
  /// A number. HTML shows 0 faintly, and marks other numbers if they are alarming.
  static ReportCell count(std::uint64_t n, bool alarming = false);
  std::string css_class = {};
};

struct ReportRow {
  std::vector<ReportCell> cells;  ///< the first is the row's name; a last one may have no column
  Document below = {};
};

struct ReportTable {
  std::vector<ReportColumn> columns;  ///< if none has a name, the table has no head
  std::vector<ReportRow> rows = {};
  std::string label = {};      ///< the name of the table for screen readers
  std::string caption = {};    ///< HTML only
  std::string css_class = {};  ///< HTML only
  bool titled = false;         ///< the first column's name is the table's title: in text the rows are indented below it

  /// Returns what is below the row; the reference is valid until the next row.
  Document& row(std::vector<ReportCell> cells);
  bool has_head() const;
};

struct ReportBlock {
  enum class Kind : std::uint8_t { title, paragraph, line, fact, section, item, details, table, verbatim, status };
  Kind kind;
  ReportLine line = {};   ///< also a heading, the text of an item, a summary, or the value of a fact
  std::string term = {};  ///< of a fact
  TextIndent indent = {};
  Document inside = {};  ///< of a section, an item, details
  ReportTable table = {};
};

struct TextLook {
  bool narrow = false;   ///< lines that are never broken are broken at 80 columns, too, and the cells of wide tables
  bool colours = false;  ///< titles and headings are bold
};
/// For a terminal of 80 columns. Content of sections and items is indented.
std::string text_of(const Document& document, const TextLook& look = {});
/// GitHub's Markdown. Formulas between dollar signs stay as they are.
std::string markdown_of(const Document& document);
/// Adds the blocks to an element. Headings begin at h`level`.
void add_document(const Element& parent, const Document& document, int level = 3);
/// Adds one line.
void add_line(const Element& parent, const ReportLine& line);
/// Adds a table in a region of its own that scrolls.
void add_table(const Element& parent, const ReportTable& table);

}  // namespace slipproof
