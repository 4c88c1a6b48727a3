#include "contact/exchange/shapes/pairs.hpp"

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"

namespace slipproof::imported {

namespace {

using Kind = Shape::Kind;

bool is_flat(const Shape& shape) {
  return shape.kind == Kind::box || shape.kind == Kind::hull || shape.kind == Kind::plane;
}

/// The rational number within 1e-15 of a place or a distance that was computed.
Vector placed_at(const Near& p) {
  return {placed(p[0]), placed(p[1]), placed(p[2])};
}

std::vector<Vector> ends(const Shape& shape) {
  const Vector along = shape.half_length * shape.pose.turn.axes[2];
  return {shape.pose.at + along, shape.pose.at - along};
}

/// A point of a shape that may touch a face, and the radius of the sphere around its centre.
struct Lowest {
  Vector at;
  Rational radius = 0;
  bool only_at_rest = false;
};

/// The lowest points of a cylinder: two of its side, four of the rim on which it stands, or one of a rim.
std::vector<Lowest> lowest_of_cylinder(const Shape& shape, const Vector& up) {
  const auto& axes = shape.pose.turn.axes;
  const double along = nearest_binary64(dot(axes[2], up));
  std::vector<Lowest> result;
  if (std::abs(along) < 1e-9) {
    for (const Vector& end : ends(shape)) result.push_back({end - shape.radius * up, shape.radius, false});
    return result;
  }
  const Vector end = shape.pose.at + Rational(along > 0 ? -1 : 1) * shape.half_length * axes[2];
  if (std::abs(along) > 1 - 1e-12) {
    for (const std::size_t axis : {0U, 1U}) {
      for (const int side : {1, -1}) result.push_back({end + Rational(side) * shape.radius * axes[axis], 0, false});
    }
    return result;
  }
  const Vector across = up - dot(up, axes[2]) * axes[2];
  return {{end - shape.radius * unit_near(near(across)), 0, true}};
}

std::vector<Lowest> lowest(const Solid& solid, const Face& face) {
  const Shape& shape = *solid.shape;
  std::vector<Lowest> result;
  switch (shape.kind) {
    case Kind::plane:
      break;
    case Kind::box:
    case Kind::hull:
      for (const Vector& p : solid.faces.corners) result.push_back({p, 0, false});
      break;
    case Kind::sphere:
      result.push_back({shape.pose.at - shape.radius * face.normal, shape.radius, false});
      break;
    case Kind::capsule:
      for (const Vector& end : ends(shape)) result.push_back({end - shape.radius * face.normal, shape.radius, false});
      break;
    case Kind::cylinder:
      return lowest_of_cylinder(shape, face.normal);
  }
  return result;
}

constexpr std::size_t most_pairs_of_edges = 250'000;

class Pair {
 public:
  Pair(const Solid& a, const Solid& b, const Rational& touch) : a_(a), b_(b), touch_(touch) {}

  std::vector<TouchPoint> find(std::string& why) {
    const bool plane = a_.shape->kind == Kind::plane || b_.shape->kind == Kind::plane;
    double apart = 0;
    if (!plane) {
      nearest_ = nearest_points(a_.core, b_.core);
      apart = nearest_.distance - nearest_binary64(reach(a_) + reach(b_));
      if (apart > nearest_binary64(touch_)) return {};
    }
    on_faces(a_, b_, false);
    if (found_.empty()) on_faces(b_, a_, true);
    if (!found_.empty() || (plane && !inside_)) return std::move(found_);
    if (a_.shape->kind == Kind::sphere && b_.shape->kind == Kind::sphere) spheres();
    if (found_.empty() && !plane) at_nearest(apart);
    if (found_.empty() && !plane) crossing_edges();
    if (found_.empty())
      why =
          inside_ || apart < 0 ? "are inside each other" : "are inside each other, or touch in a way that is not read";
    return std::move(found_);
  }

 private:
  static Rational reach(const Solid& solid) {
    return solid.shape->kind == Kind::sphere || solid.shape->kind == Kind::capsule ? solid.shape->radius : Rational(0);
  }

  /// The face of one shape from which the other is farthest, or least inside.
  static const Polytope::Side* best_side(const Solid& of, const Solid& on) {
    if (of.shape->kind == Kind::plane) return nullptr;
    const double round = nearest_binary64(reach(of));
    const Polytope::Side* best = nullptr;
    double greatest = 0;
    for (const Polytope::Side& side : on.faces.sides) {
      const auto& n = side.normal;
      const double least = dot(of.core.farthest({-n[0], -n[1], -n[2]}), n) - round - side.offset;
      if (best == nullptr || least > greatest + 1e-12) best = &side, greatest = least;
    }
    return best;
  }

  /// Points of one shape on the faces of another: on the face that keeps them apart best, if one does.
  void on_faces(const Solid& of, const Solid& on, bool swapped) {
    const Polytope::Side* side = best_side(of, on);
    if (side == nullptr) return;
    const Face best = on.faces.face(*side);
    const std::vector<Lowest> points = lowest(of, best);
    if (points.empty()) return;
    Rational greatest = best.distance(points.front().at);
    for (const Lowest& p : points) greatest = std::min(greatest, best.distance(p.at));
    inside_ = inside_ || greatest < -touch_;
    if (greatest > touch_ || greatest < -touch_) return;
    if (is_flat(*of.shape)) return flat_on(of, best, swapped);
    for (const Lowest& p : points) {
      const Rational distance = best.distance(p.at);
      if (distance > touch_ || !best.holds(p.at, touch_)) continue;
      found_.push_back({swapped, p.at - distance * best.normal, best.normal, distance, p.radius, {}, p.only_at_rest});
    }
  }

  /// The part of the corners, the edge or the face nearest to a face that lies above it.
  void flat_on(const Solid& of, const Face& face, bool swapped) {
    std::vector<Vector> close;
    for (const Vector& p : of.faces.corners) {
      if (face.distance(p) <= touch_) close.push_back(p);
    }
    const std::vector<Vector> all = face.clip(corners_of_polygon(close, face.normal));
    for (const Vector& p : all) {
      const Rational distance = face.distance(p);
      found_.push_back({swapped, p - distance * face.normal, face.normal, distance, 0, {}, false});
    }
    if (!found_.empty()) return;
    for (const Vector& p : close) {  // beside the face by less than the touch
      if (face.holds(p, touch_))
        found_.push_back({swapped, p - face.distance(p) * face.normal, face.normal, face.distance(p), 0, {}, false});
    }
  }

  void spheres() {
    const Shape &a = *a_.shape, &b = *b_.shape;
    const Vector between = a.pose.at - b.pose.at;
    const auto length = exact_root(dot(between, between));
    if (!length || length->is_zero()) return;
    const Rational distance = *length - a.radius - b.radius;
    if (abs(distance) > touch_) return;
    const Vector normal = (Rational(1) / *length) * between;
    found_.push_back(
        {false, b.pose.at + (b.radius + distance / 2) * normal, normal, distance, a.radius, b.radius, false});
  }

  /// Where their nearest points are, if these do not meet: round shapes, corners and edges.
  void at_nearest(double apart) {
    if (nearest_.distance < 1e-7 || apart < -nearest_binary64(touch_)) return;
    const Vector normal = unit_near(minus(nearest_.on_a, nearest_.on_b));
    const Rational distance = placed(apart), on = reach(b_);
    TouchPoint point;
    point.at = placed_at(nearest_.on_b) + (on + distance / 2) * normal;
    point.normal = normal;
    point.distance = distance;
    point.radius = reach(a_);
    if (!on.is_zero()) point.on_radius = on;
    point.only_at_rest = a_.shape->kind != Kind::sphere || b_.shape->kind != Kind::sphere;
    found_.push_back(std::move(point));
  }

  /// Two edges that cross, so that a plane along both keeps the shapes apart.
  void crossing_edges() {
    const Core &a = a_.core, &b = b_.core;
    if (a_.faces.edges.size() * b_.faces.edges.size() > most_pairs_of_edges) return;
    const double touch = nearest_binary64(touch_);
    for (const auto& own : a_.faces.edges) {
      for (const auto& other : b_.faces.edges) {
        const Near u = minus(near(own[1]), near(own[0])), v = minus(near(other[1]), near(other[0]));
        Near n = cross(u, v);
        const double length = std::sqrt(dot(n, n));
        if (length < 1e-9 * std::sqrt(dot(u, u) * dot(v, v))) continue;
        for (double& x : n) x /= length;
        const Near between = minus(near(own[0]), near(other[0]));
        if (std::abs(dot(between, n)) > touch) continue;
        const Near down{-n[0], -n[1], -n[2]};
        const double up_gap = dot(a.farthest(down), n) - dot(b.farthest(n), n);
        const double down_gap = dot(b.farthest(down), n) - dot(a.farthest(n), n);
        if (std::max(up_gap, down_gap) < -touch) continue;
        if (down_gap > up_gap) n = down;
        const double s = -dot(cross(between, v), cross(u, v)) / (length * length);
        const double t = -dot(cross(between, u), cross(u, v)) / (length * length);
        if (s < -1e-9 || s > 1 + 1e-9 || t < -1e-9 || t > 1 + 1e-9) continue;
        const Vector normal = unit_near(n);
        const Vector p = own[0] + placed(s) * (own[1] - own[0]), q = other[0] + placed(t) * (other[1] - other[0]);
        found_.push_back({false, Rational(1, 2) * (p + q), normal, dot(p - q, normal), 0, {}, true});
      }
    }
  }

  const Solid &a_, &b_;
  const Rational& touch_;
  Nearest nearest_;
  bool inside_ = false;
  std::vector<TouchPoint> found_;
};

}  // namespace

Solid solid_of(const Shape& shape) {
  Solid solid{&shape, polytope_of(shape), {}};
  if (shape.kind != Kind::plane) solid.core = core_of(shape, solid.faces);
  return solid;
}

std::vector<TouchPoint> touching(const Solid& a, const Solid& b, const Rational& touch, std::string& why) {
  return Pair(a, b, touch).find(why);
}

std::optional<Rational> least_along(const Shape& shape, const Vector& normal) {
  if (shape.kind == Kind::plane) return std::nullopt;
  Face face;
  face.normal = normal;
  face.unlimited = true;
  Solid solid;
  solid.shape = &shape;
  solid.faces.corners = corners_of(shape);
  std::optional<Rational> least;
  for (const Lowest& p : lowest(solid, face)) {
    const Rational here = dot(p.at, normal);
    if (!least || here < *least) least = here;
  }
  return least;
}

}  // namespace slipproof::imported
