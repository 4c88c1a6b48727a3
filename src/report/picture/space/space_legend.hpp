// What the signs in the picture of a scene in space mean.
#pragma once

#include <cstdint>
#include <set>

#include "report/markup/element.hpp"
#include "report/picture/drawing.hpp"

namespace slipproof {

enum class SpaceSign : std::uint8_t {
  normal,
  tangents,
  force,
  cone,
  open_force,
  load,
  velocity,
  acceleration,
  virtual_rate,
  slip,
  sliding,
  shadow
};

/// Adds a sample of each with its meaning, in lines of at most this width; returns their height. Of an impact forces
/// are impulses, and accelerations velocities after it.
double add_space_legend(const Element& svg, const std::set<SpaceSign>& signs, Point corner, double width,
                        bool is_impact = false);

/// A whole velocity is thin, an acceleration dotted.
void add_velocity_arrow(const Element& svg, Point from, Point to);
void add_acceleration_arrow(const Element& svg, Point from, Point to);

}  // namespace slipproof
