// Phase diagrams as SVG.
#pragma once

#include <string>

#include "report/markup/element.hpp"
#include "report/phase/thin_regions.hpp"

namespace slipproof {

struct PhaseSvgOptions {
  double width = 760, height = 500;  ///< of the picture, with axes but without a legend
  bool labels = true;                ///< names inside the regions where they fit
};

/// A diagram prepared for drawing.
struct PhasePicture {
  const PhaseDiagram& diagram;
  PhaseSvgOptions options;
  PhaseRegions regions;  ///< sets that only an enlargement shows come last
  ThinRegions thin;
};

/// The diagram must outlive the picture.
PhasePicture phase_picture(const PhaseDiagram& diagram, const PhaseSvgOptions& options = {});
/// The options for an enlargement.
PhaseSvgOptions enlargement_options(const PhaseSvgOptions& options);

/// Adds the picture as a last child, without a style; the document needs picture_style() once. data-plot gives the
/// place of the plot in the picture: left, top, width and height. A region too thin to see is drawn as wide as
/// least_seen, in a ring with its number.
Element add_phase_svg(const Element& parent, const PhasePicture& picture);
/// Adds an enlargement, given by its index.
Element add_enlargement(const Element& parent, const PhasePicture& picture, std::size_t index);
/// `1, 3 enlarged`: the numbers of the rings that an enlargement shows.
std::string enlargement_title(const PhasePicture& picture, std::size_t index);

/// Adds a swatch with the fill of a set of motions, 28 x 18; `set` is an index into regions.sets. The picture must be
/// in the document.
Element add_swatch(const Element& parent, const PhasePicture& picture, std::size_t set);
/// The same for an existing rectangle, as in a legend.
void paint_swatch(const Element& rect, const PhasePicture& picture, std::size_t set);
/// The note in a legend for a set that is too thin to see, `(1, drawn wider than it is)`; empty for other sets.
std::string thin_note(const PhasePicture& picture, std::size_t set);

/// An SVG file: the picture with title, enlargements, legend and style. The plots have their data-plot in this order.
std::string phase_svg_file(const PhasePicture& picture);
std::string phase_svg_file(const PhaseDiagram& diagram, const PhaseSvgOptions& options = {});

}  // namespace slipproof
