#include "mechanics/checks/drawing/drawing.hpp"

#include <algorithm>

namespace slipproof::mechanism_checks::drawn {

using bodies_in_motion::Frame;

void Box::take(const Spot& place, const Rational& reach) {
  low = {std::min(low.x, place.x - reach), std::min(low.y, place.y - reach), std::min(low.z, place.z - reach)};
  high = {std::max(high.x, place.x + reach), std::max(high.y, place.y + reach), std::max(high.z, place.z + reach)};
}

bool Box::holds(const Spot& place) const {
  for (std::size_t i = 0; i < 3; ++i) {
    if (place[i] < low[i] || high[i] < place[i]) return false;
  }
  return true;
}

Drawing::Drawing(const Bodies& scene, const std::vector<Frame>& frames, const ProblemMaker& maker,
                 const MechanismValues& values)
    : scene_(scene), frames_(frames), compiled_(maker.compiled()), at_(maker.at(values)) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    axes_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) axes_[i][k] = spot(frames[i].in_scene(bodies_in_motion::axis(k)));
    outlines_.emplace_back();
    for (const BodyShape& shape : scene.bodies[i].shapes) outlines_[i].push_back(outline(i, shape));
  }
}

Rational Drawing::number(const Expression& expression) {
  const auto value = at_.number(compiled_.compile(expression)).number;
  has_values_ = has_values_ && value;
  return value.value_or(0);
}

Spot Drawing::direction(std::size_t body, const PlacedVector& vector) {
  const Spot in_body = own(vector);
  const auto& [x, y, z] = axes_[body];
  return in_body.x * x + in_body.y * y + in_body.z * z;
}

Spot Drawing::touches(const BodyContact& contact) {
  return place(contact.of, contact.point) - number(contact.radius) * direction(contact.on, contact.normal);
}

std::vector<Spot> Drawing::corners_of(const BodyShape& shape) {
  std::vector<Spot> corners;
  for (const PlacedVector& point : shape.points) corners.push_back(own(point));
  using Kind = BodyShape::Kind;
  if (shape.kind == Kind::polygon || shape.kind == Kind::line || shape.kind == Kind::hull) return corners;
  const Spot middle = corners.empty() ? Spot() : corners[0];
  if (shape.kind == Kind::circle || shape.kind == Kind::sphere) return {middle};
  const Rational height = number(shape.height) / 2;
  if (shape.kind != Kind::box) {
    const Spot along = height * (shape.axis ? own(shape.axis) : Spot{0, 0, 1});
    return {middle - along, middle + along};
  }
  const Rational width = number(shape.width) / 2;
  if (!shape.depth) {
    const Spot across{width, 0, 0}, up{0, height, 0};
    return {middle - across - up, middle + across - up, middle + across + up, middle - across + up};
  }
  corners.clear();
  for (unsigned corner = 0; corner < 8; ++corner) {
    const auto side = [&](unsigned bit) { return Rational((corner & bit) == 0 ? -1 : 1); };
    corners.push_back(middle + Spot{side(1) * width, side(2) * number(shape.depth) / 2, side(4) * height});
  }
  return corners;
}

Outline Drawing::outline(std::size_t body, const BodyShape& shape) {
  Outline result;
  result.own = corners_of(shape);
  for (const Spot& corner : result.own) {
    const auto& [x, y, z] = axes_[body];
    result.corners.push_back(centre(body) + corner.x * x + corner.y * y + corner.z * z);
  }
  result.radius = number(shape.radius);
  result.blunt = shape.kind == BodyShape::Kind::cylinder;
  return result;
}

bool Drawing::is_convex(std::size_t body) const {
  if (outlines_[body].size() != 1) return false;
  if (scene_.bodies[body].shapes[0].kind != BodyShape::Kind::polygon) return true;
  const auto& c = outlines_[body][0].corners;
  int turn = 0;
  for (std::size_t i = 0; i < c.size() && c.size() > 2; ++i) {
    const Spot &next = c[(i + 1) % c.size()], &last = c[(i + 2) % c.size()];
    const int here = cross(next - c[i], last - next).z.sign();
    if (turn * here < 0) return false;
    if (here != 0) turn = here;
  }
  return true;
}

Box Drawing::box(std::size_t body) {
  Box result(centre(body));
  for (const Outline& outline : outlines_[body]) {
    for (const Spot& corner : outline.corners) result.take(corner, outline.radius);
  }
  for (const BodyContact& c : scene_.contacts) {
    if (c.of == body) result.take(place(body, c.point), abs(number(c.radius)));
  }
  return result;
}

std::optional<Box> Drawing::own_box(std::size_t body) const {
  std::optional<Box> result;
  for (const Outline& outline : outlines_[body]) {
    for (const Spot& corner : outline.own) {
      if (!result) result.emplace(corner);
      result->take(corner, outline.radius);
    }
  }
  return result;
}

}  // namespace slipproof::mechanism_checks::drawn
