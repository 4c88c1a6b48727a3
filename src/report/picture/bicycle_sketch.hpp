// The bicycle itself, to scale: the common part of the picture of a motion and of the labelled figure.
#pragma once

#include <string_view>

#include "mechanics/scene/scene.hpp"
#include "report/markup/element.hpp"
#include "report/picture/drawing.hpp"

namespace slipproof {

/// Whether a wheel is drawn off the road.
struct Raised {
  bool rear = false, front = false;
};

/// The place of the bicycle in a picture, in pixels.
struct SketchBox {
  double width = 0;   ///< of the picture; the bicycle is in its middle
  double margin = 0;  ///< on either side
  double top = 0;     ///< no part of the bicycle is above this level
  double road = 0;    ///< level of the road
};

/// Draws a bicycle to scale. The height of a raised wheel is not to scale; it only has to be visible: the other wheel
/// stays in its place, and the frame turns about that wheel's axle. If r1 and r2 only give their ratio (a sprocket as
/// large as a wheel), they are drawn smaller, in that ratio.
class BicycleSketch {
 public:
  BicycleSketch(const Element& svg, const MechanismScene& scene, const SketchBox& box, Raised raised = {});

  /// Draws the road, wheels, frame, chain, and the pedal on its arm below the line of the axles.
  void draw() const;

  double scale() const { return scale_; }
  double R() const { return R_; }
  double h0() const { return h0_; }
  double b2() const { return b2_; }
  double b3() const { return b3_; }
  double r1() const { return r1_; }
  double r2() const { return r2_; }
  double L() const { return L_; }
  /// How far before C the sprocket with the pedals is drawn: midway between the axles, since the model gives no place.
  double crank() const { return (b3_ - b2_) / 2; }

  /// Pixels for a distance in metres in front of C or above the road.
  double x(double metres) const { return x0_ + scale_ * metres; }
  double y(double metres) const { return road_ - scale_ * metres; }
  /// The same for a point of the bicycle, which may be raised.
  Point place(double across, double up) const;

  /// The place of the pedal. A pedal below the road or far above is moved into the picture.
  Point pedal() const;

  void line(Point from, Point to, std::string_view css_class) const;
  void circle(Point centre, double radius, std::string_view css_class) const;
  /// Draws an arrow from a point along (dx, dy); the tip is at the end of this vector.
  void arrow(Point from, double dx, double dy, std::string_view css_class) const;

 private:
  void wheel(double at, bool is_raised) const;
  void frame() const;
  void chain() const;
  void polygon(std::initializer_list<Point> points) const;

  const Element svg_;
  Raised raised_;
  double tilt_ = 0, shift_ = 0;
  double R_, h0_, b2_, b3_, r1_, r2_, L_, scale_ = 1, x0_ = 0, width_, road_;
};

}  // namespace slipproof
