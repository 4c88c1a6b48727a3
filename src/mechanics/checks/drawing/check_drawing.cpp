// What a drawing of bodies shows at a glance, as exact positions at points of the domain: a finding is one that holds
// at all of them, or for joints of wheels at half. It speaks of the places of contacts, joints and forces and of
// outlines that are convex; where a body has none, its points stand for it.
#include <algorithm>
#include <map>

#include "mechanics/checks/check_parts.hpp"
#include "mechanics/checks/drawing/drawing.hpp"

namespace slipproof::mechanism_checks {

namespace drawn {

namespace {

using bodies_in_motion::Frame;

/// Whether a line runs along sides of outlines all of which end before a place on it.
bool side_ends_before(const std::vector<Outline>& outlines, const Spot& place, const Spot& along) {
  bool runs_along = false;
  for (const Outline& outline : outlines) {
    const std::vector<Spot>& c = outline.corners;
    for (std::size_t i = 0; i < c.size(); ++i) {
      const Spot a = c[i] - place, b = c[(i + 1) % c.size()] - place;
      if (a == b || !cross(a, along).z.is_zero() || !cross(b, along).z.is_zero()) continue;
      if (dot(a, along).sign() * dot(b, along).sign() <= 0) return false;
      runs_along = true;
    }
  }
  return runs_along;
}

class DrawingCheck {
 public:
  DrawingCheck(const Mechanism& mechanism, const ProblemMaker& maker)
      : m_(mechanism), scene_(*m_.bodies), maker_(maker), flat_(scene_.dimension == 2 ? "line" : "plane") {
    frames_ = bodies_in_motion::frames(scene_);
  }

  void draw(const MechanismValues& values) { drawings_.emplace_back(scene_, frames_, maker_, values); }

  std::vector<MechanismFinding> check() {
    surfaces();
    for (const BodyJoint& joint : scene_.joints) meets(joint);
    for (const BodyForce& force : scene_.forces) pushed(force);
    gravity();
    return std::move(findings_);
  }

  /// What is wrong at any numbers: shapes may be drawn in part, and gravity may pass by.
  std::vector<MechanismFinding> check_numbers() {
    surfaces();
    return std::move(findings_);
  }

 private:
  void surfaces() {
    std::map<std::pair<std::size_t, std::size_t>, std::vector<const BodyContact*>> before;
    for (const BodyContact& contact : scene_.contacts) {
      std::vector<const BodyContact*>& between = before[{contact.of, contact.on}];
      for (const BodyContact* other : between) same_place(*other, contact);
      between.push_back(&contact);
      sides(contact);
      end_of_face(contact);
    }
    for (const auto& [second, first] : close_bodies()) in_each_other(first, second);
  }

  /// Pairs of bodies whose boxes have more in common than a border, the later body first. In the order of x only those
  /// that are side by side there are compared.
  std::vector<std::pair<std::size_t, std::size_t>> close_bodies() const {
    std::vector<std::pair<Box, std::size_t>> boxes;
    for (std::size_t body = 0; !drawings_.empty() && body < scene_.bodies.size(); ++body) {
      if (!drawings_[0].is_convex(body)) continue;
      const Outline& outline = drawings_[0].outlines(body)[0];
      Box box(outline.corners[0]);
      for (const Spot& corner : outline.corners) box.take(corner, outline.radius);
      boxes.emplace_back(box, body);
    }
    std::ranges::stable_sort(boxes, {}, [](const auto& one) { return one.first.low.x; });
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (auto one = boxes.begin(); one != boxes.end(); ++one) {
      for (auto other = one + 1; other != boxes.end() && other->first.low.x < one->first.high.x; ++other) {
        const auto common = [&](std::size_t axis) {
          return other->first.low[axis] < one->first.high[axis] && one->first.low[axis] < other->first.high[axis];
        };
        if (!common(1) || (scene_.dimension == 3 && !common(2))) continue;
        pairs.emplace_back(std::max(one->second, other->second), std::min(one->second, other->second));
      }
    }
    std::ranges::sort(pairs);
    return pairs;
  }

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

  void same_place(const BodyContact& a, const BodyContact& b) {
    if (a.on_radius || b.on_radius) return;
    const auto same = [&](Drawing& d) {
      return d.touches(a) == d.touches(b) && d.direction(a.on, a.normal) == d.direction(b.on, b.normal);
    };
    if (always(same)) find(b.place, "the contacts " + name(a) + " and " + name(b) + " are at one place, expected two");
  }

  /// The body that has the point is on the side to which the normal points, the other one on the other side.
  void sides(const BodyContact& c) {
    if (c.on_radius) return;
    const auto wrong_side = [&](std::size_t body, int side, bool all) {
      return always([&](Drawing& d) {
        const Spot out = Rational(side) * d.direction(c.on, c.normal), at = d.touches(c);
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
      return find(c.normal.place, name(c) + ": the " + flat_ + " that is touched cuts through " + name(c.of) +
                                      ", expected all of it on the side of the normal");
    }
    if (wrong_side(c.on, 1, false)) {
      find(c.normal.place, name(c) + ": the " + flat_ + " that is touched cuts through " + name(c.on) +
                               ", expected all of it on the other side of the normal");
    }
  }

  void end_of_face(const BodyContact& c) {
    if (c.on_radius) return;
    const auto beyond = [&](Drawing& d) {
      const Spot n = d.direction(c.on, c.normal), at = d.touches(c);
      if (scene_.dimension == 2) return side_ends_before(d.outlines(c.on), at, {n.y, -n.x});
      return d.is_convex(c.on) && face_ends_before(d.outlines(c.on)[0], at, n);
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

  /// Where two bodies meet is somewhere on both; on one that a gear turns, in its centre.
  void meets(const BodyJoint& joint) {
    using Kind = BodyJoint::Kind;
    const bool turns = joint.kind == Kind::pin || joint.kind == Kind::hinge;
    if (!turns && joint.kind != Kind::weld && joint.kind != Kind::ball && joint.kind != Kind::universal) return;
    for (const std::size_t body : {joint.first, joint.second}) {
      if (scene_.bodies[body].is_prescribed()) continue;
      const auto off = [&](Drawing& d) {
        const Spot at = d.place(joint.first, joint.at);
        return is_geared(body) && turns ? at != d.centre(body) : has_extent(body) && !d.box(body).holds(at);
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
      const auto presses = [&](const BodyForce& f) {  // one of the load may, unless it is along the surface
        const auto is = bodies_in_motion::unplaced(f.is);
        const auto normal = frames_[standing[0]->on].in_scene(bodies_in_motion::unplaced(standing[0]->normal));
        return d.number(dot(f.follows ? frames_[f.on].in_scene(is) : is, normal)).sign() < 0;
      };
      return std::ranges::all_of(standing, [&](const BodyContact* c) { return d.direction(c->on, c->normal) == n; }) &&
             std::ranges::none_of(scene_.forces, presses) && dot(g, n).sign() >= 0 &&
             g[scene_.dimension - 1].sign() <= 0;
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
      return d.is_convex(a) && d.is_convex(b) && overlap(d.outlines(a)[0], d.outlines(b)[0], scene_.dimension);
    };
    if (always(inside)) {
      find(scene_.bodies[b].place, "the shapes of " + name(a) + " and " + name(b) + " lie in each other");
    }
  }

  const Mechanism& m_;
  const Bodies& scene_;
  const ProblemMaker& maker_;
  const std::string flat_;  ///< what contacts are on
  std::vector<Frame> frames_;
  std::vector<Drawing> drawings_;
  std::vector<MechanismFinding> findings_;
};

}  // namespace

}  // namespace drawn

std::vector<MechanismFinding> check_drawing(const CheckPoints& points) {
  if (!points.mechanism().bodies) return {};
  drawn::DrawingCheck check(points.mechanism(), points.maker());
  for (std::size_t i = 0; i < std::min(points.all().size(), CheckPoints::enough); ++i)
    check.draw(points.all()[i].values);
  return check.check();
}

std::vector<MechanismFinding> check_drawing_at(const Mechanism& mechanism, const ProblemMaker& maker,
                                               const MechanismValues& values) {
  drawn::DrawingCheck check(mechanism, maker);
  check.draw(values);
  return check.check_numbers();
}

}  // namespace slipproof::mechanism_checks
