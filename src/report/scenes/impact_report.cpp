#include "report/scenes/impact_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "report/values/mode_json.hpp"
#include "report/values/motions_json.hpp"
#include "report/values/number_text.hpp"

namespace slipproof {

namespace {

/// A velocity of a contact, before and after.
struct ContactVelocity {
  std::string name;
  Rational before;
  Range after;
};

/// What both reports say of an impact.
class ImpactReport {
 public:
  explicit ImpactReport(const SolvedImpact& solved)
      : solved_(solved),
        m_(solved.scene.mechanism),
        impact_(*m_.impact),
        motion_(acceleration_names(m_)),
        impulses_(force_names(m_)) {}

 protected:
  const Range& after(const ImpactOutcome& outcome, const std::string& name) const {
    return outcome.motion[static_cast<std::size_t>(std::ranges::find(motion_, name) - motion_.begin())];
  }

  static Range less(Range range, const Rational& by) {
    if (range.lower) *range.lower -= by;
    if (range.upper) *range.upper -= by;
    return range;
  }

  /// Opening, then sliding; nothing of a contact that is apart.
  std::vector<ContactVelocity> contact_velocities(const ImpactOutcome& outcome, std::size_t index) const {
    const SolvedImpact::Contact& before = solved_.contacts[index];
    const MechanismImpact::Contact& contact = impact_.contacts[index];
    if (!before.closed) return {};
    std::vector<ContactVelocity> result{
        {"opening", before.opening, less(after(outcome, contact.gap), before.restored)}};
    if (!contact.slip.empty()) {
      result.push_back({"sliding", before.sliding, less(after(outcome, contact.slip), before.slip_restored)});
    }
    if (!contact.second_slip.empty()) {
      result.push_back({"sliding2", before.second, less(after(outcome, contact.second_slip), before.second_restored)});
    }
    return result;
  }

  const SolvedImpact& solved_;
  const Mechanism& m_;
  const MechanismImpact& impact_;
  std::vector<std::string> motion_, impulses_;
};

class ImpactText : public ImpactReport {
 public:
  ImpactText(const SolvedImpact& solved, int digits) : ImpactReport(solved), digits_(digits) {}

  Document whole() {
    document_ = scene_document(solved_.scene, m_.name + ", an impact by " + solved_.law_words());
    for (const std::string& friction : impact_.left_out) {
      document_.line("note: " + friction + " has a finite limit, and so no impulse");
    }
    std::string heading = counted(solved_.outcomes.size(), "outcome");
    if (!solved_.complete()) {
      heading += ", and there may be others";
    } else if (solved_.space) {
      heading += solved_.outcomes.empty() ? ", and that is proved" : ", and it is proved that there is no other";
    }
    Document& section = document_.section(heading);
    if (m_.elements() > 1) {
      std::string names;
      for (std::size_t i = 0; i < m_.elements(); ++i) names += (names.empty() ? "" : "/") + element_name(m_, i);
      section.line("modes are those of " + names);
    }
    for (const ImpactOutcome& outcome : solved_.outcomes) write(section, outcome);
    if (!solved_.undecided.empty()) {
      Document& open = document_.section("Patterns in which other outcomes may be");
      for (const std::string& pattern : solved_.undecided) open.line(pattern);
    }
    const auto gaining = std::ranges::count_if(solved_.outcomes, [](const auto& one) { return one.gains == true; });
    document_.status(fmt::format("s {} outcomes {} gain energy {} undecided {}",
                                 solved_.complete() ? "COMPLETE" : "UNDECIDED", solved_.outcomes.size(), gaining,
                                 solved_.undecided.size()));
    return std::move(document_);
  }

 private:
  std::string text_of(const Range& range) const { return range_text(range, digits_); }
  std::string text_of(const Rational& number) const { return number_text(number, digits_); }

  void write(Document& document, const ImpactOutcome& outcome) const {
    const auto same = [](const std::string& mode) { return mode; };
    constexpr std::size_t shown = 8;
    const std::size_t count = std::min(outcome.modes.size(), shown);
    std::string heading =
        listed(std::vector(outcome.modes.begin(), outcome.modes.begin() + std::ptrdiff_t(count)), same, " = ");
    if (outcome.modes.size() > shown) heading += " and " + counted(outcome.modes.size() - shown, "other");
    Document& below = document.section(heading + (outcome.continuum ? "  a continuum" : "") +
                                       (outcome.strict ? "  (strict)" : "  (boundary)"));
    below.line(energy_words(solved_, outcome));
    ReportTable& table = below.table({{"", "before", "after"}});
    for (std::size_t i = 0; i < solved_.velocities.size(); ++i) {
      table.row({motion_[i], text_of(solved_.velocities[i]), text_of(outcome.motion[i])});
    }
    for (std::size_t i = 0; i < solved_.contacts.size(); ++i) {
      for (const ContactVelocity& velocity : contact_velocities(outcome, i)) {
        table.row({impact_.contacts[i].name + " " + velocity.name, text_of(velocity.before), text_of(velocity.after)});
      }
    }
    table.row({"energy", text_of(solved_.energy), text_of(outcome.energy)});
    for (std::size_t i = solved_.velocities.size(); i < m_.accelerations; ++i) {
      table.row({motion_[i], "", text_of(outcome.motion[i])});
    }
    for (std::size_t i = 0; i < impulses_.size(); ++i) {
      table.row({impulses_[i], "", outcome.impulses[i] ? text_of(*outcome.impulses[i]) : "open"});
    }
  }

  int digits_;
  Document document_;
};

class ImpactDocument : public ImpactReport {
 public:
  using ImpactReport::ImpactReport;

  Json whole() const {
    Json document{{"schema", "slipproof/impact/1"}, {"scene", solved_.scene.name}, {"mechanism", m_.name}};
    document["law"] = name(impact_.law);
    document["values"] = values_json(m_, solved_.scene.values);
    document["load"] = nullptr;
    if (m_.load) document["load"] = {{"symbol", m_.load->symbol}, {"value", to_json(solved_.scene.load)}};
    document["notes"] = solved_.scene.notes;
    document["without_impulse"] = impact_.left_out;
    document["before"] = before();
    document["complete"] = solved_.complete();
    document["outcomes"] = Json::array();
    for (const ImpactOutcome& outcome : solved_.outcomes) document["outcomes"].push_back(of(outcome));
    document["undecided"] = solved_.undecided;
    return document;
  }

 private:
  Json before() const {
    Json velocities = Json::object(), contacts = Json::object();
    for (std::size_t i = 0; i < solved_.velocities.size(); ++i) {
      velocities[motion_[i]] = to_json(solved_.velocities[i]);
    }
    for (std::size_t i = 0; i < solved_.contacts.size(); ++i) {
      const SolvedImpact::Contact& contact = solved_.contacts[i];
      if (!contact.closed) continue;
      Json& entry = contacts[impact_.contacts[i].name];
      entry["opening"] = to_json(contact.opening);
      if (!impact_.contacts[i].slip.empty()) entry["sliding"] = to_json(contact.sliding);
      if (!impact_.contacts[i].second_slip.empty()) entry["sliding2"] = to_json(contact.second);
    }
    return {
        {"velocities", std::move(velocities)}, {"contacts", std::move(contacts)}, {"energy", to_json(solved_.energy)}};
  }

  Json of(const ImpactOutcome& outcome) const {
    Json velocities = Json::object(), contacts = Json::object(), impulses = Json::object();
    for (std::size_t i = 0; i < m_.accelerations; ++i) velocities[motion_[i]] = range_value(outcome.motion[i]);
    for (std::size_t i = 0; i < solved_.contacts.size(); ++i) {
      for (const ContactVelocity& one : contact_velocities(outcome, i)) {
        contacts[impact_.contacts[i].name][one.name] = range_value(one.after);
      }
    }
    for (std::size_t i = 0; i < impulses_.size(); ++i) {
      impulses[impulses_[i]] = outcome.impulses[i] ? range_value(*outcome.impulses[i]) : Json(nullptr);
    }
    return {{"modes", outcome.modes},
            {"status", outcome.strict ? "strict" : "boundary"},
            {"continuum", outcome.continuum},
            {"exists", outcome.exists},
            {"unique", outcome.unique},
            {"velocities", std::move(velocities)},
            {"contacts", std::move(contacts)},
            {"impulses", std::move(impulses)},
            {"energy", range_value(outcome.energy)},
            {"gains_energy", outcome.gains ? Json(*outcome.gains) : Json(nullptr)}};
  }
};

}  // namespace

std::string energy_words(const SolvedImpact& solved, const ImpactOutcome& outcome) {
  if (solved.driven) return "bodies that move as prescribed may put energy in";
  const bool known = outcome.energy.lower && outcome.energy.upper && !solved.energy.is_zero();
  if (!outcome.gains || !known) return "not known whether energy is gained";
  const Range& after = outcome.energy;
  if (after.is_point() && *after.lower == solved.energy) return "no energy is lost";
  const Rational end = *outcome.gains ? *after.lower : *after.upper;
  const Rational share = (end - solved.energy) * 100 / solved.energy;
  const std::string least = after.is_point() ? "" : "at least ";
  if (*outcome.gains) return "GAINS " + least + decimal_text(share, 4) + " % of the energy";
  return "loses " + least + decimal_text(-share, 4) + " % of the energy";
}

Json range_value(const Range& range) {
  return range.is_point() ? to_json(*range.lower) : ends_json(range);
}

Document impact_document(const SolvedImpact& solved, int digits) {
  return ImpactText(solved, digits).whole();
}

Json impact_value(const SolvedImpact& solved) {
  return ImpactDocument(solved).whole();
}

std::string impact_json(const SolvedImpact& solved) {
  return dump(impact_value(solved));
}

}  // namespace slipproof
