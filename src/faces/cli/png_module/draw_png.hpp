// The module that draws SVG as PNG, by librsvg: its fifty libraries are loaded for a PNG only.
#pragma once

#include <string>
#include <string_view>

/// The function that the module exports: the picture at twice its size in pixels. If it cannot be drawn, false, and the
/// result is the message. Does not throw.
extern "C" bool slipproof_draw_png(std::string_view svg, std::string* result);
