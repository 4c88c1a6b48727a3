#include "report/scenes/space_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number/format.hpp"
#include "mechanics/mechanism/words.hpp"
#include "report/picture/space/space_words.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "report/values/exact_json.hpp"
#include "report/values/mode_json.hpp"
#include "report/values/motions_json.hpp"
#include "report/values/number_text.hpp"
#include "report/values/quantity_units.hpp"

namespace slipproof {

namespace {

class SpaceText {
 public:
  SpaceText(const SolvedSpace& solved, int digits) : solved_(solved), m_(solved.scene.mechanism), digits_(digits) {}

  Document whole() {
    document_ = scene_document(solved_.scene, m_.name + ", " + counted(m_.contacts.size(), "contact") + " in space");
    std::string heading = counted_motions(solved_);
    if (m_.load) {
      heading = fmt::format("{} = {} {}: {}", m_.load->symbol, exact_text(*solved_.scene.load), m_.load->unit, heading);
    }
    if (solved_.complete()) {
      heading += solved_.motions.empty() ? ", and that is proved"
                 : are_near()            ? ", and it is proved that any other is near"
                                         : ", and it is proved that there is no other";
    }
    Document& section = document_.section(heading);
    if (m_.contacts.size() > 1) section.line("modes are those of " + contact_names());
    for (const SpaceMotion& motion : solved_.motions) write(section, motion);
    if (!solved_.complete()) write_undecided();
    document_.status(fmt::format("s {} motions {} undecided {}", solved_.complete() ? "COMPLETE" : "UNDECIDED",
                                 solved_.motions.size(), solved_.undecided.size()));
    return std::move(document_);
  }

 private:
  std::string contact_names() const {
    std::string names;
    for (const MechanismContact& contact : m_.contacts) names += (names.empty() ? "" : "/") + contact.name;
    return names;
  }

  bool are_near() const {
    return std::ranges::any_of(solved_.motions, [](const SpaceMotion& m) { return m.others_within.has_value(); });
  }

  std::string text_of(const Range& range, const std::string& unit) const { return range_text(range, digits_, unit); }

  void write(Document& document, const SpaceMotion& motion) const {
    Document& below = document.section(mode_of(motion) + (motion.strict ? "  (strict)" : ""));
    if (motion.others_within) {
      below.line("others may be near, whose gaps and slips differ by at most " +
                 decimal_text(*motion.others_within, 2));
    } else if (motion.is_continuum()) {
      below.line("a continuum: how forces are shared decides how it moves");
      below.line("one of its motions, another that is proved to differ, and where all of them are");
    }
    if (!motion.open_directions) {
      below.line("forces may be open, as directions of slips are no rational numbers: these are some of them");
    } else if (motion.may_be_open()) {
      below.line("forces are open along " + counted(*motion.open_directions, "direction") + ": these are some of them");
    }
    std::vector<const SpaceMotion*> side_by_side{&motion};
    for (const SpaceMotion& other : motion.others) side_by_side.push_back(&other);
    std::vector<ReportColumn> columns{"", motion.is_continuum() ? "one" : ""};
    columns.resize(1 + side_by_side.size(), "another");
    if (motion.is_continuum()) columns.emplace_back("all");
    ReportTable& table = below.table({std::move(columns)});
    const auto row = [&](const std::string& name, const auto& text, const std::string& of_all) {
      std::vector<ReportCell> cells{name};
      for (const SpaceMotion* one : side_by_side) cells.push_back(text(*one));
      if (motion.is_continuum()) cells.push_back(of_all);
      table.row(std::move(cells));
    };
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) {
      const auto slips = [&](const SpaceMotion& one) {
        return one.slips[i] ? text_of(*one.slips[i], "degrees") : std::string();
      };
      if (motion.slips[i]) row(m_.contacts[i].name + " slips at", slips, "");
    }
    const std::vector<std::string> accelerations = acceleration_names(m_), forces = force_names(m_),
                                   of_accelerations = acceleration_units(m_), of_forces = force_units(m_);
    for (std::size_t i = 0; i < accelerations.size(); ++i) {
      const auto own = [&](const SpaceMotion& one) { return text_of(one.accelerations[i], of_accelerations[i]); };
      row(accelerations[i], own,
          motion.is_continuum() ? text_of(motion.all_accelerations[i], of_accelerations[i]) : "");
    }
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const auto own = [&](const SpaceMotion& one) {
        return one.forces[i] ? text_of(*one.forces[i], of_forces[i]) : "open";
      };
      row(forces[i], own, "");
    }
  }

  void write_undecided() {
    constexpr std::size_t shown = 8;
    Document& section = document_.section("Patterns in which other motions may be");
    for (std::size_t i = 0; i < solved_.undecided.size() && i < shown; ++i) section.line(solved_.undecided[i]);
    if (solved_.undecided.size() > shown) section.line("and " + counted(solved_.undecided.size() - shown, "other"));
    if (solved_.open_speed) {
      section.line(fmt::format("no gap or slip acceleration is larger there than {:.3g}", *solved_.open_speed));
    }
  }

  const SolvedSpace& solved_;
  const Mechanism& m_;
  int digits_;
  Document document_;
};

Json named(const std::vector<std::string>& names, const std::vector<Range>& ranges) {
  Json result = Json::object();
  for (std::size_t i = 0; i < names.size(); ++i) result[names[i]] = ends_json(ranges[i]);
  return result;
}

/// What it is, without what is proved of it.
Json numbers_json(const Mechanism& m, const SpaceMotion& motion) {
  Json slips = Json::object(), forces = Json::object();
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    if (motion.slips[i]) slips[m.contacts[i].name] = ends_json(*motion.slips[i]);
  }
  const std::vector<std::string> force = force_names(m);
  for (std::size_t i = 0; i < force.size(); ++i) {
    forces[force[i]] = motion.forces[i] ? ends_json(*motion.forces[i]) : Json(nullptr);
  }
  return {{"modes", Json::array({mode_of(motion)})},
          {"slips", std::move(slips)},
          {"accelerations", named(acceleration_names(m), motion.accelerations)},
          {"forces", std::move(forces)}};
}

}  // namespace

Json motion_json(const Mechanism& m, const SpaceMotion& motion) {
  Json result = numbers_json(m, motion);
  result["exists"] = motion.exists;
  result["unique"] = motion.unique;
  result["others_within"] = to_json(motion.others_within);
  if (motion.is_continuum()) {
    result["others"] = Json::array();
    for (const SpaceMotion& other : motion.others) result["others"].push_back(numbers_json(m, other));
    result["all_accelerations"] = named(acceleration_names(m), motion.all_accelerations);
  }
  result["open_directions"] = motion.open_directions ? Json(*motion.open_directions) : Json(nullptr);
  result["status"] = motion.strict ? "strict" : "boundary";
  return result;
}

Document space_document(const SolvedSpace& solved, int digits) {
  return SpaceText(solved, digits).whole();
}

std::string space_json(const SolvedSpace& solved) {
  const Mechanism& m = solved.scene.mechanism;
  Json document{{"schema", "slipproof/space/1"}, {"scene", solved.scene.name}, {"mechanism", m.name}};
  document["values"] = values_json(m, solved.scene.values);
  document["load"] = nullptr;
  if (m.load) document["load"] = {{"symbol", m.load->symbol}, {"value", to_json(solved.scene.load)}};
  document["notes"] = solved.scene.notes;
  document["contacts"] = Json::array();
  for (const MechanismContact& contact : m.contacts) document["contacts"].push_back(contact.name);
  document["complete"] = solved.complete();
  document["motions"] = Json::array();
  for (const SpaceMotion& motion : solved.motions) document["motions"].push_back(motion_json(m, motion));
  document["undecided"] = solved.undecided;
  document["open_speed"] = solved.open_speed ? Json(*solved.open_speed) : Json(nullptr);
  document["programs"] = solved.programs;
  return json_text(document);
}

}  // namespace slipproof
