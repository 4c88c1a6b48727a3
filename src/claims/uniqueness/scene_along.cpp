#include "claims/uniqueness/scene_along.hpp"

#include <stdexcept>
#include <utility>

#include "base/input/diagnostic.hpp"

namespace slipproof {

SceneAlong read_scene_along(const std::filesystem::path& file, const std::string& parameter) {
  MechanismScene scene = read_scene(file);
  try {
    UniquenessAlong along = uniqueness_along(scene, parameter.empty() ? usual_parameter(scene) : parameter);
    return {std::move(scene), std::move(along)};
  } catch (const std::invalid_argument& error) {
    throw InputError({{file.string(), 0, 0, error.what()}});
  } catch (const NoValue& error) {
    throw InputError({{file.string(), 0, 0, error.what()}});
  }
}

}  // namespace slipproof
