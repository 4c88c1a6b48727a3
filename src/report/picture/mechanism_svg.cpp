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
#include "base/number/binary64.hpp"
#include "base/output/listed.hpp"
#include "report/picture/arrows/mechanism_arrows.hpp"
#include "report/picture/drawing.hpp"
#include "report/picture/labels/contact_table.hpp"
#include "report/picture/labels/picture_labels.hpp"
#include "report/picture/measures.hpp"
#include "report/picture/mechanism_geometry.hpp"
#include "report/picture/motion_words.hpp"
#include "report/picture/polyline.hpp"
#include "report/picture/velocities/body_movements.hpp"
#include "report/picture/velocities/motion_ahead.hpp"
#include "report/picture/velocities/moving_outlines.hpp"

namespace slipproof {

namespace {

using ShapeKind = MechanismShape::Kind;
constexpr double drawn_width = 270, drawn_height = 220, longest_force = 72, surface = 30, opening = 14;

class MechanismDrawing {
 public:
  MechanismDrawing(const Element& svg, const MechanismScene& scene, const MotionAtLoad* motion, const CommonLook& look)
      : svg_(svg),
        scene_(scene),
        motion_(motion),
        look_(look),
        numbers_(look.numbers ? *look.numbers : NumberWords(shown_numbers(scene, motion))),
        geometry_(geometry_of(scene, motion == nullptr)),
        frame_(svg, look.share) {
    fit();
    if (motion != nullptr && (look.movable || look.animated))
      movements_ = body_movements(scene, *motion, geometry_.turned);
    const auto has_body = [](const auto& outline) { return outline.bodies.has_value(); };
    movable_ = look.movable && !movements_.empty() && std::ranges::all_of(geometry_.outlines, has_body);
  }

  void draw() {
    for (const MechanismGeometry::Contact& contact : geometry_.contacts) this->contact(contact);
    for (const MechanismGeometry::Outline& outline : geometry_.outlines) this->outline(outline);
    if (look_.animated && !movements_.empty()) go_ahead();
    const double apart = lettered() ? 0.8 * closest() : longest_force;
    MechanismArrows arrows(svg_,
                           {scene_, motion_, geometry_, numbers_, view_, std::clamp(apart, 12.0, longest_force),
                            look_.largest_force, !lettered(), look_.is_virtual},
                           labels_);
    arrows.draw();
    for (const Point& end : arrows.ends()) see(end);
    described_ = arrows.described();
    for (std::size_t i = 0; i < geometry_.contacts.size(); ++i) {
      const MechanismGeometry::Contact& contact = geometry_.contacts[i];
      labels_.words({view_.pixel(contact.at)},
                    lettered() ? contact_letter(i) : contact_text(scene_, motion_, contact.index));
      if (lifts(contact)) opened(contact);
    }
    for (const LabelBox& box : labels_.draw(svg_)) see(box);
    if (lettered()) table();
  }

  void heading(const std::string& name, const std::string& below) { frame_.heading(name, below); }
  void caption() {
    if (look_.brief) return;
    std::vector<std::string> pieces = told();
    for (std::string& note : notes()) pieces.push_back(std::move(note));
    frame_.caption(pieces);
  }

  std::string description() const {
    std::vector<std::string> parts = described_;
    for (const std::string& part : told()) parts.push_back(part);
    if (geometry_.turned != 0) {
      parts.push_back(fmt::format("turned by {:.3g} degrees, so that gravity points down",
                                  geometry_.turned * 180 / std::numbers::pi));
    }
    return fmt::format("{}.", fmt::join(parts, "; "));
  }
  LabelBox box() const { return frame_.box(); }

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
      for (const Point& p : outline.points) add(p, std::abs(outline.radius));
    }
    for (const MechanismGeometry::Contact& contact : geometry_.contacts) add(contact.at, 0);
    const double across = all->right - all->left, up = all->bottom - all->top;
    view_.middle = {(all->left + all->right) / 2, (all->top + all->bottom) / 2};
    if (across > 0 || up > 0) {
      const bool large = lettered() || measured();
      const double width = large ? lettered_width : look_.share * drawn_width;
      const double height = large ? lettered_height : look_.share * drawn_height;
      view_.scale = std::min(across > 0 ? width / across : height / up, up > 0 ? height / up : width / across);
    }
    const Point corner = view_.pixel({all->left, all->bottom}), other = view_.pixel({all->right, all->top});
    frame_.begin({corner[0], corner[1], other[0], other[1]});
    labels_.keep_between(-PictureFrame::widest / 2, PictureFrame::widest / 2);
  }

  bool measured() const {
    return std::ranges::any_of(geometry_.outlines, [](const auto& one) { return one.kind == ShapeKind::measure; });
  }
  bool lettered() const { return geometry_.contacts.size() >= fewest_lettered; }
  /// The least distance of two contacts, in pixels.
  double closest() const { return std::min(longest_force, view_.scale * least_distance(geometry_, 4 / view_.scale)); }
  bool lifts(const MechanismGeometry::Contact& contact) const {
    return motion_ != nullptr && common_state(*motion_, contact.index) == name(ElementState::lift);
  }
  void see(const LabelBox& box) { frame_.see(box); }
  void see(Point p) { frame_.see(p); }

  Element line(Point from, Point to, std::string_view css, double weight) {
    labels_.avoid(from, to, weight);
    see(from), see(to);
    return svg_.add("line", css).set("x1", from[0]).set("y1", from[1]).set("x2", to[0]).set("y2", to[1]);
  }

  /// Draws the contact, and the surface that the body touches as a line perpendicular to N; in a motion that opens the
  /// contact it is apart from the body.
  void contact(const MechanismGeometry::Contact& contact) {
    const Point at = view_.pixel(contact.at), across{contact.normal[1], -contact.normal[0]};
    const Point below = moved(at, contact.normal, lifts(contact) ? -opening : 0);
    const double reach = lettered() ? std::min(surface, 0.45 * closest()) : surface;
    if (has_direction(contact)) {
      const Element drawn = line(moved(below, across, -reach), moved(below, across, reach), "frame", 1.5);
      if (lifts(contact) && movable_)
        drawn.set("data-opens", fmt::format("{:.2f} {:.2f}", below[0] - at[0], below[1] - at[1]));
    }
    svg_.add("circle", lifts(contact) ? "paper frame" : "ink").set("cx", at[0]).set("cy", at[1]).set("r", 3);
    labels_.avoid(LabelBox{at[0] - 4, at[1] - 4, at[0] + 4, at[1] + 4});
  }

  /// The acceleration with which a contact opens.
  void opened(const MechanismGeometry::Contact& contact) {
    const std::string& name = scene_.mechanism.contacts[contact.index].gap_name;
    const std::string value = numbers_.value(motion_->accelerations[gap_index(scene_.mechanism, contact.index)]);
    described_.push_back(name + " " + value);
    if (!lettered()) labels_.symbol({view_.pixel(contact.at)}, name, value);
  }

  void outline(const MechanismGeometry::Outline& outline) {
    const std::string_view css = outline.thin ? "chain" : "body";
    std::vector<Pixel> pixels;
    for (const Point& p : outline.points) pixels.push_back({view_.pixel(p)[0], view_.pixel(p)[1]});
    switch (outline.kind) {
      case ShapeKind::polygon:
        moving(outline, svg_.add("path", css).set("d", closed_path_of(pixels)));
        pixels.push_back(pixels.front());
        break;
      case ShapeKind::line:
        moving(outline, svg_.add("path", css).set("d", path_of(pixels)));
        break;
      case ShapeKind::circle:
        moving(outline, svg_.add("circle", css)
                            .set("cx", pixels[0].x)
                            .set("cy", pixels[0].y)
                            .set("r", view_.scale * outline.radius));
        pixels = round(pixels[0], view_.scale * outline.radius);
        break;
      case ShapeKind::point:
        moving(outline, svg_.add("circle", "ink").set("cx", pixels[0].x).set("cy", pixels[0].y).set("r", 2.5));
        break;
      case ShapeKind::measure: {
        std::vector<Point> places;
        for (const Point& p : outline.points) places.push_back(view_.pixel(p));
        return add_measure(svg_, places, outline.text, labels_);
      }
      case ShapeKind::turn:
        return add_named_turn(svg_, view_.pixel(outline.points[0]), view_.scale * outline.radius, outline.text,
                              labels_);
      case ShapeKind::arrow:
      case ShapeKind::label:
        return;  // drawn later
    }
    for (std::size_t i = 1; i < pixels.size(); ++i) {
      labels_.avoid({pixels[i - 1].x, pixels[i - 1].y}, {pixels[i].x, pixels[i].y}, 2.5);
    }
  }
  /// Says of a part how its body moves.
  void moving(const MechanismGeometry::Outline& outline, const Element& part) const {
    if (!movable_) return;
    const auto rate = [&](Point along, double turn) {
      return fmt::format("{:.6g} {:.6g} {:.6g}", view_.scale * along[0], -view_.scale * along[1], -turn);
    };
    std::vector<std::string> about, velocity, acceleration;
    for (std::size_t i = 0; i == 0 || (i == 1 && outline.bodies->front() != outline.bodies->back()); ++i) {
      const BodyMovement& body = movements_[(*outline.bodies)[i]];
      about.push_back(fmt::format("{:.2f}", fmt::join(view_.pixel(body.at), " ")));
      velocity.push_back(rate(body.velocity, body.spin));
      acceleration.push_back(rate(body.acceleration, body.turning));
    }
    part.set("data-about", listed(about, " "))
        .set("data-velocity", listed(velocity, " "))
        .set("data-acceleration", listed(acceleration, " "));
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

  /// What moves farther than the picture is wide leaves it.
  void go_ahead() {
    constexpr double farthest = 150;
    const auto frames = outlines_ahead(geometry_.outlines, movements_);
    add_moving_outlines(svg_, frames, seconds_ahead, view_.scale, [this](Point p) { return view_.pixel(p); });
    const LabelBox now = frame_.drawn();
    for (const MechanismGeometry::Outline& outline : frames.back()) {
      for (const Point& point : outline.points) {
        const Point p = view_.pixel(point);
        const double r = outline.kind == ShapeKind::circle ? view_.scale * outline.radius : 0;
        see(LabelBox{std::max(p[0] - r, now.left - farthest), std::max(p[1] - r, now.top - farthest),
                     std::min(p[0] + r, now.right + farthest), std::min(p[1] + r, now.bottom + farthest)});
      }
    }
  }

  void table() {
    std::vector<std::size_t> contacts;
    for (const MechanismGeometry::Contact& contact : geometry_.contacts) contacts.push_back(contact.index);
    see(add_contact_table(svg_, scene_, motion_, contacts, numbers_, {frame_.drawn().left, frame_.drawn().bottom + 6}));
  }

  std::vector<std::string> told() const {
    std::vector<bool> drawn(scene_.mechanism.contacts.size());
    for (const MechanismGeometry::Contact& c : geometry_.contacts) {
      drawn[c.index] = drawn[c.index] || lettered() || has_direction(c);
    }
    return told_of(scene_, motion_, drawn, numbers_);
  }
  /// What the reader should know of the arrows.
  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    if (lettered()) notes = weight_words(geometry_, numbers_);
    if (geometry_.movements.size() > most_named)
      std::ranges::copy(movement_words(geometry_), std::back_inserter(notes));
    if (look_.animated) {
      notes.emplace_back("moving, in green: half a second of these accelerations");
      notes.emplace_back("as if they stayed so; no simulation");
    }
    if (motion_ == nullptr) notes.emplace_back("arrows show positive directions, not to scale");
    const bool forces = std::ranges::any_of(scene_.mechanism.shapes, [](const auto& one) { return bool(one.force); });
    if (motion_ != nullptr && !scene_.mechanism.bodies && !forces)
      notes.emplace_back("the file has no weights to draw");
    const bool slides = std::ranges::any_of(scene_.values.starts, [](ElementKind::Start start) {
      return start == ElementKind::Start::slides_forward || start == ElementKind::Start::slides_backward;
    });
    if (look_.is_virtual)
      notes.emplace_back("green: the virtual motion");
    else if (slides || !geometry_.movements.empty())
      notes.emplace_back("green: how it moves before");
    return notes;
  }
  static bool has_direction(const MechanismGeometry::Contact& contact) {
    return contact.normal[0] != 0 || contact.normal[1] != 0;
  }

  const Element svg_;
  const MechanismScene& scene_;
  const MotionAtLoad* motion_;
  const CommonLook& look_;
  const NumberWords numbers_;
  const MechanismGeometry geometry_;
  std::vector<BodyMovement> movements_;  ///< of bodies, in a picture that moves
  bool movable_ = false;                 ///< each part says how it moves
  PictureView view_;
  PictureFrame frame_;
  PictureLabels labels_;
  std::vector<std::string> described_;
};

void expect_picture(const MechanismScene& scene) {
  if (has_picture(scene.mechanism)) return;
  throw InputError({{scene.mechanism.file, 0, 0,
                     "the mechanism " + scene.mechanism.name +
                         " has no picture, expected a [[shape]], or a contact that says where it is with `at`"}});
}

}  // namespace

bool has_picture(const Mechanism& mechanism) {
  return !mechanism.shapes.empty() || std::any_of(mechanism.contacts.begin(), mechanism.contacts.end(),
                                                  [](const MechanismContact& contact) { return !contact.at.empty(); });
}

double picture_height(const MechanismScene& scene, double usual) {
  const auto& contacts = scene.mechanism.contacts;
  const auto drawn = static_cast<std::size_t>(
      std::ranges::count_if(contacts, [](const MechanismContact& contact) { return !contact.at.empty(); }));
  if (drawn < fewest_lettered) return usual;
  return usual + lettered_height - drawn_height + contact_table_height(drawn);
}

double largest_force(const MechanismScene& scene, const MotionAtLoad& motion) {
  return largest_arrow(scene, motion, geometry_of(scene, false));
}

Element add_mechanism(const Element& parent, const MechanismScene& scene, const MotionAtLoad* motion,
                      std::string_view title, const CommonLook& look, LabelBox* seen) {
  expect_picture(scene);
  const Element svg = parent.add("svg", "mechanism").set("xmlns", "http://www.w3.org/2000/svg").set("role", "img");
  svg.add("title").text(title);
  const Element description = svg.add("desc");
  MechanismDrawing drawing(svg, scene, motion, look);
  drawing.draw();
  drawing.caption();
  description.text(drawing.description());
  svg.set("viewBox", view_box(drawing.box()));
  if (seen != nullptr) *seen = drawing.box();
  return svg;
}

std::string mechanism_svg_file(const MechanismScene& scene, const MotionAtLoad* motion, const CommonLook& look,
                               const std::string& heading) {
  expect_picture(scene);
  const std::string modes = !heading.empty() ? heading : motion == nullptr ? std::string() : modes_text(*motion);
  return picture_file(scene.name + (modes.empty() ? "" : ": " + modes), 1.6, [&](const Element& svg) {
    MechanismDrawing drawing(svg, scene, motion, look);
    drawing.draw();
    drawing.caption();
    drawing.heading(scene.name, modes);
    return DrawnPicture{drawing.description(), drawing.box()};
  });
}

}  // namespace slipproof
