#include "report/picture/space/solid.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "report/picture/space/flat.hpp"

namespace slipproof {

double extent(const std::vector<Vec3>& points) {
  double most = 0;
  for (const Vec3& p : points) most = std::max(most, length(p - points.front()));
  return most;
}

namespace {

constexpr int round_sides = 28;
/// Faces that meet at a smaller angle stand for a round surface.
const double smooth_cosine = std::cos(0.45);

/// Sets the normals (Newell), and finds the edges.
Solid finished(Solid solid) {
  std::map<std::pair<std::size_t, std::size_t>, Solid::Edge> edges;
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    Solid::Face& face = solid.faces[f];
    Vec3 sum{};
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const std::size_t from = face.corners[i], to = face.corners[(i + 1) % face.corners.size()];
      sum = sum + cross(solid.corners[from] - solid.corners[face.corners[0]],
                        solid.corners[to] - solid.corners[face.corners[0]]);
      Solid::Edge& edge = edges[std::minmax(from, to)];
      edge.from = from, edge.to = to;
      edge.faces.push_back(f);
    }
    face.normal = direction_of(sum);
  }
  for (auto& [ends, edge] : edges) {
    edge.smooth = edge.faces.size() == 2 &&
                  dot(solid.faces[edge.faces[0]].normal, solid.faces[edge.faces[1]].normal) > smooth_cosine;
    solid.edges.push_back(std::move(edge));
  }
  return solid;
}

/// Rings of corners around an axis, from below to above, closed by a corner or a face at both ends.
class Turned {
 public:
  Turned(const Vec3& centre, const Vec3& axis) : centre_(centre), axis_(direction_of(axis)), across_(axis_) {}

  void ring(double height, double radius) {
    const std::size_t first = solid_.corners.size();
    for (int i = 0; i < round_sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / round_sides;
      solid_.corners.push_back(centre_ + height * axis_ + radius * std::cos(angle) * across_.first +
                               radius * std::sin(angle) * across_.second);
    }
    if (first > 0) {
      for (std::size_t i = 0; i < sides(); ++i) {
        const std::size_t next = (i + 1) % sides();
        solid_.faces.push_back({{first - sides() + i, first - sides() + next, first + next, first + i}, {}});
      }
    }
  }
  Solid closed() {
    Solid::Face below, above;
    const std::size_t top = solid_.corners.size() - sides();
    for (std::size_t i = 0; i < sides(); ++i) {
      below.corners.push_back(sides() - 1 - i);
      above.corners.push_back(top + i);
    }
    solid_.faces.push_back(std::move(below));
    solid_.faces.push_back(std::move(above));
    return finished(std::move(solid_));
  }

 private:
  static constexpr std::size_t sides() { return static_cast<std::size_t>(round_sides); }
  Vec3 centre_, axis_;
  AcrossDirections across_;
  Solid solid_;
};

/// Grows the hull by one point after the other: faces that see it go, and their border is joined to it.
class HullMaker {
 public:
  explicit HullMaker(const std::vector<Vec3>& points) : points_(points), close_(1e-9 * extent(points)) {}

  std::vector<std::array<std::size_t, 3>> triangles() {
    if (!begin()) return {};
    for (std::size_t i = 0; i < points_.size(); ++i) add(i);
    return triangles_;
  }

 private:
  Vec3 normal(const std::array<std::size_t, 3>& t) const {
    return direction_of(cross(points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[0]]));
  }
  double above(const std::array<std::size_t, 3>& t, std::size_t point) const {
    return dot(normal(t), points_[point] - points_[t[0]]);
  }
  template <class Measure>
  std::size_t farthest(const Measure& measure) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      if (measure(i) > measure(best)) best = i;
    }
    return best;
  }

  /// A tetrahedron of points that are far from each other.
  bool begin() {
    const std::size_t a = 0, b = farthest([&](std::size_t i) { return length(points_[i] - points_[a]); });
    const Vec3 line = direction_of(points_[b] - points_[a]);
    const std::size_t c = farthest([&](std::size_t i) { return length(cross(line, points_[i] - points_[a])); });
    if (length(cross(line, points_[c] - points_[a])) <= close_) return false;
    const std::size_t d = farthest([&](std::size_t i) { return std::abs(above({a, b, c}, i)); });
    const double side = above({a, b, c}, d);
    if (std::abs(side) <= close_) return false;
    triangles_ = {{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
    if (side > 0) {
      for (auto& t : triangles_) std::swap(t[1], t[2]);
    }
    return true;
  }

  void add(std::size_t point) {
    std::set<std::pair<std::size_t, std::size_t>> border;
    std::vector<std::array<std::size_t, 3>> kept;
    for (const auto& t : triangles_) {
      if (above(t, point) <= close_) {
        kept.push_back(t);
        continue;
      }
      for (std::size_t i = 0; i < 3; ++i) {
        if (border.erase({t[(i + 1) % 3], t[i]}) == 0) border.emplace(t[i], t[(i + 1) % 3]);
      }
    }
    for (const auto& [from, to] : border) kept.push_back({from, to, point});
    triangles_ = std::move(kept);
  }

  const std::vector<Vec3>& points_;
  double close_;
  std::vector<std::array<std::size_t, 3>> triangles_;
};

/// The hull of points in one plane; nothing where they are in none, or on a line.
std::vector<Vec3> flat_hull(const std::vector<Vec3>& points) {
  const double close = 1e-9 * extent(points);
  Vec3 normal{};
  for (const Vec3& p : points) {
    for (const Vec3& q : points) {
      const Vec3 across = cross(p - points.front(), q - points.front());
      if (length(across) > length(normal)) normal = across;
    }
  }
  if (length(normal) <= close * extent(points)) return {};
  normal = direction_of(normal);
  const AcrossDirections across(normal);
  std::vector<Point> flat;
  for (const Vec3& p : points) {
    const Vec3 arm = p - points.front();
    if (std::abs(dot(normal, arm)) > close) return {};
    flat.push_back({dot(across.first, arm), dot(across.second, arm)});
  }
  std::vector<Vec3> hull;
  for (const Point& p : hull_of(flat)) hull.push_back(points.front() + p[0] * across.first + p[1] * across.second);
  return hull;
}

/// Joins triangles of one plane to faces.
std::vector<Solid::Face> joined(const std::vector<Vec3>& points, std::vector<std::array<std::size_t, 3>> triangles) {
  std::vector<Solid::Face> faces;
  while (!triangles.empty()) {
    const auto first = triangles.front();
    const Vec3 normal = direction_of(cross(points[first[1]] - points[first[0]], points[first[2]] - points[first[0]]));
    std::map<std::size_t, std::size_t> next;
    const auto in_plane = [&](const std::array<std::size_t, 3>& t) {
      const Vec3 own = direction_of(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
      return dot(own, normal) > 1 - 1e-9 &&
             std::abs(dot(normal, points[t[0]] - points[first[0]])) < 1e-7 * extent(points);
    };
    std::set<std::pair<std::size_t, std::size_t>> border;
    for (const auto& t : triangles) {
      for (std::size_t i = 0; in_plane(t) && i < 3; ++i) {
        if (border.erase({t[(i + 1) % 3], t[i]}) == 0) border.emplace(t[i], t[(i + 1) % 3]);
      }
    }
    std::erase_if(triangles, in_plane);
    for (const auto& [from, to] : border) next[from] = to;
    Solid::Face face;
    for (std::size_t at = next.begin()->first; face.corners.size() < next.size(); at = next[at])
      face.corners.push_back(at);
    faces.push_back(std::move(face));
  }
  return faces;
}

/// Positive: the second solid is beyond a face of the first, by so much; whether that face is seen.
struct Apart {
  double by = 0;
  bool seen = false;
};
Apart beyond_a_face(const Solid& one, const Solid& other, const Vec3& towards) {
  Apart best{std::numeric_limits<double>::lowest(), false};
  for (const Solid::Face& face : one.faces) {
    const Vec3& origin = one.corners[face.corners[0]];
    const double facing = dot(face.normal, towards);
    for (const double side : one.faces.size() == 1 ? std::vector<double>{1, -1} : std::vector<double>{1}) {
      double least = std::numeric_limits<double>::max();
      for (const Vec3& p : other.corners) least = std::min(least, side * dot(face.normal, p - origin));
      if (std::abs(facing) > 1e-9 && least > best.by) best = {least, side * facing > 0};
    }
  }
  return best;
}

}  // namespace

Vec3 Solid::middle() const {
  Vec3 sum{};
  for (const Vec3& p : corners) sum = sum + p;
  return (1 / static_cast<double>(std::max<std::size_t>(corners.size(), 1))) * sum;
}

Solid box_solid(const Vec3& centre, const Vec3& size) {
  std::vector<Vec3> corners;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) corners.push_back(centre + Vec3{x * size[0], y * size[1], z * size[2]});
    }
  }
  return hull_solid(corners);
}

Solid sphere_solid(const Vec3& centre, double radius) {
  return cylinder_solid(centre, {0, 0, 1}, radius, 0, true);
}

Solid cylinder_solid(const Vec3& centre, const Vec3& axis, double radius, double length, bool round_ends) {
  Turned turned(centre, axis);
  const int rings = round_ends ? round_sides / 4 : 0;
  const auto end = [&](int i, double side) {  // from the rim to near the pole
    const double angle = (rings == 0 ? 0 : i * (std::numbers::pi / 2 - 0.05) / rings);
    turned.ring(side * (length / 2 + radius * std::sin(angle)), radius * std::cos(angle));
  };
  for (int i = rings; i >= 0; --i) end(i, -1);
  for (int i = length > 0 ? 0 : 1; i <= rings; ++i) end(i, 1);
  return turned.closed();
}

Solid hull_solid(const std::vector<Vec3>& points) {
  Solid solid{points, {}, {}};
  if (const std::vector<Vec3> flat = flat_hull(points); flat.size() >= 3) return flat_solid(flat);
  solid.faces = joined(points, HullMaker(points).triangles());
  return finished(std::move(solid));
}

Solid flat_solid(const std::vector<Vec3>& corners) {
  Solid solid{corners, {Solid::Face{}}, {}};
  for (std::size_t i = 0; i < corners.size(); ++i) solid.faces[0].corners.push_back(i);
  return finished(std::move(solid));
}

std::vector<std::size_t> painting_order(const std::vector<Solid>& solids, const Vec3& towards) {
  const std::size_t count = solids.size();
  std::vector<std::vector<bool>> hides(count, std::vector<bool>(count));  // [i][j]: i hides j
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const double touch = -1e-6 * (extent(solids[i].corners) + extent(solids[j].corners));
      const Apart one = beyond_a_face(solids[i], solids[j], towards),
                  two = beyond_a_face(solids[j], solids[i], towards);
      bool second = dot(towards, solids[j].middle()) > dot(towards, solids[i].middle());
      if (std::max(one.by, two.by) > touch) second = one.by >= two.by ? one.seen : !two.seen;
      hides[i][j] = !second, hides[j][i] = second;
    }
  }
  std::vector<std::size_t> order;
  std::vector<bool> done(count);
  while (order.size() < count) {
    std::size_t best = count, fewest = count + 1;
    for (std::size_t i = 0; i < count; ++i) {
      if (done[i]) continue;
      std::size_t behind = 0;
      for (std::size_t j = 0; j < count; ++j) behind += !done[j] && hides[i][j] ? 1 : 0;
      if (behind < fewest) best = i, fewest = behind;
    }
    done[best] = true;
    order.push_back(best);
  }
  return order;
}

}  // namespace slipproof
