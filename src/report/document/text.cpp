#include <algorithm>
#include <numeric>
#include <sstream>

#include "base/input/utf8.hpp"
#include "base/output/terminal.hpp"
#include "report/document/document.hpp"

namespace slipproof {

namespace {

constexpr std::size_t line_width = 80;

/// True if an empty line separates the block from its neighbours.
bool stands_apart(const ReportBlock& block) {
  using Kind = ReportBlock::Kind;
  return block.kind == Kind::section || block.kind == Kind::details || block.kind == Kind::verbatim ||
         block.kind == Kind::status || (block.kind == Kind::table && block.table.has_head());
}

bool is_heading(const ReportBlock& block) {
  return block.kind == ReportBlock::Kind::title || block.kind == ReportBlock::Kind::section;
}

class TextWriter {
 public:
  explicit TextWriter(const TextLook& look) : look_(look) {}

  void write(const Document& document, std::size_t indent) {
    const ReportBlock* before = nullptr;
    for (const ReportBlock& block : document.blocks()) {
      const bool after = before != nullptr && (stands_apart(block) || stands_apart(*before));
      const bool apart = after || block.kind == ReportBlock::Kind::section || block.kind == ReportBlock::Kind::status;
      if (apart && !text_.empty()) text_ += '\n';
      write(block, indent + block.indent.own);
      before = &block;
    }
  }

  std::string take() { return std::move(text_); }

 private:
  void write(const ReportBlock& block, std::size_t indent) {
    const std::string margin(indent, ' ');
    switch (block.kind) {
      case ReportBlock::Kind::paragraph:
        text_ += wrapped(margin, block.line.text());
        break;
      case ReportBlock::Kind::fact:
        text_ += as_line(margin + block.term + ": " + block.line.text());
        break;
      case ReportBlock::Kind::table:
        write(block.table, indent);
        break;
      case ReportBlock::Kind::verbatim:
        text_ += block.line.text() + '\n';
        break;
      case ReportBlock::Kind::item:
        text_ += wrapped(margin, block.line.text());
        write(block.inside, indent + block.indent.inside);
        break;
      case ReportBlock::Kind::status:
        text_ += margin + block.line.text() + '\n';
        break;
      default:
        text_ += as_line(margin + block.line.text(), is_heading(block));
        write(block.inside, indent + block.indent.inside);
    }
  }

  /// A line that only a narrow look breaks.
  std::string as_line(const std::string& line, bool is_heading = false) const {
    const std::string text = look_.narrow ? narrow(line) : line + '\n';
    if (!is_heading || !look_.colours) return text;
    return emphasised(text.substr(0, text.size() - 1), Emphasis::strong) + '\n';
  }

  /// A word at the end of its row may be longer than its column, so that one long row does not widen all others.
  static std::vector<std::size_t> widths_of(const ReportTable& table) {
    std::vector<std::size_t> widths;
    for (const ReportColumn& column : table.columns) {
      const std::size_t i = widths.size();
      widths.push_back(std::max(column.width, utf8_count(column.name.text())));
      for (const ReportRow& row : table.rows) {
        if (i + (column.number ? 0 : 1) >= row.cells.size()) continue;
        widths.back() = std::max(widths.back(), utf8_count(row.cells[i].text()));
      }
    }
    return widths;
  }

  static std::string trimmed(const std::string& line) { return line.substr(0, line.find_last_not_of(' ') + 1); }

  /// The lines of a cell in a column of this width.
  static std::vector<std::string> lines_of(const std::string& text, std::size_t width) {
    if (width == 0 || utf8_count(text) <= width) return {text};
    const std::string margin(line_width - width, ' ');
    std::vector<std::string> lines;
    std::istringstream all(wrapped(margin, text));
    for (std::string line; std::getline(all, line);) lines.push_back(trimmed(line.substr(margin.size())));
    return lines;
  }

  /// Widths for a table with a head that is wider than a narrow look: the widest columns give way, down to their
  /// longest words.
  static void narrow_columns(const ReportTable& table, std::size_t indent, std::vector<std::size_t>& widths) {
    std::vector<std::size_t> whole(widths.size()), least(widths.size());
    const auto hold = [&](std::size_t i, const std::string& text) {
      whole[i] = std::max(whole[i], utf8_count(text));
      std::istringstream words(text);
      for (std::string word; words >> word;) least[i] = std::max(least[i], utf8_count(word));
    };
    for (std::size_t i = 0; i < widths.size(); ++i) {
      hold(i, table.columns[i].name.text());
      for (const ReportRow& row : table.rows) {
        if (i < row.cells.size()) hold(i, row.cells[i].text());
      }
    }
    const auto is_wide = [&](const std::vector<std::size_t>& columns) {
      return std::reduce(columns.begin(), columns.end(), indent + 2 * (columns.size() - 1)) > line_width;
    };
    widths.back() = std::max(widths.back(), whole.back());
    if (!is_wide(widths)) return;
    widths = whole;
    while (is_wide(widths)) {
      std::size_t widest = 0;
      for (std::size_t i = 1; i < widths.size(); ++i) {
        if (widths[i] - least[i] > widths[widest] - least[widest]) widest = i;
      }
      if (widths[widest] == least[widest]) return;
      --widths[widest];
    }
  }

  void write(const ReportTable& table, std::size_t indent) {
    const bool head = table.has_head();
    if (head) indent = std::max<std::size_t>(indent, 2);
    std::vector<std::size_t> widths = widths_of(table);
    if (head && look_.narrow) narrow_columns(table, indent, widths);
    const auto cell = [&](const std::string& text, std::size_t i) {
      const std::size_t length = utf8_count(text), width = i < widths.size() ? widths[i] : 0;
      const std::string space(std::max(width, length) - length, ' ');
      return width > 0 && table.columns[i].number ? space + text : text + space;
    };
    const auto write_row = [&](std::size_t margin, std::size_t cells, const auto& text_of) {
      std::vector<std::vector<std::string>> lines;
      std::size_t height = 1;
      for (std::size_t i = 0; i < cells; ++i) {
        lines.push_back(look_.narrow && i < widths.size() && head ? lines_of(text_of(i), widths[i])
                                                                  : std::vector<std::string>{text_of(i)});
        height = std::max(height, lines.back().size());
      }
      for (std::size_t k = 0; k < height; ++k) {
        std::string line(margin, ' ');
        for (std::size_t i = 0; i < cells; ++i) {
          if (i > 0) line += head ? "  " : " ";
          line += cell(k < lines[i].size() ? lines[i][k] : "", i);
        }
        text_ += trimmed(line) + '\n';
      }
    };
    if (head) {
      const std::size_t out = table.titled ? 2 : 0;
      widths.front() += out;
      write_row(indent - out, widths.size(), [&](std::size_t i) { return table.columns[i].name.text(); });
      widths.front() -= out;
    }
    for (const ReportRow& row : table.rows) {
      write_row(indent, row.cells.size(), [&](std::size_t i) { return row.cells[i].text(); });
      write(row.below, indent + (head ? 4 : 2));
    }
  }

  const TextLook look_;
  std::string text_;
};

}  // namespace

std::string text_of(const Document& document, const TextLook& look) {
  TextWriter writer(look);
  writer.write(document, 0);
  return writer.take();
}

}  // namespace slipproof
