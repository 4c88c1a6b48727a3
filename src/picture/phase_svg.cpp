#include "picture/phase_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "markup/number.hpp"
#include "number/binary64.hpp"
#include "picture/axis.hpp"
#include "picture/palette.hpp"
#include "picture/polyline.hpp"
#include "typeset/symbol.hpp"

namespace slipproof {

namespace {

/// One motion, in which a contact is open.
bool opens(const MotionSet& set) {
  if (set.motions.size() != 1) return false;
  const MechanismMode& mode = set.motions[0].front();
  return std::find(mode.begin(), mode.end(), ElementState::lift) != mode.end();
}

/// Room for the numbers of the vertical axis and its name.
double left_of(const Plane& plane) {
  std::size_t longest = 0;
  for (const Rational& y : {plane.y.from, plane.y.to}) {
    longest = std::max(longest, fmt::format("{:.0f}", nearest_binary64(y)).size());
  }
  return std::max(60.0, 8.0 * static_cast<double>(longest) + 12);
}

std::vector<MechanismMode> drawn_modes(const PhaseRegions& regions) {
  std::vector<MechanismMode> modes;
  for (const MotionSet& set : regions.sets) {
    for (const auto& motion : set.motions) modes.push_back(motion.front());
    modes.insert(modes.end(), set.continua.begin(), set.continua.end());
  }
  return modes;
}

class Picture {
 public:
  Picture(const PhaseDiagram& diagram, const PhaseRegions& regions, const PhaseSvgOptions& options)
      : plane_(diagram.plane),
        regions_(regions),
        colours_(drawn_modes(regions)),
        frame_{left_of(plane_),          14,       options.width - left_of(plane_) - 18,
               options.height - 14 - 46, plane_.x, plane_.y} {}

  /// Patterns for what one colour cannot show, and the clip of the plot.
  void add_definitions(const Element& svg) const {
    const Element defs = svg.add("defs");
    const Element clip = defs.add("clipPath").set("id", plane_.id + "-clip").add("rect");
    place(clip);
    for (std::size_t i = 0; i < regions_.sets.size(); ++i) {
      const MotionSet& set = regions_.sets[i];
      if (is_plain(set)) continue;
      const Element pattern = defs.add("pattern").set("id", pattern_id(i)).set("patternUnits", "userSpaceOnUse");
      const std::size_t stripes = std::max<std::size_t>(1, set.motions.size() + set.continua.size());
      const double size = opens(set) || is_empty(set) ? 9 : 7.0 * static_cast<double>(stripes);
      pattern.set("width", size).set("height", size);
      if (!opens(set)) pattern.set("patternTransform", "rotate(-45)");
      if (is_empty(set)) {
        pattern.add("path", "measure").set("d", "M0,0H9M0,0V9");
        continue;
      }
      for (std::size_t k = 0; k < stripes; ++k) {
        const Element stripe = pattern.add("rect", stripe_class(set, k));
        stripe.set("x", size * static_cast<double>(k) / static_cast<double>(stripes));
        stripe.set("width", size / static_cast<double>(stripes)).set("height", size);
      }
      if (opens(set)) pattern.add("circle", "dots").set("cx", 3).set("cy", 3).set("r", 0.9);
    }
  }

  void add_regions(const Element& plot) const {
    for (std::size_t i = 0; i < regions_.sets.size(); ++i) {
      std::string d;
      for (const Strip& strip : regions_.strips) {
        if (strip.set == regions_.sets[i]) d += area(strip.lower, strip.upper);
      }
      const Element path = plot.add("path").set("d", d);
      paint(path, i);
      path.add("title").text(name(regions_.sets[i]));
    }
  }

  void add_refuted(const Element& plot) const {
    if (regions_.refuted.empty()) return;
    const Element pattern = plot.add("defs").add("pattern").set("id", plane_.id + "-hatch");
    pattern.set("patternUnits", "userSpaceOnUse").set("width", 8).set("height", 8);
    pattern.add("path", "hatching").set("d", "M-2,2 L2,-2 M0,8 L8,0 M6,10 L10,6");
    const Element group = plot.add("g", "hatch");
    for (std::size_t k = 0; k < plane_.claims.size(); ++k) {
      std::string d;
      for (const RefutedStrip& strip : regions_.refuted) {
        if (strip.claim == k) d += area(strip.lower, strip.upper);
      }
      if (d.empty()) continue;
      const Element path = group.add("path").set("d", d).set("fill", "url(#" + plane_.id + "-hatch)");
      path.add("title").text(plane_.claims[k] + " is false here");
    }
  }

  void add_lines(const Element& plot) const {
    const auto draw = [&](PhaseLine::Kind kind, std::string_view css_class) {
      std::string d;
      for (const PhaseLine& line : regions_.lines) {
        if (line.kind == kind) d += path_of(frame_.to_picture(line.points));
      }
      if (!d.empty()) plot.add("path", css_class).set("d", d);
    };
    draw(PhaseLine::Kind::idle, "curve");
    draw(PhaseLine::Kind::edge, "edge");
    draw(PhaseLine::Kind::extra, "new");
    for (const Plane::Line& line : plane_.lines) {
      if (!(plane_.x.from < line.x && line.x < plane_.x.to)) continue;
      const double x = frame_.x_of(nearest_binary64(line.x));
      const Element path = plot.add("path", line.misprint ? "misprint" : "line");
      path.set("d", fmt::format("M{0},{1}V{2}", short_number(x), short_number(frame_.top),
                                short_number(frame_.top + frame_.height)));
      path.add("title").text(plain_symbol(line.symbol) + (line.misprint ? " as printed" : ""));
    }
  }

  /// The names of vertical lines, at the top; of two that are too close, the second one is lower.
  void add_line_names(const Element& plot) const {
    std::vector<const Plane::Line*> lines;
    for (const Plane::Line& line : plane_.lines) {
      if (plane_.x.from < line.x && line.x < plane_.x.to) lines.push_back(&line);
    }
    std::sort(lines.begin(), lines.end(), [](const auto* a, const auto* b) { return a->x < b->x; });
    double before = -1e9, y = 0;
    for (const Plane::Line* line : lines) {
      const double x = frame_.x_of(nearest_binary64(line->x));
      y = x - before < 60 ? y + 16 : frame_.top + 15;
      before = x;
      const Element text = plot.add("text", "ink halo").set("x", x + 5).set("y", y).set("font-size", 13);
      svg_symbol(text, line->symbol);
      if (line->misprint) text.add("tspan").set("font-size", 11).text(" as printed");
    }
  }

  /// The name of each curve at the middle of the longest piece where it is a border; of one that nowhere is, where it
  /// can be seen.
  void add_curve_names(const Element& plot) const {
    for (std::size_t c = 0; c < plane_.curves.size(); ++c) {
      std::vector<Pixel> best;
      double longest = 0;
      for (const PhaseLine& line : regions_.lines) {
        if (line.curve != c) continue;
        const auto visible = frame_.visible(frame_.to_picture(line.points));
        const double length = length_of(visible) * (line.kind == PhaseLine::Kind::idle ? 0.2 : 1);
        if (length > longest) longest = length, best = visible;
      }
      if (longest < 12) continue;
      const Pixel at = best[best.size() / 2];
      const Element text = plot.add("text", "ink halo").set("x", at.x + 5).set("y", at.y - 6).set("font-size", 15);
      svg_symbol(text, plane_.curves[c]);
    }
  }

  void add_region_names(const Element& plot) const {
    for (const MotionSet& set : regions_.sets) {
      const std::string label = set.motions.size() > 1 ? std::to_string(set.motions.size()) + " motions" : name(set);
      const double width = 7.2 * static_cast<double>(label.size()) + 14;
      Pixel best{0, 0};
      double room = 1;
      for (const Strip& strip : regions_.strips) {
        if (strip.set == set) find_room(strip, width, room, best);
      }
      if (room <= 1) continue;
      plot.add("text", "ink name").set("x", best.x).set("y", best.y + 4).set("text-anchor", "middle").text(label);
    }
  }

  void add_axes(const Element& svg) const { frame_.draw(svg); }

  void add_mark(const Element& svg) const {
    if (!plane_.mark) return;
    const double x = frame_.x_of(nearest_binary64(plane_.mark->x)), y = frame_.y_of(nearest_binary64(plane_.mark->y));
    const Element mark = svg.add("g");
    mark.add("circle", "ink").set("cx", x).set("cy", y).set("r", 4);
    mark.add("circle", "frame").set("cx", x).set("cy", y).set("r", 8);
    mark.add("title").text(plane_.mark->label);
  }

  Element add_plot(const Element& svg) const {
    svg.set("data-plot", fmt::format("{} {} {} {}", short_number(frame_.left), short_number(frame_.top),
                                     short_number(frame_.width), short_number(frame_.height)));
    return svg.add("g").set("clip-path", "url(#" + plane_.id + "-clip)");
  }

  void paint(const Element& shape, std::size_t index) const {
    const MotionSet& set = regions_.sets[index];
    if (is_plain(set)) {
      shape.set("class", set.motions.empty() ? "paper" : colours_.fill_class(set.motions[0].front()));
    } else {
      shape.set("fill", "url(#" + pattern_id(index) + ")");
    }
  }

  /// The same for a small sample in a legend, which needs an outline where it is as white as the paper.
  void paint_swatch(const Element& rect, std::size_t index) const {
    rect.set("width", 28).set("height", 18).set("rx", 3);
    paint(rect, index);
    if (is_empty(regions_.sets[index])) rect.set("class", plane_.finds_domain ? "outline" : "paper outline");
  }

 private:
  static bool is_empty(const MotionSet& set) { return set.continua.empty() && set.motions.empty(); }
  bool is_plain(const MotionSet& set) const {
    if (is_empty(set)) return !plane_.finds_domain;
    return set.continua.empty() && set.motions.size() <= 1 && !opens(set);
  }
  std::string pattern_id(std::size_t index) const { return plane_.id + "-" + std::to_string(index); }
  std::string stripe_class(const MotionSet& set, std::size_t k) const {
    if (k < set.motions.size()) return colours_.fill_class(set.motions[k].front());
    return colours_.fill_class(set.continua[k - set.motions.size()]);
  }
  void place(const Element& rect) const {
    rect.set("x", frame_.left).set("y", frame_.top).set("width", frame_.width).set("height", frame_.height);
  }

  std::string area(const std::vector<PlanePoint>& lower, const std::vector<PlanePoint>& upper) const {
    auto outline = simplified(frame_.to_picture(upper));
    const auto back = simplified(frame_.to_picture(lower));
    outline.insert(outline.end(), back.rbegin(), back.rend());
    return closed_path_of(outline);
  }

  /// The roomiest place for a label `width` wide: how many times it fits, if more often than before.
  void find_room(const Strip& strip, double width, double& room, Pixel& best) const {
    const auto lower = frame_.to_picture(strip.lower), upper = frame_.to_picture(strip.upper);
    const double top = frame_.top, bottom = frame_.top + frame_.height;
    for (std::size_t i = 0; i < lower.size(); ++i) {
      const double high = std::max(upper[i].y, top), low = std::min(lower[i].y, bottom);
      const double middle = (high + low) / 2;
      double left = lower[i].x, right = lower[i].x;
      const auto fits = [&](std::size_t k) { return upper[k].y < middle - 9 && lower[k].y > middle + 9; };
      for (std::size_t k = i; k < lower.size() && fits(k); ++k) right = lower[k].x;
      for (std::size_t k = i + 1; k-- > 0 && fits(k);) left = lower[k].x;
      const double across = 2 * std::min(right - lower[i].x, lower[i].x - left) / width, up = (low - high) / 22;
      const double here = std::min(across, up);
      if (here > room) room = here, best = {lower[i].x, middle};
    }
  }

  const Plane& plane_;
  const PhaseRegions& regions_;
  const ModeColours colours_;
  const Frame frame_;
};

}  // namespace

Element add_phase_svg(const Element& parent, const PhaseDiagram& diagram, const PhaseRegions& regions,
                      const PhaseSvgOptions& options) {
  const Picture picture(diagram, regions, options);
  const Element svg = parent.add("svg").set("xmlns", "http://www.w3.org/2000/svg");
  svg.set("viewBox", fmt::format("0 0 {} {}", short_number(options.width), short_number(options.height)));
  picture.add_definitions(svg);
  const Element plot = picture.add_plot(svg);
  picture.add_regions(plot);
  picture.add_refuted(plot);
  picture.add_lines(plot);
  if (options.labels) picture.add_region_names(plot);
  picture.add_curve_names(plot);
  picture.add_line_names(plot);
  picture.add_axes(svg);
  picture.add_mark(svg);
  return svg;
}

Element add_swatch(const Element& parent, const PhaseDiagram& diagram, const PhaseRegions& regions, std::size_t index) {
  const Element svg = parent.add("svg", "swatch").set("viewBox", "0 0 28 18").set("aria-hidden", "true");
  Picture(diagram, regions, {}).paint_swatch(svg.add("rect"), index);
  return svg;
}

namespace {

std::string whole_note(const PhaseDiagram& diagram, const PhaseRegions& regions) {
  const std::string& note = diagram.plane.note;
  if (!regions.leaves_domain) return note;
  return note + (note.empty() ? "" : " ") + "White is out of the domain.";
}

}  // namespace

std::string phase_svg_file(const PhaseDiagram& diagram, const PhaseSvgOptions& options) {
  const PhaseRegions regions = phase_regions(diagram);
  const double title = 34, legend = 16 + 24 * static_cast<double>(regions.sets.size());
  const std::string note = whole_note(diagram, regions);
  const double height = title + options.height + legend + (note.empty() ? 0 : 20);
  const Document document("svg");
  const Element svg = document.root().set("xmlns", "http://www.w3.org/2000/svg");
  svg.set("width", options.width).set("height", height).set("role", "img");
  svg.set("viewBox", fmt::format("0 0 {} {}", short_number(options.width), short_number(height)));
  svg.set("font-family", "system-ui, 'DejaVu Sans', sans-serif").set("font-size", 12);
  svg.add("title").text(diagram.plane.title);
  svg.add("style").code(picture_style());
  svg.add("rect", "paper").set("width", options.width).set("height", height);
  svg.add("text", "ink").set("x", 60).set("y", 23).set("font-size", 16).text(diagram.plane.title);
  add_phase_svg(svg.add("g").set("transform", "translate(0 " + short_number(title) + ")"), diagram, regions, options)
      .set("width", options.width)
      .set("height", options.height);
  for (std::size_t i = 0; i < regions.sets.size(); ++i) {
    const double y = title + options.height + 24 * static_cast<double>(i);
    const Element entry = svg.add("g").set("transform", "translate(60 " + short_number(y) + ")");
    Picture(diagram, regions, options).paint_swatch(entry.add("rect"), i);
    std::string words = name(regions.sets[i]);
    const auto& motions = regions.sets[i].motions;
    std::string more;
    if (motions.size() == 1) more = ": " + diagram.plane.words(motions[0].front());
    if (motions.size() > 1) more = ": ambiguous, " + std::to_string(motions.size()) + " motions";
    const auto room = static_cast<std::size_t>((options.width - 98) / 6.2);
    if (words.size() > room) words = words.substr(0, room - 4) + "…";
    if (words.size() + more.size() <= room) words += more;
    entry.add("text", "ink").set("x", 38).set("y", 13).text(words);
  }
  if (!note.empty()) svg.add("text", "soft").set("x", 60).set("y", height - 16).text(note);
  return document.xml();
}

}  // namespace slipproof
