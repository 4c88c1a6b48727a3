#include <algorithm>

#include "base/input/utf8.hpp"
#include "report/document/document.hpp"

namespace slipproof {

namespace {

using Kind = ReportBlock::Kind;

/// Whether an empty line stands between such a block and its neighbours.
bool stands_apart(const ReportBlock& block) {
  return block.kind == Kind::section || block.kind == Kind::details || block.kind == Kind::verbatim ||
         block.kind == Kind::status || (block.kind == Kind::table && block.table.has_head());
}

class TextWriter {
 public:
  void write(const Document& document, std::size_t indent) {
    const ReportBlock* before = nullptr;
    for (const ReportBlock& block : document.blocks()) {
      const bool after = before != nullptr && (stands_apart(block) || stands_apart(*before));
      const bool apart = after || block.kind == Kind::section || block.kind == Kind::status;
      if (apart && !text_.empty()) text_ += '\n';
      write(block, indent);
      before = &block;
    }
  }

  std::string take() { return std::move(text_); }

 private:
  void write(const ReportBlock& block, std::size_t indent) {
    const std::string margin(indent, ' ');
    switch (block.kind) {
      case Kind::paragraph:
        text_ += wrapped(margin, block.line.text());
        break;
      case Kind::fact:
        text_ += margin + block.term + ": " + block.line.text() + '\n';
        break;
      case Kind::table:
        write(block.table, block.table.has_head() ? std::max<std::size_t>(indent, 2) : indent);
        break;
      case Kind::verbatim:
        text_ += block.line.text() + '\n';
        break;
      default:
        text_ += margin + block.line.text() + '\n';
        write(block.inside, indent + 2);
    }
  }

  void write(const ReportTable& table, std::size_t indent) {
    const std::size_t gap = table.has_head() ? 2 : 1;
    std::vector<std::size_t> widths;
    for (const TableColumn& column : table.columns) {
      widths.push_back(std::max(column.width, utf8_count(column.name.text())));
      for (const TableRow& row : table.rows) {
        if (widths.size() > row.cells.size()) continue;
        widths.back() = std::max(widths.back(), utf8_count(row.cells[widths.size() - 1].text()));
      }
    }
    const auto write_row = [&](std::size_t cells, const auto& text_of) {
      std::string line(indent, ' ');
      for (std::size_t i = 0; i < cells; ++i) {
        const std::string text = text_of(i);
        const bool known = i < widths.size();
        const std::string space(known ? widths[i] - utf8_count(text) : 0, ' ');
        line += std::string(i == 0 ? 0 : gap, ' ') + (known && table.columns[i].number ? space + text : text + space);
      }
      text_ += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    };
    if (table.has_head()) write_row(widths.size(), [&](std::size_t i) { return table.columns[i].name.text(); });
    for (const TableRow& row : table.rows) {
      write_row(row.cells.size(), [&](std::size_t i) { return row.cells[i].text(); });
      write(row.below, indent + 4);
    }
  }

  std::string text_;
};

}  // namespace

std::string text_of(const Document& document) {
  TextWriter writer;
  writer.write(document, 0);
  return writer.take();
}

}  // namespace slipproof
