// Where one looks at a scene in space from: a parallel projection.
#pragma once

#include <string_view>

#include "report/picture/drawing.hpp"
#include "report/picture/space/vectors.hpp"

namespace slipproof {

/// The direction towards who looks, of length 1. `x,y,z` in the axes of the scene, or `azimuth,elevation` in degrees:
/// from x towards y, and above the plane of both. Throws std::invalid_argument with a message for users.
Vec3 view_direction(std::string_view text);

/// From in front, a little from the right and from above.
inline constexpr std::string_view usual_view = "-62,22";

class SpaceView {
 public:
  /// `up` is upwards in the picture. Looking along it, y is.
  SpaceView(const Vec3& from, const Vec3& up);

  void fit(Point middle, double scale) { middle_ = middle, scale_ = scale; }

  const Vec3& towards() const { return towards_; }
  double scale() const { return scale_; }
  /// In the units of the scene, y up.
  Point flat(const Vec3& p) const { return {dot(right_, p), dot(up_, p)}; }
  double nearness(const Vec3& p) const { return dot(towards_, p); }
  /// In pixels, y down.
  Point pixel(const Vec3& p) const {
    const Point at = flat(p);
    return {scale_ * (at[0] - middle_[0]), -scale_ * (at[1] - middle_[1])};
  }

 private:
  Vec3 towards_, right_, up_;
  Point middle_{0, 0};
  double scale_ = 1;
};

}  // namespace slipproof
