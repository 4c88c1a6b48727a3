#include "faces/cli/png_module/draw_png.hpp"

#include <librsvg/rsvg.h>

#include <exception>
#include <memory>
#include <stdexcept>

namespace slipproof::cli {

namespace {

template <auto release>
struct Release {
  template <class T>
  void operator()(T* pointer) const {
    release(pointer);
  }
};

std::string draw_png(std::string_view svg) {
  constexpr double scale = 2;
  GError* error = nullptr;
  const std::unique_ptr<RsvgHandle, Release<g_object_unref>> handle(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
  double width = 0, height = 0;
  if (!handle || rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height) == 0) {
    const std::string why = error != nullptr ? error->message : "it has no size";
    g_clear_error(&error);
    throw std::runtime_error(why);
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
    throw std::runtime_error(why);
  }
  return png;
}

}  // namespace

}  // namespace slipproof::cli

extern "C" __attribute__((visibility("default"))) bool slipproof_draw_png(std::string_view svg, std::string* result) {
  try {
    *result = slipproof::cli::draw_png(svg);
    return true;
  } catch (const std::exception& error) {
    *result = error.what();
    return false;
  }
}
