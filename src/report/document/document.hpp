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
struct ReportSpan {
  enum class Kind : std::uint8_t { text, strong, code, link };
  Kind kind = Kind::text;
  std::string text;
  std::string target = {};                              ///< of a link
  std::function<void(const Element&)> drawn = nullptr;  ///< what HTML has in place of the text; null: the text

  ReportSpan(std::string words) : text(std::move(words)) {}
  ReportSpan(std::string_view words) : text(words) {}
  ReportSpan(const char* words) : text(words) {}
  ReportSpan(Kind what, std::string words) : kind(what), text(std::move(words)) {}
};

ReportSpan strong(std::string text);
/// What is typed or read by programs.
ReportSpan code(std::string text);
/// `target` is an address or, within a page, `#id`: Markdown and text have the words alone of the second.
ReportSpan link(std::string text, std::string target);
/// An expression; with `symbol`, its definition. HTML typesets it.
ReportSpan formula(const Expression& expression, const std::string& symbol = "");
/// A text for which HTML has something of its own.
ReportSpan drawn(std::string text, std::function<void(const Element&)> html);

/// What stands in one line: a string, a span or a list of spans.
class ReportLine {
 public:
  ReportLine() = default;
  ReportLine(std::string text) { *this += ReportSpan(std::move(text)); }
  ReportLine(std::string_view text) : ReportLine(std::string(text)) {}
  ReportLine(const char* text) : ReportLine(std::string(text)) {}
  ReportLine(ReportSpan span) { *this += std::move(span); }
  ReportLine(std::initializer_list<ReportSpan> spans) : spans_(spans) { std::erase_if(spans_, is_empty); }

  ReportLine& operator+=(ReportSpan span);
  ReportLine& operator+=(const ReportLine& other);
  bool empty() const { return spans_.empty(); }
  const std::vector<ReportSpan>& spans() const { return spans_; }
  /// All texts one after the other.
  std::string text() const;

 private:
  static bool is_empty(const ReportSpan& span) { return span.text.empty() && !span.drawn; }
  std::vector<ReportSpan> spans_;
};

struct ReportBlock;

/// Blocks one below the other. What is returned by reference is good for as long as the document is.
class Document {
 public:
  /// What the whole is about: its first line.
  void title(ReportLine text);
  /// Broken into lines of 80 columns; nothing where the text is empty.
  void paragraph(ReportLine text);
  /// Never broken, as the lines that somebody searches for; nothing where it is empty.
  void line(ReportLine text);
  /// `term: value`, never broken; nothing where the value is empty.
  void fact(std::string term, ReportLine value);
  /// A heading; what stands below is returned.
  Document& section(ReportLine heading);
  /// An entry of a list; what stands below it is returned.
  Document& item(ReportLine text);
  /// What HTML shows when it is asked for.
  Document& details(ReportLine summary);
  struct ReportTable& table(struct ReportTable table);
  void verbatim(std::string text);
  /// `s VERIFIED ...`: what happened, for programs.
  void status(std::string text);

  const std::list<ReportBlock>& blocks() const { return blocks_; }

 private:
  std::list<ReportBlock> blocks_;
};

struct TableColumn {
  ReportLine name;
  bool number = false;    ///< stands to the right
  std::size_t width = 0;  ///< at least, in text

  TableColumn(ReportLine text, bool is_number = false, std::size_t least = 0)
      : name(std::move(text)), number(is_number), width(least) {}
  TableColumn(std::string text, bool is_number = false) : TableColumn(ReportLine(std::move(text)), is_number) {}
  TableColumn(const char* text, bool is_number = false) : TableColumn(ReportLine(text), is_number) {}
};

struct TableCell : ReportLine {
  using ReportLine::ReportLine;
  TableCell(ReportLine line) : ReportLine(std::move(line)) {}
  /// A number of which 0 is of no interest; in HTML what is alarming is marked.
  static TableCell count(std::uint64_t n, bool alarming = false);
  std::string css_class = {};
};

struct TableRow {
  std::vector<TableCell> cells;  ///< the first says what the row is about; a last one may have no column
  Document below = {};
};

struct ReportTable {
  std::vector<TableColumn> columns;  ///< all without a name: there is no head
  std::vector<TableRow> rows = {};
  std::string label = {};      ///< what it is about, for those who have a page read out
  std::string caption = {};    ///< in HTML
  std::string css_class = {};  ///< in HTML

  /// What stands below the row is returned; it is good until the next row.
  Document& row(std::vector<TableCell> cells);
  bool has_head() const;
};

struct ReportBlock {
  enum class Kind : std::uint8_t { title, paragraph, line, fact, section, item, details, table, verbatim, status };
  Kind kind;
  ReportLine line = {};   ///< also of a heading, an item, a summary; the value of a fact
  std::string term = {};  ///< of a fact
  Document inside = {};   ///< of a section, an item, details
  ReportTable table = {};
};

/// For a terminal of 80 columns: what stands below a heading or an entry is indented.
std::string text_of(const Document& document);
/// GitHub's Markdown. Formulas between dollar signs stay as they are.
std::string markdown_of(const Document& document);
/// Adds the blocks to an element; headings begin at h`level`.
void add_document(const Element& parent, const Document& document, int level = 3);
/// One line of them.
void add_line(const Element& parent, const ReportLine& line);
/// The table in a region that scrolls by itself.
void add_table(const Element& parent, const ReportTable& table);

}  // namespace slipproof
