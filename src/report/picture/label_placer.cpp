#include "report/picture/label_placer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slipproof {

namespace {

/// The length of the part of a line that is inside a box (Liang and Barsky).
double length_inside(Point from, Point to, const LabelBox& box) {
  const double dx = to[0] - from[0], dy = to[1] - from[1];
  double enters = 0, leaves = 1;
  const auto cut = [&](double step, double room) {
    if (step == 0) return room >= 0;
    const double at = room / step;
    if (step < 0) enters = std::max(enters, at);
    if (step > 0) leaves = std::min(leaves, at);
    return enters < leaves;
  };
  const bool inside = cut(-dx, from[0] - box.left) && cut(dx, box.right - from[0]) && cut(-dy, from[1] - box.top) &&
                      cut(dy, box.bottom - from[1]);
  return inside ? (leaves - enters) * std::hypot(dx, dy) : 0;
}

}  // namespace

double LabelBox::overlap(const LabelBox& other) const {
  const double across = std::min(right, other.right) - std::max(left, other.left);
  const double down = std::min(bottom, other.bottom) - std::max(top, other.top);
  return across > 0 && down > 0 ? across * down : 0;
}

double LabelPlacer::cost(const LabelBox& box) const {
  double sum = std::max(0.0, left_ - box.left) + std::max(0.0, box.right - right_);
  for (const LabelBox& other : boxes_) sum += 20 * box.overlap(other);
  for (const Line& line : lines_) sum += line.weight * length_inside(line.from, line.to, box);
  return sum;
}

LabelBox LabelPlacer::place(const std::vector<Point>& near, double width, double height) {
  constexpr int directions = 16;
  LabelBox best;
  double least = -1;
  for (const Point& point : near) {
    for (const double distance : {5.0, 12.0, 22.0, 36.0, 54.0, 76.0}) {
      for (int i = 0; i < directions; ++i) {
        const double angle = 2 * std::numbers::pi * i / directions;
        const double x = point[0] + std::cos(angle) * (distance + width / 2);
        const double y = point[1] + std::sin(angle) * (distance + height / 2);
        const LabelBox box{x - width / 2, y - height / 2, x + width / 2, y + height / 2};
        const double here = distance + cost(box);
        if (least < 0 || here < least - 1e-6) least = here, best = box;
      }
    }
  }
  boxes_.push_back(best);
  return best;
}

}  // namespace slipproof
