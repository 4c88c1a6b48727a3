#include "report/picture/mechanism_svg.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "base/input/utf8.hpp"
#include "base/number/binary64.hpp"
#include "report/markup/number.hpp"
#include "report/picture/drawing.hpp"
#include "report/picture/labels/picture_labels.hpp"
#include "report/picture/mechanism_geometry.hpp"
#include "report/picture/motion_words.hpp"
#include "report/picture/palette.hpp"
#include "report/picture/polyline.hpp"

namespace slipproof {

namespace {

using ShapeKind = MechanismShape::Kind;

constexpr double drawn_width = 270, drawn_height = 220, least_width = 360, widest = 436, longest_force = 72,
                 shortest_force = 12, plain_force = 34, letter_width = 0.62, text_line = 17, free_margin = 10;

class MechanismDrawing {
 public:
  MechanismDrawing(const Element& svg, const MechanismScene& scene, const MotionAtLoad* motion, const CommonLook& look)
      : svg_(svg),
        scene_(scene),
        motion_(motion),
        look_(look),
        numbers_(look.numbers ? *look.numbers : NumberWords(shown_numbers(scene, motion))),
        geometry_(geometry_of(scene)) {
    fit();
  }

  void draw() {
    for (const MechanismGeometry::Contact& contact : geometry_.contacts) surface(contact);
    for (const MechanismGeometry::Outline& outline : geometry_.outlines) this->outline(outline);
    if (motion_ != nullptr) set_force_scale();
    for (const MechanismGeometry::Contact& contact : geometry_.contacts) forces(contact);
    for (const MechanismGeometry::Push& push : geometry_.pushes) pushed(push);
    for (const MechanismGeometry::Outline& outline : geometry_.outlines) {
      if (outline.kind == ShapeKind::arrow) load_arrow(pixel(outline.points[0]), pixel(outline.points[1]));
      if (outline.kind == ShapeKind::label) labels_.words({pixel(outline.points[0])}, outline.text);
    }
    for (const MechanismGeometry::Contact& contact : geometry_.contacts) {
      labels_.words({pixel(contact.at)}, contact_text(scene_, motion_, contact.index));
    }
    for (const LabelBox& box : labels_.draw(svg_)) see(box);
  }

  /// Adds lines of text above or below the drawing.
  void heading(const std::string& name, const std::string& below) {
    const double left = box_.left;
    double y = box_.top - (below.empty() ? 10 : 10 + text_line);
    for (const auto& [words, size, css] : {std::tuple{name, 16.0, "ink"}, std::tuple{below, 13.0, "soft"}}) {
      if (words.empty()) continue;
      svg_.add("text", css).set("x", left).set("y", y).set("font-size", size).text(words);
      see({left, y - size, left + letter_width * size * static_cast<double>(utf8_count(words)), y});
      y += text_line + 1;
    }
  }
  void caption() {
    const double left = box_.left;
    double y = box_.bottom + text_line + 2;
    std::vector<std::string> pieces = told();
    if (look_.brief) pieces.clear();
    for (const std::string& line : caption_lines(pieces, 54)) {
      svg_.add("text", "soft halo").set("x", left).set("y", y).set("font-size", 12).text(line);
      see({left, y - 12, left + letter_width * 12 * static_cast<double>(utf8_count(line)), y + 3});
      y += text_line;
    }
  }

  std::string description() const {
    std::vector<std::string> parts = described_;
    for (const std::string& part : told()) parts.push_back(part);
    return fmt::format("{}.", fmt::join(parts, "; "));
  }
  /// The bounding box of the drawing, with a margin.
  LabelBox box() const {
    const double more = std::max(0.0, least_width - (box_.right - box_.left)) / 2 + free_margin;
    return {box_.left - more, box_.top - free_margin, box_.right + more, box_.bottom + free_margin};
  }

 private:
  /// Chooses the scale so that the drawing fits.
  void fit() {
    std::optional<LabelBox> all;
    const auto add = [&](Point p, double radius) {
      if (!all) all = LabelBox{p[0], p[1], p[0], p[1]};
      *all = {std::min(all->left, p[0] - radius), std::min(all->top, p[1] - radius),
              std::max(all->right, p[0] + radius), std::max(all->bottom, p[1] + radius)};
    };
    for (const MechanismGeometry::Outline& outline : geometry_.outlines) {
      for (const Point& p : outline.points) add(p, outline.radius);
    }
    for (const MechanismGeometry::Contact& contact : geometry_.contacts) add(contact.at, 0);
    const double across = all->right - all->left, up = all->bottom - all->top;
    middle_ = {(all->left + all->right) / 2, (all->top + all->bottom) / 2};
    if (across > 0 || up > 0) {
      scale_ = std::min(across > 0 ? drawn_width / across : drawn_height / up,
                        up > 0 ? drawn_height / up : drawn_width / across);
    }
    const Point corner = pixel({all->left, all->bottom}), other = pixel({all->right, all->top});
    box_ = {corner[0], corner[1], other[0], other[1]};
    labels_.keep_between(-widest / 2, widest / 2);
  }

  Point pixel(Point p) const { return {scale_ * (p[0] - middle_[0]), -scale_ * (p[1] - middle_[1])}; }
  /// Moves a place by this many pixels along a direction given with y up.
  static Point moved(Point from, Point direction, double by) {
    return {from[0] + by * direction[0], from[1] - by * direction[1]};
  }
  void see(const LabelBox& box) {
    box_ = {std::min(box_.left, box.left), std::min(box_.top, box.top), std::max(box_.right, box.right),
            std::max(box_.bottom, box.bottom)};
  }
  void see(Point p) { see({p[0], p[1], p[0], p[1]}); }

  void line(Point from, Point to, std::string_view css, double weight) {
    svg_.add("line", css).set("x1", from[0]).set("y1", from[1]).set("x2", to[0]).set("y2", to[1]);
    labels_.avoid(from, to, weight);
    see(from), see(to);
  }

  /// Draws the surface that the body touches, as a line perpendicular to N, and the contact itself.
  void surface(const MechanismGeometry::Contact& contact) {
    const Point at = pixel(contact.at), across{contact.normal[1], -contact.normal[0]};
    if (across[0] != 0 || across[1] != 0) line(moved(at, across, -30), moved(at, across, 30), "frame", 1.5);
    svg_.add("circle", "ink").set("cx", at[0]).set("cy", at[1]).set("r", 3);
    labels_.avoid(LabelBox{at[0] - 4, at[1] - 4, at[0] + 4, at[1] + 4});
  }

  void outline(const MechanismGeometry::Outline& outline) {
    std::vector<Pixel> pixels;
    for (const Point& p : outline.points) pixels.push_back({pixel(p)[0], pixel(p)[1]});
    switch (outline.kind) {
      case ShapeKind::polygon:
        svg_.add("path", "body").set("d", closed_path_of(pixels));
        pixels.push_back(pixels.front());
        break;
      case ShapeKind::line:
        svg_.add("path", "body").set("d", path_of(pixels));
        break;
      case ShapeKind::circle:
        svg_.add("circle", "body").set("cx", pixels[0].x).set("cy", pixels[0].y).set("r", scale_ * outline.radius);
        pixels = round(pixels[0], scale_ * outline.radius);
        break;
      case ShapeKind::point:
        svg_.add("circle", "ink").set("cx", pixels[0].x).set("cy", pixels[0].y).set("r", 2.5);
        break;
      case ShapeKind::arrow:
      case ShapeKind::label:
        return;  // drawn later
    }
    for (std::size_t i = 1; i < pixels.size(); ++i) {
      labels_.avoid({pixels[i - 1].x, pixels[i - 1].y}, {pixels[i].x, pixels[i].y}, 2.5);
    }
  }
  static std::vector<Pixel> round(Pixel centre, double radius) {
    constexpr int sides = 24;
    std::vector<Pixel> points;
    for (int i = 0; i <= sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    return points;
  }

  const Range& range_of(std::size_t unknown) const { return range_of_force(scene_, *motion_, unknown); }
  std::vector<std::string> told() const {
    std::vector<bool> drawn(scene_.mechanism.contacts.size());
    for (const MechanismGeometry::Contact& c : geometry_.contacts) drawn[c.index] = drawn[c.index] || has_direction(c);
    return told_of(scene_, motion_, drawn, numbers_);
  }
  const std::string& symbol_of(std::size_t unknown) const { return scene_.mechanism.unknowns[unknown].symbol; }
  static bool has_direction(const MechanismGeometry::Contact& contact) {
    return contact.normal[0] != 0 || contact.normal[1] != 0;
  }

  void set_force_scale() {
    const double largest = look_.largest_force > 0 ? look_.largest_force : largest_force(scene_, *motion_);
    if (largest > 0) unit_ = longest_force / largest;
  }

  void forces(const MechanismGeometry::Contact& contact) {
    const MechanismContact& given = scene_.mechanism.contacts[contact.index];
    std::string description = contact_text(scene_, motion_, contact.index);
    const auto draw = [&](std::size_t force, Point direction, bool pushes, std::string_view css) {
      if (motion_ != nullptr) description += ", " + symbol_of(force) + " " + numbers_.range(range_of(force));
      if (has_direction(contact)) this->force(pixel(contact.at), force, direction, pushes, css);
    };
    draw(given.normal, contact.normal, true, "normal");
    if (given.tangent) draw(*given.tangent, contact.along, false, "friction");
    described_.push_back(std::move(description));
  }

  /// Draws an arrow that ends at the contact if it pushes, and begins there otherwise; its name is next to it.
  void force(Point at, std::size_t unknown, Point direction, bool pushes, std::string_view css) {
    double length = plain_force;
    bool determined = true;
    std::string value;
    if (motion_ != nullptr) {
      const Range& range = range_of(unknown);
      const double number = nearest_binary64(shown_value(range).value_or(Rational(0)));
      determined = range.is_point();
      value = numbers_.range(range);
      if (determined && number == 0) return;
      length = number == 0 ? 0 : std::copysign(std::max(std::abs(number) * unit_, shortest_force), number);
    }
    // A pull leaves the contact on the side from which a push would come.
    const double gap = 5;
    const bool pulls = pushes && length < 0;
    const Point start = pushes && !pulls ? moved(at, direction, -length - gap) : moved(at, direction, pulls ? -gap : 0);
    const Point end = moved(start, direction, length);
    add_arrow(svg_, start, end[0] - start[0], end[1] - start[1], css,
              determined ? ArrowLine::solid : ArrowLine::dashed);
    labels_.avoid(start, end, 4);
    arrows_.emplace_back(start, end);
    see(start), see(end);
    const Point half{(start[0] + end[0]) / 2, (start[1] + end[1]) / 2};
    labels_.symbol({pushes ? start : end, half}, symbol_of(unknown), std::move(value));
  }

  /// Draws it beside an arrow of a force on the same line, where one would hide the other. Returns where it begins.
  Point load_arrow(Point from, Point to) {
    const auto hides = [&](const std::pair<Point, Point>& other) { return cover(from, to, other.first, other.second); };
    const double dx = to[0] - from[0], dy = to[1] - from[1], length = std::hypot(dx, dy);
    if (length > 0 && std::any_of(arrows_.begin(), arrows_.end(), hides)) {
      const Point aside{9 * dy / length, -9 * dx / length};
      from = {from[0] + aside[0], from[1] + aside[1]};
    }
    add_arrow(svg_, from, dx, dy, "load");
    labels_.avoid(from, {from[0] + dx, from[1] + dy}, 4);
    return from;
  }

  /// An arrow that ends where the force acts, to scale beside the forces of a motion; of a couple its name and sense.
  void pushed(const MechanismGeometry::Push& push) {
    const Point at = pixel(push.at);
    if (push.along == Point{0, 0}) return labels_.words({at}, push.name + (push.size > 0 ? " \u21ba" : " \u21bb"));
    const double length = motion_ == nullptr ? plain_force : std::max(push.size * unit_, shortest_force);
    const Point start = load_arrow(moved(at, push.along, -length), at);
    see(start);
    labels_.symbol({start, {(start[0] + at[0]) / 2, (start[1] + at[1]) / 2}}, {}, push.name);
    described_.push_back("pushed by " + push.name);
  }

  const Element svg_;
  const MechanismScene& scene_;
  const MotionAtLoad* motion_;
  const CommonLook& look_;
  const NumberWords numbers_;
  const MechanismGeometry geometry_;
  Point middle_{0, 0};
  double scale_ = 1, unit_ = 1;
  LabelBox box_;
  PictureLabels labels_;
  std::vector<std::pair<Point, Point>> arrows_;  ///< of forces at contacts
  std::vector<std::string> described_;
};

void expect_picture(const MechanismScene& scene) {
  if (has_picture(scene.mechanism)) return;
  throw InputError({{scene.mechanism.file, 0, 0,
                     "the mechanism " + scene.mechanism.name +
                         " has no picture, expected a [[shape]], or a contact that says where it is with `at`"}});
}

std::string view_box(const LabelBox& box) {
  return fmt::format("{} {} {} {}", short_number(box.left), short_number(box.top), short_number(box.right - box.left),
                     short_number(box.bottom - box.top));
}

}  // namespace

bool has_picture(const Mechanism& mechanism) {
  return !mechanism.shapes.empty() || std::any_of(mechanism.contacts.begin(), mechanism.contacts.end(),
                                                  [](const MechanismContact& contact) { return !contact.at.empty(); });
}

double largest_force(const MechanismScene& scene, const MotionAtLoad& motion) {
  const MechanismGeometry geometry = geometry_of(scene);
  double largest = 0;
  for (const MechanismGeometry::Contact& contact : geometry.contacts) {
    const MechanismContact& given = scene.mechanism.contacts[contact.index];
    for (const auto& force : {std::optional(given.normal), given.tangent}) {
      if (!force) continue;
      const auto value = shown_value(range_of_force(scene, motion, *force));
      if (value) largest = std::max(largest, std::abs(nearest_binary64(*value)));
    }
  }
  for (const MechanismGeometry::Push& push : geometry.pushes) {
    if (push.along != Point{0, 0}) largest = std::max(largest, push.size);
  }
  return largest;
}

Element add_mechanism(const Element& parent, const MechanismScene& scene, const MotionAtLoad* motion,
                      std::string_view title, const CommonLook& look) {
  expect_picture(scene);
  const Element svg = parent.add("svg", "mechanism").set("xmlns", "http://www.w3.org/2000/svg").set("role", "img");
  svg.add("title").text(title);
  const Element description = svg.add("desc");
  MechanismDrawing drawing(svg, scene, motion, look);
  drawing.draw();
  drawing.caption();
  description.text(drawing.description());
  svg.set("viewBox", view_box(drawing.box()));
  return svg;
}

std::string mechanism_svg_file(const MechanismScene& scene, const MotionAtLoad* motion) {
  expect_picture(scene);
  const ElementTree document("svg");
  const Element svg = document.root().set("xmlns", "http://www.w3.org/2000/svg").set("role", "img");
  const std::string modes = motion == nullptr ? std::string() : modes_text(*motion);
  svg.add("title").text(scene.name + (modes.empty() ? "" : ": " + modes));
  const Element description = svg.add("desc");
  svg.add("style").code(picture_style());
  const Element ground = svg.add("rect", "paper");
  svg.set("font-family", "system-ui, 'DejaVu Sans', sans-serif");
  const CommonLook alone;
  MechanismDrawing drawing(svg, scene, motion, alone);
  drawing.draw();
  drawing.caption();
  drawing.heading(scene.name, modes);
  description.text(drawing.description());
  const LabelBox box = drawing.box();
  ground.set("x", box.left).set("y", box.top).set("width", box.right - box.left).set("height", box.bottom - box.top);
  svg.set("viewBox", view_box(box))
      .set("width", 1.6 * (box.right - box.left))
      .set("height", 1.6 * (box.bottom - box.top));
  return document.xml();
}

}  // namespace slipproof
