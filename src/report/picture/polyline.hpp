// Lines of a picture as SVG paths, without points that cannot be seen.
#pragma once

#include <string>
#include <vector>

namespace slipproof {

/// A place in a picture, y down.
struct Pixel {
  double x, y;
};

/// Leaves out points that are nearer than a twelfth of a unit to the line without them (Douglas and Peucker).
std::vector<Pixel> simplified(const std::vector<Pixel>& points);

/// The outline of a band around a line of at least two points. The band has the given heights, and at least the given
/// thickness across the line; it extends by half of that thickness beyond both ends.
std::vector<Pixel> band_of(const std::vector<Pixel>& middle, const std::vector<double>& heights, double least);

double length_of(const std::vector<Pixel>& points);

/// `M...L...` for a simplified line. closed_path_of takes the points as they are and ends with `Z`.
std::string path_of(const std::vector<Pixel>& points);
std::string closed_path_of(const std::vector<Pixel>& points);

}  // namespace slipproof
