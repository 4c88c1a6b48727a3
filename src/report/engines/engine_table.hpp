// The counts of the table of engines.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "records/engines/judged_engines.hpp"
#include "report/expected/expected.hpp"

namespace slipproof {

/// Judged answers with the motions of their scenes.
struct EngineResults {
  JudgedEngines judged;
  std::vector<Expected> expected;  ///< of each scene
};
/// Solves the scenes, in parallel. Throws InputError where that fails.
EngineResults engine_results(JudgedEngines judged);

using EngineCounts = std::array<std::size_t, engine_verdict_count>;

/// How an engine was asked, and what came of it.
struct EngineRow {
  std::string engine, asked;
  std::string version, law, date;               ///< of its first answer
  std::string design;                           ///< how its contacts differ from rigid ones on purpose, or empty
  std::map<std::string, EngineCounts> classes;  ///< by class
  EngineCounts all{};
};

/// What was asked at a scene's own values: a row for each engine and way of asking, by name.
std::vector<EngineRow> engine_rows(const JudgedEngines& judged);

/// A threshold that an engine was asked for.
struct EngineThresholdRow {
  std::string engine, asked, scene;
  EngineThreshold found;
  std::optional<double> exact;  ///< the nearest at which the scene's motions change; nothing where none does
  /// |found - exact| / |exact|.
  double off() const;
};
std::vector<EngineThresholdRow> engine_thresholds(const EngineResults& results);

/// What an engine answers to impacts.
struct EngineImpactRow {
  std::string engine, asked;
  std::size_t scenes = 0;                               ///< that it has answered
  std::array<std::size_t, judged_laws.size()> right{};  ///< by each law
  std::size_t by_no_law = 0, gains = 0;                 ///< gains: energy, by more than `engine_right`
  std::optional<double> most;                           ///< the largest gain, over the energy before
};
/// A row for each engine and way of asking, by name.
std::vector<EngineImpactRow> engine_impacts(const JudgedEngines& judged);

/// The classes of the scenes: the shipped ones in their order, then others by name.
std::vector<std::string> engine_classes(const JudgedEngines& judged);

/// `one-motion` as people write it: `one motion`.
std::string class_title(const std::string& name);

/// {"schema":"slipproof/engine-table/1","scenes":...,"engines":[...],"thresholds":[...]}.
std::string engine_table_json(const EngineResults& results);

}  // namespace slipproof
