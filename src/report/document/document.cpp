#include "report/document/document.hpp"

#include <algorithm>

#include "report/markup/mathml.hpp"

namespace slipproof {

ReportSpan strong(std::string text) {
  return {ReportSpan::Kind::strong, std::move(text)};
}

ReportSpan code(std::string text) {
  return {ReportSpan::Kind::code, std::move(text)};
}

ReportSpan link_to(std::string text, std::string target) {
  ReportSpan span{ReportSpan::Kind::link, std::move(text)};
  span.target = std::move(target);
  return span;
}

ReportSpan formula(const Expression& expression, const std::string& symbol) {
  ReportSpan span = code((symbol.empty() ? "" : symbol + " = ") + to_string(expression));
  span.drawn = [expression, symbol](const Element& parent) {
    symbol.empty() ? add_math(parent, expression) : add_definition(parent, symbol, expression);
  };
  return span;
}

ReportSpan drawn(std::string text, std::function<void(const Element&)> html) {
  ReportSpan span(std::move(text));
  span.drawn = std::move(html);
  return span;
}

ReportLine& ReportLine::operator+=(ReportSpan span) {
  if (!is_empty(span)) spans_.push_back(std::move(span));
  return *this;
}

std::string ReportLine::text() const {
  std::string text;
  for (const ReportSpan& span : spans_) text += span.text;
  return text;
}

ReportCell ReportCell::count(std::uint64_t n, bool alarming) {
  ReportCell cell(std::to_string(n));
  cell.css_class = n == 0 ? "none" : alarming ? "alarm" : "";
  return cell;
}

Document& ReportTable::row(std::vector<ReportCell> cells) {
  rows.push_back({std::move(cells)});
  return rows.back().below;
}

bool ReportTable::has_head() const {
  return std::any_of(columns.begin(), columns.end(), [](const ReportColumn& column) { return !column.name.empty(); });
}

void Document::title(ReportLine text) {
  blocks_.push_back({ReportBlock::Kind::title, std::move(text)});
}

void Document::paragraph(ReportLine text, std::size_t indent) {
  if (!text.empty()) blocks_.push_back({ReportBlock::Kind::paragraph, std::move(text), {}, {indent}});
}

void Document::line(ReportLine text, std::size_t indent) {
  if (!text.empty()) blocks_.push_back({ReportBlock::Kind::line, std::move(text), {}, {indent}});
}

void Document::fact(std::string term, ReportLine value) {
  if (!value.empty()) blocks_.push_back({ReportBlock::Kind::fact, std::move(value), std::move(term)});
}

Document& Document::section(ReportLine heading, TextIndent indent) {
  return blocks_.emplace_back(ReportBlock{ReportBlock::Kind::section, std::move(heading), {}, indent}).inside;
}

Document& Document::item(ReportLine text, TextIndent indent) {
  return blocks_.emplace_back(ReportBlock{ReportBlock::Kind::item, std::move(text), {}, indent}).inside;
}

Document& Document::details(ReportLine summary) {
  return blocks_.emplace_back(ReportBlock{ReportBlock::Kind::details, std::move(summary)}).inside;
}

ReportTable& Document::table(ReportTable table) {
  ReportBlock& block = blocks_.emplace_back(ReportBlock{ReportBlock::Kind::table});
  block.table = std::move(table);
  return block.table;
}

void Document::verbatim(std::string text) {
  blocks_.push_back({ReportBlock::Kind::verbatim, std::move(text)});
}

void Document::status(std::string text) {
  blocks_.push_back({ReportBlock::Kind::status, std::move(text)});
}

Document Document::as_part() && {
  std::erase_if(blocks_, [](const ReportBlock& block) {
    return block.kind == ReportBlock::Kind::title || block.kind == ReportBlock::Kind::status;
  });
  return std::move(*this);
}

}  // namespace slipproof
