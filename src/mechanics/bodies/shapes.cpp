// The picture that follows from bodies: their outlines, or lines through their points where they have none, and joints.
#include "mechanics/bodies/parts.hpp"

namespace slipproof::bodies_in_motion {

namespace {

using Kind = MechanismShape::Kind;

class Picture {
 public:
  explicit Picture(Derivation& derivation) : d_(derivation), drawn_(derivation.bodies.bodies.size()) {}

  void draw() {
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
      for (const BodyShape& shape : d_.bodies.bodies[i].shapes) outline(i, shape);
    }
    for (const BodyContact& contact : d_.bodies.contacts) {
      note(contact.of, contact.point);
      if (contact.radius) disc(contact.of, contact.point, contact.radius, contact.place);
      if (contact.on_radius) disc(contact.on, contact.on_point, contact.on_radius, contact.place);
    }
    for (const BodyForce& force : d_.bodies.forces) note(force.on, force.at);
    for (const BodyJoint& joint : d_.bodies.joints) this->joint(joint);
    for (std::size_t i = 0; i < drawn_.size(); ++i) body_without_shape(i);
  }

 private:
  void add(Kind kind, const std::vector<SceneVector>& points, Place place, const Expression& radius = nullptr) {
    MechanismShape shape;
    shape.kind = kind;
    for (const SceneVector& point : points) shape.points.push_back(d_.derived(point, place));
    if (radius) shape.radius = d_.derived(radius, place);
    shape.place = place;
    d_.mechanism.shapes.push_back(std::move(shape));
  }

  SceneVector placed(std::size_t body, const SceneVector& own) const {
    return d_.frames[body].at + d_.frames[body].in_scene(own);
  }
  SceneVector placed(std::size_t body, const PlacedVector& own) const { return placed(body, unplaced(own)); }

  void outline(std::size_t body, const BodyShape& shape) {
    std::vector<SceneVector> points;
    for (const PlacedVector& point : shape.points) points.push_back(placed(body, point));
    if (shape.kind == BodyShape::Kind::box) {
      const Expression half = quotient_of(make_number(1), make_number(2));
      const Expression w = times(half, unplaced(shape.width)), h = times(half, unplaced(shape.height));
      const SceneVector centre = shape.points.empty() ? unplaced(PlacedVector{}) : unplaced(shape.points[0]);
      points.clear();
      for (const auto& corner : {SceneVector{negative_of(w), negative_of(h)}, SceneVector{w, negative_of(h)},
                                 SceneVector{w, h}, SceneVector{negative_of(w), h}}) {
        points.push_back(placed(body, centre + corner));
      }
    } else if (shape.kind == BodyShape::Kind::circle) {
      if (points.empty()) points.push_back(d_.frames[body].at);
      return add(Kind::circle, points, shape.place, unplaced(shape.radius));
    }
    add(shape.kind == BodyShape::Kind::line ? Kind::line : Kind::polygon, points, shape.place);
  }

  /// A disc that no shape of its body draws.
  void disc(std::size_t body, const PlacedVector& centre, const PlacedExpression& radius, Place place) {
    if (!d_.bodies.bodies[body].shapes.empty()) return;
    const Expression size = unplaced(radius);
    add(Kind::circle, {placed(body, centre)}, place, make(Operation::absolute, {size}));
  }

  void note(std::size_t body, const PlacedVector& point) {
    const SceneVector own = unplaced(point);
    for (const SceneVector& known : drawn_[body].points) {
      if (same(known.x, own.x) && same(known.y, own.y)) return;
    }
    drawn_[body].points.push_back(own);
  }

  void joint(const BodyJoint& joint) {
    using Joint = BodyJoint::Kind;
    if (joint.kind == Joint::gear) return;
    const SceneVector first = placed(joint.first, joint.at);
    note(joint.first, joint.at);
    if (joint.to) note(joint.second, joint.to);
    if (joint.kind == Joint::rod || joint.kind == Joint::rope || joint.kind == Joint::spring) {
      add(Kind::line, {first, placed(joint.second, joint.to)}, joint.place);
    } else if (joint.kind == Joint::pin) {
      if (!joint.to)
        drawn_[joint.second].points.push_back(d_.frames[joint.second].in_body(first - d_.frames[joint.second].at));
      add(Kind::point, {first}, joint.place);
    }
  }

  /// From its centre to each of its points.
  void body_without_shape(std::size_t body) {
    const Body& one = d_.bodies.bodies[body];
    if (!one.shapes.empty() || one.is_prescribed()) return;
    for (const SceneVector& own : drawn_[body].points) {
      if (is_literal_zero(own.x) && is_literal_zero(own.y)) continue;
      add(Kind::line, {d_.frames[body].at, placed(body, own)}, one.place);
    }
    add(Kind::point, {d_.frames[body].at}, one.place);
  }

  struct Drawn {
    std::vector<SceneVector> points;  ///< in the body's axes
  };
  Derivation& d_;
  std::vector<Drawn> drawn_;
};

}  // namespace

void draw_shapes(Derivation& derivation) {
  if (derivation.in_space()) return;
  Picture(derivation).draw();
}

}  // namespace slipproof::bodies_in_motion
