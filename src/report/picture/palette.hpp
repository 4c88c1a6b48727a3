// The colours of modes, in hues that colour-blind readers can tell apart.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mechanics/elements/element.hpp"

namespace slipproof {

/// A style sheet for pictures, light and dark. Colours are literal, because some readers of SVG do not support
/// variables.
std::string picture_style();

/// What pictures of scenes in space need in addition.
std::string space_style();

/// The class of a face of a solid by its light, from 0 to 1.
std::string shade_class(double light);

/// Assigns colours to the modes of one picture. Up to sixteen modes all have different colours; the modes of two
/// contacts have the same colours in every picture.
class ModeColours {
 public:
  explicit ModeColours(std::vector<MechanismMode> modes);

  /// The class that fills a shape with the colour of a mode, which must be one of the picture's.
  std::string fill_class(const MechanismMode& mode) const;

 private:
  std::map<MechanismMode, std::size_t> indices_;
};

}  // namespace slipproof
