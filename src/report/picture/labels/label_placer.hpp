// Places labels in a picture: near what they name, without overlap, and across as few lines as possible.
#pragma once

#include <limits>
#include <vector>

#include "report/picture/drawing.hpp"

namespace slipproof {

/// In pixels, y down.
struct LabelBox {
  double left = 0, top = 0, right = 0, bottom = 0;

  double overlap(const LabelBox& other) const;   ///< its area
  LabelBox around(const LabelBox& other) const;  ///< the least that contains both
};

class LabelPlacer {
 public:
  /// A line that labels should not cover; `weight` is the penalty for a pixel of it.
  void avoid(Point from, Point to, double weight) { lines_.push_back({from, to, weight}); }
  /// A box that no label should cover.
  void avoid(const LabelBox& box) { boxes_.push_back(box); }

  /// Labels should stay between these limits on the left and the right.
  void keep_between(double left, double right) { left_ = left, right_ = right; }

  /// A label that stands near one of the points.
  struct Label {
    std::vector<Point> near;
    double width = 0, height = 0;
  };
  /// The best places for labels: one after the other, then each again among the others until none moves. Compares some
  /// hundred places for each. A place nearer to what another label names costs more.
  std::vector<LabelBox> place(const std::vector<Label>& labels);
  /// The same for one label; later ones avoid it.
  LabelBox place(const std::vector<Point>& near, double width, double height);

 private:
  struct Line {
    Point from, to;
    double weight;
  };
  /// Of a place; from `enough` on, perhaps only a part of it.
  double cost(const LabelBox& box, double enough) const;
  LabelBox best(const Label& label, const std::vector<Label>& all) const;

  double left_ = std::numeric_limits<double>::lowest(), right_ = std::numeric_limits<double>::max();
  std::vector<Line> lines_;
  std::vector<LabelBox> boxes_;
};

}  // namespace slipproof
