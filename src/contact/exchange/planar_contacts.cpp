#include "contact/exchange/planar_contacts.hpp"

#include <algorithm>

namespace slipproof::imported {

namespace {

/// A side of an outline, or the edge of a half plane.
struct Side {
  Point from, along, normal;  ///< `along` and `normal` of length 1
  std::optional<Rational> length;

  Rational distance(const Point& p) const { return dot(p - from, normal); }
  bool faces(const Point& p, const Rational& touch) const {
    const Rational at = dot(p - from, along);
    return !length || (at >= -touch && at <= *length + touch);
  }
};

struct Placed {
  std::size_t body;
  const Shape* shape;
  Outline outline;
};

class OutlineContacts {
 public:
  OutlineContacts(const Scene& scene, const View& view, const Rational& touch, Mistakes& mistakes)
      : scene_(scene), view_(view), touch_(touch), mistakes_(mistakes) {}

  std::vector<PlanarContact> find() {
    for_each_pair(scene_, [&](std::size_t i, const Shape& a, std::size_t j, const Shape& b) {
      std::string why;
      const auto first = outline_of(a, view_, why), second = outline_of(b, view_, why);
      if (first && second) pair({i, &a, *first}, {j, &b, *second});
    });
    return std::move(found_);
  }

 private:
  /// The sides whose lengths are rational; those of others are never exactly where they seem.
  std::vector<Side> sides(const Placed& p) {
    std::vector<Side> result;
    if (p.outline.normal) {
      const Point& n = *p.outline.normal;
      return {{p.outline.through, {n.y, -n.x}, n, std::nullopt}};
    }
    const auto& corners = p.outline.corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point edge = corners[(i + 1) % corners.size()] - corners[i];
      const auto length = exact_root(dot(edge, edge));
      if (!length || length->is_zero()) continue;
      const Point along = (Rational(1) / *length) * edge;
      result.push_back({corners[i], along, {along.y, -along.x}, *length});
    }
    return result;
  }

  void pair(const Placed& a, const Placed& b) {
    if (a.outline.normal && b.outline.normal) return;
    const std::size_t before = found_.size();
    if (are_apart(a, b)) return;
    on_sides(a, b, before);
    on_sides(b, a, before);
    discs(a, b, before);
    if (found_.size() > before) return;
    mistakes_.add(b.shape->place, b.shape->name + " and " + a.shape->name +
                                      " are inside each other, or touch in a way that is not read (corner on corner)");
  }

  /// Whether a line keeps them apart, by more than what counts as touching. That between the nearest points of discs
  /// and corners is among those that are tried.
  bool are_apart(const Placed& a, const Placed& b) {
    const auto beyond = [&](const Placed& p, const Placed& q) {
      return std::ranges::any_of(sides(p), [&](const Side& side) { return least_distance(side, q) > touch_; });
    };
    if (beyond(a, b) || beyond(b, a)) return true;
    if (a.outline.normal || b.outline.normal) return false;
    const auto far = [&](const Placed& p, const Placed& q) {  // a disc is far from all corners, and faces no side
      if (p.outline.centres.empty()) return false;
      return std::ranges::all_of(p.outline.centres, [&](const Point& c) { return is_far(c, p.outline.radius, q); });
    };
    return far(a, b) || far(b, a);
  }

  bool is_far(const Point& centre, const Rational& radius, const Placed& other) {
    const auto beyond = [&](const Point& p, const Rational& reach) {
      const Point d = centre - p;
      return dot(d, d) > reach * reach;
    };
    for (const Point& c : other.outline.centres) {
      if (!beyond(c, radius + other.outline.radius + touch_)) return false;
    }
    for (const Point& corner : other.outline.corners) {
      if (!beyond(corner, radius + touch_)) return false;
    }
    for (const Side& side : sides(other)) {
      if (side.faces(centre, 0) && side.distance(centre) <= radius + touch_) return false;
    }
    return true;
  }

  static Rational least_distance(const Side& side, const Placed& p) {
    std::optional<Rational> least;
    const auto take = [&](const Rational& d) {
      if (!least || d < *least) least = d;
    };
    for (const Point& corner : p.outline.corners) take(side.distance(corner));
    for (const Point& centre : p.outline.centres) take(side.distance(centre) - p.outline.radius);
    return *least;
  }

  /// Corners and discs of `p` on the sides of `q` beyond which all of `p` is.
  void on_sides(const Placed& p, const Placed& q, std::size_t before) {
    if (p.outline.normal) return;
    for (const Side& side : sides(q)) {
      if (least_distance(side, p) < -touch_) continue;
      for (const Point& corner : p.outline.corners) {
        if (p.outline.has_corners) add(p, q, side, corner, 0, before);
      }
      for (const Point& centre : p.outline.centres) add(p, q, side, centre, p.outline.radius, before);
    }
  }

  void add(const Placed& p, const Placed& q, const Side& side, const Point& centre, const Rational& radius,
           std::size_t before) {
    const Rational distance = side.distance(centre) - radius;
    if (abs(distance) > touch_ || !side.faces(centre, touch_)) return;
    const Point touches = centre - radius * side.normal;
    const auto here = [&](const PlanarContact& other) {
      const Point d = other.centre - other.radius * other.normal.value_or(Point{}) - touches;
      return dot(d, d) <= 4 * touch_ * touch_;
    };
    if (std::any_of(found_.begin() + static_cast<std::ptrdiff_t>(before), found_.end(), here)) return;
    found_.push_back({p.body, q.body, p.shape, q.shape, centre, radius, side.normal, touches, 0, distance});
  }

  void discs(const Placed& a, const Placed& b, std::size_t before) {
    if (found_.size() > before) return;
    for (const Point& c : a.outline.centres) {
      for (const Point& d : b.outline.centres) {
        const Point between = c - d;
        const Rational reach = a.outline.radius + b.outline.radius, square = dot(between, between);
        if (square > (reach + touch_) * (reach + touch_) || square < (reach - touch_) * (reach - touch_)) continue;
        const auto length = exact_root(square);
        if (!length) {
          mistakes_.add(b.shape->place, b.shape->name + " touches " + a.shape->name +
                                            ", but not exactly, and their distance is not rational");
          continue;
        }
        found_.push_back({a.body, b.body, a.shape, b.shape, c, a.outline.radius, std::nullopt, d,
                          *length - a.outline.radius, *length - reach});
      }
    }
  }

  const Scene& scene_;
  const View& view_;
  const Rational& touch_;
  Mistakes& mistakes_;
  std::vector<PlanarContact> found_;
};

}  // namespace

std::vector<PlanarContact> planar_contacts(const Scene& scene, const View& view, const Rational& touch,
                                           Mistakes& mistakes) {
  return OutlineContacts(scene, view, touch, mistakes).find();
}

}  // namespace slipproof::imported
