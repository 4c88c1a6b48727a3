#include <string_view>

#include "base/algebra/real_roots.hpp"
#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "mechanics/kernel/motion.hpp"
#include "report/expected/expected.hpp"
#include "report/picture/space/space_words.hpp"
#include "report/scenes/impact_report.hpp"
#include "report/values/mode_json.hpp"

namespace slipproof {

namespace expected {

namespace {

Json number_json(const Rational& value) {
  return {{"exact", exact_text(value)}, {"double", nearest_binary64(value) + 0.0}};
}
Json number_json(const std::optional<Rational>& value) {
  return value ? number_json(*value) : Json(nullptr);
}
Json range_json(const Range& range) {
  if (range.is_point()) return number_json(*range.lower);
  return {{"lower", number_json(range.lower)}, {"upper", number_json(range.upper)}};
}
Json range_json(const std::optional<Range>& range) {
  return range ? range_json(*range) : Json(nullptr);
}
template <class Ranges>
Json ranges_json(const std::vector<std::string>& names, const Ranges& ranges) {
  Json result = Json::object();
  for (std::size_t i = 0; i < names.size(); ++i) result[names[i]] = range_json(ranges[i]);
  return result;
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

/// What a document says first: the scene.
Json scene_json(const std::string& id, const MechanismScene& scene) {
  const Mechanism& m = scene.mechanism;
  Json document{{"schema", "slipproof/expected/1"}, {"scene", id}, {"name", scene.name}};
  document["question"] = text_or_null(scene.question);
  document["asked"] = text_or_null(scene.asked);
  document["mechanism"] = m.name;
  document["values"] = values_json(m, scene.values);
  document["load"] = nullptr;
  if (m.load) document["load"] = {{"symbol", m.load->symbol}, {"value", number_json(scene.load)}};
  document["unknowns"] = Json::array();
  for (std::size_t i = 0; i < m.accelerations; ++i) document["unknowns"].push_back(m.unknowns[i].symbol);
  return document;
}

Json there_json(const MotionsThere& there) {
  Json motions = Json::array();
  for (const auto& modes : there.motions) motions.push_back(names_json(modes));
  return {{"motions", std::move(motions)}, {"continua", names_json(there.continua)}};
}

class ExpectedDocument {
 public:
  explicit ExpectedDocument(const ExpectedAnswer& answer)
      : answer_(answer), scene_(answer.solved.scene), m_(scene_.mechanism), found_(*answer.solved.at_load) {}

  Json whole() const {
    Json document = scene_json(answer_.id, scene_);
    document["how_many"] = how_many();
    document["by_kinematics"] = answer_.solved.by_kinematics;
    put_motions(document);
    document["threshold"] = threshold();
    return document;
  }

 private:
  std::string_view how_many() const {
    if (!found_.continua.empty()) return "a continuum";
    if (found_.motions.empty()) return "none";
    return found_.motions.size() == 1 ? "one" : "several";
  }

  void put_motions(Json& document) const {
    const auto accelerations = acceleration_names(m_), forces = force_names(m_);
    document["motions"] = Json::array();
    document["continua"] = Json::array();
    for (const MotionAtLoad& motion : found_.motions) {
      std::vector<Range> points;
      for (const Rational& value : motion.accelerations) points.push_back({value, value});
      document["motions"].push_back({{"modes", names_json(motion.modes)},
                                     {"boundary_modes", names_json(motion.boundary_modes)},
                                     {"status", motion.strict() ? "strict" : "boundary"},
                                     {"accelerations", ranges_json(accelerations, points)},
                                     {"forces", ranges_json(forces, motion.forces)}});
    }
    for (const ContinuumAtLoad& continuum : found_.continua) {
      document["continua"].push_back({{"mode", name(continuum.mode)},
                                      {"status", continuum.strict ? "strict" : "boundary"},
                                      {"accelerations", ranges_json(accelerations, continuum.accelerations)},
                                      {"forces", ranges_json(forces, continuum.forces)}});
    }
  }

  Json threshold() const {
    const auto& given = scene_.threshold;
    if (!given) return nullptr;
    Json changes = Json::array();
    for (const MotionChange& change : answer_.changes) {
      changes.push_back({{"at", root_json(change.at)},
                         {"below", there_json(change.below)},
                         {"here", change.here ? there_json(*change.here) : Json(nullptr)},
                         {"above", there_json(change.above)}});
    }
    return {{"parameter", given->parameter},
            {"from", number_json(given->from)},
            {"to", number_json(given->to)},
            {"changes", std::move(changes)}};
  }

  Json root_json(const RealRoot& root) const {
    if (root.is_rational()) return number_json(root.lower);
    const std::string& symbol = scene_.threshold->parameter;
    RealRoot place = root;
    const double nearest = nearest_binary64(place);
    return {{"polynomial", text_of(*root.polynomial, symbol)},
            {"interval", {exact_text(place.lower), exact_text(place.upper)}},
            {"double", nearest}};
  }

  const ExpectedAnswer& answer_;
  const MechanismScene& scene_;
  const Mechanism& m_;
  const MotionsAtLoad& found_;
};

Json expected_motion(const Mechanism& m, const SpaceMotion& motion) {
  Json slips = Json::object();
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    if (motion.slips[i]) slips[m.contacts[i].name] = range_json(*motion.slips[i]);
  }
  return {{"modes", Json::array({mode_of(motion)})},
          {"status", motion.strict ? "strict" : "boundary"},
          {"slips", std::move(slips)},
          {"accelerations", ranges_json(acceleration_names(m), motion.accelerations)},
          {"forces", ranges_json(force_names(m), motion.forces)},
          {"exists", motion.exists},
          {"unique", motion.unique},
          {"others_within", number_json(motion.others_within)},
          {"open_directions", motion.open_directions ? Json(*motion.open_directions) : Json(nullptr)}};
}

std::string_view how_many(const SolvedSpace& solved) {
  if (!solved.complete()) return "undecided";
  for (const SpaceMotion& motion : solved.motions) {
    if (motion.is_continuum()) return "a continuum";
  }
  return solved.motions.empty() ? "none" : solved.motions.size() == 1 ? "one" : "several";
}

Json known_json(const std::optional<bool>& known) {
  return known ? Json(*known) : Json(nullptr);
}

/// Each motion has one mode in space.
Json there_json(const MotionSet& set) {
  Json motions = Json::array(), continua = Json::array();
  for (const auto& modes : set.motions) motions.push_back(Json::array({mode_name(set, modes.front())}));
  for (const MechanismMode& mode : set.continua) continua.push_back(mode_name(set, mode));
  return {{"motions", std::move(motions)}, {"continua", std::move(continua)}};
}

Json threshold_json(const ExpectedInSpace& answer) {
  const auto& given = answer.solved.scene.threshold;
  if (!given) return nullptr;
  Json changes = Json::array();
  for (const ChangeInSpace& change : answer.changes) {
    changes.push_back({{"at", range_json(Range{change.lower, change.upper})},
                       {"below", there_json(change.below)},
                       {"above", there_json(change.above)}});
  }
  return {{"parameter", given->parameter},
          {"from", number_json(given->from)},
          {"to", number_json(given->to)},
          {"changes", std::move(changes)}};
}

Json document_of(const ExpectedAnswer& answer) {
  return ExpectedDocument(answer).whole();
}
Json document_of(const ExpectedInSpace& answer) {
  const SolvedSpace& solved = answer.solved;
  Json document = scene_json(answer.id, solved.scene);
  document["dimension"] = 3;
  document["how_many"] = how_many(solved);
  document["complete"] = solved.complete();
  document["motions"] = Json::array();
  for (const SpaceMotion& motion : solved.motions) {
    document["motions"].push_back(expected_motion(solved.scene.mechanism, motion));
  }
  document["undecided"] = solved.undecided;
  document["can_rest"] = known_json(answer.can_rest);
  document["must_rest"] = known_json(answer.must_rest);
  document["threshold"] = threshold_json(answer);
  return document;
}

/// What impact_json() has, once for all laws: and by each law its outcomes.
Json document_of(const ExpectedImpact& answer) {
  Json document = scene_json(answer.id, answer.scene());
  document["dimension"] = answer.scene().mechanism.dimension;
  document["unknowns"].clear();
  Json laws = Json::object();
  for (const SolvedImpact& solved : answer.laws) {
    Json one = impact_value(solved);
    document["before"] = one["before"];
    laws[one["law"].get<std::string>()] = {
        {"complete", one["complete"]}, {"outcomes", one["outcomes"]}, {"undecided", one["undecided"]}};
  }
  for (const auto& [name, value] : document["before"]["velocities"].items()) document["unknowns"].push_back(name);
  document["impact"] = std::move(laws);
  return document;
}

}  // namespace

}  // namespace expected

Expected expected_of(MechanismScene scene, const std::string& id) {
  if (scene.mechanism.dimension == 2) return expected_answer(std::move(scene), id);
  return expected_in_space(std::move(scene), id);
}

Expected expected_of(const std::filesystem::path& file, const std::string& id) {
  MechanismScene scene = read_scene(file, Dimensions::any);
  if (scene.mechanism.impact) return expected_impact(file, id);
  return expected_of(std::move(scene), id);
}

const MechanismScene& scene_of(const Expected& expected) {
  if (const auto* impact = std::get_if<ExpectedImpact>(&expected)) return impact->scene();
  const auto* space = std::get_if<ExpectedInSpace>(&expected);
  return space != nullptr ? space->solved.scene : std::get<ExpectedAnswer>(expected).solved.scene;
}

std::string expected_json(const std::vector<Expected>& answers) {
  Json all = Json::array();
  for (const Expected& answer : answers) {
    all.push_back(std::visit([](const auto& one) { return expected::document_of(one); }, answer));
  }
  return dump(answers.size() == 1 ? all.front() : all);
}

}  // namespace slipproof
