// The arrows in the picture of a scene in space: forces of contacts in their cones, slips, pushes, weights, velocities
// and accelerations.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "report/markup/element.hpp"
#include "report/picture/labels/picture_labels.hpp"
#include "report/picture/space/space_geometry.hpp"
#include "report/picture/space/space_legend.hpp"
#include "report/picture/space/space_view.hpp"
#include "report/picture/space/space_words.hpp"

namespace slipproof {

/// The largest of each kind has the longest arrow.
struct SpaceSizes {
  double force = 0, speed = 0, spin = 0, acceleration = 0, turning = 0;

  /// Of a scene, and of each motion.
  void see(const SpaceGeometry& geometry);
  void see(const MechanismScene& scene, const SpaceGeometry& geometry, const SpaceMotion& motion);
};

/// One of the lines that make the arrows, in space, for pages that turn them: what has a length in pixels begins at its
/// anchor.
struct SpaceStroke {
  enum class Kind : std::uint8_t { arrow, area, cone, turn, dot };
  Kind kind = Kind::arrow;
  Vec3 anchor{};
  std::vector<Vec3> points;  ///< of a cone: its circle
  std::string css;
  ArrowLine line = ArrowLine::solid;
};
struct SpaceLabel {
  Vec3 anchor{}, at{};
  std::string text;
};

class SpaceArrows {
 public:
  struct Input {
    const MechanismScene& scene;
    const SpaceMotion* motion;  ///< none: all forces are as long, in their positive directions
    const SpaceGeometry& geometry;
    const SpaceNumbers& numbers;
    const SpaceView& view;
    SpaceSizes sizes;
    bool lettered = false;    ///< contacts have letters
    bool is_virtual = false;  ///< accelerations are the rates of a virtual motion
  };
  SpaceArrows(const Element& svg, const Input& input, PictureLabels& labels);

  void draw();

  const std::vector<Point>& ends() const { return ends_; }
  const std::vector<std::string>& described() const { return described_; }
  const std::set<SpaceSign>& signs() const { return signs_; }
  const std::vector<SpaceStroke>& strokes() const { return strokes_; }
  const std::vector<SpaceLabel>& labels() const { return names_; }

 private:
  void contact(std::size_t number);
  void contact_force(const SpaceGeometry::Contact& contact);
  void contact_directions(const SpaceGeometry::Contact& contact);
  void name_once(const std::string& symbol, Point start, Point tip);
  void cone(const SpaceGeometry::Contact& contact, double height);
  void slip(const SpaceGeometry::Contact& contact, const Range& degrees);
  void push(const SpaceGeometry::Push& push);
  void weight(const SpaceGeometry::Weight& weight);
  void body(const SpaceGeometry::MovingBody& body);
  void straight(const Vec3& at, const Vec3& way, bool before, const std::string& name, double size);
  /// Notes the sign of a velocity, or of an acceleration or a virtual rate.
  void sign_of_motion(bool before);
  /// Part of a circle around an axis, with an arrow at its end; returns places for its label.
  std::vector<Point> turn(const Vec3& at, const Vec3& axis, double radius, std::string_view css, ArrowLine line);
  std::string after(const char* velocity, const char* change, const char* rate) const;
  std::string quantity(const std::string& symbol, double value, const std::string& unit, const std::string& body) const;
  void describe(const std::string& body, const std::string& words);
  Point see(const Vec3& p);
  enum class Anchor : std::uint8_t { start, end };
  void arrow(const Vec3& from, const Vec3& to, std::string_view css, ArrowLine line = ArrowLine::solid,
             Anchor anchor = Anchor::start);
  bool named() const { return in_.geometry.bodies.size() <= 3; }

  const Element svg_;
  const Input in_;
  PictureLabels& labels_;
  double force_unit_ = 0;  ///< length in the scene of a force of 1
  std::vector<Point> ends_;
  std::vector<std::pair<std::string, Point>> named_;
  std::vector<std::string> described_;
  std::set<SpaceSign> signs_;
  std::vector<SpaceStroke> strokes_;
  std::vector<SpaceLabel> names_;
};

}  // namespace slipproof
