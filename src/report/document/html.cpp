#include <algorithm>
#include <optional>

#include "report/document/document.hpp"

namespace slipproof {

namespace {

const char* heading(int level) {
  constexpr const char* names[] = {"h1", "h2", "h3", "h4", "h5", "h6"};
  return names[std::clamp(level, 1, 6) - 1];
}

/// The element that neighbours of a kind share.
const char* shared_element(ReportBlock::Kind kind) {
  return kind == ReportBlock::Kind::item ? "ul" : kind == ReportBlock::Kind::fact ? "dl" : nullptr;
}

void add_block(const Element& parent, const ReportBlock& block, int level) {
  switch (block.kind) {
    case ReportBlock::Kind::title:
      return add_line(parent.add(heading(level - 1)), block.line);
    case ReportBlock::Kind::section:
      add_line(parent.add(heading(level)), block.line);
      return add_document(parent, block.inside, level + 1);
    case ReportBlock::Kind::item: {
      const Element item = parent.add("li");
      add_line(item, block.line);
      return add_document(item, block.inside, level);
    }
    case ReportBlock::Kind::fact:
      parent.add("dt").text(block.term);
      return add_line(parent.add("dd"), block.line);
    case ReportBlock::Kind::details: {
      const Element details = parent.add("details", "data");
      add_line(details.add("summary"), block.line);
      return add_document(details, block.inside, level);
    }
    case ReportBlock::Kind::table:
      return add_table(parent, block.table);
    case ReportBlock::Kind::verbatim:
    case ReportBlock::Kind::status:
      return add_line(parent.add("pre").set("tabindex", 0).add("code"), block.line);
    case ReportBlock::Kind::paragraph:
    case ReportBlock::Kind::line:
      return add_line(parent.add("p"), block.line);
  }
}

}  // namespace

void add_line(const Element& parent, const ReportLine& line) {
  for (const ReportSpan& span : line.spans()) {
    if (span.drawn) {
      span.drawn(parent);
    } else if (span.kind == ReportSpan::Kind::text) {
      parent.text(span.text);
    } else if (span.kind == ReportSpan::Kind::link) {
      parent.add("a").set("href", span.target).text(span.text);
    } else {
      parent.add(span.kind == ReportSpan::Kind::code ? "code" : "b").text(span.text);
    }
  }
}

void add_document(const Element& parent, const Document& document, int level) {
  std::optional<Element> shared;
  const char* name = nullptr;
  for (const ReportBlock& block : document.blocks()) {
    const char* const needed = shared_element(block.kind);
    if (needed != name) shared.reset();
    name = needed;
    if (name != nullptr && !shared) shared = parent.add(name);
    add_block(shared.value_or(parent), block, level);
  }
}

void add_table(const Element& parent, const ReportTable& table) {
  const Element scroll = parent.add("div", "scroll").set("tabindex", 0);
  if (!table.label.empty()) scroll.set("role", "region").set("aria-label", table.label);
  const Element whole = scroll.add("table");
  if (!table.css_class.empty()) whole.set("class", table.css_class);
  if (!table.caption.empty()) whole.add("caption").text(table.caption);
  if (table.has_head()) {
    const Element head = whole.add("thead").add("tr");
    for (const ReportColumn& column : table.columns) {
      const bool named = !column.name.empty();
      const Element cell = head.add(named ? "th" : "td");
      if (named) add_line(cell.set("scope", "col"), column.name);
    }
  }
  const Element body = whole.add("tbody");
  for (const ReportRow& row : table.rows) {
    const Element line = body.add("tr");
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const Element cell = i == 0 ? line.add("th").set("scope", "row") : line.add("td");
      const bool number = i > 0 && i < table.columns.size() && table.columns[i].number;
      const std::string& own = row.cells[i].css_class;
      if (number || !own.empty()) cell.set("class", (number ? "number" : "") + (own.empty() ? "" : " " + own));
      add_line(cell, row.cells[i]);
    }
    if (!row.below.blocks().empty()) {
      const auto columns = static_cast<int>(std::max(table.columns.size(), row.cells.size()));
      add_document(body.add("tr").add("td").set("colspan", columns), row.below, 4);
    }
  }
}

}  // namespace slipproof
