#include "faces/cli/png.hpp"

#include <stdexcept>
#include <utility>

#include "faces/cli/command.hpp"

#ifdef SLIPPROOF_RSVG

#include <librsvg/rsvg.h>

#include <memory>

namespace slipproof::cli {

namespace {

template <auto release>
struct Release {
  template <class T>
  void operator()(T* pointer) const {
    release(pointer);
  }
};

}  // namespace

std::string png_of(std::string_view svg) {
  constexpr double scale = 2;
  GError* error = nullptr;
  const std::unique_ptr<RsvgHandle, Release<g_object_unref>> handle(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
  double width = 0, height = 0;
  if (!handle || rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height) == 0) {
    const std::string why = error != nullptr ? error->message : "it has no size";
    g_clear_error(&error);
    throw std::runtime_error("the picture cannot be drawn: " + why);
  }
  const std::unique_ptr<cairo_surface_t, Release<cairo_surface_destroy>> surface(cairo_image_surface_create(
      CAIRO_FORMAT_ARGB32, static_cast<int>(width * scale), static_cast<int>(height * scale)));
  const std::unique_ptr<cairo_t, Release<cairo_destroy>> context(cairo_create(surface.get()));
  const RsvgRectangle viewport{0, 0, width * scale, height * scale};
  std::string png;
  const auto write = [](void* closure, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  };
  if (rsvg_handle_render_document(handle.get(), context.get(), &viewport, &error) == 0 ||
      cairo_surface_write_to_png_stream(surface.get(), write, &png) != CAIRO_STATUS_SUCCESS) {
    const std::string why = error != nullptr ? error->message : "out of memory";
    g_clear_error(&error);
    throw std::runtime_error("the picture cannot be drawn: " + why);
  }
  return png;
}

}  // namespace slipproof::cli

#else

#include <CLI/CLI.hpp>

namespace slipproof::cli {

std::string png_of(std::string_view) {
  throw CLI::ValidationError(
      "PNG", "found a slipproof that was built without librsvg: use SVG, or install librsvg2-dev and build again");
}

}  // namespace slipproof::cli

#endif

namespace slipproof::cli {

void expect_picture_name(const std::string& file, std::string_view advice) {
  expect_ending("--out", file, {".svg", ".png"}, advice);
}

std::string picture_for(const std::string& file, std::string svg) {
  return file.ends_with(".png") ? png_of(svg) : std::move(svg);
}

}  // namespace slipproof::cli
