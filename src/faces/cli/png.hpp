// SVG to PNG, where librsvg was there when the program was built.
#pragma once

#include <string>
#include <string_view>

namespace slipproof::cli {

/// The picture at twice its size in pixels. An error of usage if the program was built without librsvg.
std::string png_of(std::string_view svg);

}  // namespace slipproof::cli
