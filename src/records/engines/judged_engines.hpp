// What engines answered, held against all motions of each scene.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/kernel/motions.hpp"
#include "mechanics/scene/scene.hpp"
#include "records/engines/engine_answers.hpp"

namespace slipproof {

/// The verdict on an answer, by its distance from a motion: the largest error of an acceleration over the largest
/// acceleration of its kind (contact/problem/yardstick.hpp).
enum class EngineVerdict : std::uint8_t {
  right,      ///< within `engine_right`
  near,       ///< within `contact_near`
  wrong,      ///< no motion is near
  undecided,  ///< the effort did not suffice to find all motions
  refused,    ///< the engine cannot have the scene
  failed      ///< it crashed, did not answer in time, or answered with a number that is not finite
};
inline constexpr std::size_t engine_verdict_count = 6;
std::string_view name(EngineVerdict verdict);

/// Engines iterate, so an answer is right if it is within 0.1 %.
inline constexpr double engine_right = 1e-3;

struct JudgedEngineAnswer {
  EngineAnswer answer;
  EngineVerdict verdict = EngineVerdict::failed;
  std::optional<double> distance;  ///< distance from the nearest motion; nothing if there is no motion
  // Of an impact the verdict is the best by some law:
  std::vector<ImpactLaw> laws = {};     ///< by which it is right
  std::optional<double> energy_gained;  ///< over that before; below 0 if energy is lost
};

struct EngineScene {
  std::string name;  ///< CLASS/NAME
  std::filesystem::path file;
  MechanismScene scene;
  std::vector<JudgedEngineAnswer> answers;  ///< by engine, then in the order of the file

  std::string class_name() const { return name.substr(0, name.find('/')); }
};

struct JudgedEngines {
  std::vector<EngineScene> scenes;             ///< by name
  std::vector<std::string> engines;            ///< by name
  std::map<std::string, std::string> designs;  ///< by engine: engine_designs
};

/// Whether a folder has `scenes` and `answers`.
bool is_engines_folder(const std::filesystem::path& folder);

/// For each engine, how its contacts differ from rigid ones by design: the key `design` in a file like
/// cases/engines/engines.toml, whose other keys are for the scripts that run the engines. Empty without the file.
/// Throws InputError.
std::map<std::string, std::string> engine_designs(const std::filesystem::path& file);

/// The laws of impact by which answers are judged.
inline constexpr std::array<ImpactLaw, 3> judged_laws{ImpactLaw::newton, ImpactLaw::moreau, ImpactLaw::poisson};

/// Reads FOLDER/scenes/CLASS/NAME.toml, FOLDER/answers/ENGINE.jsonl and, if it is there, FOLDER/engines.toml, and
/// judges each answer in exact numbers, to an impact by each law; the scenes in parallel. Throws InputError for files
/// that cannot be read, for an answer about a scene that is not there, and for a motion that lacks an acceleration.
JudgedEngines judge_engines(const std::filesystem::path& folder);

}  // namespace slipproof
