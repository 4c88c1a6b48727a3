// Points with names in a plane with two logarithmic axes.
#pragma once

#include <string>
#include <vector>

#include "report/markup/element.hpp"

namespace slipproof {

struct Scatter {
  struct Dot {
    std::string name;
    double x = 0;            ///< > 0
    double y = 0;            ///< >= 0; points with 0 are on a separate line below all others
    bool highlight = false;  ///< drawn so that it stands out
  };
  std::string title, x_name, y_name;
  std::string zero = "0";  ///< label of the line for y = 0
  std::vector<Dot> dots;   ///< dots whose x or y is not allowed are left out
  double width = 640, height = 400;
};

/// The picture as a last child. Needs picture_style() in the document.
Element add_scatter(const Element& parent, const Scatter& scatter);

}  // namespace slipproof
