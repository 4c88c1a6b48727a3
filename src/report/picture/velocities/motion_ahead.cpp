#include "report/picture/velocities/motion_ahead.hpp"

namespace slipproof {

std::vector<std::vector<MechanismGeometry::Outline>> outlines_ahead(
    const std::vector<MechanismGeometry::Outline>& outlines, const std::vector<BodyMovement>& movements) {
  std::vector<MechanismGeometry::Outline> now;
  for (const MechanismGeometry::Outline& outline : outlines) {
    if (!outline.bodies) continue;
    now.push_back(outline);
    if (outline.kind != MechanismShape::Kind::circle) continue;
    const Point centre = outline.points[0];
    now.push_back(outline);
    now.back().kind = MechanismShape::Kind::line;
    now.back().points.push_back({centre[0] + outline.radius, centre[1]});
  }
  std::vector<std::vector<MechanismGeometry::Outline>> frames;
  for (int i = 0; i <= frames_ahead; ++i) {
    std::vector<MechanismGeometry::Outline>& frame = frames.emplace_back(now);
    for (MechanismGeometry::Outline& outline : frame) {
      for (std::size_t k = 0; k < outline.points.size(); ++k) {
        const BodyMovement& body = movements[(*outline.bodies)[k == 0 ? 0 : 1]];
        outline.points[k] = body.after(seconds_ahead * i / frames_ahead, outline.points[k]);
      }
    }
  }
  return frames;
}

}  // namespace slipproof
