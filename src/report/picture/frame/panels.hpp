// Pictures side by side, each under its heading, all to one scale.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/picture/frame/picture_frame.hpp"

namespace slipproof {

struct Panel {
  std::string heading;  ///< empty: none
  std::string below;    ///< a second line
  /// Adds the picture to a parent; sets the box of what it shows.
  std::function<Element(const Element&, LabelBox&)> draw;
};

struct PanelSheet {
  std::string title, below;
  std::vector<Panel> panels;
  double height = 330;  ///< at most, of a picture
  /// Adds what stands below all panels, from this corner on and at most so wide; returns its height. May be empty.
  std::function<double(const Element&, Point, double)> legend = {};
  std::string more_style = {};  ///< beside picture_style()
};

/// At most three in a row. All have one viewBox: what does not move is in the same place.
std::string panels_svg_file(const PanelSheet& sheet);

}  // namespace slipproof
