#include "report/picture/mechanism_geometry.hpp"

#include <cmath>
#include <utility>

#include "base/input/diagnostic.hpp"
#include "base/number/binary64.hpp"

namespace slipproof {

namespace {

class GeometryReader {
 public:
  explicit GeometryReader(const MechanismScene& scene)
      : scene_(scene), maker_(scene.mechanism), at_(maker_.at(scene.values)) {
    if (scene.load) at_.set(maker_.compiled().load(), *scene.load);
  }

  MechanismGeometry read() {
    MechanismGeometry geometry;
    for (const MechanismShape& shape : scene_.mechanism.shapes) {
      MechanismGeometry::Outline outline{shape.kind, {}, 0, shape.text};
      for (const auto& point : shape.points) outline.points.push_back(pair(point));
      if (shape.radius) outline.radius = std::abs(number(shape.radius));
      geometry.outlines.push_back(std::move(outline));
    }
    for (std::size_t i = 0; i < scene_.mechanism.contacts.size(); ++i) {
      if (!scene_.mechanism.contacts[i].at.empty()) geometry.contacts.push_back(contact(i));
    }
    return geometry;
  }

 private:
  double number(const PlacedExpression& placed) {
    const auto value = at_.number(maker_.compiled().compile(placed.expression));
    if (value.number) return nearest_binary64(*value.number);
    const Place place = placed.place();
    throw InputError({{scene_.mechanism.file, place.line, place.column,
                       "found " + in_quotes(placed.text.text()) + ", expected a coordinate that has a value there"}});
  }
  Point pair(const std::vector<PlacedExpression>& two) { return {number(two[0]), number(two[1])}; }

  MechanismGeometry::Contact contact(std::size_t index) {
    const MechanismContact& given = scene_.mechanism.contacts[index];
    MechanismGeometry::Contact contact{index, pair(given.at), {0, 0}, {0, 0}};
    if (!given.direction.empty()) contact.normal = unit(pair(given.direction));
    // Slip is positive to the right, or upwards, unless the file gives a direction.
    contact.along = {contact.normal[1], -contact.normal[0]};
    const bool left = contact.along[0] < 0, down = contact.along[0] == 0 && contact.along[1] < 0;
    if (left || down) contact.along = {-contact.along[0], -contact.along[1]};
    if (!given.slip_direction.empty()) contact.along = unit(pair(given.slip_direction));
    return contact;
  }
  static Point unit(Point vector) {
    const double length = std::hypot(vector[0], vector[1]);
    return length > 0 ? Point{vector[0] / length, vector[1] / length} : Point{0, 0};
  }

  const MechanismScene& scene_;
  ProblemMaker maker_;
  Evaluator<Rational> at_;
};

}  // namespace

MechanismGeometry geometry_of(const MechanismScene& scene) {
  return GeometryReader(scene).read();
}

}  // namespace slipproof
