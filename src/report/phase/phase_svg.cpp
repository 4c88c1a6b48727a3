#include "report/phase/phase_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/number/binary64.hpp"
#include "report/markup/number.hpp"
#include "report/markup/symbol.hpp"
#include "report/phase/axis.hpp"
#include "report/phase/phase_names.hpp"
#include "report/picture/palette.hpp"
#include "report/picture/polyline.hpp"

namespace slipproof {

namespace {

/// Width needed for the numbers of the vertical axis and its name.
double left_of(const Plane& plane) {
  std::size_t longest = 0;
  for (const Rational& y : {plane.y.from, plane.y.to}) {
    longest = std::max(longest, fmt::format("{:.0f}", nearest_binary64(y)).size());
  }
  return std::max(60.0, 7.0 * static_cast<double>(longest) + 28);
}

std::vector<MechanismMode> drawn_modes(const PhaseRegions& regions) {
  std::vector<MechanismMode> modes;
  for (const MotionSet& set : regions.sets) {
    for (const auto& motion : set.motions) modes.push_back(motion.front());
    modes.insert(modes.end(), set.continua.begin(), set.continua.end());
  }
  return modes;
}

Frame frame_of(const Plane& plane, const PhaseSvgOptions& options) {
  const double left = left_of(plane);
  return {left, 14, options.width - left - 18, options.height - 14 - 46, plane.x, plane.y};
}

class Picture {
 public:
  Picture(const PhaseDiagram& diagram, const PhaseRegions& regions, const PhaseSvgOptions& options)
      : plane_(diagram.plane),
        raster_(diagram.raster),
        regions_(regions),
        colours_(drawn_modes(regions)),
        frame_(frame_of(diagram.plane, options)) {}

  /// Patterns for sets that one colour cannot show, and the clip path of the plot.
  void add_definitions(const Element& svg) const {
    const Element defs = svg.add("defs");
    const Element clip = defs.add("clipPath").set("id", plane_.id + "-clip").add("rect");
    place(clip);
    for (std::size_t i = 0; i < regions_.sets.size(); ++i) {
      const MotionSet& set = regions_.sets[i];
      if (is_plain(set)) continue;
      const Element pattern = defs.add("pattern").set("id", pattern_id(i)).set("patternUnits", "userSpaceOnUse");
      const std::size_t stripes = set.motions.size() + set.continua.size();
      const double size = opens(set) || stripes == 0 ? 9 : 7.0 * static_cast<double>(stripes);
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
      if (!set.complete) pattern.add("path", "hatching").set("d", fmt::format("M0,{0}L{0},0", short_number(size)));
    }
  }

  void add_regions(const Element& plot) const {
    for (std::size_t i = 0; i < regions_.sets.size(); ++i) {
      std::string d;
      for (const Strip& strip : regions_.strips) {
        if (strip.set == regions_.sets[i] && strip.lower.size() > 1) d += area(strip.lower, strip.upper);
      }
      if (d.empty()) continue;
      const Element path = plot.add("path").set("d", d);
      paint(path, i);
      path.add("title").text(name(regions_.sets[i]));
    }
  }

  /// Draws each column of a thin set as a bar that is wide and high enough to see.
  void add_thin(const Element& plot, const std::vector<ThinRegion>& thin) const {
    for (const ThinRegion& region : thin) {
      std::string d;
      for (const Strip& strip : regions_.strips) {
        if (strip.set == regions_.sets[region.set]) d += widened(strip);
      }
      const Element path = plot.add("path", "thin").set("d", d);
      paint(path, region.set);
      path.add("title").text(name(regions_.sets[region.set]) + ", drawn wider than it is");
    }
  }

  /// What is known of a raster: its places.
  void add_places(const Element& svg) const {
    if (!raster_) return;
    for (const auto& place : raster_->places) {
      if (!place.set) continue;
      const double x = frame_.x_of(nearest_binary64(place.x)), y = frame_.y_of(nearest_binary64(place.y));
      svg.add("circle", "ink place").set("cx", x).set("cy", y).set("r", 1.2);
    }
  }

  void add_rings(const Element& svg, const std::vector<ThinRegion>& thin) const {
    for (std::size_t k = 0; k < thin.size(); ++k) {
      const double x = frame_.x_of(thin[k].at.x), y = frame_.y_of(thin[k].at.y);
      svg.add("circle", "new ring").set("cx", x).set("cy", y).set("r", 9);
      const bool at_right = x > frame_.left + frame_.width - 30;
      const Element number = svg.add("text", "ink halo").set("x", x + (at_right ? -12 : 12)).set("y", y - 8);
      number.set("text-anchor", at_right ? "end" : "start").text(std::to_string(k + 1));
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

  void add_names(const Element& plot, bool of_regions) const {
    if (of_regions) add_region_names(plot, regions_, frame_);
    add_curve_names(plot, plane_, regions_, frame_);
    add_line_names(plot, plane_, frame_);
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

  /// The same for a small sample in a legend; a sample as white as the paper gets an outline.
  void paint_swatch(const Element& rect, std::size_t index) const {
    rect.set("width", 28).set("height", 18).set("rx", 3);
    paint(rect, index);
    if (is_empty(regions_.sets[index])) rect.set("class", plane_.finds_domain ? "outline" : "paper outline");
  }

 private:
  static bool is_empty(const MotionSet& set) { return set.complete && set.continua.empty() && set.motions.empty(); }
  bool is_plain(const MotionSet& set) const {
    if (is_empty(set)) return !plane_.finds_domain;
    return set.complete && set.continua.empty() && set.motions.size() <= 1 && !opens(set);
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

  /// The part of a strip inside the frame, widened across its direction and at its ends.
  std::string widened(const Strip& strip) const {
    const auto lower = frame_.to_picture(strip.lower), upper = frame_.to_picture(strip.upper);
    const double top = frame_.top, bottom = top + frame_.height;
    std::string path;
    std::vector<Pixel> middle;
    std::vector<double> heights;
    for (std::size_t i = 0; i < lower.size(); ++i) {
      const double high = std::max(upper[i].y, top), low = std::min(lower[i].y, bottom);
      if (low > high) {
        middle.push_back({lower[i].x, (low + high) / 2});
        heights.push_back(low - high);
      }
      if (middle.empty() || (low > high && i + 1 < lower.size())) continue;
      path += band(middle, heights);
      middle.clear(), heights.clear();
    }
    return path;
  }

  std::string band(const std::vector<Pixel>& middle, const std::vector<double>& heights) const {
    constexpr double half = least_seen / 2;
    if (middle.size() == 1) {
      const double x = std::clamp(middle[0].x - half, frame_.left, frame_.left + frame_.width - 2 * half);
      const double reach = std::max(heights[0] / 2, half), y = middle[0].y;
      return closed_path_of({{x, y - reach}, {x + 2 * half, y - reach}, {x + 2 * half, y + reach}, {x, y + reach}});
    }
    return closed_path_of(band_of(middle, heights, least_seen));
  }

  const Plane& plane_;
  const std::optional<PhaseRaster>& raster_;
  const PhaseRegions& regions_;
  const ModeColours colours_;
  const Frame frame_;
};

void draw(const Element& svg, const Picture& picture, const PhaseSvgOptions& options,
          const std::vector<ThinRegion>& thin) {
  svg.set("xmlns", "http://www.w3.org/2000/svg");
  svg.set("viewBox", fmt::format("0 0 {} {}", short_number(options.width), short_number(options.height)));
  picture.add_definitions(svg);
  const Element plot = picture.add_plot(svg);
  picture.add_regions(plot);
  picture.add_refuted(plot);
  picture.add_lines(plot);
  picture.add_thin(plot, thin);
  picture.add_places(plot);
  picture.add_names(plot, options.labels);
  picture.add_axes(svg);
  picture.add_rings(svg, thin);
  picture.add_mark(svg);
}

Picture picture_of(const PhasePicture& picture) {
  return {picture.diagram, picture.regions, picture.options};
}

}  // namespace

PhaseSvgOptions enlargement_options(const PhaseSvgOptions& options) {
  return {.width = std::max(options.width / 2, 330.0), .height = 260, .labels = options.labels};
}

PhasePicture phase_picture(const PhaseDiagram& diagram, const PhaseSvgOptions& options) {
  PhasePicture picture{diagram, options, phase_regions(diagram), {}};
  if (diagram.raster) return picture;
  picture.thin = thin_regions(diagram, picture.regions, frame_of(diagram.plane, options),
                              frame_of(diagram.plane, enlargement_options(options)));
  return picture;
}

Element add_phase_svg(const Element& parent, const PhasePicture& picture) {
  const Element svg = parent.add("svg");
  draw(svg, picture_of(picture), picture.options, picture.thin.regions);
  return svg;
}

Element add_enlargement(const Element& parent, const PhasePicture& picture, std::size_t index) {
  const Enlargement& enlarged = picture.thin.enlargements[index];
  const PhaseSvgOptions options = enlargement_options(picture.options);
  const Element svg = parent.add("svg");
  draw(svg, {enlarged.diagram, enlarged.regions, options}, options, {});
  return svg;
}

Element add_swatch(const Element& parent, const PhasePicture& picture, std::size_t set) {
  const Element svg = parent.add("svg", "swatch").set("viewBox", "0 0 28 18").set("aria-hidden", "true");
  paint_swatch(svg.add("rect"), picture, set);
  return svg;
}

void paint_swatch(const Element& rect, const PhasePicture& picture, std::size_t set) {
  picture_of(picture).paint_swatch(rect, set);
}

}  // namespace slipproof
