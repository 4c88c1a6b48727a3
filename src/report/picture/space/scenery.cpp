#include "report/picture/space/scenery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/picture/palette.hpp"
#include "report/picture/space/flat.hpp"

namespace slipproof {

namespace {

constexpr double floor_like = 0.25;  ///< cosine of the slope up to which shadows fall on a plane

/// A plane with directions in it.
struct PlaneAxes {
  Vec3 through, normal;
  AcrossDirections across;
  explicit PlaneAxes(const SpaceGeometry::Plane& plane)
      : through(plane.through), normal(plane.normal), across(plane.normal) {}

  Point flat(const Vec3& p) const { return {dot(across.first, p - through), dot(across.second, p - through)}; }
  Vec3 place(const Point& p) const { return through + p[0] * across.first + p[1] * across.second; }
  double height(const Vec3& p) const { return dot(normal, p - through); }
  /// Moved along a direction into the plane.
  Vec3 dropped(const Vec3& p, const Vec3& along) const { return p - (height(p) / dot(along, normal)) * along; }
};

std::string segment(const Vec3& from, const Vec3& to, const SpaceView& view) {
  const Point a = view.pixel(from), b = view.pixel(to);
  return fmt::format("M{:.1f},{:.1f}L{:.1f},{:.1f}", a[0], a[1], b[0], b[1]);
}

}  // namespace

std::string_view mark_of(BodyJoint::Kind kind) {
  using Kind = BodyJoint::Kind;
  if (kind == Kind::rod || kind == Kind::rope || kind == Kind::spring) return "line";
  return kind == Kind::weld || kind == Kind::slider ? "square" : "circle";
}
std::string_view line_of(BodyJoint::Kind kind) {
  return kind == BodyJoint::Kind::rod ? "body" : "chain";
}

std::string path_through(const std::vector<Vec3>& corners, const SpaceView& view) {
  std::string path;
  for (const Vec3& corner : corners) {
    const Point at = view.pixel(corner);
    path += fmt::format("{}{:.1f},{:.1f}", path.empty() ? "M" : "L", at[0], at[1]);
  }
  return path + "Z";
}

Scenery::Scenery(const SpaceGeometry& geometry, const Vec3& towards) : geometry_(geometry), towards_(towards) {
  for (const auto& placed : geometry.solids) pieces_.push_back({placed.solid, false, {}});
  const std::vector<Vec3> all = corners();
  for (const Vec3& p : all) size_ = std::max(&p == &all.front() ? 0.0 : size_, length(p - all.front()));
  for (std::size_t i = 0; i < geometry.planes.size(); ++i) add_plane(geometry.planes[i], i);
  std::vector<Solid> solids;
  for (const Piece& piece : pieces_) solids.push_back(piece.solid);
  order_ = painting_order(solids, towards);
}

std::vector<Vec3> Scenery::corners() const {
  std::vector<Vec3> all;
  for (const Piece& piece : pieces_) all.insert(all.end(), piece.solid.corners.begin(), piece.solid.corners.end());
  for (const auto& stick : geometry_.sticks) all.push_back(stick.from), all.push_back(stick.to);
  for (const auto& contact : geometry_.contacts) all.push_back(contact.at);
  for (const auto& joint : geometry_.joints) all.push_back(joint.at), all.push_back(joint.to);
  return all;
}

bool Scenery::shows_shadows(const SpaceView& view) const {
  if (dot(geometry_.up, towards_) <= 0) return false;
  std::vector<std::vector<Point>> in_front;  // outlines of what is painted later
  const auto covered = [&](const Vec3& p) {
    return std::ranges::any_of(in_front, [&](const auto& outline) { return is_inside(view.pixel(p), outline); });
  };
  for (std::size_t i = order_.size(); i-- > 0;) {
    const Piece& piece = pieces_[order_[i]];
    for (const auto& shadow : piece.shadows) {
      if (!std::ranges::all_of(shadow, covered)) return true;
    }
    std::vector<Point> corners;
    for (const Vec3& corner : piece.solid.corners) corners.push_back(view.pixel(corner));
    in_front.push_back(hull_of(std::move(corners)));
  }
  return false;
}

bool Scenery::touches(std::size_t body, std::size_t plane) const {
  return std::ranges::any_of(geometry_.contacts,
                             [&](const auto& contact) { return contact.of == body && contact.plane == plane; });
}

/// What the piece of the plane must reach: contacts, and shadows of the bodies that touch it, or the nearest points.
std::vector<Vec3> Scenery::near_plane(const SpaceGeometry::Plane& plane, std::size_t index) const {
  const PlaneAxes axes(plane);
  const Vec3 along = dot(plane.normal, geometry_.up) > floor_like ? geometry_.up : plane.normal;
  std::vector<Vec3> near;
  for (const auto& contact : geometry_.contacts) {
    if (contact.plane == index) near.push_back(axes.dropped(contact.at, plane.normal));
  }
  const bool only_plane = geometry_.planes.size() == 1;
  const auto reach = [&](std::size_t body, const Vec3& p) {
    if (touches(body, index) || (only_plane && body != plane.on)) near.push_back(axes.dropped(p, along));
  };
  for (const auto& placed : geometry_.solids) {
    for (const Vec3& corner : placed.solid.corners) reach(placed.body, corner);
  }
  for (const auto& stick : geometry_.sticks) reach(stick.body, stick.from), reach(stick.body, stick.to);
  return near;
}

/// On a face of the body that the plane belongs to, or on a piece of the plane where no face is.
void Scenery::add_plane(const SpaceGeometry::Plane& plane, std::size_t index) {
  for (std::size_t i = 0; i < geometry_.solids.size(); ++i) {
    if (geometry_.solids[i].body != plane.on) continue;
    const Solid& solid = pieces_[i].solid;
    for (const Solid::Face& face : solid.faces) {
      if (dot(face.normal, plane.normal) < 1 - 1e-6) continue;
      if (std::abs(dot(plane.normal, solid.corners[face.corners[0]] - plane.through)) > 1e-6 * size_) continue;
      std::vector<Vec3> onto;
      for (const std::size_t corner : face.corners) onto.push_back(solid.corners[corner]);
      pieces_[i].shadows = shadows(plane, onto);
      return;
    }
  }
  const PlaneAxes axes(plane);
  const double margin = 0.14 * size_;
  std::array<double, 4> box{1e300, 1e300, -1e300, -1e300};
  for (const Vec3& p : near_plane(plane, index)) {
    const Point at = axes.flat(p);
    box = {std::min(box[0], at[0]), std::min(box[1], at[1]), std::max(box[2], at[0]), std::max(box[3], at[1])};
  }
  if (box[0] > box[2]) return;
  std::vector<Vec3> corners;
  for (const Point& corner : {Point{box[0] - margin, box[1] - margin}, Point{box[2] + margin, box[1] - margin},
                              Point{box[2] + margin, box[3] + margin}, Point{box[0] - margin, box[3] + margin}}) {
    corners.push_back(axes.place(corner));
  }
  pieces_.push_back({flat_solid(corners), true, shadows(plane, corners)});
}

std::vector<std::vector<Vec3>> Scenery::shadows(const SpaceGeometry::Plane& plane,
                                                const std::vector<Vec3>& onto) const {
  std::vector<std::vector<Vec3>> all;
  if (dot(plane.normal, geometry_.up) <= floor_like) return all;
  const PlaneAxes axes(plane);
  std::vector<Point> inside;
  for (const Vec3& corner : onto) inside.push_back(axes.flat(corner));
  for (const auto& placed : geometry_.solids) {
    if (placed.body == plane.on || axes.height(placed.solid.middle()) <= 0) continue;
    std::vector<Point> dark;
    for (const Vec3& corner : placed.solid.corners) dark.push_back(axes.flat(axes.dropped(corner, geometry_.up)));
    std::vector<Vec3> shadow;
    for (const Point& p : clipped(hull_of(std::move(dark)), inside)) shadow.push_back(axes.place(p));
    if (shadow.size() >= 3) all.push_back(std::move(shadow));
  }
  return all;
}

void Scenery::draw(const Element& svg, const SpaceView& view, PictureLabels& labels) const {
  for (const std::size_t index : order_) draw_piece(svg, pieces_[index], view, labels);
  for (const auto& stick : geometry_.sticks) {
    const Point from = view.pixel(stick.from), to = view.pixel(stick.to);
    if (from == to) {
      svg.add("circle", "ink").set("cx", from[0]).set("cy", from[1]).set("r", 2.5);
    } else {
      svg.add("path", "body").set("d", segment(stick.from, stick.to, view));
      labels.avoid(from, to, 2.5);
    }
  }
  for (const auto& joint : geometry_.joints) draw_joint(svg, joint, view, labels);
}

void Scenery::draw_piece(const Element& svg, const Piece& piece, const SpaceView& view, PictureLabels& labels) const {
  const Element group = svg.add("g", piece.floor ? "plane" : "solid");
  const bool from_below = piece.floor && dot(piece.solid.faces[0].normal, towards_) < 0;
  if (from_below) group.set("opacity", 0.5);
  const Vec3 light = direction_of(0.55 * towards_ + 0.8 * geometry_.up + 0.35 * cross(towards_, geometry_.up));
  const Element faces = piece.floor ? group : group.add("g").set("opacity", 0.86);
  for (const Solid::Face& face : piece.solid.faces) {
    if (piece.solid.faces.size() > 1 && dot(face.normal, towards_) <= 1e-9) continue;
    std::vector<Vec3> corners;
    for (const std::size_t corner : face.corners) corners.push_back(piece.solid.corners[corner]);
    faces.add("path", piece.floor ? "floor" : shade_class((1 + dot(face.normal, light)) / 2))
        .set("d", path_through(corners, view));
  }
  for (const auto& shadow : piece.shadows) {
    if (dot(geometry_.up, towards_) > 0) group.add("path", "shadow").set("d", path_through(shadow, view));
  }
  draw_edges(group, piece, view, labels);
}

void Scenery::draw_edges(const Element& svg, const Piece& piece, const SpaceView& view, PictureLabels& labels) const {
  std::string seen, hidden;
  for (const Solid::Edge& edge : piece.solid.edges) {
    const auto faces_us = [&](std::size_t face) { return dot(piece.solid.faces[face].normal, towards_) > 1e-9; };
    const auto facing = std::ranges::count_if(edge.faces, faces_us);
    const bool flat = edge.faces.size() == 1, silhouette = facing == 1 || flat;
    if (edge.smooth && !silhouette) continue;
    const Vec3 &from = piece.solid.corners[edge.from], &to = piece.solid.corners[edge.to];
    (facing > 0 || flat ? seen : hidden) += segment(from, to, view);
    if (facing > 0) labels.avoid(view.pixel(from), view.pixel(to), 1);
  }
  if (!hidden.empty()) svg.add("path", "hidden").set("d", hidden);
  if (!seen.empty()) svg.add("path", piece.floor ? "measure" : "rim").set("d", seen);
}

/// A line along each axis, and a mark: round for a ball, square for a weld.
void Scenery::draw_joint(const Element& svg, const SpaceGeometry::Joint& joint, const SpaceView& view,
                         PictureLabels& labels) const {
  const auto line = [&](const Vec3& from, const Vec3& to, std::string_view css) {
    svg.add("path", css).set("d", segment(from, to, view));
    labels.avoid(view.pixel(from), view.pixel(to), 1);
  };
  const Point at = view.pixel(joint.at);
  const double reach = 13 / view.scale();
  for (const Vec3& axis : joint.axes) line(joint.at - reach * axis, joint.at + reach * axis, "joint");
  const std::string_view mark = mark_of(joint.kind);
  if (mark == "line") {
    line(joint.at, joint.to, line_of(joint.kind));
  } else if (mark == "square") {
    svg.add("rect", "paper rim").set("x", at[0] - 3.5).set("y", at[1] - 3.5).set("width", 7).set("height", 7);
  } else {
    svg.add("circle", "paper rim").set("cx", at[0]).set("cy", at[1]).set("r", 3.5);
  }
  labels.avoid(LabelBox{at[0] - 4, at[1] - 4, at[0] + 4, at[1] + 4});
}

}  // namespace slipproof
