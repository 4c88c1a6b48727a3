// The signs of pictures of friction cones: the disc, the point of a force, and samples of all for legends.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "contact/judge/judge.hpp"
#include "report/markup/element.hpp"
#include "report/picture/drawing.hpp"

namespace slipproof {

enum class ConeSign : std::uint8_t { open, stick, slide, smooth, marked, law, pyramid, motion, lifts, disc };

/// A sample of a sign of the picture, or of counts, 28 x 18.
Element add_swatch(const Element& parent, ConeSign sign);

/// An entry of a legend: a sample and what it means.
void add_sign_entry(const Element& list, ConeSign sign, const std::string& meaning);

/// `fit-open`, ...: the class of its colour; only for the four cases of the law.
std::string_view fill_class(ConeSign sign);

void add_path(const Element& svg, std::string_view css_class, const std::string& path);

/// The axes of r_T / (mu r_N), so long on each side.
void add_cone_axes(const Element& svg, Point center, double length);

/// Draws the boundary of a law around a center, `unit` long where r_T / (mu r_N) is 1.
void add_boundary(const Element& svg, Point center, double unit, FrictionLaw law, std::string_view css_class);

/// Where r_T / (mu r_N) stands around a center.
Point in_disc(Point center, double unit, const std::array<double, 2>& at);

/// Draws a round point for a contact that sticks, and a triangle around the same place for one that slides.
Element add_cone_point(const Element& parent, Point at, double radius, bool slides);

}  // namespace slipproof
