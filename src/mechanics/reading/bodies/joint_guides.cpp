// Joints with friction: the contacts in their place.
//
// A slider becomes two guides, bilateral contacts of two points of the second body with a line of the first; where
// nothing turns, one. A pin becomes a disc in a ring, which touches at one place.
#include <utility>

#include "mechanics/mechanism/algebra.hpp"
#include "mechanics/reading/bodies/body_parts.hpp"

namespace slipproof::mechanism_reader {

namespace {

using Role = MechanismUnknown::Role;

class GuideReader : public BodyParts {
 public:
  GuideReader(Context& context, Bodies& bodies, bool named_well) : BodyParts(context, bodies) {
    named_well_ = named_well;
  }

  void read_slider(const TableReader& table, BodyJoint& joint) {
    const bool turning = turns({joint.first, joint.second});
    for (const char* suffix : {"_front", "_back"}) {
      BodyContact& guide = add_contact(table, joint, turning ? suffix : "", true);
      guide.normal = {negated(joint.axis.y), joint.axis.x, {}, joint.axis.place};
      guide.through = joint.at;
      guide.slip_direction = joint.axis;
      if (!turning) return;
    }
  }

  void read_ring(const TableReader& table, BodyJoint& joint) {
    BodyContact& disc = add_contact(table, joint, "", false);
    disc.point = joint.to;
    disc.radius = joint.radius;
    disc.on_point = joint.at;
    disc.on_radius = negated(joint.ring);
  }

 private:
  static PlacedExpression negated(PlacedExpression placed) {
    if (placed) placed.expression = negative_of(placed.expression);
    return placed;
  }

  BodyContact& add_contact(const TableReader& table, BodyJoint& joint, const std::string& suffix, bool bilateral) {
    MechanismContact contact;
    contact.place = joint.place;
    contact.name = joint.name + suffix;
    if (named_well_ && !suffix.empty()) context_.declare_element(contact.name, table.place("name"));
    contact.bilateral = bilateral;
    read_coefficients(table, contact);
    const bool smooth = contact.frictionless();
    read_state(table, contact.start,
               {.law = smooth ? ElementKind::Law::frictionless : ElementKind::Law::coulomb, .bilateral = bilateral});
    BodyContact touch;
    touch.place = joint.place;
    touch.contact = mechanism_.contacts.size();
    touch.state_given = table.has("state");
    touch.well_named = named_well_;
    touch.of = joint.second;
    touch.on = joint.first;
    contact.normal = unknown(table, "N", "N_" + contact.name, Role::normal, touch.contact);
    if (!smooth) contact.tangent = unknown(table, "S", "S_" + contact.name, Role::tangent, touch.contact);
    contact.gap_name = named(table, "gap", "gap_" + contact.name);
    if (!smooth) contact.slip_name = named(table, "slip", "slip_" + contact.name);
    joint.guides.push_back(bodies_.contacts.size());
    mechanism_.contacts.push_back(std::move(contact));
    bodies_.contacts.push_back(std::move(touch));
    return bodies_.contacts.back();
  }
};

}  // namespace

void add_guides(const TableReader& table, BodyJoint joint, bool named_well, Context& context, Bodies& bodies) {
  GuideReader reader(context, bodies, named_well);
  joint.kind == BodyJoint::Kind::pin ? reader.read_ring(table, joint) : reader.read_slider(table, joint);
  bodies.guides.push_back(std::move(joint));
}

}  // namespace slipproof::mechanism_reader
