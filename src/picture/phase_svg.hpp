// Phase diagrams as SVG.
#pragma once

#include <string>

#include "markup/element.hpp"
#include "picture/phase_regions.hpp"

namespace slipproof {

struct PhaseSvgOptions {
  double width = 760, height = 500;  ///< of the picture, with axes and without a legend
  bool labels = true;                ///< names inside of the regions where they fit
};

/// The picture as a last child, without a style: picture_style() once in the document. Where the plot is inside of the
/// picture stands in data-plot: left, top, width and height.
Element add_phase_svg(const Element& parent, const PhaseDiagram& diagram, const PhaseRegions& regions,
                      const PhaseSvgOptions& options = {});

/// A swatch with the fill of a set of motions, 28 x 18; `index` counts regions.sets. The picture must be in the
/// document.
Element add_swatch(const Element& parent, const PhaseDiagram& diagram, const PhaseRegions& regions, std::size_t index);

/// A file of its own: the picture with title, legend and style.
std::string phase_svg_file(const PhaseDiagram& diagram, const PhaseSvgOptions& options = {});

}  // namespace slipproof
