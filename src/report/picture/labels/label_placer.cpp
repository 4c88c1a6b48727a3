#include "report/picture/labels/label_placer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slipproof {

namespace {

/// The length of the part of a line that is inside a box (Liang and Barsky).
double length_inside(Point from, Point to, const LabelBox& box) {
  if (std::max(from[0], to[0]) < box.left || std::min(from[0], to[0]) > box.right) return 0;
  if (std::max(from[1], to[1]) < box.top || std::min(from[1], to[1]) > box.bottom) return 0;
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

double distance_to(const Point& point, const LabelBox& box) {
  return std::hypot(std::max({box.left - point[0], point[0] - box.right, 0.0}),
                    std::max({box.top - point[1], point[1] - box.bottom, 0.0}));
}

}  // namespace

LabelBox LabelBox::around(const LabelBox& other) const {
  return {std::min(left, other.left), std::min(top, other.top), std::max(right, other.right),
          std::max(bottom, other.bottom)};
}

double LabelBox::overlap(const LabelBox& other) const {
  const double across = std::min(right, other.right) - std::max(left, other.left);
  const double down = std::min(bottom, other.bottom) - std::max(top, other.top);
  return across > 0 && down > 0 ? across * down : 0;
}

double LabelPlacer::cost(const LabelBox& box, double enough) const {
  double sum = 6 * (std::max(0.0, left_ - box.left) + std::max(0.0, box.right - right_));
  for (const LabelBox& other : boxes_) sum += 20 * box.overlap(other);
  for (auto line = lines_.begin(); sum < enough && line != lines_.end(); ++line) {
    sum += line->weight * length_inside(line->from, line->to, box);
  }
  return sum;
}

LabelBox LabelPlacer::best(const Label& label, const std::vector<Label>& all) const {
  constexpr int directions = 16;
  constexpr double wrong_name = 40, same_place = 8, clearly = 14;
  std::vector<Point> others;
  for (const Label& other : all) {
    for (const Point& point : other.near) {
      const bool own = std::any_of(label.near.begin(), label.near.end(), [&](const Point& p) {
        return std::hypot(p[0] - point[0], p[1] - point[1]) < same_place;
      });
      if (!own) others.push_back(point);
    }
  }
  LabelBox best;
  double least = std::numeric_limits<double>::max();
  for (const Point& point : label.near) {
    for (const double distance : {5.0, 9.0, 14.0, 22.0, 36.0, 54.0, 76.0}) {
      if (distance >= least) break;  // no cost is negative
      for (int i = 0; i < directions; ++i) {
        const double angle = 2 * std::numbers::pi * i / directions;
        const double x = point[0] + std::cos(angle) * (distance + label.width / 2);
        const double y = point[1] + std::sin(angle) * (distance + label.height / 2);
        const LabelBox box{x - label.width / 2, y - label.height / 2, x + label.width / 2, y + label.height / 2};
        double here = distance + cost(box, least);
        for (const Point& other : others) {
          if (here >= least) break;
          const double nearer = distance_to(point, box) + clearly - distance_to(other, box);
          if (nearer > 0) here += nearer > clearly ? wrong_name : wrong_name * nearer / clearly;
        }
        if (here < least - 1e-6) least = here, best = box;
      }
    }
  }
  return best;
}

std::vector<LabelBox> LabelPlacer::place(const std::vector<Label>& labels) {
  constexpr int rounds = 6;
  const auto first = static_cast<std::ptrdiff_t>(boxes_.size());
  for (const Label& label : labels) boxes_.push_back(best(label, labels));
  for (int round = 0; round < rounds; ++round) {
    bool moved = false;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const auto at = boxes_.begin() + first + static_cast<std::ptrdiff_t>(i);
      const LabelBox before = *at;
      *at = {};  // an empty box is in nobody's way
      const LabelBox after = best(labels[i], labels);
      moved = moved || after.left != before.left || after.top != before.top;
      *at = after;
    }
    if (!moved) break;
  }
  return {boxes_.begin() + first, boxes_.end()};
}

LabelBox LabelPlacer::place(const std::vector<Point>& near, double width, double height) {
  return place({Label{near, width, height}}).front();
}

}  // namespace slipproof
