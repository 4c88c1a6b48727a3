// A model of MuJoCo from a file and all that it includes.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>

#include "contact/imported/scene.hpp"
#include "contact/imported/tags.hpp"

namespace slipproof::imported {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
using Model = std::unique_ptr<mjModel, DeleteModel>;
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using Data = std::unique_ptr<mjData, DeleteData>;

/// The file with the files that it includes and the meshes of both, as MuJoCo compiles them. Pictures, sensors and
/// names of materials are taken out before, with a note for each in the file itself. Null, with mistakes, for what
/// MuJoCo does not understand, and for files that cannot be read.
Model load_model(TaggedFile& file, const ReadOptions& options, Scene& scene, Mistakes& mistakes);

/// A model of files in memory, the first of them its own: pairs of a name and what is in it. Null, with `why`.
Model model_of(const std::vector<std::pair<std::string, std::string>>& files, std::string& why);

}  // namespace slipproof::imported
