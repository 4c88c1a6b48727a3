// Writes a phase diagram as a file of its own.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/markup/number.hpp"
#include "report/phase/phase_signs.hpp"
#include "report/phase/phase_svg.hpp"
#include "report/picture/palette.hpp"

namespace slipproof {

namespace {

constexpr double title_height = 34, entry_height = 24, heading_height = 24;

std::string whole_note(const PhaseDiagram& diagram, const PhaseRegions& regions) {
  const std::string& note = diagram.plane.note;
  if (!regions.leaves_domain) return note;
  return note + (note.empty() ? "" : " ") + "White is out of the domain.";
}

/// As many words as fit into a line, with at least the beginning of the first.
std::string fitting(std::string words, const std::vector<std::string>& more, double width) {
  const auto room = static_cast<std::size_t>((width - 98) / 6.2);
  if (words.size() > room) words = words.substr(0, room - 4) + "…";
  for (const std::string& part : more) {
    if (words.size() + part.size() <= room) words += part;
  }
  return words;
}

Element add_entry(const Element& svg, std::string_view css_class, double top, std::size_t index) {
  const double y = top + entry_height * static_cast<double>(index);
  return svg.add("g", css_class).set("transform", "translate(60 " + short_number(y) + ")");
}

void add_legend(const Element& svg, const PhasePicture& picture, double top) {
  const PhaseRegions& regions = picture.regions;
  for (std::size_t i = 0; i < regions.sets.size(); ++i) {
    const Element entry = add_entry(svg, "key", top, i);
    paint_swatch(entry.add("rect"), picture, i);
    const auto& motions = regions.sets[i].motions;
    std::string more;
    if (motions.size() == 1) more = ": " + picture.diagram.plane.words(motions[0].front());
    if (motions.size() > 1) more = ": ambiguous, " + std::to_string(motions.size()) + " motions";
    const std::string note = thin_note(picture, i), first = note.empty() ? note : note + " ";
    const std::string words = fitting(first + name(regions.sets[i]), {more}, picture.options.width);
    entry.add("text", "ink").set("x", 38).set("y", 13).text(words);
  }
  std::size_t index = regions.sets.size();
  for (const PhaseSign& sign : phase_signs(picture)) {
    const Element entry = add_entry(svg, "sign", top, index++);
    draw_sign(entry, picture, sign);
    entry.add("text", "ink").set("x", 38).set("y", 13).text(fitting(sign.words, {}, picture.options.width));
  }
}

/// Adds the enlargements, two in a row.
void add_enlargements(const Element& svg, const PhasePicture& picture, double top) {
  const PhaseSvgOptions options = enlargement_options(picture.options);
  for (std::size_t i = 0; i < picture.thin.enlargements.size(); ++i) {
    const double x = options.width * static_cast<double>(i % 2);
    const double y = top + (heading_height + options.height) * static_cast<double>(i / 2);
    const Element part = svg.add("g").set("transform", "translate(" + short_number(x) + " " + short_number(y) + ")");
    part.add("text", "ink").set("x", 60).set("y", 16).text(enlargement_title(picture, i));
    const Element place = part.add("g").set("transform", "translate(0 " + short_number(heading_height) + ")");
    add_enlargement(place, picture, i).set("width", options.width).set("height", options.height);
  }
}

}  // namespace

std::string enlargement_title(const PhasePicture& picture, std::size_t index) {
  std::vector<std::size_t> numbers;
  const auto& thin = picture.thin.regions;
  for (std::size_t k = 0; k < thin.size(); ++k) {
    if (thin[k].enlargement == index) numbers.push_back(k + 1);
  }
  return fmt::format("({}) enlarged", fmt::join(numbers, ", "));
}

std::string thin_note(const PhasePicture& picture, std::size_t set) {
  const auto& thin = picture.thin.regions;
  for (std::size_t k = 0; k < thin.size(); ++k) {
    if (thin[k].set != set) continue;
    return fmt::format("({}, {})", k + 1, thin[k].line ? "in one column only" : "drawn wider than it is");
  }
  return {};
}

std::string phase_svg_file(const PhaseDiagram& diagram, const PhaseSvgOptions& options) {
  return phase_svg_file(phase_picture(diagram, options));
}

std::string phase_svg_file(const PhasePicture& picture) {
  const PhaseDiagram& diagram = picture.diagram;
  const PhaseSvgOptions& options = picture.options;
  const std::size_t enlarged = picture.thin.enlargements.size();
  const double row = heading_height + enlargement_options(options).height;
  const double plots = title_height + options.height + row * static_cast<double>((enlarged + 1) / 2);
  const std::string note = whole_note(diagram, picture.regions);
  const std::size_t entries = picture.regions.sets.size() + phase_signs(picture).size();
  const double legend = 16 + entry_height * static_cast<double>(entries);
  const double height = plots + legend + (note.empty() ? 0 : 20);
  const ElementTree document("svg");
  const Element svg = document.root().set("xmlns", "http://www.w3.org/2000/svg");
  svg.set("width", options.width).set("height", height).set("role", "img");
  svg.set("viewBox", fmt::format("0 0 {} {}", short_number(options.width), short_number(height)));
  svg.set("font-family", "system-ui, 'DejaVu Sans', sans-serif").set("font-size", 12);
  svg.add("title").text(diagram.plane.title);
  svg.add("style").code(picture_style());
  svg.add("rect", "paper").set("width", options.width).set("height", height);
  svg.add("text", "ink").set("x", 60).set("y", 23).set("font-size", 16).text(diagram.plane.title);
  add_phase_svg(svg.add("g").set("transform", "translate(0 " + short_number(title_height) + ")"), picture)
      .set("width", options.width)
      .set("height", options.height);
  add_enlargements(svg, picture, title_height + options.height);
  add_legend(svg, picture, plots);
  if (!note.empty()) svg.add("text", "soft").set("x", 60).set("y", height - 16).text(note);
  return document.xml();
}

}  // namespace slipproof
