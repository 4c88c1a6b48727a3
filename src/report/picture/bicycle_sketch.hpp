// The bicycle itself, to scale: what the picture of a motion and the labelled figure have in common.
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

/// Where in a picture the bicycle stands, in pixels.
struct SketchBox {
  double width = 0;   ///< of the picture; the bicycle stands in its middle
  double margin = 0;  ///< on either side
  double top = 0;     ///< nothing of the bicycle is above
  double road = 0;    ///< level of the road
};

/// Draws a bicycle to scale. A raised wheel is raised by no measure but that it can be seen: the other one stays, and
/// the frame turns about its axle. Where r1 and r2 only say their ratio (a sprocket as large as a wheel), they are
/// drawn smaller, in that ratio.
class BicycleSketch {
 public:
  BicycleSketch(const Element& svg, const MechanismScene& scene, const SketchBox& box, Raised raised = {});

  /// The road, wheels, frame, chain, and the pedal at its arm below the axles' line.
  void draw() const;

  double scale() const { return scale_; }
  double R() const { return R_; }
  double h0() const { return h0_; }
  double b2() const { return b2_; }
  double b3() const { return b3_; }
  double r1() const { return r1_; }
  double r2() const { return r2_; }
  double L() const { return L_; }
  /// How far before C the sprocket with the pedals is drawn: in the middle of the axles, the model does not say where.
  double crank() const { return (b3_ - b2_) / 2; }

  /// Pixels, from metres in front of C and above the road.
  double x(double metres) const { return x0_ + scale_ * metres; }
  double y(double metres) const { return road_ - scale_ * metres; }
  /// The same for a point of the bicycle, where it is raised.
  Point place(double across, double up) const;

  /// Where the pedal is. What stands for one below the road, or far above, is moved into the picture.
  Point pedal() const;

  void line(Point from, Point to, std::string_view css_class) const;
  void circle(Point centre, double radius, std::string_view css_class) const;
  /// From a point along (dx, dy), which is also where the tip is.
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
