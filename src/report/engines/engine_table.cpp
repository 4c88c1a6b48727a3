#include "report/engines/engine_table.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "base/algebra/real_roots.hpp"
#include "base/number/binary64.hpp"
#include "base/output/json.hpp"
#include "base/parallel/in_parallel.hpp"

namespace slipproof {

namespace {

constexpr std::string_view threshold_asked = "threshold";  // or `threshold, many iterations`

/// Not about the motion of a scene as it is.
bool is_about_more(const EngineAnswer& answer) {
  return answer.threshold || answer.asked.starts_with(threshold_asked) || answer.asked == "drift" ||
         answer.asked == "energy";
}

/// How the engine was asked for a threshold: `default`, `many iterations`.
std::string way_of(const EngineAnswer& answer) {
  constexpr std::string_view comma = ", ";
  const std::string way = answer.asked.substr(std::min(answer.asked.size(), threshold_asked.size() + comma.size()));
  return way.empty() ? "default" : way;
}

double place_of(const MotionChange& change) {
  RealRoot at = change.at;
  return nearest_binary64(at);
}
/// In the middle of what is proved to hold it.
double place_of(const ChangeInSpace& change) {
  return nearest_binary64((change.lower + change.upper) / 2);
}

/// Where the motions of a scene change.
std::vector<double> changes_of(const Expected& expected) {
  std::vector<double> places;
  const auto take = [&](const auto* answer) {
    if (answer == nullptr) return;
    for (const auto& change : answer->changes) places.push_back(place_of(change));
  };
  take(std::get_if<ExpectedAnswer>(&expected));
  take(std::get_if<ExpectedInSpace>(&expected));
  return places;
}

std::optional<double> nearest(const std::vector<double>& values, double to) {
  const auto found = std::ranges::min_element(values, {}, [&](double value) { return std::abs(value - to); });
  return found == values.end() ? std::nullopt : std::optional(*found);
}

Json counts_json(const EngineCounts& counts) {
  Json json = Json::object();
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) json[std::string(name(static_cast<EngineVerdict>(i)))] = counts[i];
  }
  return json;
}

}  // namespace

EngineResults engine_results(JudgedEngines judged) {
  EngineResults results{std::move(judged), {}};
  std::vector<std::optional<Expected>> expected(results.judged.scenes.size());
  in_parallel(0, expected.size(), [&](std::size_t i) {
    const EngineScene& scene = results.judged.scenes[i];
    expected[i] = expected_of(scene.file, scene.name);
  });
  for (auto& one : expected) results.expected.push_back(std::move(*one));
  return results;
}

double EngineThresholdRow::off() const {
  const double apart = std::abs(found.changes_at - *exact);
  return *exact == 0 ? apart : apart / std::abs(*exact);
}

std::vector<EngineThresholdRow> engine_thresholds(const EngineResults& results) {
  std::vector<EngineThresholdRow> rows;
  for (std::size_t i = 0; i < results.expected.size(); ++i) {
    const EngineScene& scene = results.judged.scenes[i];
    const std::vector<double> changes = changes_of(results.expected[i]);
    for (const JudgedEngineAnswer& one : scene.answers) {
      if (!one.answer.threshold) continue;
      const EngineThreshold& found = *one.answer.threshold;
      rows.push_back({one.answer.engine, way_of(one.answer), scene.name, found, nearest(changes, found.changes_at)});
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
    return std::tie(a.engine, a.asked) < std::tie(b.engine, b.asked);
  });
  return rows;
}

std::vector<EngineImpactRow> engine_impacts(const JudgedEngines& judged) {
  std::map<std::pair<std::string, std::string>, EngineImpactRow> rows;
  for (const EngineScene& scene : judged.scenes) {
    for (const JudgedEngineAnswer& one : scene.answers) {
      if (!scene.scene.mechanism.impact || one.answer.motion.empty()) continue;
      EngineImpactRow& row = rows[{one.answer.engine, one.answer.asked}];
      row.engine = one.answer.engine, row.asked = one.answer.asked;
      ++row.scenes;
      for (const ImpactLaw law : one.laws) ++row.right[static_cast<std::size_t>(law)];
      row.by_no_law += one.laws.empty() ? 1 : 0;
      if (!one.energy_gained || !(*one.energy_gained > engine_right)) continue;
      ++row.gains;
      row.most = std::max(row.most.value_or(0), *one.energy_gained);
    }
  }
  std::vector<EngineImpactRow> result;
  for (auto& [key, row] : rows) result.push_back(std::move(row));
  return result;
}

namespace {

Json impacts_json(const JudgedEngines& judged) {
  Json rows = Json::array();
  for (const EngineImpactRow& row : engine_impacts(judged)) {
    Json right = Json::object();
    for (const ImpactLaw law : judged_laws) right[std::string(name(law))] = row.right[static_cast<std::size_t>(law)];
    rows.push_back({{"engine", row.engine},
                    {"asked", row.asked},
                    {"scenes", row.scenes},
                    {"right_by", std::move(right)},
                    {"by_no_law", row.by_no_law},
                    {"gains_energy", row.gains},
                    {"most", row.most ? Json(*row.most) : Json()}});
  }
  return rows;
}

}  // namespace

std::string engine_table_json(const EngineResults& results) {
  Json document{{"schema", "slipproof/engine-table/1"}, {"scenes", results.judged.scenes.size()}};
  document["engines"] = Json::array();
  for (const EngineRow& row : engine_rows(results.judged)) {
    Json classes = Json::object();
    for (const auto& [name, counts] : row.classes) classes[name] = counts_json(counts);
    Json one{{"engine", row.engine}, {"version", row.version},        {"asked", row.asked},         {"law", row.law},
             {"date", row.date},     {"classes", std::move(classes)}, {"all", counts_json(row.all)}};
    if (!row.design.empty()) one["design"] = row.design;
    document["engines"].push_back(std::move(one));
  }
  document["thresholds"] = Json::array();
  for (const EngineThresholdRow& row : engine_thresholds(results)) {
    Json one{{"engine", row.engine},
             {"asked", row.asked},
             {"scene", row.scene},
             {"parameter", row.found.parameter},
             {"changes_at", row.found.changes_at},
             {"within", row.found.within}};
    one["exact"] = row.exact ? Json(*row.exact) : Json();
    if (row.found.floor) one["floor"] = *row.found.floor;
    document["thresholds"].push_back(std::move(one));
  }
  document["impacts"] = impacts_json(results.judged);
  return json_text(document, 2) + '\n';
}

std::vector<EngineRow> engine_rows(const JudgedEngines& judged) {
  std::map<std::pair<std::string, std::string>, EngineRow> rows;
  for (const EngineScene& scene : judged.scenes) {
    for (const JudgedEngineAnswer& one : scene.answers) {
      if (is_about_more(one.answer)) continue;
      EngineRow& row = rows[{one.answer.engine, one.answer.asked}];
      if (row.engine.empty()) {
        row.engine = one.answer.engine, row.asked = one.answer.asked;
        row.version = one.answer.version, row.date = one.answer.date;
        const auto design = judged.designs.find(row.engine);
        if (design != judged.designs.end()) row.design = design->second;
      }
      if (row.law.empty()) row.law = one.answer.law;
      const auto verdict = static_cast<std::size_t>(one.verdict);
      ++row.classes[scene.class_name()][verdict];
      ++row.all[verdict];
    }
  }
  std::vector<EngineRow> result;
  for (auto& [key, row] : rows) result.push_back(std::move(row));
  return result;
}

std::vector<std::string> engine_classes(const JudgedEngines& judged) {
  std::set<std::string> names;
  for (const EngineScene& scene : judged.scenes) names.insert(scene.class_name());
  std::vector<std::string> classes{"one-motion", "thresholds", "several-or-none", "undetermined", "extremes"};
  std::erase_if(classes, [&](const std::string& name) { return names.erase(name) == 0; });
  classes.insert(classes.end(), names.begin(), names.end());
  return classes;
}

std::string class_title(const std::string& name) {
  std::string title = name;
  std::replace(title.begin(), title.end(), '-', ' ');
  return title;
}

}  // namespace slipproof
