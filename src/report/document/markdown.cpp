#include <algorithm>
#include <cctype>

#include "report/document/document.hpp"

namespace slipproof {

namespace {

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// True if Markdown would read the character at `i` as markup.
bool is_sign(std::string_view text, std::size_t i) {
  const char before = i == 0 ? ' ' : text[i - 1], after = i + 1 == text.size() ? ' ' : text[i + 1];
  switch (text[i]) {
    case '\\':
    case '`':
    case '[':
    case '|':
      return true;
    case '*':
      return before != ' ' || after != ' ' || i == 0;
    case '_':
      return !is_word(before) || !is_word(after);
    case '<':
    case '&':
      return is_word(after) || after == '/' || after == '!' || after == '?' || after == '#';
    case '>':
      return i == 0;
    case '#':
    case '+':
    case '-':
      return i == 0 && (after == ' ' || after == text[i]);
    default:
      return false;
  }
}

std::string escaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t end = text[i] == '$' ? text.find('$', i + 1) : text.npos;
    if (end != text.npos) {  // a formula
      result += text.substr(i, end + 1 - i);
      i = end;
      continue;
    }
    if (is_sign(text, i)) result += '\\';
    result += text[i] == '\n' ? ' ' : text[i];
  }
  return result;
}

/// A fence of more backquotes than the longest run in the text.
std::string fenced(std::string_view text, std::size_t least) {
  std::size_t longest = 0, run = 0;
  for (const char c : text) longest = std::max(longest, run = c == '`' ? run + 1 : 0);
  return std::string(std::max(least, longest + 1), '`');
}

std::string in_markdown(const ReportSpan& span) {
  switch (span.kind) {
    case ReportSpan::Kind::text:
      break;
    case ReportSpan::Kind::strong:
      return "**" + escaped(span.text) + "**";
    case ReportSpan::Kind::code: {
      const std::string fence = fenced(span.text, 1), blank = fence.size() > 1 ? " " : "";
      return fence + blank + span.text + blank + fence;
    }
    case ReportSpan::Kind::link:
      if (!span.target.starts_with('#')) return "[" + escaped(span.text) + "](" + span.target + ")";
      break;
  }
  return escaped(span.text);
}

std::string in_markdown(const ReportLine& line) {
  std::string text;
  for (const ReportSpan& span : line.spans()) text += in_markdown(span);
  return text;
}

/// A bar ends a cell even in code.
std::string in_cell(const ReportLine& line) {
  std::string text;
  for (const ReportSpan& span : line.spans()) {
    const std::string part = in_markdown(span);
    for (const char c : part) text += c == '|' && span.kind == ReportSpan::Kind::code ? "\\|" : std::string(1, c);
  }
  return text;
}

class MarkdownWriter {
 public:
  void write(const Document& document, int level, const std::string& margin) {
    const ReportBlock* before = nullptr;
    for (const ReportBlock& block : document.blocks()) {
      const bool entry = block.kind == ReportBlock::Kind::item || block.kind == ReportBlock::Kind::fact;
      const bool goes_on = before != nullptr && entry &&
                           (before->kind == ReportBlock::Kind::item || before->kind == ReportBlock::Kind::fact);
      if (!text_.empty() && !goes_on) text_ += "\n";
      write(block, level, margin);
      before = &block;
    }
  }

  std::string take() { return std::move(text_); }

 private:
  void write(const ReportBlock& block, int level, const std::string& margin) {
    const std::string text = in_markdown(block.line);
    const auto line = [&](const std::string& whole) { text_ += margin + whole + "\n"; };
    switch (block.kind) {
      case ReportBlock::Kind::title:
        return line("# " + text);
      case ReportBlock::Kind::section:
        line(std::string(static_cast<std::size_t>(std::min(level, 6)), '#') + " " + text);
        return write(block.inside, level + 1, margin);
      case ReportBlock::Kind::item:
        line("- " + text);
        return write(block.inside, level, margin + "  ");
      case ReportBlock::Kind::fact:
        return line("- **" + escaped(block.term) + "**: " + text);
      case ReportBlock::Kind::details:
        line("<details><summary>" + text + "</summary>");
        write(block.inside, level, margin);
        text_ += "\n";
        return line("</details>");
      case ReportBlock::Kind::table:
        return write(block.table, level, margin);
      case ReportBlock::Kind::verbatim:
        return write_verbatim(block.line.text(), margin);
      case ReportBlock::Kind::status:
        return line(in_markdown(code(block.line.text())));
      case ReportBlock::Kind::paragraph:
      case ReportBlock::Kind::line:
        return line(text);
    }
  }

  void write_verbatim(std::string_view text, const std::string& margin) {
    const std::string fence = fenced(text, 3);
    text_ += margin + fence + "\n";
    for (std::size_t at = 0; at < text.size(); ++at) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      text_ += margin + std::string(text.substr(at, end - at)) + "\n";
      at = end;
    }
    text_ += margin + fence + "\n";
  }

  /// The content below the rows follows the table as a list.
  void write(const ReportTable& table, int level, const std::string& margin) {
    std::size_t columns = table.columns.size();
    for (const ReportRow& row : table.rows) columns = std::max(columns, row.cells.size());
    const auto write_row = [&](const auto& cell) {
      text_ += margin + "|";
      for (std::size_t i = 0; i < columns; ++i) text_ += cell(i);
      text_ += "\n";
    };
    const auto known = [&](std::size_t i) { return i < table.columns.size(); };
    write_row([&](std::size_t i) { return " " + (known(i) ? in_cell(table.columns[i].name) : "") + " |"; });
    write_row([&](std::size_t i) { return std::string(known(i) && table.columns[i].number ? "---:|" : "---|"); });
    for (const ReportRow& row : table.rows) {
      write_row([&](std::size_t i) { return " " + (i < row.cells.size() ? in_cell(row.cells[i]) : "") + " |"; });
    }
    Document notes;
    for (const ReportRow& row : table.rows) {
      if (!row.below.blocks().empty()) notes.item(strong(row.cells.front().text())) = row.below;
    }
    write(notes, level, margin);
  }

  std::string text_;
};

}  // namespace

std::string markdown_of(const Document& document) {
  MarkdownWriter writer;
  writer.write(document, 2, "");
  return writer.take();
}

}  // namespace slipproof
