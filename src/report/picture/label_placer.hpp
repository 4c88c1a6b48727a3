// Where labels go in a picture: near what they name, not over each other, and over lines as little as possible.
#pragma once

#include <limits>
#include <vector>

#include "report/picture/drawing.hpp"

namespace slipproof {

/// In pixels, y down.
struct LabelBox {
  double left = 0, top = 0, right = 0, bottom = 0;

  double overlap(const LabelBox& other) const;  ///< its area
};

class LabelPlacer {
 public:
  /// A line that a label had better not cover; `weight` is what a pixel of it counts.
  void avoid(Point from, Point to, double weight) { lines_.push_back({from, to, weight}); }
  /// What no label should be over.
  void avoid(const LabelBox& box) { boxes_.push_back(box); }

  /// Labels had better not reach beyond these, to the left and to the right.
  void keep_between(double left, double right) { left_ = left, right_ = right; }

  /// The best place of a label near one of the points, which the next ones avoid. A few hundred places are compared.
  LabelBox place(const std::vector<Point>& near, double width, double height);

 private:
  struct Line {
    Point from, to;
    double weight;
  };
  double cost(const LabelBox& box) const;

  double left_ = std::numeric_limits<double>::lowest(), right_ = std::numeric_limits<double>::max();
  std::vector<Line> lines_;
  std::vector<LabelBox> boxes_;
};

}  // namespace slipproof
