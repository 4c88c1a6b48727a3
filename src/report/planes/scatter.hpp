// Points with names in a plane of two logarithmic axes.
#pragma once

#include <string>
#include <vector>

#include "report/markup/element.hpp"

namespace slipproof {

struct Scatter {
  struct Dot {
    std::string name;
    double x = 0;            ///< > 0
    double y = 0;            ///< >= 0; 0 has a line of its own below all others
    bool highlight = false;  ///< drawn so that the eye finds it
  };
  std::string title, x_name, y_name;
  std::string zero = "0";  ///< what the line for y = 0 is called
  std::vector<Dot> dots;   ///< those with another x or y than allowed are left out
  double width = 640, height = 400;
};

/// The picture as a last child. Needs picture_style() in the document.
Element add_scatter(const Element& parent, const Scatter& scatter);

}  // namespace slipproof
