// Masses and inertias against the shapes that are drawn, at all points of the domain: a finding is one that holds at
// each, as sizes that have nothing to do with each other agree somewhere. And whether contacts and the centre of mass
// are somewhere in the shapes. At the numbers of a scene, also density.
#include <algorithm>

#include "base/number/format.hpp"
#include "mechanics/checks/check_parts.hpp"
#include "mechanics/checks/drawing/drawing.hpp"

namespace slipproof::mechanism_checks {

namespace drawn {

namespace {

using bodies_in_motion::Frame;

constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};

/// An upper bound on the square of the distance from an axis through the centre of mass, of all that is drawn.
Rational reach(const std::vector<Outline>& outlines, std::size_t axis) {
  Rational most = 0;
  for (const Outline& outline : outlines) {
    for (const Spot& corner : outline.own) {
      const Rational square = dot(corner, corner) - corner[axis] * corner[axis];
      const Rational round = outline.radius * outline.radius;
      // (a + b)^2 <= 2 (a^2 + b^2), and exactly b^2 where a = 0
      const bool one = square.is_zero() || round.is_zero();
      most = std::max(most, one ? square + round : 2 * (square + round));
    }
  }
  return most;
}

/// The moment of inertia of a homogeneous box of these sizes, up to a factor.
Rational of_box(const Box& box, std::size_t axis) {
  const Spot size = box.high - box.low;
  return dot(size, size) - size[axis] * size[axis];
}

class SolidCheck {
 public:
  SolidCheck(const Mechanism& mechanism, const ProblemMaker& maker)
      : m_(mechanism), scene_(*mechanism.bodies), maker_(maker) {
    frames_ = bodies_in_motion::frames(scene_);
  }

  void draw(const MechanismValues& values) { drawings_.emplace_back(scene_, frames_, maker_, values); }

  /// What holds at all points that were drawn.
  std::vector<MechanismFinding> check() {
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      if (scene_.bodies[i].inertia) inertia(i);
      if (!scene_.bodies[i].shapes.empty() && scene_.bodies[i].mass) centre(i);
    }
    for (const BodyContact& contact : scene_.contacts) {
      place(contact);
      size(contact);
    }
    return std::move(findings_);
  }

  /// At the numbers of a scene, which are drawn alone: inertias, and in kg and m densities.
  std::vector<MechanismFinding> check_numbers() {
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      if (scene_.bodies[i].inertia) inertia(i);
      if (scene_.bodies[i].mass && in_si_units()) density(i);
    }
    return std::move(findings_);
  }

 private:
  bool in_si_units() const {
    const auto has = [&](std::string_view unit) {
      return std::ranges::any_of(m_.parameters, [&](const MechanismParameter& p) { return p.unit == unit; });
    };
    return has("kg") && has("m");
  }

  /// Between that of osmium and a hundredth of that of air.
  void density(std::size_t body) {
    Drawing& d = drawings_.front();
    const auto box = d.own_box(body);
    if (!box || scene_.dimension == 2 || !d.has_values()) return;
    const Spot size = box->high - box->low;
    const Rational volume = size.x * size.y * size.z, mass = d.number(scene_.bodies[body].mass);
    const bool heavy = mass > 22600 * volume;
    if (volume.is_zero() || mass.is_zero() || !(heavy || 100 * mass < volume)) return;
    find(scene_.bodies[body].mass.place(),
         "body " + scene_.bodies[body].name + ": found the mass " + decimal_text(mass, 3) +
             " kg in a shape of less than " + decimal_text(volume, 3) + " m^3, which is " +
             (heavy ? "heavier than any metal" : "lighter than air") + ", expected kg and m");
  }

  template <class Holds>
  bool always(const Holds& holds) {
    return !drawings_.empty() && std::ranges::all_of(drawings_, [&](Drawing& d) { return holds(d) && d.has_values(); });
  }
  void find(Place place, std::string message, MechanismFinding::Check check = MechanismFinding::Check::geometry) {
    findings_.push_back(warning(check, place, std::move(message)));
  }

  void inertia(std::size_t body) {
    const PlacedInertia& given = scene_.bodies[body].inertia;
    const std::string name = "body " + scene_.bodies[body].name + ": ";
    const auto report = [&](const std::string& message) {
      find(given.place(), name + message, MechanismFinding::Check::inertia);
      return true;
    };
    if (scene_.bodies[body].shapes.empty() || !scene_.bodies[body].mass) return;
    for (std::size_t i = scene_.dimension == 3 ? 0 : 2; i < 3; ++i) {
      const auto beyond = [&](Drawing& d) {
        const Rational mass = d.number(scene_.bodies[body].mass);  // 0: another body's mass counts it
        return !mass.is_zero() && d.number(given.at(i, i)) > mass * reach(d.outlines(body), i);
      };
      if (always(beyond)) {
        report("found a moment of inertia " + about(i) +
               "that is more than if all of its mass were where its shape ends, "
               "expected that about its centre of mass");
        return;
      }
    }
    if (scene_.dimension == 3) order(body, report);
  }
  std::string about(std::size_t axis) const {
    return scene_.dimension == 3 ? std::string("about ") + axis_names[axis] + " " : std::string();
  }

  /// Two moments whose order is always the other one than that of a homogeneous box of this size, of which one is twice
  /// as large or more.
  template <class Report>
  void order(std::size_t body, const Report& report) {
    const PlacedInertia& given = scene_.bodies[body].inertia;
    const auto against = [&](std::size_t i, std::size_t k) {
      std::size_t count = 0;
      for (Drawing& d : drawings_) {
        const auto box = d.own_box(body);
        const Rational one = of_box(*box, i), other = of_box(*box, k);
        if (one < 2 * other && other < 2 * one) continue;
        if ((d.number(given.at(i, i)) < d.number(given.at(k, k))) == (one < other)) return false;
        ++count;
      }
      return count >= CheckPoints::needed;
    };
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = i + 1; k < 3; ++k) {
        if (!against(i, k)) continue;
        report(std::string("found moments of inertia about ") + axis_names[i] + " and " + axis_names[k] +
               " in the other order than a box of its size has them, expected them as xx yy zz");
        return;
      }
    }
  }

  void centre(std::size_t body) {
    const auto outside = [&](Drawing& d) {  // or at its end
      const auto box = d.own_box(body);
      for (std::size_t i = 0; i < 3; ++i) {
        if (box->low[i] < box->high[i] && (box->low[i].sign() >= 0 || box->high[i].sign() <= 0)) return true;
      }
      return false;
    };
    if (!always(outside)) return;
    find(scene_.bodies[body].shapes[0].place,
         "body " + scene_.bodies[body].name +
             ": its centre of mass is outside of its shape, which is drawn from there, "
             "expected it inside");
  }

  /// Of a point, or of the middle of a sphere, where other contacts of the body are on its shape: legs may be left out.
  void place(const BodyContact& contact) {
    if (contact.of == ground || scene_.bodies[contact.of].shapes.empty()) return;
    const auto off = [&](Drawing& d) {
      const Box box = *d.own_box(contact.of);
      const auto on = [&](const BodyContact& c) { return c.of == contact.of && box.holds(d.own(c.point)); };
      return !on(contact) && std::ranges::any_of(scene_.contacts, on);
    };
    if (!always(off)) return;
    find(contact.point.place, m_.contacts[contact.contact].name + ": it is outside of the shape of " +
                                  scene_.bodies[contact.of].name + ", expected a place on it, from its centre of mass");
  }

  /// A ball that touches is the one that is drawn around the same middle.
  void size(const BodyContact& contact) {
    const auto differs = [&](Drawing& d) {
      const auto& outlines = d.outlines(contact.of);
      return outlines.size() == 1 && outlines[0].own.size() == 1 && outlines[0].own[0] == d.own(contact.point) &&
             outlines[0].radius != d.number(contact.radius);
    };
    if (!contact.radius || !always(differs)) return;
    find(contact.radius.place(), m_.contacts[contact.contact].name +
                                     ": found another radius than that of the shape of " +
                                     scene_.bodies[contact.of].name + " around the same point, expected the same");
  }

  const Mechanism& m_;
  const Bodies& scene_;
  const ProblemMaker& maker_;
  std::vector<Frame> frames_;
  std::vector<Drawing> drawings_;
  std::vector<MechanismFinding> findings_;
};

}  // namespace

}  // namespace drawn

std::vector<MechanismFinding> check_solids(const CheckPoints& points) {
  if (!points.mechanism().bodies) return {};
  drawn::SolidCheck check(points.mechanism(), points.maker());
  for (const CheckPoint& point : points.all()) check.draw(point.values);
  return check.check();
}

std::vector<MechanismFinding> check_solids_at(const Mechanism& mechanism, const ProblemMaker& maker,
                                              const MechanismValues& values) {
  drawn::SolidCheck check(mechanism, maker);
  check.draw(values);
  return check.check_numbers();
}

}  // namespace slipproof::mechanism_checks
