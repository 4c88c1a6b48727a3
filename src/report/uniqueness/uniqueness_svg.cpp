#include "report/uniqueness/uniqueness_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "claims/uniqueness/ranges.hpp"
#include "mechanics/planes/mechanism_plane.hpp"
#include "report/phase/axis.hpp"
#include "report/picture/palette.hpp"
#include "report/picture/polyline.hpp"

namespace slipproof {

namespace {

enum class LoadKind : std::uint8_t { one, several, continuum, none };

struct KindOfLoads {
  std::string_view fill, words;
};
/// By LoadKind.
constexpr std::array<KindOfLoads, 4> kinds_of_loads{
    {{"m0", "one motion"}, {"m9", "several motions"}, {"m11", "infinitely many motions"}, {"m15", "no motion"}}};

LoadKind kind_of(const LoadCell& cell) {
  if (!cell.continua.empty()) return LoadKind::continuum;
  if (cell.motions.empty()) return LoadKind::none;
  return cell.motions.size() == 1 ? LoadKind::one : LoadKind::several;
}

/// An open interval of loads of one kind.
struct KindBand {
  LoadKind kind;
  std::optional<Rational> lower, upper;
};

std::vector<KindBand> kind_bands(const PhaseColumn& column) {
  std::vector<KindBand> result;
  for (const LoadCell* cell : open_cells(column)) {
    const LoadKind kind = kind_of(*cell);
    if (!result.empty() && result.back().kind == kind) {
      result.back().upper = cell->loads.upper();
    } else {
      result.push_back({kind, cell->loads.lower(), cell->loads.upper()});
    }
  }
  return result;
}

/// The range of loads without one motion, which is drawn in the middle; nothing if all loads have one motion.
std::optional<std::pair<Rational, Rational>> loads_apart(const PhaseDiagram& diagram) {
  std::optional<std::pair<Rational, Rational>> range;
  const auto reach = [&](const std::optional<Rational>& load) {
    if (!load) return;
    range = range ? std::pair(std::min(range->first, *load), std::max(range->second, *load)) : std::pair(*load, *load);
  };
  for (const PhaseColumn& column : diagram.columns) {
    for (const KindBand& band : kind_bands(column)) {
      if (band.kind != LoadKind::one) reach(band.lower), reach(band.upper);
    }
  }
  return range;
}

class UniquenessPicture {
 public:
  UniquenessPicture(const PhaseDiagram& diagram, const UniquenessAlong& along)
      : diagram_(diagram), along_(along), frame_{70, 44, 672, 360, diagram.plane.x, diagram.plane.y} {}

  std::string file() const {
    const ElementTree document("svg");
    const Element svg = document.root().set("xmlns", "http://www.w3.org/2000/svg");
    svg.set("width", width).set("height", height).set("role", "img");
    svg.set("viewBox", fmt::format("0 0 {} {}", width, height));
    svg.set("font-family", "system-ui, 'DejaVu Sans', sans-serif").set("font-size", 12);
    svg.add("title").text(diagram_.plane.title);
    svg.add("style").code(picture_style());
    svg.add("rect", "paper").set("width", width).set("height", height);
    svg.add("text", "ink").set("x", frame_.left).set("y", 23).set("font-size", 16).text(diagram_.plane.title);
    const Element clip = svg.add("defs").add("clipPath").set("id", "plot").add("rect");
    clip.set("x", frame_.left).set("y", frame_.top).set("width", frame_.width).set("height", frame_.height);
    const Element plot = svg.add("g").set("clip-path", "url(#plot)");
    add_bands(plot);
    add_values(plot);
    frame_.draw(svg);
    add_every_q(svg);
    add_legend(svg);
    return document.xml();
  }

 private:
  static constexpr int width = 760, height = 532;

  double x_of(const Rational& x) const { return frame_.x_of(nearest_binary64(x)); }
  /// An infinite end is placed outside the frame, which clips it.
  double y_of(const std::optional<Rational>& y, bool upper) const {
    if (y) return std::clamp(frame_.y_of(nearest_binary64(*y)), -1e4, 1e4);
    return upper ? frame_.top - 4 : frame_.top + frame_.height + 4;
  }

  /// Joins neighbouring columns with the same kinds in the same order; they are so close that this cannot be seen.
  void add_bands(const Element& plot) const {
    std::array<std::string, kinds_of_loads.size()> paths;
    for (std::size_t i = 0; i < diagram_.columns.size();) {
      const auto first = kind_bands(diagram_.columns[i]);
      std::vector<std::vector<Pixel>> upper(first.size()), lower(first.size());
      std::size_t k = i;
      for (; k < diagram_.columns.size() && (k == i || !diagram_.columns[k].after_gap); ++k) {
        const auto bands = kind_bands(diagram_.columns[k]);
        const auto alike = [](const KindBand& a, const KindBand& b) { return a.kind == b.kind; };
        if (!std::equal(bands.begin(), bands.end(), first.begin(), first.end(), alike)) break;
        for (std::size_t b = 0; b < bands.size(); ++b) {
          upper[b].push_back({x_of(diagram_.columns[k].x), y_of(bands[b].upper, true)});
          lower[b].push_back({x_of(diagram_.columns[k].x), y_of(bands[b].lower, false)});
        }
      }
      for (std::size_t b = 0; b < first.size(); ++b) {
        upper[b].insert(upper[b].end(), lower[b].rbegin(), lower[b].rend());
        paths[static_cast<std::size_t>(first[b].kind)] += closed_path_of(upper[b]);
      }
      i = k;
    }
    for (std::size_t kind = 0; kind < paths.size(); ++kind) {
      if (paths[kind].empty()) continue;
      const Element path = plot.add("path", kinds_of_loads[kind].fill).set("d", paths[kind]);
      path.add("title").text(std::string(kinds_of_loads[kind].words));
      // A window thinner than a pixel is visible by its edge.
      if (kind != 0) plot.add("path", "edge").set("d", paths[kind]);
    }
  }

  /// Draws the scene's own value, the critical value, and single values with infinitely many motions.
  void add_values(const Element& plot) const {
    for (const ParameterCell& cell : along_.cells) {
      if (!cell.is_point() || !cell.sample || !cell.motions) continue;
      for (const LoadsApart& apart : cell.motions->apart) {
        if (apart.continuum) add_continuum(plot, x_of(*cell.sample), apart.loads);
      }
    }
    if (const auto critical = along_.first_apart()) {
      const bool short_enough = critical->is_rational() && exact_text(critical->lower).size() < 9;
      const std::string value =
          short_enough ? " = " + exact_text(critical->lower) : " ≈ " + decimal_text(critical->lower, 4);
      add_value(plot, critical->lower, along_.parameter + value, "new", 16);
    }
    add_value(plot, along_.own, "the scene", "line", 34);
  }

  void add_continuum(const Element& plot, double x, const ForceInterval& loads) const {
    const double top = y_of(loads.upper(), true), bottom = y_of(loads.lower(), false);
    plot.add("path", "new").set("d", fmt::format("M{:.2f},{:.2f}V{:.2f}", x, bottom, top));
    for (const double y : {top, bottom}) plot.add("circle", "ink").set("cx", x).set("cy", y).set("r", 3.5);
  }

  void add_value(const Element& plot, const Rational& value, const std::string& words, std::string_view line,
                 double down) const {
    const double x = x_of(value);
    plot.add("path", line).set("d", fmt::format("M{:.2f},{:.2f}v{:.2f}", x, frame_.top, frame_.height));
    const bool on_left = x > frame_.left + frame_.width - 130;
    const Element text = plot.add("text", "ink halo").set("x", x + (on_left ? -6 : 6)).set("y", frame_.top + down);
    text.set("text-anchor", on_left ? "end" : "start").text(words);
  }

  /// Draws a bar below the axis over the values that have one motion whatever else pushes.
  void add_every_q(const Element& svg) const {
    for (const ParameterRange& range : ranges(along_)) {
      if (!unique_for_every_q(range.motions)) continue;
      const auto at = [&](const std::optional<RealRoot>& end, double otherwise) {
        return std::clamp(end ? x_of(end->lower) : otherwise, frame_.left, frame_.left + frame_.width);
      };
      const double from = at(range.lower, frame_.left), to = at(range.upper, frame_.left + frame_.width);
      const Element bar = svg.add("rect", "highlight").set("x", from).set("y", frame_.top + frame_.height);
      bar.set("width", to - from).set("height", 5);
    }
  }

  static bool unique_for_every_q(const MotionsAtParameter& motions) {
    return motions.for_every_q && motions.for_every_q->verdict == EveryLoad::Verdict::unique;
  }

  void add_legend(const Element& svg) const {
    double x = frame_.left;
    const auto entry = [&](std::string_view css_class, const std::string& words, double thick) {
      svg.add("rect", css_class).set("x", x).set("y", 462 + (14 - thick) / 2).set("width", 24).set("height", thick);
      svg.add("text", "ink").set("x", x + 30).set("y", 474).text(words);
      x += 46 + 7.2 * static_cast<double>(words.size());
    };
    std::array<bool, kinds_of_loads.size()> seen{};
    for (const PhaseColumn& column : diagram_.columns) {
      for (const KindBand& band : kind_bands(column)) seen[static_cast<std::size_t>(band.kind)] = true;
    }
    for (std::size_t kind = 0; kind < seen.size(); ++kind) {
      if (seen[kind]) entry(kinds_of_loads[kind].fill, std::string(kinds_of_loads[kind].words), 14);
    }
    const auto all = ranges(along_);
    if (std::ranges::any_of(all, [](const ParameterRange& range) { return unique_for_every_q(range.motions); })) {
      entry("highlight", "one, whatever else pushes", 5);
    }
    const std::string dots = any_continuum() ? "Dots: infinitely many motions. " : "";
    const Element note = svg.add("text", "soft").set("x", frame_.left).set("y", 506);
    note.text(dots + "Exact in each column, joined up between them.");
  }

  bool any_continuum() const {
    return std::ranges::any_of(along_.cells, [](const ParameterCell& cell) {
      return cell.is_point() && cell.motions &&
             std::ranges::any_of(cell.motions->apart, [](const LoadsApart& apart) { return apart.continuum; });
    });
  }

  const PhaseDiagram& diagram_;
  const UniquenessAlong& along_;
  const Frame frame_;
};

}  // namespace

PhaseDiagram uniqueness_diagram(const MechanismScene& scene, const UniquenessAlong& along, std::size_t columns) {
  MechanismAxes axes;
  axes.x = along.parameter;
  const auto critical = along.first_apart();
  if (along.parameter == usual_parameter(scene)) {
    axes.x_from = 0;
    axes.x_to = (critical ? std::max(along.own, critical->upper) : along.own) * Rational(3, 2);
  }
  Plane plane = mechanism_plane(scene, axes, "critical");
  plane.title = scene.name + ": loads with one motion and with several";
  PhaseDiagram diagram = phase_diagram(std::move(plane), columns);
  if (const auto range = loads_apart(diagram)) {
    const Rational reach = range->first < range->second ? Rational((range->second - range->first) / 4) : Rational(1);
    diagram.plane.y.from = range->first - reach;
    diagram.plane.y.to = range->second + reach;
  }
  return diagram;
}

std::string uniqueness_svg(const PhaseDiagram& diagram, const UniquenessAlong& along) {
  return UniquenessPicture(diagram, along).file();
}

}  // namespace slipproof
