#include "faces/cli/png.hpp"

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <utility>

#include "base/os/module.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/png_module/draw_png.hpp"

namespace slipproof::cli {

#ifdef SLIPPROOF_RSVG

std::string png_of(std::string_view svg) {
  std::string why, result;
  const auto draw = reinterpret_cast<decltype(&slipproof_draw_png)>(
      function_of_module("slipproof-png.so", "slipproof_draw_png", why));
  if (draw == nullptr) {
    throw CLI::ValidationError("PNG", "found a slipproof that cannot draw it with librsvg: " + why + "; use SVG");
  }
  if (!draw(svg, &result)) throw std::runtime_error("the picture cannot be drawn: " + result);
  return result;
}

#else

std::string png_of(std::string_view) {
  throw CLI::ValidationError(
      "PNG", "found a slipproof that was built without librsvg: use SVG, or install librsvg2-dev and build again");
}

#endif

void expect_picture_name(const std::string& file, std::string_view advice) {
  expect_ending("--out", file, {".svg", ".png"}, advice);
}

std::string picture_for(const std::string& file, std::string svg) {
  return file.ends_with(".png") ? png_of(svg) : std::move(svg);
}

}  // namespace slipproof::cli
