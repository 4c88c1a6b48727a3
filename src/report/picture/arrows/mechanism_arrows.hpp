// The arrows in the picture of a mechanism: forces at contacts, weights, pushes, and how bodies move before the motion.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mechanics/kernel/motion.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/markup/element.hpp"
#include "report/picture/labels/picture_labels.hpp"
#include "report/picture/mechanism_geometry.hpp"
#include "report/picture/motion_words.hpp"

namespace slipproof {

/// Where the places of a mechanism are in its picture.
struct PictureView {
  Point middle{0, 0};
  double scale = 1;

  Point pixel(Point p) const { return {scale * (p[0] - middle[0]), -scale * (p[1] - middle[1])}; }
};
/// A place in pixels, moved by so many along a direction given with y up.
Point moved(Point from, Point direction, double by);

/// The size of the largest force of a motion that has an arrow.
double largest_arrow(const MechanismScene& scene, const MotionAtLoad& motion, const MechanismGeometry& geometry);

class MechanismArrows {
 public:
  /// What the arrows show, and how long they are.
  struct Input {
    const MechanismScene& scene;
    const MotionAtLoad* motion;  ///< none: all forces are as long, in their positive directions
    const MechanismGeometry& geometry;
    const NumberWords& numbers;
    PictureView view;
    double longest = 0;       ///< in pixels, of the largest force
    double largest = 0;       ///< that force; 0: the largest of the motion
    bool names = true;        ///< beside each; otherwise whoever draws says them elsewhere
    bool is_virtual = false;  ///< velocities are dotted
  };
  MechanismArrows(const Element& svg, const Input& input, PictureLabels& labels);

  /// All of them; those of contacts first, which others make way for.
  void draw();

  /// The ends of all arrows, in pixels.
  const std::vector<Point>& ends() const { return ends_; }
  /// In words, one of each.
  const std::vector<std::string>& described() const { return described_; }

 private:
  void contact(const MechanismGeometry::Contact& contact);
  void force(Point at, std::size_t unknown, Point direction, bool pushes, std::string_view css);
  std::pair<Point, Point> sliding(const MechanismGeometry::Contact& contact, bool forward);
  Rational slip_of(std::size_t contact) const;
  void shape(const MechanismGeometry::Outline& outline);
  void push(const MechanismGeometry::Push& push);
  void acceleration(const MechanismGeometry::Acceleration& acceleration);
  void weight(const MechanismGeometry::Weight& weight);
  void movement(const MechanismGeometry::Movement& movement, double fastest);
  std::pair<Point, Point> load_arrow(Point from, Point to, std::string_view css = "load");
  void see(Point from, Point to);
  double pixels(double size) const;
  const std::string& symbol_of(std::size_t unknown) const { return in_.scene.mechanism.unknowns[unknown].symbol; }

  const Element svg_;
  const Input in_;
  PictureLabels& labels_;
  double unit_ = 0;
  std::vector<std::pair<Point, Point>> drawn_;  ///< of forces
  std::vector<Point> ends_;
  std::vector<std::string> described_;
};

/// From more moving bodies on, their velocities and spins are not written beside them.
inline constexpr std::size_t most_named = 3;

/// `weight = 5 of upper and lower`: for each weight the bodies that have it; the same for velocities and spins.
std::vector<std::string> weight_words(const MechanismGeometry& geometry, const NumberWords& numbers);
std::vector<std::string> movement_words(const MechanismGeometry& geometry);

}  // namespace slipproof
