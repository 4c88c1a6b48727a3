#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/number/format.hpp"
#include "report/html/sections.hpp"
#include "report/markup/latex.hpp"
#include "report/markup/symbol.hpp"
#include "report/phase/phase_points.hpp"
#include "report/phase/phase_signs.hpp"
#include "report/phase/phase_svg.hpp"

namespace slipproof {

namespace {

/// A short number exactly; a longer one rounded, and marked as rounded.
std::string in_table(const Rational& x) {
  const std::string exact = exact_text(x);
  return exact.size() <= 12 ? exact : "≈ " + decimal_text(x, 6);
}

std::string in_table(const ForceInterval& forces) {
  if (forces.is_point()) return in_table(*forces.lower());
  return "(" + (forces.lower() ? in_table(*forces.lower()) : "−∞") + ", " +
         (forces.upper() ? in_table(*forces.upper()) : "+∞") + ")";
}

/// About ten columns, and those with names.
std::vector<const PhaseColumn*> table_columns(const PhaseDiagram& diagram) {
  std::vector<const PhaseColumn*> even, chosen;
  for (const PhaseColumn& column : diagram.columns) {
    if (column.even) even.push_back(&column);
  }
  for (std::size_t i = 0; i < 9 && !even.empty(); ++i) chosen.push_back(even[i * (even.size() - 1) / 8]);
  for (const PhaseColumn& column : diagram.columns) {
    const auto named = [&](const Plane::Line& line) { return line.x == column.x; };
    if (std::any_of(diagram.plane.lines.begin(), diagram.plane.lines.end(), named)) chosen.push_back(&column);
  }
  std::sort(chosen.begin(), chosen.end(), [](const auto* a, const auto* b) { return a->x < b->x; });
  chosen.erase(std::unique(chosen.begin(), chosen.end(), [](const auto* a, const auto* b) { return a->x == b->x; }),
               chosen.end());
  return chosen;
}

std::string column_name(const Plane& plane, const Rational& x) {
  std::string text = in_table(x);
  for (const Plane::Line& line : plane.lines) {
    if (line.x == x) text += " = " + plain_symbol(line.symbol) + (line.misprint ? " as printed" : "");
  }
  return text;
}

void add_columns(const Element& parent, const PhaseDiagram& diagram) {
  Document hidden;
  ReportTable& table =
      hidden.details("The same as a table")
          .table({{plain_symbol(diagram.plane.x.symbol), {plain_symbol(diagram.plane.y.symbol), true}, "motions"}});
  table.label = "Table of " + diagram.plane.title;
  table.caption = "Exact sets of forces, open intervals; the motions at their ends are those of both sides.";
  for (const PhaseColumn* column : table_columns(diagram)) {
    for (const auto* cell : open_cells(*column)) {
      table.row({column_name(diagram.plane, column->x), in_table(cell->loads), name(motion_set(*cell))});
    }
  }
  add_document(parent, hidden);
}

void add_legend(const Element& parent, const PhasePicture& picture, bool words) {
  const Element list = parent.add("ul", "legend");
  for (std::size_t i = 0; i < picture.regions.sets.size(); ++i) {
    const Element item = list.add("li");
    add_swatch(item, picture, i);
    const MotionSet& set = picture.regions.sets[i];
    const Element text = item.add("span");
    text.add("b").text(name(set));
    if (words && set.motions.size() == 1) text.text(" " + picture.diagram.plane.words(set.motions[0].front()));
    if (set.motions.size() > 1) text.text(" ambiguous: " + std::to_string(set.motions.size()) + " motions");
    if (const std::string note = thin_note(picture, i); !note.empty()) text.text(" " + note);
  }
  for (const PhaseSign& sign : phase_signs(picture)) {
    const Element item = list.add("li");
    draw_sign(item.add("svg", "swatch").set("viewBox", "0 0 28 18").set("aria-hidden", "true"), picture, sign);
    item.add("span").text(sign.words);
  }
}

void add_enlargements(const Element& parent, const PhasePicture& picture) {
  for (std::size_t i = 0; i < picture.thin.enlargements.size(); ++i) {
    const Element box = parent.add("div", "enlarged");
    const std::string title = enlargement_title(picture, i);
    box.add("p").text(title);
    add_enlargement(box, picture, i).set("role", "img").set("aria-label", title);
  }
}

/// The claims that are false as printed at some point of the diagram.
std::string refuted_claims(const PhaseDiagram& diagram, const PhaseRegions& regions) {
  std::string ids;
  for (std::size_t k = 0; k < diagram.plane.claims.size(); ++k) {
    const auto here = [&](const RefutedStrip& strip) { return strip.claim == k; };
    if (std::any_of(regions.refuted.begin(), regions.refuted.end(), here)) {
      ids += (ids.empty() ? "" : ", ") + diagram.plane.claims[k];
    }
  }
  return ids;
}

/// The meaning of the lines and the hatching that occur in the diagram.
void add_line_legend(const Element& parent, const PhaseDiagram& diagram, const PhaseRegions& regions) {
  if (diagram.plane.curves.empty()) return;
  const Element list = parent.add("ul", "legend lines");
  const auto entry = [&](std::string_view css_class, std::string_view text) {
    const Element item = list.add("li");
    const Element svg = item.add("svg", "swatch").set("viewBox", "0 0 28 18").set("aria-hidden", "true");
    svg.add("path", css_class).set("d", "M1,9H27");
    item.add("span").text(text);
  };
  const auto occurs = [&](PhaseLine::Kind kind) {
    return std::any_of(regions.lines.begin(), regions.lines.end(), [&](const auto& l) { return l.kind == kind; });
  };
  entry("edge", "the motions change, exactly on a threshold of the claims");
  if (occurs(PhaseLine::Kind::extra)) entry("new", "the motions change, and the claims have no threshold there");
  if (occurs(PhaseLine::Kind::idle)) entry("curve", "a threshold of the claims where nothing changes");
  const auto shows_misprint = [&](const Plane::Line& line) {
    return line.misprint && diagram.plane.x.from < line.x && line.x < diagram.plane.x.to;
  };
  if (std::any_of(diagram.plane.lines.begin(), diagram.plane.lines.end(), shows_misprint)) {
    entry("misprint", "a value of b as printed, where another one is meant");
  }
  if (!regions.refuted.empty()) {
    const Element item = list.add("li", "hatch-key");
    const Element svg = item.add("svg", "swatch").set("viewBox", "0 0 28 18").set("aria-hidden", "true");
    svg.add("rect").set("width", 28).set("height", 18).set("fill", "url(#" + diagram.plane.id + "-hatch)");
    item.add("span").text("a claim is false: " + refuted_claims(diagram, regions));
  }
}

void add_hatch_switch(const Element& parent, const PhaseRegions& regions) {
  if (regions.refuted.empty()) return;
  const Element label = parent.add("label", "switch");
  label.add("input").set("type", "checkbox").set("class", "show-hatch").set("checked", "checked");
  label.text(" Hatch the forces at which a claim is false");
}

}  // namespace

void add_phase_figure(const Element& parent, const PhaseFigure& figure) {
  const PhaseDiagram& diagram = figure.diagram;
  PhaseSvgOptions options;
  if (figure.small) options.width = 430, options.height = 320;
  const PhasePicture picture = phase_picture(diagram, options);
  const PhaseRegions& regions = picture.regions;
  const Element box = parent.add("figure", figure.small ? "phase small" : "phase").set("id", diagram.plane.id);
  const Element heading = box.add(figure.small ? "h4" : "h3").set("id", diagram.plane.id + "-title");
  heading.add("bdi").text(diagram.plane.title);
  add_hatch_switch(box, regions);
  const Element plot = box.add("div", "plot");
  const Element svg = add_phase_svg(plot, picture);
  svg.set("role", "img").set("aria-labelledby", diagram.plane.id + "-title");
  const auto points = figure.small ? sample_points(diagram, 10, 8) : sample_points(diagram, 30, 20);
  box.add("script").set("type", "application/json").set("class", "points").text(points_json(diagram, points));
  add_enlargements(box, picture);
  add_legend(box, picture, !figure.small);
  add_line_legend(box, diagram, regions);
  if (!figure.caption.empty()) add_sentence(box.add("figcaption"), figure.caption);
  if (!figure.explorer.empty()) box.add("p", "explore").add("a").set("href", figure.explorer).text(explorer_words);
  add_columns(box, diagram);
}

}  // namespace slipproof
