#include "report/picture/polyline.hpp"

#include <algorithm>
#include <cmath>

#include "report/markup/number.hpp"

namespace slipproof {

namespace {

void keep(const std::vector<Pixel>& points, std::size_t first, std::size_t last, std::vector<bool>& kept) {
  const double dx = points[last].x - points[first].x, dy = points[last].y - points[first].y;
  const double length = std::hypot(dx, dy);
  double worst = 1.0 / 12;
  std::size_t far = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double px = points[i].x - points[first].x, py = points[i].y - points[first].y;
    const double distance = length > 0 ? std::abs(dx * py - dy * px) / length : std::hypot(px, py);
    if (distance > worst) worst = distance, far = i;
  }
  if (far == first) return;
  kept[far] = true;
  keep(points, first, far, kept);
  keep(points, far, last, kept);
}

std::string through(const std::vector<Pixel>& points) {
  std::string path;
  for (const Pixel& p : points) {
    path += path.empty() ? "M" : "L";
    path += short_number(p.x) + "," + short_number(p.y);
  }
  return path;
}

}  // namespace

std::vector<Pixel> simplified(const std::vector<Pixel>& points) {
  if (points.size() < 3) return points;
  std::vector<bool> kept(points.size());
  kept.front() = kept.back() = true;
  keep(points, 0, points.size() - 1, kept);
  std::vector<Pixel> rest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i]) rest.push_back(points[i]);
  }
  return rest;
}

std::vector<Pixel> band_of(const std::vector<Pixel>& middle, const std::vector<double>& heights, double least) {
  const double half = least / 2;
  std::vector<Pixel> above, below;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const Pixel &before = middle[i == 0 ? 0 : i - 1], &after = middle[std::min(i + 1, middle.size() - 1)];
    const double dx = after.x - before.x, dy = after.y - before.y, length = std::max(std::hypot(dx, dy), 1e-9);
    const double beyond = i == 0 ? -half : i + 1 == middle.size() ? half : 0;
    const double x = middle[i].x + beyond * dx / length, y = middle[i].y + beyond * dy / length;
    const bool high = heights[i] * dx / length >= least;
    const Pixel reach = high ? Pixel{0, heights[i] / 2} : Pixel{-half * dy / length, half * dx / length};
    above.push_back({x - reach.x, y - reach.y});
    below.push_back({x + reach.x, y + reach.y});
  }
  above.insert(above.end(), below.rbegin(), below.rend());
  return above;
}

double length_of(const std::vector<Pixel>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
  }
  return length;
}

std::string path_of(const std::vector<Pixel>& points) {
  return through(simplified(points));
}

std::string closed_path_of(const std::vector<Pixel>& points) {
  return through(points) + "Z";
}

}  // namespace slipproof
