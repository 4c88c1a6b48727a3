// The shapes that touch: geoms as MuJoCo places them.
#ifdef SLIPPROOF_MJCF

#include <fmt/format.h>

#include <map>

#include "contact/imported/mjcf/context.hpp"

namespace slipproof::imported {

namespace {

class GeomReader {
 public:
  explicit GeomReader(const MjcfContext& context) : c_(context), m_(context.m) {}

  void read() {
    for (int i = 0; i < m_.ngeom; ++i) {
      const bool is_surface = m_.geom_type[i] == mjGEOM_MESH || m_.geom_type[i] == mjGEOM_HFIELD;
      if (is_surface && m_.geom_contype[i] == 0 && m_.geom_conaffinity[i] == 0) {
        ++seen_only_;
      } else {
        add(i);
      }
      margin_ = margin_ || m_.geom_margin[i] > m_.geom_gap[i];
      spin_ = spin_ || m_.geom_condim[i] > 3;
    }
    if (seen_only_ > 0) c_.tell(fmt::format("left out: {} meshes that are only seen", seen_only_));
    if (margin_) c_.tell("a margin, within which MuJoCo's contacts push softly from afar, is left out");
    if (spin_) c_.tell("friction against spinning and rolling at a contact (condim 4 and 6) is left out");
  }

 private:
  void add(int i) {
    const auto owner = static_cast<std::size_t>(m_.geom_bodyid[i]);
    Body& body = c_.scene.bodies[c_.number_of[owner]];
    Shape shape;
    shape.name = c_.name_of(mjOBJ_GEOM, i, owner == 0 ? "floor" : body.name);
    shape.place = c_.file.place("geom", shape.name);
    if (shape.place.line == 0) shape.place = body.place;
    shape.pose = pose_of(i, owner, shape.name);
    shape.mu = m_.geom_condim[i] == 1 ? Rational(0) : computed(m_.geom_friction[3 * i]);
    shape.kinds = static_cast<unsigned>(m_.geom_contype[i]);
    shape.meets = static_cast<unsigned>(m_.geom_conaffinity[i]);
    shape.priority = m_.geom_priority[i];
    if (measure(i, shape)) body.shapes.push_back(std::move(shape));
  }

  Pose pose_of(int i, std::size_t owner, const std::string& name) {
    const mjtNum* q = m_.geom_quat + 4 * i;
    const RationalTurn turn = rational_turn({q[0], q[1], q[2], q[3]});
    if (c_.exact[owner]) {
      if (turn.error > 0) turn_of({q[0], q[1], q[2], q[3]}, name, c_.scene);
      return tidy(c_.poses[owner] * Pose{turn.turn, c_.vector_of(m_.geom_pos + 3 * i)});
    }
    std::array<mjtNum, 4> all{};
    mju_mat2Quat(all.data(), c_.d.geom_xmat + 9 * i);
    return {rational_turn(all).turn, c_.placed_at(c_.d.geom_xpos + 3 * i)};
  }

  /// False for what is no shape here.
  bool measure(int i, Shape& shape) {
    const mjtNum* size = m_.geom_size + 3 * i;
    switch (m_.geom_type[i]) {
      case mjGEOM_PLANE:
        shape.kind = Shape::Kind::plane;
        return true;
      case mjGEOM_BOX:
        shape.half = c_.vector_of(size);
        return true;
      case mjGEOM_SPHERE:
        shape.kind = Shape::Kind::sphere;
        shape.radius = computed(size[0]);
        return true;
      case mjGEOM_CYLINDER:
      case mjGEOM_CAPSULE:
        shape.kind = m_.geom_type[i] == mjGEOM_CYLINDER ? Shape::Kind::cylinder : Shape::Kind::capsule;
        shape.radius = computed(size[0]);
        shape.half_length = computed(size[1]);
        return true;
      case mjGEOM_MESH:
        return hull(i, shape);
      case mjGEOM_HFIELD:
        return leave_out(shape, "found a mesh or a height field, expected a box, sphere, cylinder, capsule or plane",
                         "the terrain (a height field), on which nothing stands here, is left out");
      default:
        return leave_out(shape, "found another shape, expected a box, sphere, cylinder, capsule or plane",
                         "its shape (an ellipsoid) is left out: it touches nothing here");
    }
  }

  bool leave_out(const Shape& shape, const std::string& found, const std::string& left_out) {
    c_.scene.only_in_space.push_back({shape.place, shape.name + ": " + found, shape.name + ": " + left_out});
    return false;
  }

  /// A mesh that touches is its convex hull, of which MuJoCo knows the corners.
  bool hull(int i, Shape& shape) {
    c_.scene.only_in_space.push_back(
        {shape.place,
         shape.name + ": found a mesh or a height field, expected a box, sphere, cylinder, capsule or plane", ""});
    hull_of_mesh(m_, m_.geom_dataid[i], shape);
    return true;
  }

  const MjcfContext& c_;
  const mjModel& m_;
  std::size_t seen_only_ = 0;
  bool margin_ = false, spin_ = false;
};

}  // namespace

void hull_of_mesh(const mjModel& m, int mesh, Shape& shape) {
  shape.kind = Shape::Kind::hull;
  if (m.mesh_graphadr[mesh] < 0) return;
  const float* vertices = m.mesh_vert + 3 * m.mesh_vertadr[mesh];
  const int* graph = m.mesh_graph + m.mesh_graphadr[mesh];
  const int corners = graph[0], faces = graph[1];
  const int *own = graph + 2 + corners, *triangles = own + corners + corners + 3 * faces;
  std::map<int, std::size_t> number;
  for (int k = 0; k < corners; ++k) {
    number[own[k]] = shape.points.size();
    shape.points.push_back(MjcfContext::vector_of(vertices + 3 * own[k]));
  }
  for (int k = 0; k < faces; ++k) {
    const int* t = triangles + 3 * k;
    shape.triangles.push_back({number.at(t[0]), number.at(t[1]), number.at(t[2])});
  }
}

void read_geoms(const MjcfContext& context) {
  GeomReader(context).read();
}

}  // namespace slipproof::imported

#endif
