#include "report/picture/mechanism_geometry.hpp"

#include <cmath>
#include <utility>

#include "base/input/diagnostic.hpp"
#include "base/number/binary64.hpp"
#include "mechanics/bodies/frame.hpp"

namespace slipproof {

namespace {

class GeometryReader {
 public:
  explicit GeometryReader(const MechanismScene& scene)
      : scene_(scene), maker_(scene.mechanism), at_(maker_.at(scene.values)) {
    const bool positive = maker_.load_domain(scene.values).contains(Rational(1));
    if (scene.mechanism.load)
      at_.set(maker_.compiled().load(), scene.load.value_or(positive ? Rational(1) : Rational(-1)));
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
    if (scene_.mechanism.bodies) add_pushes(*scene_.mechanism.bodies, geometry);
    return geometry;
  }

 private:
  void add_pushes(const Bodies& bodies, MechanismGeometry& geometry) {
    using namespace bodies_in_motion;
    const std::vector<bodies_in_motion::Frame> at = frames(bodies);
    const auto point = [&](const PlanarVector& v) { return Point{number(v.x), number(v.y)}; };
    for (const BodyForce& force : bodies.forces) {
      const PlanarVector is = unplaced(force.is);
      const Point push = point(force.follows ? at[force.on].in_scene(is) : is);
      const double size = std::hypot(push[0], push[1]);
      const PlanarVector place = at[force.on].at + at[force.on].in_scene(unplaced(force.at));
      if (size > 0) geometry.pushes.push_back({point(place), unit(push), size, name_of(force.is)});
    }
    for (const BodyTorque& torque : bodies.torques) {
      const double size = number(torque.is);
      if (size != 0) geometry.pushes.push_back({point(at[torque.on].at), {0, 0}, size, text_of(torque.is)});
    }
  }

  /// Without the sign, which the arrow shows. A product that has the size of the load has its name.
  std::string text_of(const PlacedExpression& placed) {
    const Expression& e = placed.expression;
    std::string text = to_string(e->operation == Operation::negate ? e->operands[0] : e);
    const auto& load = scene_.mechanism.load;
    const bool compound = text.find_first_of("*+/( ") != text.npos;
    if (!compound || !load || !scene_.load) return text;
    const auto size = at_.number(maker_.compiled().compile(e));
    return size.number && (*size.number == *scene_.load || -*size.number == *scene_.load) ? load->symbol : text;
  }
  std::string name_of(const PlacedPair& pair) {
    if (is_literal_zero(pair.x.expression)) return text_of(pair.y);
    if (is_literal_zero(pair.y.expression)) return text_of(pair.x);
    return "(" + to_string(pair.x.expression) + ", " + to_string(pair.y.expression) + ")";
  }

  double number(const Expression& expression) { return number(PlacedExpression{expression, {}}); }
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
