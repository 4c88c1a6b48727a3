// The colours of modes: hues that colour-blind readers tell apart.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mechanics/elements/element.hpp"

namespace slipproof {

/// A style sheet for pictures, light and dark. Literal colours: not every reader of SVG knows variables.
std::string picture_style();

/// Colours for the modes of one picture. Up to sixteen are all different; those of two contacts have the same in every
/// picture.
class ModeColours {
 public:
  explicit ModeColours(std::vector<MechanismMode> modes);

  /// The class that fills a shape with a mode's colour; the mode must be one of the picture's.
  std::string fill_class(const MechanismMode& mode) const;

 private:
  std::map<MechanismMode, std::size_t> indices_;
};

}  // namespace slipproof
