#include <string_view>

#include "base/algebra/real_roots.hpp"
#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "mechanics/kernel/motion.hpp"
#include "report/expected/expected.hpp"
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
Json ranges_json(const std::vector<std::string>& names, const std::vector<Range>& ranges) {
  Json result = Json::object();
  for (std::size_t i = 0; i < names.size(); ++i) result[names[i]] = range_json(ranges[i]);
  return result;
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
    Json document{{"schema", "slipproof/expected/1"}, {"scene", answer_.id}, {"name", scene_.name}};
    document["question"] = text_or_null(scene_.question);
    document["asked"] = text_or_null(scene_.asked);
    document["mechanism"] = m_.name;
    document["values"] = values_json(m_, scene_.values);
    document["load"] = nullptr;
    if (m_.load) document["load"] = {{"symbol", m_.load->symbol}, {"value", number_json(scene_.load)}};
    document["unknowns"] = Json::array();
    for (std::size_t i = 0; i < m_.accelerations; ++i) document["unknowns"].push_back(m_.unknowns[i].symbol);
    document["how_many"] = how_many();
    document["by_kinematics"] = answer_.solved.by_kinematics;
    put_motions(document);
    document["threshold"] = threshold();
    return document;
  }

 private:
  static Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

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

}  // namespace

}  // namespace expected

std::string expected_json(const std::vector<ExpectedAnswer>& answers) {
  if (answers.size() == 1) return dump(expected::ExpectedDocument(answers.front()).whole());
  Json all = Json::array();
  for (const ExpectedAnswer& answer : answers) all.push_back(expected::ExpectedDocument(answer).whole());
  return dump(all);
}

}  // namespace slipproof
