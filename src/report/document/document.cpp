#include "report/document/document.hpp"

#include <algorithm>

#include "report/markup/mathml.hpp"

namespace slipproof {

Span strong(std::string text) {
  return {Span::Kind::strong, std::move(text)};
}

Span code(std::string text) {
  return {Span::Kind::code, std::move(text)};
}

Span link(std::string text, std::string target) {
  Span span{Span::Kind::link, std::move(text)};
  span.target = std::move(target);
  return span;
}

Span formula(const Expression& expression, const std::string& symbol) {
  Span span = code((symbol.empty() ? "" : symbol + " = ") + to_string(expression));
  span.drawn = [expression, symbol](const Element& parent) {
    symbol.empty() ? add_math(parent, expression) : add_definition(parent, symbol, expression);
  };
  return span;
}

Span drawn(std::string text, std::function<void(const Element&)> html) {
  Span span(std::move(text));
  span.drawn = std::move(html);
  return span;
}

Line& Line::operator+=(Span span) {
  if (!is_empty(span)) spans_.push_back(std::move(span));
  return *this;
}

Line& Line::operator+=(const Line& other) {
  spans_.insert(spans_.end(), other.spans_.begin(), other.spans_.end());
  return *this;
}

std::string Line::text() const {
  std::string text;
  for (const Span& span : spans_) text += span.text;
  return text;
}

Cell Cell::count(std::uint64_t n, bool alarming) {
  Cell cell(std::to_string(n));
  cell.css_class = n == 0 ? "none" : alarming ? "alarm" : "";
  return cell;
}

Document& Table::row(std::vector<Cell> cells) {
  rows.push_back({std::move(cells)});
  return rows.back().below;
}

bool Table::has_head() const {
  return std::any_of(columns.begin(), columns.end(), [](const Column& column) { return !column.name.empty(); });
}

void Document::title(Line text) {
  blocks_.push_back({Block::Kind::title, std::move(text)});
}

void Document::paragraph(Line text) {
  if (!text.empty()) blocks_.push_back({Block::Kind::paragraph, std::move(text)});
}

void Document::line(Line text) {
  if (!text.empty()) blocks_.push_back({Block::Kind::line, std::move(text)});
}

void Document::fact(std::string term, Line value) {
  if (!value.empty()) blocks_.push_back({Block::Kind::fact, std::move(value), std::move(term)});
}

Document& Document::section(Line heading) {
  return blocks_.emplace_back(Block{Block::Kind::section, std::move(heading)}).inside;
}

Document& Document::item(Line text) {
  return blocks_.emplace_back(Block{Block::Kind::item, std::move(text)}).inside;
}

Document& Document::details(Line summary) {
  return blocks_.emplace_back(Block{Block::Kind::details, std::move(summary)}).inside;
}

Table& Document::table(Table table) {
  Block& block = blocks_.emplace_back(Block{Block::Kind::table});
  block.table = std::move(table);
  return block.table;
}

void Document::verbatim(std::string text) {
  blocks_.push_back({Block::Kind::verbatim, std::move(text)});
}

void Document::status(std::string text) {
  blocks_.push_back({Block::Kind::status, std::move(text)});
}

}  // namespace slipproof
