// What a drawing of bodies shows at a glance, as exact positions at points of the domain: a finding is one that holds
// at all of them, or for pins of wheels at half. It speaks of the places of contacts, pins and forces and of outlines
// that are convex; where a body has none, its points stand for it.
#include <algorithm>

#include "mechanics/bodies/frame.hpp"
#include "mechanics/checks/check_parts.hpp"

namespace slipproof::mechanism_checks {

namespace drawn {

namespace {

using bodies_in_motion::Frame;
using bodies_in_motion::SceneVector;

struct Spot {
  Rational x, y;
  bool operator==(const Spot&) const = default;
};
Spot operator-(const Spot& a, const Spot& b) {
  return {a.x - b.x, a.y - b.y};
}
Spot operator+(const Spot& a, const Spot& b) {
  return {a.x + b.x, a.y + b.y};
}
Rational dot(const Spot& a, const Spot& b) {
  return a.x * b.x + a.y * b.y;
}
Rational cross(const Spot& a, const Spot& b) {
  return a.x * b.y - a.y * b.x;
}

/// The corners of an outline, or the centre of a disc.
struct Outline {
  std::vector<Spot> corners;
  Rational radius = 0;
};

/// Where all bodies are at one point of the domain.
class Drawing {
 public:
  Drawing(const Bodies& scene, const std::vector<Frame>& frames, const CheckPoints& points, const CheckPoint& point)
      : scene_(scene), frames_(frames), compiled_(points.maker().compiled()), at_(points.maker().at(point.values)) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      outlines_.emplace_back();
      for (const BodyShape& shape : scene.bodies[i].shapes) outlines_[i].push_back(outline(i, shape));
    }
  }

  /// Whether all that was asked for has a value there; what divides by 0 has none.
  bool has_values() const { return has_values_; }

  Rational number(const Expression& expression) {
    const auto value = at_.number(compiled_.compile(expression)).number;
    has_values_ = has_values_ && value;
    return value.value_or(0);
  }
  Rational number(const PlacedExpression& placed) { return placed ? number(placed.expression) : Rational(0); }
  Spot spot(const SceneVector& v) { return {number(v.x), number(v.y)}; }
  Spot centre(std::size_t body) { return spot(frames_[body].at); }
  Spot direction(std::size_t body, const PlacedVector& own) {
    return spot(frames_[body].in_scene(bodies_in_motion::unplaced(own)));
  }
  Spot place(std::size_t body, const PlacedVector& own) { return centre(body) + direction(body, own); }

  const std::vector<Outline>& outlines(std::size_t body) const { return outlines_[body]; }
  /// Whether all is inside one convex outline: only then a line along its side leaves it on one side.
  bool is_convex(std::size_t body) const {
    if (outlines_[body].size() != 1) return false;
    const auto& c = outlines_[body][0].corners;
    int turn = 0;
    for (std::size_t i = 0; i < c.size() && c.size() > 2; ++i) {
      const int here = cross(c[(i + 1) % c.size()] - c[i], c[(i + 2) % c.size()] - c[(i + 1) % c.size()]).sign();
      if (turn * here < 0) return false;
      if (here != 0) turn = here;
    }
    return true;
  }

  /// The box along x and y around what is known of a body.
  struct Box {
    Spot low, high;
    void take(const Spot& p, const Rational& reach) {
      low = {std::min(low.x, p.x - reach), std::min(low.y, p.y - reach)};
      high = {std::max(high.x, p.x + reach), std::max(high.y, p.y + reach)};
    }
    bool holds(const Spot& p) const { return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y; }
  };
  Box box(std::size_t body) {
    Box result{centre(body), centre(body)};
    for (const Outline& outline : outlines_[body]) {
      for (const Spot& corner : outline.corners) result.take(corner, outline.radius);
    }
    for (const BodyContact& c : scene_.contacts) {
      if (c.of == body) result.take(place(body, c.point), abs(number(c.radius)));
    }
    return result;
  }

 private:
  Outline outline(std::size_t body, const BodyShape& shape) {
    Outline result;
    for (const PlacedVector& point : shape.points) result.corners.push_back(place(body, point));
    if (shape.kind != BodyShape::Kind::box && shape.kind != BodyShape::Kind::circle) return result;
    if (result.corners.empty()) result.corners.push_back(centre(body));
    result.radius = number(shape.radius);
    if (shape.kind == BodyShape::Kind::circle) return result;
    const Spot middle = result.corners[0];
    const Rational w = number(shape.width) / 2, h = number(shape.height) / 2, c = number(frames_[body].turn.entry(0, 0)),
                   s = number(frames_[body].turn.entry(1, 0));
    const Spot across{w * c, w * s}, up{-h * s, h * c};
    result.corners = {middle - across - up, middle + across - up, middle + across + up, middle - across + up};
    return result;
  }

  const Bodies& scene_;
  const std::vector<Frame>& frames_;
  const CompiledMechanism& compiled_;
  Evaluator<Rational> at_;
  bool has_values_ = true;
  std::vector<std::vector<Outline>> outlines_;
};

/// How far an outline reaches along a direction at most, as seen from a place; of a disc with the square of that.
bool reaches_beyond(const Outline& outline, const Spot& place, const Spot& direction) {
  return std::ranges::any_of(outline.corners, [&](const Spot& corner) {
    const Rational along = dot(corner - place, direction);
    if (outline.radius.is_zero()) return along.sign() > 0;
    const Rational reach = outline.radius * outline.radius * dot(direction, direction);
    return along.sign() > 0 || along * along < reach;
  });
}

/// Whether two convex outlines have more in common than a border. Discs are compared with discs only.
bool overlap(const Outline& a, const Outline& b) {
  if (!a.radius.is_zero() && !b.radius.is_zero()) {
    const Spot between = a.corners[0] - b.corners[0];
    return dot(between, between) < (a.radius + b.radius) * (a.radius + b.radius);
  }
  if (!a.radius.is_zero() || !b.radius.is_zero() || a.corners.size() < 3 || b.corners.size() < 3) return false;
  const auto separates = [](const Outline& one, const Outline& other) {
    for (std::size_t i = 0; i < one.corners.size(); ++i) {
      const Spot side = one.corners[(i + 1) % one.corners.size()] - one.corners[i], normal{side.y, -side.x};
      const bool own = reaches_beyond(one, one.corners[i], normal);  // then the other direction points out
      const Spot out = own ? Spot{-normal.x, -normal.y} : normal;
      const auto beyond = [&](const Spot& p) { return dot(p - one.corners[i], out).sign() >= 0; };
      if (std::ranges::all_of(other.corners, beyond)) return true;
    }
    return false;
  };
  return !separates(a, b) && !separates(b, a);
}

/// Whether a line runs along sides of outlines all of which end before a place on it.
bool ends_before(const std::vector<Outline>& outlines, const Spot& place, const Spot& along) {
  bool runs_along = false;
  for (const auto& [c, unused] : outlines) {
    for (std::size_t i = 0; i < c.size(); ++i) {
      const Spot a = c[i] - place, b = c[(i + 1) % c.size()] - place;
      if (a == b || !cross(a, along).is_zero() || !cross(b, along).is_zero()) continue;
      if (dot(a, along).sign() * dot(b, along).sign() <= 0) return false;
      runs_along = true;
    }
  }
  return runs_along;
}

class DrawingCheck {
 public:
  explicit DrawingCheck(const CheckPoints& points) : m_(points.mechanism()), scene_(*m_.bodies) {
    frames_ = bodies_in_motion::frames(scene_);
    for (const CheckPoint& point : points.all()) {
      if (drawings_.size() == CheckPoints::enough) break;
      drawings_.emplace_back(scene_, frames_, points, point);
    }
  }

  std::vector<MechanismFinding> check() {
    for (std::size_t i = 0; i < scene_.contacts.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) same_place(scene_.contacts[k], scene_.contacts[i]);
      sides(scene_.contacts[i]);
      end_of_face(scene_.contacts[i]);
    }
    for (const BodyJoint& joint : scene_.joints) pin(joint);
    for (const BodyForce& force : scene_.forces) pushed(force);
    gravity();
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) in_each_other(k, i);
    }
    return std::move(findings_);
  }

 private:
  template <class Holds>
  bool always(const Holds& holds) {
    return std::ranges::all_of(drawings_, [&](Drawing& d) { return holds(d) && d.has_values(); });
  }
  /// Of what a drawing means for all sizes: at half of the points it is no accident of the sizes there.
  template <class Holds>
  bool often(const Holds& holds) {
    const auto seen = [&](Drawing& d) { return holds(d) && d.has_values(); };
    return 2 * std::ranges::count_if(drawings_, seen) >= static_cast<std::ptrdiff_t>(drawings_.size());
  }
  void find(Place place, std::string message) {
    findings_.push_back(warning(MechanismFinding::Check::geometry, place, std::move(message)));
  }
  const std::string& name(const BodyContact& contact) const { return m_.contacts[contact.contact].name; }
  const std::string& name(std::size_t body) const { return scene_.bodies[body].name; }

  static Spot touches(Drawing& drawing, const BodyContact& c) {
    const Spot centre = drawing.place(c.of, c.point), n = drawing.direction(c.on, c.normal);
    const Rational radius = drawing.number(c.radius);
    return centre - Spot{radius * n.x, radius * n.y};
  }

  void same_place(const BodyContact& a, const BodyContact& b) {
    if (a.of != b.of || a.on != b.on || a.on_radius || b.on_radius) return;
    const auto same = [&](Drawing& d) {
      return touches(d, a) == touches(d, b) && d.direction(a.on, a.normal) == d.direction(b.on, b.normal);
    };
    if (always(same)) find(b.place, "the contacts " + name(a) + " and " + name(b) + " are at one place, expected two");
  }

  /// The body that has the point is on the side to which the normal points, the other one on the other side.
  void sides(const BodyContact& c) {
    if (c.on_radius) return;
    const auto wrong_side = [&](std::size_t body, int side, bool all) {
      return always([&](Drawing& d) {
        const Spot n = d.direction(c.on, c.normal), out{side * n.x, side * n.y}, at = touches(d, c);
        const auto beyond = [&](const Outline& outline) { return reaches_beyond(outline, at, out); };
        if (!all) return d.is_convex(body) && std::ranges::any_of(d.outlines(body), beyond);
        return dot(d.centre(body) - at, out).sign() > 0;
      });
    };
    if (c.of != ground && !scene_.bodies[c.of].is_prescribed() && wrong_side(c.of, -1, true)) {
      return find(c.normal.place, name(c) + ": the normal points away from the centre of " + name(c.of) +
                                      ", which it pushes, expected one out of " + name(c.on));
    }
    if (m_.contacts[c.contact].bilateral) return;  // a groove is inside
    if (!c.radius && wrong_side(c.of, -1, false)) {
      return find(c.normal.place, name(c) + ": the line that is touched cuts through " + name(c.of) +
                                      ", expected all of it on the side of the normal");
    }
    if (wrong_side(c.on, 1, false)) {
      find(c.normal.place, name(c) + ": the line that is touched cuts through " + name(c.on) +
                               ", expected all of it on the other side of the normal");
    }
  }

  void end_of_face(const BodyContact& c) {
    if (c.on_radius) return;
    const auto beyond = [&](Drawing& d) {
      const Spot n = d.direction(c.on, c.normal);
      return ends_before(d.outlines(c.on), touches(d, c), {n.y, -n.x});
    };
    if (!always(beyond)) return;
    find(c.point.place, name(c) + ": it is beyond the end of the face of " + name(c.on) + ", expected a place on it");
  }

  bool is_wheel(std::size_t body) const {
    return std::ranges::any_of(scene_.contacts, [&](const BodyContact& c) { return c.of == body && c.radius; });
  }
  bool has_extent(std::size_t body) const { return !scene_.bodies[body].shapes.empty() || is_wheel(body); }
  bool is_geared(std::size_t body) const {
    return std::ranges::any_of(scene_.joints, [&](const BodyJoint& j) {
      return j.kind == BodyJoint::Kind::gear && (j.first == body || j.second == body);
    });
  }

  /// A pin is somewhere on both bodies; on one that a gear turns, in its centre.
  void pin(const BodyJoint& joint) {
    if (joint.kind != BodyJoint::Kind::pin && joint.kind != BodyJoint::Kind::weld) return;
    for (const std::size_t body : {joint.first, joint.second}) {
      if (scene_.bodies[body].is_prescribed()) continue;
      const auto off = [&](Drawing& d) {
        const Spot at = d.place(joint.first, joint.at);
        return is_geared(body) && joint.kind == BodyJoint::Kind::pin ? at != d.centre(body)
                                                                     : has_extent(body) && !d.box(body).holds(at);
      };
      if (is_wheel(body) || is_geared(body) ? often(off) : always(off)) {
        return find(joint.at.place, "joint " + joint.name + ": it is " +
                                        (is_geared(body) ? "not in the centre of " : "outside of ") + name(body) +
                                        ", expected a place on both bodies");
      }
    }
  }

  void pushed(const BodyForce& force) {
    const auto holds = [&](const BodyJoint& j) { return j.first == force.on || j.second == force.on; };
    if (!force.at || scene_.bodies[force.on].shapes.empty() || std::ranges::any_of(scene_.joints, holds)) return;
    const auto off = [&](Drawing& d) { return !d.box(force.on).holds(d.place(force.on, force.at)); };
    if (always(off)) {
      find(force.at.place, "the force acts outside of " + name(force.on) + ", expected a place on it");
    }
  }

  /// Where all surfaces that stand still face one way, gravity or a force presses on them; check_gravity() looks up.
  void gravity() {
    std::vector<const BodyContact*> standing;
    for (const BodyContact& c : scene_.contacts) {
      if (scene_.bodies[c.on].is_prescribed() && !m_.contacts[c.contact].bilateral && c.normal) standing.push_back(&c);
    }
    const bool held = std::ranges::any_of(scene_.joints, [&](const BodyJoint& j) {
      return scene_.bodies[j.first].is_prescribed() || scene_.bodies[j.second].is_prescribed();
    });
    if (!scene_.gravity || standing.empty() || held) return;
    const auto lifts = [&](Drawing& d) {
      const Spot g = d.spot(bodies_in_motion::unplaced(scene_.gravity));
      const Spot n = d.direction(standing[0]->on, standing[0]->normal);
      const auto presses = [&](const BodyForce& f) {
        return dot(f.follows ? d.direction(f.on, f.is) : d.spot(bodies_in_motion::unplaced(f.is)), n).sign() < 0;
      };
      return std::ranges::all_of(standing, [&](const BodyContact* c) { return d.direction(c->on, c->normal) == n; }) &&
             std::ranges::none_of(scene_.forces, presses) && dot(g, n).sign() >= 0 && g.y.sign() <= 0;
    };
    if (!always(lifts)) return;
    find(scene_.gravity.place, "gravity presses nothing on the surface that all contacts have, expected it into it");
  }

  void in_each_other(std::size_t a, std::size_t b) {
    const auto joined = [&](const BodyJoint& j) {
      return (j.first == a && j.second == b) || (j.first == b && j.second == a);
    };
    if (std::ranges::any_of(scene_.joints, joined)) return;
    const auto inside = [&](Drawing& d) {
      return d.is_convex(a) && d.is_convex(b) && overlap(d.outlines(a)[0], d.outlines(b)[0]);
    };
    if (always(inside)) {
      find(scene_.bodies[b].place, "the shapes of " + name(a) + " and " + name(b) + " lie in each other");
    }
  }

  const Mechanism& m_;
  const Bodies& scene_;
  std::vector<Frame> frames_;
  std::vector<Drawing> drawings_;
  std::vector<MechanismFinding> findings_;
};

}  // namespace

}  // namespace drawn

std::vector<MechanismFinding> check_drawing(const CheckPoints& points) {
  return points.mechanism().bodies ? drawn::DrawingCheck(points).check() : std::vector<MechanismFinding>();
}

}  // namespace slipproof::mechanism_checks
