#include "report/picture/labels/contact_table.hpp"

#include <algorithm>

#include "base/input/utf8.hpp"

namespace slipproof {

namespace {

constexpr double table_row = 16, table_letter = 7.4, column_gap = 12, table_text = 12;

std::string force_text(const MechanismScene& scene, const MotionAtLoad& motion, std::size_t unknown,
                       const NumberWords& numbers) {
  return numbers.range(range_of_force(scene, motion, unknown));
}

}  // namespace

std::string contact_letter(std::size_t index) {
  const std::string last(1, static_cast<char>('a' + index % 26));
  return index < 26 ? last : contact_letter(index / 26 - 1) + last;
}

LabelBox add_contact_table(const Element& svg, const MechanismScene& scene, const MotionAtLoad* motion,
                           const std::vector<std::size_t>& contacts, const NumberWords& numbers, Point corner) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const MechanismContact& contact = scene.mechanism.contacts[contacts[i]];
    std::vector<std::string> row{contact_letter(i), contact_text(scene, motion, contacts[i]), "", ""};
    if (motion != nullptr) {
      row[2] = "N " + force_text(scene, *motion, contact.normal, numbers);
      if (contact.tangent) row[3] = "S " + force_text(scene, *motion, *contact.tangent, numbers);
    }
    rows.push_back(std::move(row));
  }
  return add_text_table(svg, rows, corner);
}

LabelBox add_text_table(const Element& svg, const std::vector<std::vector<std::string>>& rows, Point corner,
                        double most) {
  std::vector<double> widths(rows.empty() ? 0 : rows.front().size());
  double whole = 0;
  for (std::size_t column = 0; column < widths.size(); ++column) {
    std::size_t widest = 0;
    for (const auto& row : rows) widest = std::max(widest, utf8_count(row[column]));
    if (widest > 0) widths[column] = table_letter * static_cast<double>(widest) + column_gap;
    whole += widths[column];
  }
  const double share = std::min(1.0, most / std::max(whole - column_gap, 1.0));
  double x = corner[0];
  for (std::size_t column = 0; column < widths.size(); ++column) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i][column].empty()) continue;
      svg.add("text", column == 0 ? "ink" : "soft")
          .set("x", x)
          .set("y", corner[1] + table_row * static_cast<double>(i + 1) - 4)
          .set("font-size", share * table_text)
          .text(rows[i][column]);
    }
    x += share * widths[column];
  }
  return {corner[0], corner[1], x - share * column_gap, corner[1] + contact_table_height(rows.size())};
}

double contact_table_height(std::size_t contacts) {
  return table_row * static_cast<double>(contacts);
}

}  // namespace slipproof
