// Joints with friction: the contacts in their place.
//
// A slider becomes two guides, bilateral contacts of two points of the second body with a line of the first; where
// nothing turns, one. A pin becomes a disc in a ring, which touches at one place.
//
// In space a slider is a carriage on a rail: four feet of the second body, which may lift, on a plane of the first, and
// two smooth guides that hold it across. A hinge is a shaft in two rings, spheres in hollow spheres, each of which
// touches at one place, and a smooth guide that holds it along its axis. So each contact presses to one side: two that
// are closed and press against each other would leave open how much they do, and with it all friction.
#include <utility>

#include "mechanics/bodies/frame.hpp"
#include "mechanics/mechanism/algebra.hpp"
#include "mechanics/reading/bodies/body_parts.hpp"

namespace slipproof::mechanism_reader {

namespace {

class GuideReader : public BodyParts {
 public:
  GuideReader(Context& context, Bodies& bodies, bool named_well) : BodyParts(context, bodies) {
    named_well_ = named_well;
  }

  void read_slider(const TableReader& table, BodyJoint& joint) {
    const bool turning = turns({joint.first, joint.second});
    if (in_space()) return read_carriage(table, joint, turning);
    for (const char* suffix : {"_front", "_back"}) {
      BodyContact& guide = add_contact(table, joint, {turning ? suffix : "", true, true});
      place_last(joint, turning ? (joint.guides.size() == 1 ? 1 : -1) : 0, 0);
      guide.normal = {negated(joint.axis.y), joint.axis.x, {}, joint.axis.place};
      guide.through = joint.at;
      guide.slip_direction = joint.axis;
      if (!turning) return;
    }
  }

  void read_pin(const TableReader& table, BodyJoint& joint) {
    add_ring(add_contact(table, joint, {"", false, true}), joint);
  }

  void read_hinge(const TableReader& table, BodyJoint& joint) {
    for (const int ahead : {1, -1}) {
      add_ring(add_contact(table, joint, {ahead > 0 ? "_front" : "_back", false, true}), joint);
      place_last(joint, ahead, 0);
    }
    BodyContact& along = add_contact(table, joint, {"_along", true, false});
    along.normal = joint.axis;
    along.through = joint.at;
  }

 private:
  static PlacedExpression negated(PlacedExpression placed) {
    if (placed) placed.expression = negative_of(placed.expression);
    return placed;
  }

  void read_carriage(const TableReader& table, BodyJoint& joint, bool turning) {
    for (const int ahead : {1, -1}) {
      for (const int across : {1, -1}) {
        const std::string suffix = std::string(ahead > 0 ? "_front" : "_back") + (across > 0 ? "_left" : "_right");
        BodyContact& foot = add_contact(table, joint, {turning ? suffix : "", false, true});
        place_last(joint, turning ? ahead : 0, turning ? across : 0);
        foot.normal = joint.normal;
        foot.through = joint.at;
        foot.tangent = joint.axis;
        if (!turning) break;
      }
      if (!turning) break;
    }
    for (const int ahead : {1, -1}) {
      BodyContact& side =
          add_contact(table, joint, {turning ? ahead > 0 ? "_side_front" : "_side_back" : "_side", true, false});
      place_last(joint, turning ? ahead : 0, 0);
      side.normal = across(joint.normal, joint.axis);
      side.through = joint.at;
      if (!turning) return;
    }
  }

  static void add_ring(BodyContact& disc, const BodyJoint& joint) {
    disc.point = joint.to;
    disc.radius = joint.radius;
    disc.on_point = joint.at;
    disc.on_radius = negated(joint.ring);
  }

  static PlacedVector across(const PlacedVector& normal, const PlacedVector& axis) {
    using namespace bodies_in_motion;
    const SceneVector product = moment(unplaced(normal), unplaced(axis));
    const auto placed = [&](const Expression& one) {
      return PlacedExpression{folded(one), PlacedText("", normal.place)};
    };
    return {placed(product.x), placed(product.y), placed(product.z), normal.place};
  }

  static void place_last(BodyJoint& joint, int ahead, int across) {
    joint.guides.back().ahead = ahead;
    joint.guides.back().across = across;
  }

  struct Guide {
    std::string suffix;
    bool bilateral, rubs;
  };
  BodyContact& add_contact(const TableReader& table, BodyJoint& joint, const Guide& guide) {
    MechanismContact contact;
    contact.place = joint.place;
    contact.name = joint.name + guide.suffix;
    if (named_well_ && !guide.suffix.empty()) context_.declare_element(contact.name, table.place("name"));
    contact.bilateral = guide.bilateral;
    if (guide.rubs) read_coefficients(table, contact);
    const bool smooth = contact.frictionless();
    if (guide.rubs) {
      read_state(
          table, contact.start,
          {.law = smooth ? ElementKind::Law::frictionless : ElementKind::Law::coulomb, .bilateral = guide.bilateral});
    }
    BodyContact touch;
    touch.place = joint.place;
    touch.contact = mechanism_.contacts.size();
    touch.state_given = guide.rubs && table.has("state");
    touch.well_named = named_well_;
    touch.of = joint.second;
    touch.on = joint.first;
    name_forces(table, contact, touch.contact);
    joint.guides.push_back({bodies_.contacts.size()});
    mechanism_.contacts.push_back(std::move(contact));
    bodies_.contacts.push_back(std::move(touch));
    return bodies_.contacts.back();
  }
};

}  // namespace

void add_guides(const TableReader& table, BodyJoint joint, bool named_well, Context& context, Bodies& bodies) {
  GuideReader reader(context, bodies, named_well);
  using Kind = BodyJoint::Kind;
  if (joint.kind == Kind::pin) {
    reader.read_pin(table, joint);
  } else if (joint.kind == Kind::hinge) {
    reader.read_hinge(table, joint);
  } else {
    reader.read_slider(table, joint);
  }
  bodies.guides.push_back(std::move(joint));
}

}  // namespace slipproof::mechanism_reader
