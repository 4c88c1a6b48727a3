// Phase diagrams as SVG.
#pragma once

#include <string>

#include "report/markup/element.hpp"
#include "report/phase/thin_regions.hpp"

namespace slipproof {

struct PhaseSvgOptions {
  double width = 760, height = 500;  ///< of the picture, with axes and without a legend
  bool labels = true;                ///< names inside of the regions where they fit
};

/// A diagram made ready to be drawn.
struct PhasePicture {
  const PhaseDiagram& diagram;
  PhaseSvgOptions options;
  PhaseRegions regions;  ///< sets that only an enlargement shows are the last ones
  ThinRegions thin;
};

/// The diagram must outlive the picture.
PhasePicture phase_picture(const PhaseDiagram& diagram, const PhaseSvgOptions& options = {});
/// Of an enlargement.
PhaseSvgOptions enlargement_options(const PhaseSvgOptions& options);

/// The picture as a last child, without a style: picture_style() once in the document. Where the plot is inside of the
/// picture stands in data-plot: left, top, width and height. What is too thin to be seen is drawn as wide as
/// least_seen, in a ring with its number.
Element add_phase_svg(const Element& parent, const PhasePicture& picture);
/// An enlargement, by its index.
Element add_enlargement(const Element& parent, const PhasePicture& picture, std::size_t index);
/// `1, 3 enlarged`: the numbers of the rings that an enlargement is for.
std::string enlargement_title(const PhasePicture& picture, std::size_t index);

/// A swatch with the fill of a set of motions, 28 x 18; `set` counts regions.sets. The picture must be in the document.
Element add_swatch(const Element& parent, const PhasePicture& picture, std::size_t set);
/// The same as a rectangle that is there, of a legend.
void paint_swatch(const Element& rect, const PhasePicture& picture, std::size_t set);
/// What a legend says of a set that is too thin to be seen, `(1, drawn wider than it is)`; empty for others.
std::string thin_note(const PhasePicture& picture, std::size_t set);

/// A file of its own: the picture with title, enlargements, legend and style.
std::string phase_svg_file(const PhaseDiagram& diagram, const PhaseSvgOptions& options = {});

}  // namespace slipproof
