#include "mechanics/reading/write_mechanism.hpp"

#include <fmt/format.h>

#include <vector>

#include "base/input/toml.hpp"
#include "base/output/listed.hpp"

namespace slipproof {

namespace {

class MechanismWriter {
 public:
  explicit MechanismWriter(const Mechanism& mechanism) : m_(mechanism) {}

  std::string text() {
    line("schema", toml_string("slipproof/mechanism/1"));
    line("name", toml_string(m_.name));
    if (!m_.source.empty()) line("source", toml_string(m_.source));
    if (!m_.note.empty()) line("note", toml_string(m_.note));
    if (!m_.reciprocal) line("reciprocal", "false");
    if (m_.energy) line("energy", quoted(m_.energy));
    symbols();
    equations();
    for (const MechanismContact& contact : m_.contacts) this->contact(contact);
    for (const MechanismFriction& friction : m_.friction) this->friction(friction);
    for (const MechanismLink& link : m_.links) this->link(link);
    for (const MechanismShape& shape : m_.shapes) this->shape(shape);
    return std::move(text_);
  }

 private:
  static std::string quoted(const Expression& expression) { return toml_string(to_string(expression)); }
  static std::string quoted(const PlacedExpression& placed) { return quoted(placed.expression); }
  static std::string domain(const PlacedExpression& placed) {
    return placed.expression->operation == Operation::truth && placed.expression->truth ? "\"real\"" : quoted(placed);
  }
  static std::string two(const PlacedExpression& at_rest, const PlacedExpression& in_slip) {
    if (same(at_rest.expression, in_slip.expression)) return quoted(at_rest);
    return fmt::format("{{ static = {}, kinetic = {} }}", quoted(at_rest), quoted(in_slip));
  }
  static std::string array(const std::vector<std::string>& items) { return "[" + listed(items) + "]"; }
  static std::string array(const std::vector<PlacedExpression>& items) {
    std::vector<std::string> texts;
    for (const PlacedExpression& item : items) texts.push_back(quoted(item));
    return array(texts);
  }
  static bool is_key(const std::string& name) {
    return !name.empty() &&
           name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
               std::string::npos;
  }

  void header(std::string_view name) { text_ += fmt::format("\n{}\n", name); }
  void line(const std::string& key, const std::string& value) {
    text_ += fmt::format("{} = {}\n", is_key(key) ? key : toml_string(key), value);
  }

  static std::string described(const std::string& domain, const std::string& unit, const std::string& meaning,
                               bool optional) {
    std::string text = "{ domain = " + domain;
    if (!unit.empty()) text += ", unit = " + toml_string(unit);
    if (!meaning.empty()) text += ", meaning = " + toml_string(meaning);
    return text + (optional ? ", optional = true }" : " }");
  }

  void conditions(std::string_view name, const std::vector<MechanismCondition>& list) {
    if (!list.empty()) header(name);
    for (const MechanismCondition& one : list) line(one.name, quoted(one.condition));
  }

  void symbols() {
    header("[parameters]");
    for (const MechanismParameter& p : m_.parameters) {
      line(p.symbol, described(domain(p.domain), p.unit, p.meaning, p.optional));
    }
    conditions("[assume]", m_.assume);
    conditions("[realisable]", m_.realisable);
    if (!m_.definitions.empty()) header("[definitions]");
    for (const MechanismDefinition& one : m_.definitions) line(one.symbol, quoted(one.expression));
    if (!m_.angles.empty()) header("[angles]");
    for (const MechanismAngle& angle : m_.angles) {
      std::string text = fmt::format("{{ cos = {}, sin = {}, domain = {}", toml_string(angle.cosine),
                                     toml_string(angle.sine), domain(angle.domain));
      if (!angle.meaning.empty()) text += ", meaning = " + toml_string(angle.meaning);
      line(angle.name, text + " }");
    }
    if (m_.load) load(*m_.load);
  }

  void load(const MechanismLoad& load) {
    header("[load]");
    line("symbol", toml_string(load.symbol));
    std::vector<std::string> domains;
    for (const PlacedExpression& one : load.domain) {
      if (one.expression->operation != Operation::truth) domains.push_back(to_string(one.expression));
    }
    if (!domains.empty()) line("domain", toml_string(listed(domains, " and ")));
    if (!load.unit.empty()) line("unit", toml_string(load.unit));
    if (!load.meaning.empty()) line("meaning", toml_string(load.meaning));
  }

  void equations() {
    header("[unknowns]");
    std::vector<std::string> accelerations, forces;
    bool units = false;
    for (std::size_t i = 0; i < m_.unknowns.size(); ++i) {
      units = units || !m_.unknowns[i].unit.empty();
      if (i >= m_.accelerations + m_.forces) continue;
      (i < m_.accelerations ? accelerations : forces).push_back(toml_string(m_.unknowns[i].symbol));
    }
    line("accelerations", array(accelerations));
    if (!forces.empty()) line("forces", array(forces));
    if (units) header("[units]");
    for (const MechanismUnknown& unknown : m_.unknowns) {
      if (!unknown.unit.empty()) line(unknown.symbol, toml_string(unknown.unit));
    }
    header(m_.by_virtual_work ? "[motion]" : "[equations]");
    for (const MechanismEquation& e : m_.equations) {
      line(e.name, toml_string(to_string(e.left.expression) + " = " + to_string(e.right.expression)));
    }
  }

  void state(ElementKind::Start start) {
    if (start != ElementKind::Start::rest) line("state", toml_string(name(start)));
  }

  void contact(const MechanismContact& c) {
    header("[[contact]]");
    line("name", toml_string(c.name));
    line("gap", quoted(c.gap));
    if (c.slip) line("slip", quoted(c.slip));
    if (c.static_friction) line("friction", two(c.static_friction, c.kinetic_friction));
    line("normal", toml_string(m_.unknowns[c.normal].symbol));
    if (c.tangent) line("tangent", toml_string(m_.unknowns[*c.tangent].symbol));
    line("gap_name", toml_string(c.gap_name));
    if (c.slip) line("slip_name", toml_string(c.slip_name));
    state(c.start);
    if (c.bilateral) line("bilateral", "true");
    std::vector<std::string> needed;
    for (const std::size_t parameter : c.lift_needs) needed.push_back(toml_string(m_.parameters[parameter].symbol));
    if (!needed.empty()) line("lift_needs", array(needed));
    if (!c.at.empty()) line("at", array(c.at));
    if (!c.direction.empty()) line("direction", array(c.direction));
    if (!c.slip_direction.empty()) line("slip_direction", array(c.slip_direction));
  }

  void friction(const MechanismFriction& f) {
    header("[[friction]]");
    line("name", toml_string(f.name));
    line("slip", quoted(f.slip));
    line("limit", two(f.static_limit, f.kinetic_limit));
    line("force", toml_string(m_.unknowns[f.force].symbol));
    if (f.contact) line("contact", toml_string(m_.contacts[*f.contact].name));
    state(f.start);
  }

  void link(const MechanismLink& l) {
    header("[[link]]");
    line("name", toml_string(l.name));
    line("zero", quoted(l.zero));
    line("force", toml_string(m_.unknowns[l.force].symbol));
  }

  void shape(const MechanismShape& s) {
    header("[[shape]]");
    line("kind", toml_string(name(s.kind)));
    std::vector<std::string> points;
    for (const auto& point : s.points) points.push_back(array(point));
    line("points", array(points));
    if (s.radius) line("radius", quoted(s.radius));
    if (!s.text.empty()) line("text", toml_string(s.text));
    if (s.force) line("force", quoted(s.force));
    if (!s.acceleration.empty()) line("acceleration", toml_string(s.acceleration));
    if (s.still) line("still", "true");
    if (s.thin) line("thin", "true");
  }

  const Mechanism& m_;
  std::string text_;
};

}  // namespace

std::string to_toml(const Mechanism& mechanism) {
  return MechanismWriter(mechanism).text();
}

}  // namespace slipproof
