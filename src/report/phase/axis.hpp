// The frame of a plot: maps numbers to places in a picture, and has axes with round numbers.
#pragma once

#include <vector>

#include "report/markup/element.hpp"
#include "report/phase/phase_regions.hpp"
#include "report/picture/polyline.hpp"

namespace slipproof {

/// Round numbers from `from` to `to`, about `count` of them.
std::vector<double> ticks(double from, double to, int count);

struct Frame {
  Frame(double left, double top, double width, double height, const Axis& x, const Axis& y);

  double left, top, width, height;

  const Axis& across() const { return x_; }
  const Axis& up() const { return y_; }
  double x_of(double x) const { return left + (x - x_from_) / (x_to_ - x_from_) * width; }
  double y_of(double y) const { return top + height - (y - y_from_) / (y_to_ - y_from_) * height; }
  std::vector<Pixel> to_picture(const std::vector<PlanePoint>& points) const;
  /// The longest part of a line inside the frame, as points.
  std::vector<Pixel> visible(const std::vector<Pixel>& points) const;
  void draw(const Element& svg) const;

 private:
  void draw_tick(const Element& axes, double x, const std::string& text) const;

  double x_from_, x_to_, y_from_, y_to_;
  Axis x_, y_;
};

}  // namespace slipproof
