// Converts SVG to PNG, if the program was built with librsvg.
#pragma once

#include <string>
#include <string_view>

namespace slipproof::cli {

/// The picture at twice its size in pixels. A usage error if the program was built without librsvg.
std::string png_of(std::string_view svg);

}  // namespace slipproof::cli
