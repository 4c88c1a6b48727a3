// Inside the reading of bodies: what refers to them.
#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "mechanics/reading/element_parts.hpp"

namespace slipproof::mechanism_reader {

class BodyParts : public ElementParts {
 public:
  BodyParts(Context& context, Bodies& bodies) : ElementParts(context), bodies_(bodies) {}

 protected:
  PlacedVector vector(const TableReader& table, std::string_view key);
  PlacedVector vector(const TomlValue& value, std::string_view key);
  /// A turning, spin or couple: a number in the plane, a vector in space.
  PlacedVector turning(const TableReader& table, std::string_view key);
  PlacedExpression one(const TableReader& table, std::string_view key);
  PlacedExpression folded_number(const TomlValue& value, std::string_view key);
  /// The index of the body that a key names. If there is no such body, reports it and returns the ground.
  std::size_t body_of(const TableReader& table, std::string_view key);
  /// The two bodies in `between`.
  std::pair<std::size_t, std::size_t> read_between(const TableReader& table);
  /// Whether one of the bodies turns as its forces say.
  bool turns(std::initializer_list<std::size_t> bodies) const;
  static constexpr std::string_view expected_turning = ", expected one that turns freely, with an inertia";
  /// The names that a table gives in `names`, or the table itself, which has none of these keys.
  TableReader names_of(const TableReader& table, std::span<const std::string_view> keys);

  /// Forces, gap and slip of a contact, by the names in a table or the default ones.
  void name_forces(const TableReader& names, MechanismContact& contact, std::size_t index);

  Bodies& bodies_;

 private:
  std::optional<std::size_t> find_body(const PlacedText& name, std::string_view key);
  std::size_t failed();
  static void fold(PlacedExpression& placed);
};

/// [[body]] and the unknowns that follow. A mechanism's unknowns come in the order of these calls.
void read_body_list(const TableReader& root, Context& context, Bodies& bodies);
/// [[contact]]
void read_body_contacts(const TableReader& root, Context& context, Bodies& bodies);
/// [[joint]]: ropes and freewheels are contacts; the links of the others come last, by add_joint_links().
void read_joints(const TableReader& root, Context& context, Bodies& bodies);
/// The contacts in place of a slider or pin with friction.
void add_guides(const TableReader& table, BodyJoint joint, bool named_well, Context& context, Bodies& bodies);
/// [[friction]], then rolling resistance.
void read_body_friction(const TableReader& root, Context& context, Bodies& bodies);
void add_joint_links(Context& context, Bodies& bodies);
/// [state], when bodies, joints and contacts are read.
void read_state(const TableReader& root, Context& context, Bodies& bodies);

}  // namespace slipproof::mechanism_reader
