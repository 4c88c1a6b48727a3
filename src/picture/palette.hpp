// The colours of contact modes, the same in every picture: hues that colour-blind readers tell apart, and a texture
// where a wheel is off the road.
#pragma once

#include <string>

#include "model/contact_mode.hpp"

namespace slipproof {

/// A style sheet for pictures, light and dark. Literal colours: not every reader of SVG knows variables.
std::string picture_style();

/// The class that fills a shape with a mode's colour.
std::string fill_class(ContactMode mode);

/// What a mode is in words: "both wheels roll".
std::string in_words(ContactMode mode);

}  // namespace slipproof
