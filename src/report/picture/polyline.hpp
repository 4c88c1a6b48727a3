// Lines of a picture as SVG paths, without the points that nobody can see.
#pragma once

#include <string>
#include <vector>

namespace slipproof {

/// A place in a picture, y down.
struct Pixel {
  double x, y;
};

/// Points that are nearer than a twelfth of a unit to the line without them are left out (Douglas and Peucker).
std::vector<Pixel> simplified(const std::vector<Pixel>& points);

/// The outline of a band around a line of two points or more: of the heights, and at least so thick across the line. It
/// reaches half of that beyond both ends.
std::vector<Pixel> band_of(const std::vector<Pixel>& middle, const std::vector<double>& heights, double least);

double length_of(const std::vector<Pixel>& points);

/// `M...L...` of a simplified line; closed_path_of takes the points as they are, and ends in `Z`.
std::string path_of(const std::vector<Pixel>& points);
std::string closed_path_of(const std::vector<Pixel>& points);

}  // namespace slipproof
