#include "contact/exchange/spatial_contacts.hpp"

#include <algorithm>

namespace slipproof::imported {

namespace {

/// A face of a box, or a plane, which has no end: `half` of its edges along two directions across the normal.
struct Face {
  Vector centre, normal;
  std::array<Vector, 2> along;
  std::array<Rational, 2> half;
  bool unlimited = false;

  Rational distance(const Vector& p) const { return dot(p - centre, normal); }
  bool holds(const Vector& p, const Rational& touch) const {
    if (unlimited) return true;
    for (std::size_t i = 0; i < 2; ++i) {
      if (abs(dot(p - centre, along[i])) > half[i] + touch) return false;
    }
    return true;
  }
  std::vector<Vector> corners() const {
    const Vector a = half[0] * along[0], b = half[1] * along[1];
    return {centre - a - b, centre + a - b, centre + a + b, centre - a + b};
  }
};

std::vector<Face> faces(const Shape& shape) {
  const auto& axes = shape.pose.turn.axes;
  if (shape.kind == Shape::Kind::plane) return {{shape.pose.at, axes[2], {axes[0], axes[1]}, {0, 0}, true}};
  std::vector<Face> result;
  if (shape.kind != Shape::Kind::box) return result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    for (const int side : {1, -1}) {
      const Vector normal = Rational(side) * axes[i];
      result.push_back(
          {shape.pose.at + shape.half[i] * normal, normal, {axes[j], axes[k]}, {shape.half[j], shape.half[k]}});
    }
  }
  return result;
}

std::vector<Vector> corners(const Shape& box) {
  std::vector<Vector> result;
  for (int bits = 0; bits < 8; ++bits) {
    const auto sign = [&](int bit) { return Rational((bits & bit) != 0 ? 1 : -1); };
    result.push_back(box.pose(Vector{sign(1) * box.half.x, sign(2) * box.half.y, sign(4) * box.half.z}));
  }
  return result;
}

/// The part of a polygon within a face's bounds.
std::vector<Vector> clipped(std::vector<Vector> polygon, const Face& face) {
  if (face.unlimited) return polygon;
  for (std::size_t i = 0; i < 2; ++i) {
    for (const int side : {1, -1}) {
      const auto inside = [&](const Vector& p) -> Rational {
        return face.half[i] - Rational(side) * dot(p - face.centre, face.along[i]);
      };
      std::vector<Vector> rest;
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
        const Rational a = inside(p), b = inside(q);
        if (a.sign() >= 0) rest.push_back(p);
        if (a.sign() * b.sign() < 0) rest.push_back(p + (a / (a - b)) * (q - p));
      }
      polygon = std::move(rest);
    }
  }
  return polygon;
}

class ShapeContacts {
 public:
  ShapeContacts(const Scene& scene, const Rational& touch, Mistakes& mistakes, std::vector<std::string>& import_notes)
      : scene_(scene), touch_(touch), mistakes_(mistakes), notes_(import_notes) {}

  std::vector<SpatialContact> find() {
    for_each_pair(scene_, [&](std::size_t i, const Shape& a, std::size_t j, const Shape& b) { pair(i, a, j, b); });
    return std::move(found_);
  }

 private:
  using Kind = Shape::Kind;

  void pair(std::size_t i, const Shape& a, std::size_t j, const Shape& b) {
    if ((a.kind == Kind::plane && b.kind == Kind::plane) || are_apart(a, b)) return;
    const std::size_t before = found_.size();
    if (a.kind == Kind::sphere && b.kind == Kind::sphere) return spheres(i, a, j, b);
    if (a.kind == Kind::box && b.kind == Kind::box) face_on_face(i, a, j, b);
    if (found_.size() == before) on_faces(i, a, j, b);
    if (found_.size() == before) on_faces(j, b, i, a);
    if (found_.size() > before || (a.kind == Kind::box && b.kind == Kind::box && boxes_are_apart(a, b))) return;
    mistakes_.add(b.place,
                  b.name + " and " + a.name +
                      " are inside each other, or touch in a way that is not read (edge on edge, round on round)");
  }

  /// Whether their boxes along the axes, or along those of a face, surely do not meet.
  bool are_apart(const Shape& a, const Shape& b) {
    const auto beyond = [&](const Shape& p, const Shape& q) {
      return std::ranges::any_of(faces(p), [&](const Face& face) { return least_distance(face, q) > touch_; });
    };
    if (beyond(a, b) || beyond(b, a)) return true;
    if (a.kind == Kind::plane || b.kind == Kind::plane) return false;
    for (const Vector& axis : Turn().axes) {
      const Rational between = abs(dot(a.pose.at - b.pose.at, axis));
      if (between > reach(a, axis) + reach(b, axis) + touch_) return true;
    }
    const Vector between = a.pose.at - b.pose.at;
    const Rational touching = a.radius + b.radius + touch_;
    return a.kind == Kind::sphere && b.kind == Kind::sphere && dot(between, between) > touching * touching;
  }

  /// An upper bound on how far a shape reaches from its centre along a direction of length 1.
  static Rational reach(const Shape& shape, const Vector& axis) {
    const auto& axes = shape.pose.turn.axes;
    switch (shape.kind) {
      case Kind::box: {
        Rational sum = 0;
        for (std::size_t i = 0; i < 3; ++i) sum += shape.half[i] * abs(dot(axes[i], axis));
        return sum;
      }
      case Kind::sphere:
        return shape.radius;
      default: {
        const Rational along = abs(dot(axes[2], axis));
        const bool stands = shape.kind == Kind::cylinder && along == 1;
        return shape.half_length * along + (stands ? Rational(0) : shape.radius);
      }
    }
  }

  Rational least_distance(const Face& face, const Shape& shape) const {
    return face.distance(shape.pose.at) - reach(shape, face.normal);
  }

  static bool boxes_are_apart(const Shape& a, const Shape& b) {
    for (const Vector& p : a.pose.turn.axes) {
      for (const Vector& q : b.pose.turn.axes) {
        const Vector axis = cross(p, q);
        if (axis == Vector{}) continue;
        if (abs(dot(a.pose.at - b.pose.at, axis)) > reach(a, axis) + reach(b, axis)) return true;
      }
    }
    return false;
  }

  /// Where two faces lie on each other: the corners of the polygon in which they meet.
  void face_on_face(std::size_t i, const Shape& a, std::size_t j, const Shape& b) {
    for (const Face& own : faces(a)) {
      for (const Face& other : faces(b)) {
        if (own.normal + other.normal != Vector{}) continue;
        const Rational distance = other.distance(own.centre);
        if (abs(distance) > touch_) continue;
        const std::vector<Vector> polygon = clipped(own.corners(), other);
        for (const Vector& p : polygon) add({i, j, &a, &b, p - distance * other.normal, other.normal, distance});
        if (!polygon.empty()) return;
      }
    }
  }

  void on_faces(std::size_t i, const Shape& a, std::size_t j, const Shape& b) {
    for (const Face& face : faces(b)) {
      if (least_distance(face, a) < -touch_) continue;
      for (const Vector& p : lowest(a, face)) {
        const Rational distance = face.distance(p);
        if (abs(distance) <= touch_ && face.holds(p, touch_)) {
          add({i, j, &a, &b, p - distance * face.normal, face.normal, distance});
        }
      }
    }
  }

  /// The points of a shape that may touch a face.
  std::vector<Vector> lowest(const Shape& shape, const Face& face) {
    if (shape.kind == Kind::plane) return {};
    if (shape.kind == Kind::box) return corners(shape);
    if (shape.kind == Kind::sphere) return {shape.pose.at - shape.radius * face.normal};
    const auto& axes = shape.pose.turn.axes;
    std::vector<Vector> ends;
    for (const int side : {1, -1}) ends.push_back(shape.pose.at + Rational(side) * shape.half_length * axes[2]);
    if (shape.kind == Kind::capsule || dot(axes[2], face.normal).is_zero()) {
      for (Vector& end : ends) end = end - shape.radius * face.normal;
      return ends;
    }
    if (cross(axes[2], face.normal) != Vector{}) return {};  // on its rim, at a point that need not be rational
    std::vector<Vector> rim;
    for (const Vector& end : ends) {
      for (const std::size_t axis : {0U, 1U}) {
        for (const int side : {1, -1}) rim.push_back(end + Rational(side) * shape.radius * axes[axis]);
      }
    }
    notes_.push_back(shape.name + " stands on a disc: four points of its rim touch");
    return rim;
  }

  void spheres(std::size_t i, const Shape& a, std::size_t j, const Shape& b) {
    const Vector between = a.pose.at - b.pose.at;
    const auto length = rational_root(dot(between, between));
    const Rational reach = a.radius + b.radius;
    if (!length) {
      return mistakes_.add(b.place, b.name + " touches " + a.name + ", and their distance is not rational");
    }
    const Rational distance = *length - reach;
    if (abs(distance) > touch_) {
      return mistakes_.add(b.place, b.name + " and " + a.name + " are " + distance_in_words(distance));
    }
    const Vector normal = (Rational(1) / *length) * between;
    add({i, j, &a, &b, b.pose.at + (b.radius + distance / 2) * normal, normal, distance});
  }

  void add(SpatialContact contact) {
    const auto here = [&](const SpatialContact& other) {
      const Vector d = other.at - contact.at;
      return other.shape_of == contact.shape_of && other.shape_on == contact.shape_on && dot(d, d) <= touch_ * touch_;
    };
    if (std::ranges::none_of(found_, here)) found_.push_back(std::move(contact));
  }

  const Scene& scene_;
  const Rational& touch_;
  Mistakes& mistakes_;
  std::vector<std::string>& notes_;
  std::vector<SpatialContact> found_;
};

}  // namespace

std::vector<SpatialContact> spatial_contacts(const Scene& scene, const Rational& touch, Mistakes& mistakes,
                                             std::vector<std::string>& import_notes) {
  return ShapeContacts(scene, touch, mistakes, import_notes).find();
}

std::array<Vector, 2> tangents(const Vector& n) {
  if (n == Vector{0, 0, -1}) return {Vector{1, 0, 0}, Vector{0, -1, 0}};
  // The turn that takes z to n, about the axis between them.
  const Rational s = Rational(1) / (1 + n.z);
  return {Vector{1 - s * n.x * n.x, -s * n.x * n.y, -n.x}, Vector{-s * n.x * n.y, 1 - s * n.y * n.y, -n.y}};
}

}  // namespace slipproof::imported
