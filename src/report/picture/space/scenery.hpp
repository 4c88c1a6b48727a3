// What stands still in the picture of a scene in space: planes with shadows, solids, joints.
#pragma once

#include <string_view>
#include <vector>

#include "report/markup/element.hpp"
#include "report/picture/labels/picture_labels.hpp"
#include "report/picture/space/space_geometry.hpp"
#include "report/picture/space/space_view.hpp"

namespace slipproof {

/// Solids hide what is behind them; edges on their far sides are dotted. A shadow falls straight down, against
/// `SpaceGeometry::up`, onto the planes that bodies touch, and onto faces in such a plane.
class Scenery {
 public:
  /// What is painted at once: a solid, or a piece of a plane without one.
  struct Piece {
    Solid solid;
    bool floor = false;
    std::vector<std::vector<Vec3>> shadows;  ///< on it
  };

  Scenery(const SpaceGeometry& geometry, const Vec3& towards);

  /// All corners of what is drawn: the picture must show them.
  std::vector<Vec3> corners() const;
  void draw(const Element& svg, const SpaceView& view, PictureLabels& labels) const;
  /// Whether one sees more of a shadow than what solids cover.
  bool shows_shadows(const SpaceView& view) const;
  const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  void add_plane(const SpaceGeometry::Plane& plane, std::size_t index);
  std::vector<Vec3> near_plane(const SpaceGeometry::Plane& plane, std::size_t index) const;
  std::vector<std::vector<Vec3>> shadows(const SpaceGeometry::Plane& plane, const std::vector<Vec3>& onto) const;
  bool touches(std::size_t body, std::size_t plane) const;
  void draw_piece(const Element& svg, const Piece& piece, const SpaceView& view, PictureLabels& labels) const;
  void draw_edges(const Element& svg, const Piece& piece, const SpaceView& view, PictureLabels& labels) const;
  void draw_joint(const Element& svg, const SpaceGeometry::Joint& joint, const SpaceView& view,
                  PictureLabels& labels) const;

  const SpaceGeometry& geometry_;
  Vec3 towards_;
  double size_ = 1;  ///< of the scene
  std::vector<Piece> pieces_;
  std::vector<std::size_t> order_;
};

/// How a joint is drawn: `line` from end to end, `square` or `circle`; and the class of its line.
std::string_view mark_of(BodyJoint::Kind kind);
std::string_view line_of(BodyJoint::Kind kind);

/// A closed path through points in space.
std::string path_through(const std::vector<Vec3>& corners, const SpaceView& view);

}  // namespace slipproof
