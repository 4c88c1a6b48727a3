// Scenes of mechanisms: exact values for a mechanism's parameters, angles and load.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/input/table_reader.hpp"
#include "base/number/affine.hpp"
#include "mechanics/mechanism/mechanism.hpp"
#include "mechanics/points/problem.hpp"

namespace slipproof {

/// A name for several parameters, or for a number that one of them follows from: each of `sets` is affine in it.
struct CombinedParameter {
  std::string symbol, unit;
  Rational value;  ///< in the scene
  std::vector<std::pair<std::string, Affine<Rational>>> sets;
};

/// The values of a parameter between which the motion is expected to change.
struct SceneThreshold {
  std::string parameter;  ///< or the load
  Rational from, to;      ///< from < to
};

struct MechanismScene {
  std::string name;
  Mechanism mechanism;                           ///< with the load given by `along`
  MechanismValues values;                        ///< in the domain, with all of [assume]
  std::optional<Rational> load;                  ///< nothing: all loads, or a mechanism without a load
  std::vector<std::string> notes;                ///< remarks for the user on how the file was interpreted
  std::vector<CombinedParameter> combined = {};  ///< further names that can be varied
  std::string question = {}, asked = {};         ///< a question that the scene answers, in a sentence; its source
  std::optional<SceneThreshold> threshold = {};
};

/// Reads a scene file: of any mechanism (name, mechanism, along, question, asked, [values], [state], [threshold]),
/// where `mechanism` is a file, a name or, in the scene itself, a table; of the bicycle in its own words
/// (bicycle_scene.hpp), which has no key `mechanism`; or a mechanism without parameters, which is a scene of its own.
/// Throws InputError with every mistake of the file, in the order of their places; mistakes of the mechanism's file
/// among them.
MechanismScene read_scene(const std::filesystem::path& path, MechanismRequest request = Dimensions::plane);
/// Reads a scene from a text. `file` is its name in messages; relative paths of mechanisms start from its folder.
MechanismScene parse_scene(std::string_view text, const std::string& file,
                           MechanismRequest request = Dimensions::plane);

/// The scene with another parameter as its load, like `along` in a file; the previous load becomes a parameter. Throws
/// InputError, with places in the mechanism's file, if the parameter cannot be the load, and std::invalid_argument if
/// the scene has no value of the previous load.
MechanismScene with_load(const MechanismScene& scene, std::string_view parameter);

/// Sets a parameter, an angle by the tangent of its half, name of the parameter, or of the load, whose symbols differ;
/// false for another name. The domain is not looked at.
bool set_value(MechanismScene& scene, std::string_view name, const Rational& value);
/// The scene with other values of parameters, of the load, or of angles (as tangents of half angles). Throws
/// std::invalid_argument, with a message for users, for an unknown name and for values outside the domain.
MechanismScene with_values(const MechanismScene& scene, const std::vector<std::pair<std::string, Rational>>& values);

/// The first parameter that is a contact's coefficient of friction; if there is none, the first parameter that is
/// given, or the first angle.
std::string usual_parameter(const MechanismScene& scene);

/// A scene file that reads back as the same scene, apart from its notes. `mechanism` and `along` are what it says
/// there.
std::string to_toml(const MechanismScene& scene, const std::string& mechanism, const std::string& along = {});

/// The mechanism that a table names: its keys `mechanism` and, if it is there, `along`. A relative path counts from
/// `directory`. Mistakes are reported at these keys, those of the mechanism's file among them.
std::optional<Mechanism> named_mechanism(const TableReader& table, const std::string& directory,
                                         MechanismRequest request = Dimensions::plane);
/// A table [state]: replaces the states of the elements that it names. Mistakes are reported.
void read_states(const TomlValue& table, const Mechanism& mechanism, std::vector<ElementKind::Start>& starts,
                 Mistakes& mistakes);

/// Whether a text is the scene of a mechanism: TOML with `mechanism` at the top.
bool is_mechanism_scene(std::string_view text);

}  // namespace slipproof
