// Scenes of mechanisms: exact values for a mechanism's parameters, angles and load.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/input/table_reader.hpp"
#include "mechanics/mechanism/mechanism.hpp"
#include "mechanics/scene/problem.hpp"

namespace slipproof {

struct MechanismScene {
  std::string name;
  Mechanism mechanism;             ///< with the load that `along` asks for
  MechanismValues values;          ///< in the domain, with all of [assume]
  std::optional<Rational> load;    ///< absent: every load at once, or a mechanism without one
  std::vector<std::string> notes;  ///< what the reader should know of how the file was understood
};

/// Reads a scene file (name, mechanism, along, [values], [state]). Throws InputError with all mistakes of the file in
/// the order of their places, including those of the mechanism's file.
MechanismScene read_mechanism_scene(const std::filesystem::path& path);
/// The same from a text; `file` is how messages call it, and where a relative path of the mechanism counts from.
MechanismScene parse_mechanism_scene(std::string_view text, const std::string& file);

/// The same scene with another parameter as its load, as `along` in its file has it; the load that it had becomes a
/// parameter. Throws InputError, with places in the mechanism's file, where that cannot be the load, and
/// std::invalid_argument where the scene has no value of the load that becomes a parameter.
MechanismScene with_load(const MechanismScene& scene, std::string_view parameter);

/// The first parameter that is a contact's coefficient of friction; if there is none, the first parameter that is
/// given, or the first angle.
std::string usual_parameter(const MechanismScene& scene);

/// A scene file that reads back as the same scene, apart from its notes. `mechanism` and `along` are what it says
/// there.
std::string to_toml(const MechanismScene& scene, const std::string& mechanism, const std::string& along = {});

/// The mechanism that a table names: its keys `mechanism` and, if it is there, `along`. A relative path counts from
/// `directory`. Mistakes are reported at these keys, those of the mechanism's file among them.
std::optional<Mechanism> named_mechanism(const TableReader& table, const std::string& directory);
/// A table [state]: replaces the states of the elements that it names. Mistakes are reported.
void read_states(const TomlValue& table, const Mechanism& mechanism, std::vector<ElementKind::Start>& starts,
                 Mistakes& mistakes);

/// Whether a text is the scene of a mechanism: TOML with `mechanism` at the top.
bool is_mechanism_scene(std::string_view text);

}  // namespace slipproof
