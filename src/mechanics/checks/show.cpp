#include "mechanics/checks/show.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/input/utf8.hpp"
#include "base/output/listed.hpp"
#include "mechanics/checks/free_motion.hpp"
#include "mechanics/elements/element.hpp"
#include "mechanics/kernel/kinematic_modes.hpp"

namespace slipproof {

namespace {

std::string padded(const std::string& text, std::size_t width) {
  const std::size_t length = utf8_count(text);
  return text + std::string(length < width ? width - length : 0, ' ');
}

/// Rows of a table: all columns but the last padded, the last one wrapped.
std::string columns(const std::vector<std::vector<std::string>>& rows) {
  constexpr std::size_t widest = 30;
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      widths[i] = std::max(widths[i], std::min(widest, utf8_count(row[i])));
    }
  }
  std::string text;
  for (const auto& row : rows) {
    std::string start = "  ";
    for (std::size_t i = 0; i + 1 < row.size(); ++i) start += padded(row[i], widths[i]) + "  ";
    text += wrapped(start, row.back());
  }
  return text;
}

std::string domain_text(const PlacedExpression& domain) {
  return domain.expression->operation == Operation::truth ? "any" : to_string(domain.expression);
}

std::string start_text(ElementKind::Start start) {
  switch (start) {
    case ElementKind::Start::rest:
      return "at rest";
    case ElementKind::Start::slides_forward:
      return "slides forward";
    case ElementKind::Start::slides_backward:
      return "slides backward";
    case ElementKind::Start::open:
      break;
  }
  return "open";
}

std::string two(const PlacedExpression& at_rest, const PlacedExpression& in_slip) {
  const std::string first = to_string(at_rest.expression);
  if (same(at_rest.expression, in_slip.expression)) return first;
  return first + " at rest, " + to_string(in_slip.expression) + " in slip";
}

class MechanismText {
 public:
  explicit MechanismText(const Mechanism& mechanism) : m_(mechanism), kinds_(element_kinds(mechanism)) {
    for (ElementKind& kind : kinds_) kind.slips = true;
  }

  std::string text() {
    text_ = wrapped("", m_.name);
    if (!m_.source.empty()) text_ += wrapped("source: ", m_.source);
    if (!m_.note.empty()) text_ += wrapped("note: ", m_.note);
    parameters();
    conditions("Assumed", m_.assume);
    conditions("Realisable", m_.realisable);
    unknowns();
    equations();
    contacts();
    friction();
    links();
    if (m_.dimension == 3) return std::move(text_);
    const double modes = mode_count(kinds_);
    text_ += fmt::format("\nModes: {:.0f}{}\n", modes,
                         modes > max_tried ? ", too many to try each: motions are found by kinematics" : "");
    return text_;
  }

 private:
  void section(const std::string& title, const std::vector<std::vector<std::string>>& rows) {
    if (!rows.empty()) text_ += "\n" + title + "\n" + columns(rows);
  }

  void parameters() {
    std::vector<std::vector<std::string>> rows;
    for (const MechanismParameter& p : m_.parameters) {
      rows.push_back({p.symbol, domain_text(p.domain), p.unit, p.meaning + (p.optional ? " (optional)" : "")});
    }
    section("Parameters", rows);
    rows.clear();
    for (const MechanismAngle& a : m_.angles) {
      rows.push_back({a.name, domain_text(a.domain), a.cosine + " = cos, " + a.sine + " = sin", a.meaning});
    }
    section("Angles", rows);
    rows.clear();
    for (const MechanismDefinition& d : m_.definitions)
      rows.push_back({d.symbol, "= " + to_string(d.expression.expression)});
    section("Definitions", rows);
    if (!m_.load) return;
    std::vector<std::string> domain;
    for (const PlacedExpression& one : m_.load->domain) {
      if (one.expression->operation != Operation::truth) domain.push_back(to_string(one.expression));
    }
    section("Load",
            {{m_.load->symbol, domain.empty() ? "any" : listed(domain, " and "), m_.load->unit, m_.load->meaning}});
  }

  void conditions(const std::string& title, const std::vector<MechanismCondition>& list) {
    std::vector<std::vector<std::string>> rows;
    for (const MechanismCondition& one : list) rows.push_back({one.name, to_string(one.condition.expression)});
    section(title, rows);
  }

  void unknowns() {
    std::vector<std::string> accelerations = acceleration_names(m_);
    accelerations.resize(m_.accelerations);
    std::vector<std::vector<std::string>> rows{
        {m_.impact ? "velocities after" : "accelerations", listed(accelerations)}};
    if (m_.unknowns.size() > m_.accelerations) {
      rows.push_back({m_.impact ? "impulses" : "forces", listed(force_names(m_))});
    }
    section("Unknowns", rows);
  }

  void equations() {
    std::vector<std::vector<std::string>> rows;
    for (const MechanismEquation& e : m_.equations) {
      rows.push_back({e.name, to_string(e.left.expression) + " = " + to_string(e.whole_right())});
    }
    section(m_.by_virtual_work ? "Equations, contact forces by virtual work" : "Equations", rows);
  }

  static constexpr const char* any_slip = "slip in a direction";
  static std::string vector_text(const std::vector<PlacedExpression>& vector) {
    return "(" + listed(vector, [](const PlacedExpression& one) { return to_string(one.expression); }) + ")";
  }
  std::string states_of(std::size_t element) const {
    std::vector<std::string> names;
    for (const ElementState state : states(kinds_[element])) {
      names.emplace_back(state == ElementState::slip ? any_slip : name(state));
    }
    return listed(names);
  }

  void contacts() {
    if (!m_.contacts.empty()) text_ += "\nContacts\n";
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) {
      const MechanismContact& c = m_.contacts[i];
      std::string what =
          m_.dimension == 3 && c.start == ElementKind::Start::slides_forward ? "slides" : start_text(c.start);
      if (c.bilateral) what += ", a guide";
      what += c.frictionless() ? ", without friction" : ", friction " + two(c.static_friction, c.kinetic_friction);
      std::vector<std::string> forces{m_.unknowns[c.normal].symbol};
      if (c.tangent) forces.push_back(m_.unknowns[*c.tangent].symbol);
      std::vector<std::vector<std::string>> rows{{"  " + c.gap_name, "= " + to_string(c.gap.expression)}};
      if (c.slip) rows.push_back({"  " + c.slip_name, "= " + to_string(c.slip.expression)});
      if (c.second) {
        forces.push_back(m_.unknowns[c.second->force].symbol);
        rows.push_back({"  " + c.second->name, "= " + to_string(c.second->slip.expression)});
        rows.push_back({"  T1 along", vector_text(c.slip_direction)});
        rows.push_back({"  T2 along", vector_text(c.second->direction)});
      }
      if (!c.sliding.empty()) rows.push_back({"  slides along", vector_text(c.sliding) + " of T1, T2"});
      rows.push_back({"  forces", listed(forces)});
      rows.push_back({"  states", states_of(i)});
      if (!c.lift_needs.empty()) {
        std::vector<std::string> needed;
        for (const std::size_t parameter : c.lift_needs) needed.push_back(m_.parameters[parameter].symbol);
        rows.push_back({"  lift", "only with " + listed(needed)});
      }
      text_ += wrapped("  " + c.name + ": ", what) + columns(rows);
    }
  }

  void friction() {
    if (!m_.friction.empty()) text_ += "\nFriction elements\n";
    for (std::size_t i = 0; i < m_.friction.size(); ++i) {
      const MechanismFriction& f = m_.friction[i];
      text_ += wrapped("  " + f.name + ": ", start_text(f.start) + ", limit " + two(f.static_limit, f.kinetic_limit));
      text_ += columns({{"  " + f.slip_name, "= " + to_string(f.slip.expression)},
                        {"  force", m_.unknowns[f.force].symbol},
                        {"  states", states_of(m_.contacts.size() + i)}});
    }
  }

  void links() {
    std::vector<std::vector<std::string>> rows;
    for (const MechanismLink& link : m_.links) {
      rows.push_back(
          {link.name, "0 = " + to_string(link.zero.expression) + ", force " + m_.unknowns[link.force].symbol});
    }
    section("Links", rows);
    if (m_.links.empty()) return;
    const auto found = mechanism_checks::freedom(m_);
    if (!found) return;
    text_ += fmt::format("\nDegrees of freedom, contacts and friction aside: {}\n", found->degrees);
    if (found->said_before.empty()) return;
    const std::string names = listed(found->said_before, [&](std::size_t link) { return m_.links[link].name; });
    text_ += wrapped("  said by the links before: ", names + ", so that their forces are undetermined");
  }

  const Mechanism& m_;
  std::vector<ElementKind> kinds_;
  std::string text_;
};

}  // namespace

std::string show_text(const Mechanism& mechanism, const std::vector<MechanismFinding>& findings) {
  std::string text = MechanismText(mechanism).text();
  if (!findings.empty()) text += "\n";
  for (const MechanismFinding& finding : findings) text += wrapped("", to_string(mechanism, finding));
  return text;
}

}  // namespace slipproof
