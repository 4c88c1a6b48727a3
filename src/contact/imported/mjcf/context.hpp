// What the parts of the reader of MJCF share: the file, the model at one instant, and the scene that it becomes.
#pragma once

#include <string>
#include <vector>

#include "contact/imported/mjcf/model.hpp"
#include "contact/imported/readers.hpp"

namespace slipproof::imported {

struct MjcfContext {
  const TaggedFile& file;
  const mjModel& m;
  const mjData& d;
  Scene& scene;
  Mistakes& mistakes;
  /// Of the bodies in the scene. Where the file's own numbers give a pose exactly, it is that; elsewhere it is near the
  /// one that MuJoCo computes.
  std::vector<Pose> poses;
  std::vector<bool> exact;
  std::vector<std::size_t> number_of;  ///< of MuJoCo's bodies in the scene

  std::string name_of(mjtObj kind, int id, const std::string& otherwise) const {
    const char* name = mj_id2name(&m, kind, id);
    return name != nullptr && *name != '\0' ? name : otherwise;
  }
  void tell(std::string sentence) const { scene.import_notes.push_back(std::move(sentence)); }

  template <class Number>
  static Vector vector_of(const Number* v) {
    return {computed(v[0]), computed(v[1]), computed(v[2])};
  }
  /// A place that was computed: a rounding error beside 0 is 0.
  static Vector placed_at(const mjtNum* v) { return {placed(v[0]), placed(v[1]), placed(v[2])}; }
};

/// Makes a shape the convex hull of a mesh, which MuJoCo computes for meshes that touch.
void hull_of_mesh(const mjModel& m, int mesh, Shape& shape);

/// Adds the shapes of all geoms.
void read_geoms(const MjcfContext& context);
/// Adds connected and welded bodies, pairs that do not touch, and sentences about what else holds.
void read_couplings(const MjcfContext& context);
/// Adds what springs, dampers, fluids and actuators exert at this instant.
void read_forces(const MjcfContext& context);

}  // namespace slipproof::imported
