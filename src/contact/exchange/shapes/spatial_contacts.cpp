#include "contact/exchange/shapes/spatial_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/number/binary64.hpp"
#include "contact/exchange/shapes/pairs.hpp"
#include "contact/exchange/shapes/polytope.hpp"

namespace slipproof::imported {

namespace {

class SceneContacts {
 public:
  SceneContacts(const Scene& scene, const Rational& touch, Mistakes& mistakes, std::vector<std::string>& import_notes,
                Overlaps overlaps)
      : scene_(scene),
        touch_(touch),
        mistakes_(mistakes),
        notes_(import_notes),
        trees_(trees_of(scene)),
        on_ground_(scene.bodies.size()),
        overlaps_(overlaps) {
    for (const Joint& joint : scene.joints) {
      if (joint.first == 0 || joint.second == 0) on_ground_[trees_[std::max(joint.first, joint.second)]] = true;
    }
  }

  std::vector<SpatialContact> find() {
    for_each_pair(scene_, [&](std::size_t i, const Shape& a, std::size_t j, const Shape& b) { pair(i, a, j, b); });
    return std::move(found_);
  }

 private:
  void pair(std::size_t i, const Shape& a, std::size_t j, const Shape& b) {
    if (a.kind == Shape::Kind::plane && b.kind == Shape::Kind::plane) return;
    const Ball ball = ball_of(a), other = ball_of(b);
    const double touch = nearest_binary64(touch_);
    if (are_far(a, ball, b, other, touch) || are_far(b, other, a, ball, touch)) return;
    std::string why;
    const std::vector<TouchPoint> points = touching(solid(a), solid(b), touch_, why);
    for (const TouchPoint& point : points) add(i, a, j, b, point);
    if (points.size() == 4) note_rim(points[0].swapped ? b : a);
    if (why.empty()) return;
    // What stands still belongs to the robots that joints hold to it.
    const bool of_one = i == 0 ? a.kind != Shape::Kind::plane && on_ground_[trees_[j]] : trees_[i] == trees_[j];
    if (overlaps_ == Overlaps::left_out || (overlaps_ == Overlaps::within_one_robot && of_one)) {
      notes_.push_back(b.name + " and " + a.name + (of_one ? " of one robot " : " ") + why +
                       ": no contact between them");
    } else {
      mistakes_.add(b.place, b.name + " and " + a.name + " " + why);
    }
  }

  void note_rim(const Shape& shape) {
    if (shape.kind != Shape::Kind::cylinder || std::ranges::find(rims_, &shape) != rims_.end()) return;
    rims_.push_back(&shape);
    notes_.push_back(shape.name + " stands on a disc: four points of its rim touch");
  }

  struct Ball {
    Near centre{};
    double radius = 0;
  };
  /// A ball that surely holds the shape.
  static Ball ball_of(const Shape& shape) {
    Ball ball{near(shape.pose.at), 0};
    const Near half = near(shape.half);
    switch (shape.kind) {
      case Shape::Kind::box:
        ball.radius = std::sqrt(dot(half, half));
        break;
      case Shape::Kind::hull:
        for (const Vector& p : shape.points) ball.radius = std::max(ball.radius, std::sqrt(dot(near(p), near(p))));
        break;
      default:
        ball.radius = nearest_binary64(shape.radius + shape.half_length);
    }
    ball.radius *= 1 + 1e-9;
    return ball;
  }
  static bool are_far(const Shape& a, const Ball& ball, const Shape& b, const Ball& other, double touch) {
    if (b.kind == Shape::Kind::plane) return false;
    if (a.kind == Shape::Kind::plane) {
      return dot(minus(other.centre, ball.centre), near(a.pose.turn.axes[2])) > other.radius + touch * 2;
    }
    const Near between = minus(ball.centre, other.centre);
    return std::sqrt(dot(between, between)) > ball.radius + other.radius + touch * 2;
  }

  /// Faces, edges and corners are made once for each shape.
  const Solid& solid(const Shape& shape) {
    const auto [found, is_new] = solids_.try_emplace(&shape);
    if (is_new) found->second = solid_of(shape);
    return found->second;
  }

  void add(std::size_t i, const Shape& a, std::size_t j, const Shape& b, const TouchPoint& point) {
    SpatialContact contact{
        i, j, &a, &b, point.at, point.normal, point.distance, point.radius, point.on_radius, point.only_at_rest};
    if (point.swapped) {
      std::swap(contact.of, contact.on);
      std::swap(contact.shape_of, contact.shape_on);
    }
    const auto here = [&](const SpatialContact& other) {
      const Vector d = other.at - contact.at;
      return other.shape_of == contact.shape_of && other.shape_on == contact.shape_on &&
             imported::dot(d, d) <= touch_ * touch_;
    };
    if (std::ranges::none_of(found_, here)) found_.push_back(std::move(contact));
  }

  const Scene& scene_;
  const Rational& touch_;
  Mistakes& mistakes_;
  std::vector<std::string>& notes_;
  std::vector<std::size_t> trees_;
  std::vector<bool> on_ground_;  ///< trees that a joint holds to the ground
  Overlaps overlaps_;
  std::map<const Shape*, Solid> solids_;
  std::vector<const Shape*> rims_;
  std::vector<SpatialContact> found_;
};

}  // namespace

std::vector<SpatialContact> spatial_contacts(const Scene& scene, const Rational& touch, Mistakes& mistakes,
                                             std::vector<std::string>& import_notes, Overlaps overlaps) {
  return SceneContacts(scene, touch, mistakes, import_notes, overlaps).find();
}

std::array<Vector, 2> tangents(const Vector& n) {
  if (n == Vector{0, 0, -1}) return {Vector{1, 0, 0}, Vector{0, -1, 0}};
  // The turn that takes z to n, about the axis between them.
  const Rational s = Rational(1) / (1 + n.z);
  return {Vector{1 - s * n.x * n.x, -s * n.x * n.y, -n.x}, Vector{-s * n.x * n.y, 1 - s * n.y * n.y, -n.y}};
}

}  // namespace slipproof::imported
