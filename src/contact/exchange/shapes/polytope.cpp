#include "contact/exchange/shapes/polytope.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/number/binary64.hpp"

namespace slipproof::imported {

Near near(const Vector& v) {
  return {nearest_binary64(v.x), nearest_binary64(v.y), nearest_binary64(v.z)};
}

namespace {

/// Across an edge from `a` to `b` of a face, to its inside.
Vector inwards(const Face& face, const Vector& a, const Vector& b) {
  return cross(face.normal, b - a);
}

Polytope::Side side_of(Face face) {
  Polytope::Side side;
  side.normal = near(face.normal);
  side.offset = dot(side.normal, near(face.through));
  side.face = std::move(face);
  return side;
}

Polytope box(const Shape& shape) {
  Polytope result;
  result.corners = corners_of(shape);
  for (std::size_t bits = 0; bits < 8; ++bits) {
    for (const std::size_t bit : {1U, 2U, 4U}) {
      if ((bits & bit) == 0) result.edges.push_back({result.corners[bits], result.corners[bits | bit]});
    }
  }
  const auto& axes = shape.pose.turn.axes;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    for (const int side : {1, -1}) {
      Face face;
      face.normal = Rational(side) * axes[i];
      face.through = shape.pose.at + shape.half[i] * face.normal;
      const Vector a = shape.half[j] * axes[j], b = Rational(side) * shape.half[k] * axes[k];
      face.corners = {face.through - a - b, face.through + a - b, face.through + a + b, face.through - a + b};
      result.sides.push_back(side_of(std::move(face)));
    }
  }
  return result;
}

Polytope plane(const Shape& shape) {
  Polytope result;
  Face face;
  face.through = shape.pose.at;
  face.normal = shape.pose.turn.axes[2];
  face.unlimited = true;
  result.sides.push_back(side_of(std::move(face)));
  return result;
}

Polytope cylinder(const Shape& shape) {
  Polytope result;
  for (const int side : {1, -1}) {
    Face face;
    face.normal = Rational(side) * shape.pose.turn.axes[2];
    face.through = shape.pose.at + shape.half_length * face.normal;
    face.disc = shape.radius;
    result.sides.push_back(side_of(std::move(face)));
  }
  return result;
}

/// Where the segment from a to b leaves a disc, within 1e-15 of its length.
Vector on_rim(const Face& face, const Vector& a, const Vector& b) {
  const Near from = minus(near(a), near(face.through)), along = minus(near(b), near(a));
  const double r = nearest_binary64(*face.disc), square = dot(along, along), middle = dot(from, along) / square;
  const double beyond = std::sqrt(std::max(0.0, middle * middle - (dot(from, from) - r * r) / square));
  const double first = -middle - beyond, last = -middle + beyond;
  return a + placed(first >= 0 && first <= 1 ? first : last) * (b - a);
}

/// The faces of a hull: triangles, joined where they lie in one plane.
class HullFaces {
 public:
  explicit HullFaces(const Shape& shape) : triangles_(shape.triangles), group_(shape.triangles.size()) {
    result_.corners = corners_of(shape);
    for (const Vector& p : result_.corners) places_.push_back(near(p));
    std::iota(group_.begin(), group_.end(), std::size_t{0});
  }

  Polytope join() {
    Near least = places_.front(), most = least, sum{};
    for (const Near& p : places_) {
      for (std::size_t k = 0; k < 3; ++k) {
        least[k] = std::min(least[k], p[k]), most[k] = std::max(most[k], p[k]);
        sum[k] += p[k] / static_cast<double>(places_.size());
      }
    }
    middle_ = sum;
    flat_ = 1e-6 * std::sqrt(dot(minus(most, least), minus(most, least)));
    std::map<std::array<std::size_t, 2>, std::vector<std::size_t>> sides;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
        sides[{std::min(a, b), std::max(a, b)}].push_back(t);
      }
    }
    for (const auto& [side, owners] : sides) {
      if (owners.size() == 2 && is_flat(owners[0], owners[1]) && is_flat(owners[1], owners[0])) {
        group_[root(owners[0])] = root(owners[1]);
      }
    }
    for (const auto& [side, owners] : sides) {
      if (owners.size() != 2 || root(owners[0]) != root(owners[1])) {
        result_.edges.push_back({result_.corners[side[0]], result_.corners[side[1]]});
      }
    }
    add_faces();
    return std::move(result_);
  }

 private:
  std::size_t root(std::size_t i) const {
    while (group_[i] != i) i = group_[i];
    return i;
  }
  /// Twice the area, times the normal out of the hull.
  Near normal(std::size_t t) const {
    const auto& [a, b, c] = triangles_[t];
    Near n = cross(minus(places_[b], places_[a]), minus(places_[c], places_[a]));
    if (dot(n, minus(places_[a], middle_)) < 0) n = {-n[0], -n[1], -n[2]};
    return n;
  }
  bool is_flat(std::size_t t, std::size_t other) const {
    const Near n = normal(t);
    const double length = std::sqrt(dot(n, n));
    if (length == 0) return true;
    return std::ranges::all_of(triangles_[other], [&](std::size_t corner) {
      return std::abs(dot(n, minus(places_[corner], places_[triangles_[t][0]]))) <= flat_ * length;
    });
  }

  void add_faces() {
    std::map<std::size_t, std::vector<std::size_t>> members;
    for (std::size_t t = 0; t < triangles_.size(); ++t) members[root(t)].push_back(t);
    for (const auto& [name, all] : members) {
      const auto area = [&](std::size_t t) { return dot(normal(t), normal(t)); };
      const std::size_t largest = *std::ranges::max_element(all, {}, area);
      if (area(largest) == 0) continue;
      Polytope::Side side;
      side.normal = normal(largest);
      const double length = std::sqrt(dot(side.normal, side.normal));
      for (double& x : side.normal) x /= length;
      const std::size_t first = triangles_[largest][0];
      side.offset = dot(side.normal, places_[first]);
      for (const std::size_t t : all)
        side.corners.insert(side.corners.end(), triangles_[t].begin(), triangles_[t].end());
      std::ranges::sort(side.corners);
      side.corners.erase(std::unique(side.corners.begin(), side.corners.end()), side.corners.end());
      std::iter_swap(side.corners.begin(), std::ranges::find(side.corners, first));
      result_.sides.push_back(std::move(side));
    }
  }

  const std::vector<std::array<std::size_t, 3>>& triangles_;
  std::vector<std::size_t> group_;
  std::vector<Near> places_;
  Near middle_{};
  double flat_ = 0;
  Polytope result_;
};

}  // namespace

bool Face::holds(const Vector& p, const Rational& touch) const {
  if (unlimited) return true;
  if (disc) {
    const Vector off = p - through - distance(p) * normal;
    return imported::dot(off, off) <= (*disc + touch) * (*disc + touch);
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const Vector in = inwards(*this, a, b);
    if (imported::dot(p - a, in) < -touch * (abs(in.x) + abs(in.y) + abs(in.z))) return false;
  }
  return true;
}

std::vector<Vector> Face::clip(std::vector<Vector> polygon) const {
  if (disc) {
    std::vector<Vector> rest;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vector &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
      if (holds(p, 0)) rest.push_back(p);
      if (holds(p, 0) != holds(q, 0)) rest.push_back(on_rim(*this, p, q));
    }
    return rest;
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector &a = corners[i], in = inwards(*this, a, corners[(i + 1) % corners.size()]);
    const auto inside = [&](const Vector& p) -> Rational { return imported::dot(p - a, in); };
    std::vector<Vector> rest;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vector &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
      const Rational from = inside(p), to = inside(q);
      if (from.sign() >= 0) rest.push_back(p);
      if (from.sign() * to.sign() < 0) rest.push_back(p + (from / (from - to)) * (q - p));
    }
    polygon = std::move(rest);
  }
  return polygon;
}

Face Polytope::face(const Side& side) const {
  if (side.face) return *side.face;
  Face face;
  face.normal = unit_near(side.normal);
  face.through = corners[side.corners.front()];
  std::vector<Vector> points;
  for (const std::size_t corner : side.corners) points.push_back(corners[corner]);
  face.corners = corners_of_polygon(points, face.normal);
  return face;
}

std::vector<Vector> corners_of(const Shape& shape) {
  std::vector<Vector> result;
  if (shape.kind == Shape::Kind::hull) {
    for (const Vector& p : shape.points) result.push_back(shape.pose(p));
  }
  for (int bits = 0; shape.kind == Shape::Kind::box && bits < 8; ++bits) {
    const auto sign = [&](int bit) { return Rational((bits & bit) != 0 ? 1 : -1); };
    result.push_back(shape.pose(Vector{sign(1) * shape.half.x, sign(2) * shape.half.y, sign(4) * shape.half.z}));
  }
  return result;
}

Polytope polytope_of(const Shape& shape) {
  if (shape.kind == Shape::Kind::box) return box(shape);
  if (shape.kind == Shape::Kind::plane) return plane(shape);
  if (shape.kind == Shape::Kind::cylinder) return cylinder(shape);
  if (shape.kind == Shape::Kind::hull && !shape.points.empty()) return HullFaces(shape).join();
  return {};
}

std::vector<Vector> corners_of_polygon(const std::vector<Vector>& points, const Vector& normal) {
  if (points.size() < 3) return points;
  // Coordinates along two directions across the normal, of any length.
  const Vector along = normal.x.is_zero() && normal.y.is_zero() ? Vector{1, 0, 0} : cross(Vector{0, 0, 1}, normal);
  const Vector across = cross(normal, along);
  struct Planar {
    double x, y;
    std::size_t point;
  };
  std::vector<Planar> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    all.push_back(
        {nearest_binary64(imported::dot(points[i], along)), nearest_binary64(imported::dot(points[i], across)), i});
  }
  std::ranges::sort(all, [](const Planar& a, const Planar& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  const auto left = [](const Planar& a, const Planar& b, const Planar& c) {  // Andrew's chain
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 1e-18;
  };
  std::vector<Planar> chain;
  for (int half = 0; half < 2; ++half) {
    const std::size_t begin = chain.size();
    for (const Planar& one : all) {
      while (chain.size() >= begin + 2 && !left(chain[chain.size() - 2], chain.back(), one)) chain.pop_back();
      chain.push_back(one);
    }
    chain.pop_back();
    std::ranges::reverse(all);
  }
  std::vector<Vector> result;
  for (const Planar& one : chain) result.push_back(points[one.point]);
  return result;
}

}  // namespace slipproof::imported
