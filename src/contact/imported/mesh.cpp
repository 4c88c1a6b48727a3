#include "contact/imported/mesh.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cmath>
#include <fstream>

#include "base/number/binary64.hpp"
#ifdef SLIPPROOF_MJCF
#include "contact/imported/mjcf/context.hpp"
#endif

namespace slipproof::imported {

std::filesystem::path find_mesh(const std::string& uri, const std::filesystem::path& scene) {
  const std::size_t scheme = uri.find("://");
  const std::filesystem::path name = scheme == std::string::npos ? uri : uri.substr(scheme + 3);
  std::error_code error;
  if (name.is_absolute()) return std::filesystem::exists(name, error) ? name : std::filesystem::path{};
  std::filesystem::path rest;  // without the package's name
  for (auto part = std::next(name.begin()); part != name.end(); ++part) rest /= *part;
  const std::filesystem::path own = std::filesystem::absolute(scene, error).parent_path();
  for (std::filesystem::path folder = own;; folder = folder.parent_path()) {
    if (std::filesystem::exists(folder / name, error)) return folder / name;
    if (scheme != std::string::npos && std::filesystem::exists(folder / rest, error)) return folder / rest;
    if (folder == folder.parent_path()) return {};
  }
}

#ifdef SLIPPROOF_MJCF

namespace {

/// What stands in a file of single precision.
Rational single(mjtNum x) {
  return placed(std::round(x * 1e9) / 1e9);
}

}  // namespace

bool read_hull(const std::filesystem::path& file, const Vector& scale, Shape& shape, std::string& why) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (bytes.empty() || bytes.rfind("version https://git-lfs", 0) == 0) {
    why = "is empty, or stands elsewhere";
    return false;
  }
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending != ".stl" && ending != ".obj" && ending != ".msh") {
    why = "is of a kind that is not read (" + ending + "), expected STL, OBJ or MSH";
    return false;
  }
  const std::string text = fmt::format(
      "<mujoco><asset><mesh name=\"m\" file=\"m{}\" scale=\"{} {} {}\"/></asset>"
      "<worldbody><geom type=\"mesh\" mesh=\"m\"/></worldbody></mujoco>",
      ending, nearest_binary64(scale.x), nearest_binary64(scale.y), nearest_binary64(scale.z));
  const Model model = model_of({{"scene.xml", text}, {"m" + ending, bytes}}, why);
  if (!model) return false;
  hull_of_mesh(*model, 0, shape);
  if (shape.points.empty()) {
    why = "has no convex hull";
    return false;
  }
  // MuJoCo has put its centre of mass to the origin, and turned it along its inertia.
  for (Vector& p : shape.points) {
    const std::array<mjtNum, 3> own{nearest_binary64(p.x), nearest_binary64(p.y), nearest_binary64(p.z)};
    std::array<mjtNum, 3> whole{};
    mju_rotVecQuat(whole.data(), own.data(), model->geom_quat);
    for (std::size_t k = 0; k < 3; ++k) whole[k] += model->geom_pos[k];
    // The file has single precision: beyond nine digits there is only what the turning back has left.
    p = {single(whole[0]), single(whole[1]), single(whole[2])};
  }
  return true;
}

#else

bool read_hull(const std::filesystem::path&, const Vector&, Shape&, std::string& why) {
  why = "is a mesh, which this program was built without: it needs libmujoco-dev";
  return false;
}

#endif

bool read_mesh(const std::string& uri, const Vector& scale, const ReadOptions& options, Shape& shape, Scene& scene,
               Mistakes& mistakes) {
  if (options.without_meshes) {
    scene.import_notes.push_back("left out: the mesh " + in_quotes(uri) + " of " + shape.name);
    return false;
  }
  scene.only_in_space.push_back(
      {shape.place, shape.name + ": found <mesh>, expected a box, sphere, cylinder, capsule or plane", ""});
  const std::filesystem::path file = find_mesh(uri, scene.file);
  std::string why = "is not there";
  if (!file.empty() && read_hull(file, scale, shape, why)) {
    scene.import_notes.push_back(shape.name + ": the convex hull of " + in_quotes(uri) + " touches");
    return true;
  }
  mistakes.add(shape.place, shape.name + ": found the mesh " + in_quotes(uri) + ", which " + why +
                                " (--without-meshes leaves meshes out)");
  return false;
}

}  // namespace slipproof::imported
