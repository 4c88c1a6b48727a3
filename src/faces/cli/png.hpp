// Converts SVG to PNG, if the program was built with librsvg.
#pragma once

#include <string>
#include <string_view>

namespace slipproof::cli {

/// The picture at twice its size in pixels. A usage error if the program was built without librsvg.
std::string png_of(std::string_view svg);

/// Refuses the name of a picture's file, of the option --out, that ends neither in .svg nor in .png.
void expect_picture_name(const std::string& file, std::string_view advice = {});

/// What a file of this name holds: the picture as PNG where the name ends in .png, as SVG otherwise.
std::string picture_for(const std::string& file, std::string svg);

}  // namespace slipproof::cli
