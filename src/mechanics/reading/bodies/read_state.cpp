// [state]: numbers from which the velocities of linkages follow.
#include <algorithm>
#include <array>

#include "mechanics/reading/bodies/body_parts.hpp"

namespace slipproof::mechanism_reader {

namespace {

class StateReader : public BodyParts {
  using Kind = BodyRate::Kind;

 public:
  using BodyParts::BodyParts;

  void read(const TomlValue& state) {
    if (state.entries.empty()) context_.mistakes.add(state.place, "state: found nothing, expected " + an_entry());
    if (!within(state.entries.size(), max_symbols, "state", state.place, context_.mistakes)) return;
    for (const TomlEntry& entry : state.entries) {
      if (entry.value.kind != TomlValue::Kind::table) {
        refuse(entry, ": found " + std::string(kind_name(entry.value.kind)) +
                          (contact_called(entry.key) ? ", expected its state in [[contact]], or a number such as " +
                                                           entry.key + ".opening = \"0\""
                                                     : ", expected " + an_entry()));
        continue;
      }
      for (const TomlEntry& one : entry.value.entries) read(entry.key, one);
    }
  }

 private:
  std::string an_entry() const {
    return std::string("an entry such as crank.spin = ") +
           (in_space() ? "[\"0\", \"w\", \"0\"], hip.rate = \"w\"" : "\"w\"");
  }

  void refuse(const TomlEntry& entry, const std::string& message) {
    context_.mistakes.add(entry.place, "state: " + entry.key + message);
    context_.sound = false;
  }

  void read(const std::string& name, const TomlEntry& entry) {
    const std::string& key = entry.key;
    if (key == "spin") return read_spin(name, entry);
    if (key == "velocity") return read_velocity(name, entry);
    if (key == "rate" || key == "speed") return read_joint(name, entry);
    if (key == "opening" || key == "sliding") return read_contact(name, entry);
    refuse(entry, " of " + name +
                      ": found no such number, expected the spin or velocity of a body, the rate or speed of a joint, "
                      "or the opening, sliding or velocity of a contact");
  }

  std::optional<std::size_t> body_called(const std::string& name) const {
    const auto found = std::ranges::find(bodies_.bodies, name, &Body::name);
    return found == bodies_.bodies.end() ? std::nullopt : std::optional<std::size_t>(found - bodies_.bodies.begin());
  }
  const BodyContact* contact_called(const std::string& name) const {
    const auto found = std::ranges::find_if(
        bodies_.contacts, [&](const BodyContact& one) { return mechanism_.contacts[one.contact].name == name; });
    return found == bodies_.contacts.end() ? nullptr : &*found;
  }

  void refuse_name(const TomlEntry& entry, std::string_view kind, const std::string& name,
                   const std::vector<std::string_view>& known) {
    context_.mistakes.add(entry.place, "state: " + unknown_name(kind, name, known));
    context_.sound = false;
  }
  std::vector<std::string_view> body_names() const {
    std::vector<std::string_view> names;
    for (const Body& body : bodies_.bodies) names.push_back(body.name);
    return names;
  }
  std::vector<std::string_view> contact_names() const {
    std::vector<std::string_view> names;
    for (const BodyContact& one : bodies_.contacts) names.push_back(mechanism_.contacts[one.contact].name);
    return names;
  }

  void add(Kind kind, const std::string& name, std::size_t of, std::size_t axis, PlacedExpression is,
           const PlacedVector& at = {}) {
    if (is) bodies_.rates.push_back({kind, name, of, axis, at, std::move(is)});
  }

  void read_spin(const std::string& name, const TomlEntry& entry) {
    const auto body = body_called(name);
    if (!body) return refuse_name(entry, "body", name, body_names());
    if (!in_space()) {
      return add(Kind::spin, name + ".spin", *body, 2, context_.expression(entry.value, name + ".spin", Sort::number));
    }
    read_components(Kind::spin, name + ".spin", *body, entry.value, {});
  }

  void read_velocity(const std::string& name, const TomlEntry& entry) {
    const auto body = body_called(name);
    const BodyContact* contact = contact_called(name);
    if (!body && contact == nullptr) {
      auto known = body_names();
      const auto contacts = contact_names();
      known.insert(known.end(), contacts.begin(), contacts.end());
      return refuse_name(entry, "body or contact", name, known);
    }
    const bool placed = entry.value.kind == TomlValue::Kind::table && entry.value.find("at") != nullptr;
    if (body && contact != nullptr && !placed) {
      return refuse(entry, " of " + name +
                               ": found a body and a contact of that name, expected { at = ..., x = ... } "
                               "with a point of the body, or another name");
    }
    if (body) return read_components(Kind::velocity, name + ".velocity", *body, entry.value, {});
    if (contact->radius) {
      return refuse(entry, " of " + name + ": found the contact of a disc, expected its opening or sliding");
    }
    if (placed) return refuse(entry, " of " + name + ": found `at` for a contact, which has its point, expected none");
    read_components(Kind::velocity, name + ".velocity", contact->of, entry.value, contact->point);
  }

  /// ["v", "0"], or { at = [...], x = "v" } with some of the components.
  void read_components(Kind kind, const std::string& name, std::size_t body, const TomlValue& value, PlacedVector at) {
    const std::size_t count = in_space() ? 3 : 2;
    if (value.kind == TomlValue::Kind::array) {
      PlacedVector all = vector(value, name);
      std::array<PlacedExpression, 3> parts{std::move(all.x), std::move(all.y), std::move(all.z)};
      for (std::size_t i = 0; i < count; ++i) add(kind, name, body, i, std::move(parts[i]), at);
      return;
    }
    if (value.kind != TomlValue::Kind::table) {
      context_.mistakes.add(value.place, name + ": found " + std::string(kind_name(value.kind)) +
                                             ", expected a vector, or components such as " + name + ".x = \"v\"");
      context_.sound = false;
      return;
    }
    std::vector<std::string_view> keys;
    for (std::size_t i = 0; i < count; ++i) keys.push_back(std::string_view("xyz").substr(i, 1));
    if (kind == Kind::velocity) keys.push_back("at");
    const TableReader table(value, name, keys, context_.mistakes);
    if (table.has("at")) at = vector(table, "at");
    if (value.entries.size() == (table.has("at") ? 1 : 0)) {
      context_.mistakes.add(value.place, name + ": found no component, expected one such as x = \"v\"");
    }
    for (std::size_t i = 0; i < count; ++i) {
      add(kind, name + "." + std::string(keys[i]), body, i, context_.expression(table, keys[i], Sort::number), at);
    }
  }

  void read_joint(const std::string& name, const TomlEntry& entry) {
    std::vector<const BodyJoint*> joints;
    for (const BodyJoint& joint : bodies_.joints) joints.push_back(&joint);
    for (const BodyJoint& joint : bodies_.guides) joints.push_back(&joint);
    const auto found = std::ranges::find(joints, name, [](const BodyJoint* joint) { return joint->name; });
    if (found == joints.end()) {
      std::vector<std::string_view> known;
      for (const BodyJoint* joint : joints) known.push_back(joint->name);
      return refuse_name(entry, "joint", name, known);
    }
    using Joint = BodyJoint::Kind;
    const Joint kind = (*found)->kind;
    const bool slides = entry.key == "speed";
    const bool fits =
        kind == Joint::cylindrical || (slides ? kind == Joint::slider : kind == Joint::pin || kind == Joint::hinge);
    if (!fits) {
      return refuse(entry, " of " + name + ": a " + std::string(slipproof::name(kind)) + " has none, expected the " +
                               (slides       ? "speed of a slider"
                                : in_space() ? "rate of a hinge"
                                             : "rate of a pin"));
    }
    const std::string whole = name + "." + entry.key;
    add(slides ? Kind::speed : Kind::rate, whole, static_cast<std::size_t>(found - joints.begin()), 2,
        context_.expression(entry.value, whole, Sort::number));
  }

  void read_contact(const std::string& name, const TomlEntry& entry) {
    const BodyContact* contact = contact_called(name);
    if (contact == nullptr) return refuse_name(entry, "contact", name, contact_names());
    const auto index = static_cast<std::size_t>(contact - bodies_.contacts.data());
    const std::string whole = name + "." + entry.key;
    if (entry.key == "opening") {
      return add(Kind::opening, whole, index, 0, context_.expression(entry.value, whole, Sort::number));
    }
    if (mechanism_.contacts[contact->contact].frictionless()) {
      return refuse(entry, " of " + name + ": found a frictionless contact, expected the velocity of its point");
    }
    if (!in_space()) return add(Kind::sliding, whole, index, 0, context_.expression(entry.value, whole, Sort::number));
    if (entry.value.kind != TomlValue::Kind::array || entry.value.items.size() != 2) {
      return refuse(entry, " of " + name + ": expected two numbers, along the tangent and across it");
    }
    for (std::size_t i = 0; i < 2; ++i) {
      add(Kind::sliding, whole, index, i, context_.expression(entry.value.items[i], whole, Sort::number));
    }
  }
};

}  // namespace

void read_state(const TableReader& root, Context& context, Bodies& bodies) {
  if (const TomlValue* state = root.table("state")) StateReader(context, bodies).read(*state);
}

}  // namespace slipproof::mechanism_reader
