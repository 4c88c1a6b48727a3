// What physics engines answered to scenes, as recorded: a line of JSON an answer, `slipproof/engine-answer/1`.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/input/diagnostic.hpp"

namespace slipproof {

/// The value of a parameter of a scene at which the answer of an engine changes.
struct EngineThreshold {
  std::string parameter;
  double changes_at = 0, within = 0;  ///< the middle of the interval to which it was bisected, and half its length
  std::optional<double> floor;  ///< least acceleration that counted as motion, over the scene's natural acceleration
};

/// An answer of an engine: a motion, a threshold, a drift, a rise of energy, or a reason why there is none of them.
struct EngineAnswer {
  std::string engine, version;
  std::string scene;     ///< CLASS/NAME
  std::string asked;     ///< `default`, `many iterations`, `threshold`, `drift`, `energy`
  std::string law;       ///< the law that the engine solves, in its own words
  std::string settings;  ///< the settings, as written in the line
  std::string date;
  std::vector<std::pair<std::string, double>> motion;  ///< accelerations by the names of the mechanism's unknowns
  std::optional<EngineThreshold> threshold;
  /// By the number of steps: how far a body moves that rests, over the size; and by how much energy rises where nothing
  /// drives, over that at the start and what lifts all bodies by the size.
  std::map<std::string, double> drift, energy;
  std::string refused;  ///< why the engine cannot have such a scene
  std::string failed;   ///< why it gave no answer: a crash, a number that is not finite
  Place place;          ///< its line
};

/// Reads all answers in a file. Throws InputError with all mistakes.
std::vector<EngineAnswer> read_engine_answers(const std::filesystem::path& path);

}  // namespace slipproof
