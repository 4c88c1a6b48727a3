// What physics engines answered to scenes, as recorded: a line of JSON an answer, `slipproof/engine-answer/1`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/input/diagnostic.hpp"

namespace slipproof {

/// Where an engine changes its mind when a parameter of a scene varies.
struct EngineThreshold {
  std::string parameter;
  double changes_at = 0, within = 0;  ///< the middle of the interval to which it was bisected, and half its length
  std::optional<double> floor;        ///< what counted as motion, in parts of the scene's natural acceleration
};

/// One answer. It has a motion, a threshold, or a reason why it has neither.
struct EngineAnswer {
  std::string engine, version;
  std::string scene;     ///< CLASS/NAME
  std::string asked;     ///< `default`, `many iterations`, `threshold`
  std::string law;       ///< what the engine solves, in its own words
  std::string settings;  ///< what was set, as the line has it
  std::string date;
  std::vector<std::pair<std::string, double>> motion;  ///< accelerations by the names of the mechanism's unknowns
  std::optional<EngineThreshold> threshold;
  std::string refused;  ///< why the engine cannot have such a scene
  std::string failed;   ///< what went wrong when it was asked: a crash, a number that is not finite
  Place place;          ///< its line
};

/// All answers in a file. Throws InputError with all mistakes.
std::vector<EngineAnswer> read_engine_answers(const std::filesystem::path& path);

}  // namespace slipproof
