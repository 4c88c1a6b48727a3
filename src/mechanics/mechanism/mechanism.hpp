// A mechanism with dry friction as data, in the plane or in space: what a mechanism file says, and what follows from it
// by virtual work.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/expression/expression.hpp"
#include "base/input/toml.hpp"
#include "mechanics/elements/element.hpp"

namespace slipproof {

/// An expression and the text in the file that it was read from.
struct PlacedExpression {
  Expression expression;  ///< null where the file leaves it out
  PlacedText text;

  explicit operator bool() const { return expression != nullptr; }
  Place place() const { return text.at(0); }
  /// The place of a part of the expression.
  Place place(const Expression& part) const { return text.at(part->column == 0 ? 0 : part->column - 1); }
};

/// constant + load * (the load) + the sum of terms over unknowns of the mechanism. Coefficients are expressions in
/// parameters, definitions and angle symbols. None is null; absent ones are the literal 0.
struct SymbolicForm {
  std::vector<std::pair<std::size_t, Expression>> terms;  ///< by unknown, in ascending order; none is the literal 0
  Expression load, constant;

  /// Of an unknown; the literal 0 where there is no term.
  const Expression& coefficient(std::size_t unknown) const;
};

struct MechanismParameter {
  std::string symbol;
  PlacedExpression domain;  ///< a condition over parameters and angle symbols, perhaps `true`
  std::string unit, meaning;
  bool optional = false;  ///< a scene may leave it out; it counts as 0 then
  Place place;
};

/// An entry of [assume] or [realisable], over parameters, definitions and angle symbols.
struct MechanismCondition {
  std::string name;
  PlacedExpression condition;
};

struct MechanismDefinition {
  std::string symbol;
  PlacedExpression expression;  ///< over parameters, angle symbols and the definitions before it
  Place place;
};

/// Two symbols whose squares add up to 1.
struct MechanismAngle {
  std::string name, cosine, sine;
  PlacedExpression domain;
  std::string meaning;
  Place place;
};

struct MechanismLoad {
  std::string symbol;
  /// Conditions that together define an interval: conjunctions of comparisons that are affine in the load. The first is
  /// the load's own; others come from parameters that with_load() made the load.
  std::vector<PlacedExpression> domain;
  std::string unit, meaning;
  Place place;
};

struct MechanismUnknown {
  enum class Role : std::uint8_t { acceleration, force, normal, tangent, friction, link };
  std::string symbol;
  Role role = Role::acceleration;
  std::size_t owner = 0;  ///< index of the contact, friction element or link that the force belongs to
  std::string unit;       ///< empty: not given
  Place place;
};

struct MechanismEquation {
  std::string name;
  PlacedExpression left, right;  ///< as in the file
  /// Contact forces on the right side, by virtual work; null in a file with [equations], or if there are none.
  Expression contact_forces;
  SymbolicForm form;  ///< left - right - contact forces

  /// The right side with all forces.
  Expression whole_right() const;
};

/// The second slip of a contact in space, across the first and the normal.
struct MechanismSlip {
  PlacedExpression slip;
  std::string name;
  std::size_t force = 0;                    ///< among the unknowns
  std::vector<PlacedExpression> direction;  ///< where it counts positive
  SymbolicForm form;
};

/// A contact. `gap` and `slip` are accelerations: of the opening along N, and along positive slip.
struct MechanismContact {
  std::string name;
  PlacedExpression gap;
  PlacedExpression slip;                               ///< null for a frictionless contact without slip
  PlacedExpression static_friction, kinetic_friction;  ///< null: frictionless; the same if the file gives one
  ElementKind::Start start = ElementKind::Start::rest;
  bool bilateral = false;
  std::vector<std::size_t> lift_needs;  ///< parameters without which `lift` is not modelled
  std::string gap_name, slip_name;
  std::size_t normal = 0;              ///< its force among the unknowns
  std::optional<std::size_t> tangent;  ///< nothing: frictionless
  /// Position, direction of N, and direction of positive slip, for pictures; each has two coordinates or none.
  std::vector<PlacedExpression> at, direction, slip_direction;
  SymbolicForm gap_form, slip_form;
  std::optional<MechanismSlip> second;  ///< in space, with friction
  /// In space, of a contact that slides: the direction of its sliding velocity along the first and the second slip, or
  /// that velocity, where its length is no rational expression.
  std::vector<PlacedExpression> sliding;
  Place place;

  bool frictionless() const { return !static_friction; }
};

/// A friction element. `slip` is an acceleration along its positive direction.
struct MechanismFriction {
  std::string name;
  PlacedExpression slip;
  PlacedExpression static_limit, kinetic_limit;
  ElementKind::Start start = ElementKind::Start::rest;
  std::string slip_name;
  std::optional<std::size_t> contact;  ///< that limits it, as for rolling resistance (ElementKind::contact)
  std::size_t force = 0;               ///< among the unknowns
  SymbolicForm slip_form, static_form, kinetic_form;
  Place place;
};

struct MechanismLink {
  std::string name;
  PlacedExpression zero;
  std::size_t force = 0;  ///< among the unknowns
  SymbolicForm form;
  Place place;
};

struct MechanismShape {
  enum class Kind : std::uint8_t { polygon, line, circle, point, arrow, label, measure, turn };
  Kind kind = Kind::polygon;
  std::vector<std::vector<PlacedExpression>> points;  ///< two coordinates each, x to the right and y up
  PlacedExpression radius;                            ///< radius of a circle, or of a turn, clockwise if negative
  std::string text;                                   ///< text of a label; name of an arrow, measure or turn
  PlacedExpression force;                             ///< force shown by an arrow, positive along it
  std::string acceleration;                           ///< acceleration shown by an arrow, one of acceleration_names()
  bool still = false;                                 ///< left out of the picture of a motion
  bool thin = false;                                  ///< drawn with a thin line
  Place place;
};
std::string_view name(MechanismShape::Kind kind);

struct Bodies;

/// How velocities after an impact follow from those before.
enum class ImpactLaw : std::uint8_t { newton, moreau, poisson };
std::string_view name(ImpactLaw law);
std::optional<ImpactLaw> parse_impact_law(std::string_view text);  ///< nothing unless as written by name()

/// What an impact's mechanism says of the instant before. Expressions over parameters, definitions and angle symbols.
struct MechanismImpact {
  struct Contact {
    std::string name, gap, slip, second_slip;  ///< as quantities of a motion are called; empty: it has none
    Expression opening;                        ///< velocity of the gap before; null where the contact is apart
    Expression sliding, second;                ///< null: frictionless; not in space
    /// The gap is the velocity of opening after, and this; slips are those of sliding after, and these.
    Expression restored, slip_restored, second_restored;
  };
  ImpactLaw law = ImpactLaw::moreau;
  std::vector<Expression> velocities;  ///< of each unknown acceleration, before
  std::vector<Contact> contacts;       ///< of each contact
  std::vector<Expression> prescribed;  ///< velocities and spins of bodies that no impulse changes
  std::vector<std::string> left_out;   ///< friction elements with limits of their own: finite couples have no impulse
};

struct Mechanism {
  std::string file, name, source, note;
  std::size_t dimension = 2;  ///< 2: in the plane; 3: in space, which has bodies
  Place dimension_place;
  std::vector<MechanismParameter> parameters;
  std::vector<MechanismCondition> assume, realisable;
  std::vector<MechanismDefinition> definitions;
  std::vector<MechanismAngle> angles;
  std::optional<MechanismLoad> load;
  std::vector<MechanismUnknown> unknowns;  ///< accelerations, forces, then those of contacts, friction elements, links
  std::size_t accelerations = 0, forces = 0;  ///< numbers of unknown accelerations; of forces of no element
  bool by_virtual_work = false;               ///< the file has [motion], not [equations]
  bool reciprocal = true;                     ///< false: the file says that its matrix is not symmetric on purpose
  std::vector<MechanismEquation> equations;
  std::vector<MechanismContact> contacts;
  std::vector<MechanismFriction> friction;
  std::vector<MechanismLink> links;
  std::vector<MechanismShape> shapes;
  PlacedExpression energy;  ///< kinetic energy; names of accelerations mean the velocities. Null: not given
  std::vector<SymbolicForm> energy_slopes;  ///< its derivatives by each of them: rows of a symmetric matrix
  std::shared_ptr<const Bodies> bodies;     ///< the bodies from which the rest was derived; null without
  /// Of an impact: unknown accelerations are velocities after it, and forces are impulses.
  std::optional<MechanismImpact> impact;
  bool shipped = false;  ///< comes with slipproof and was found by name: tests have checked it

  /// Contacts and friction elements: what has a state in a mode.
  std::size_t elements() const { return contacts.size() + friction.size(); }
};

/// Which mechanisms are asked for.
enum class Dimensions : std::uint8_t { plane, any };
/// An impact as it is asked for: by this law; without one by that of the file, or by Moreau's.
struct ImpactRequest {
  std::optional<ImpactLaw> law;
};
/// A mechanism or scene as it is asked for: its impact, or what the file says.
struct MechanismRequest {
  MechanismRequest(Dimensions which, std::optional<ImpactRequest> as = {}) : dimensions(which), impact(as) {}
  Dimensions dimensions;
  std::optional<ImpactRequest> impact;
};
/// Throws InputError for a mechanism in space if only those in the plane are asked for: whatever knows the plane alone
/// opens its mechanisms and scenes by functions that call this.
void refuse_other(const Mechanism& mechanism, Dimensions dimensions);

/// Names of the quantities that have a value at a point of the mechanism: parameters, angles and the load.
std::vector<std::string_view> value_names(const Mechanism& mechanism);
/// Names of the quantities that define a motion: unknown accelerations, the gap and slip of each contact, the slip of
/// each friction element. In the order of FrictionProblem::accelerations.
std::vector<std::string> acceleration_names(const Mechanism& mechanism);
/// Names of all forces in the order of the file: FrictionProblem::forces.
std::vector<std::string> force_names(const Mechanism& mechanism);
/// The name of a contact or friction element, in the order of a mode.
const std::string& element_name(const Mechanism& mechanism, std::size_t element);

/// The parameters without which the contact's `lift` is not modelled, and which are not given.
std::vector<std::size_t> missing_for_lift(const MechanismContact& contact, const std::vector<bool>& given);

/// The state of each element before the motion, as the file gives it.
std::vector<ElementKind::Start> starts(const Mechanism& mechanism);
/// The kinds of the elements, for the states before the motion and for `given`: for each parameter, whether it has a
/// value (which decides whether a contact may lift). By default the states in the file, with all parameters given.
std::vector<ElementKind> element_kinds(const Mechanism& mechanism);
std::vector<ElementKind> element_kinds(const Mechanism& mechanism, const std::vector<ElementKind::Start>& starts,
                                       const std::vector<bool>& given);

/// In space, of a contact that slides: what times N resists along a direction, of which `along` is in `sliding`.
Expression drag_factor(const MechanismContact& contact, const PlacedExpression& along);

/// Whether an expression is the literal 0.
bool is_literal_zero(const Expression& expression);

}  // namespace slipproof
