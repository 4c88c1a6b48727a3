// Names for the contacts of a picture: beside each where they are few, otherwise letters that a table explains.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "mechanics/kernel/motion.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/markup/element.hpp"
#include "report/picture/labels/label_placer.hpp"
#include "report/picture/motion_words.hpp"

namespace slipproof {

/// From so many contacts on they have letters.
inline constexpr std::size_t fewest_lettered = 8;
/// The room for a drawing of so many, in pixels: as wide as its table.
inline constexpr double lettered_width = 420, lettered_height = 400;

/// `a`, `b`, ..., `z`, `aa`, ...
std::string contact_letter(std::size_t index);

/// Adds a line for each of these contacts, with its letter, its name and state, and its forces; returns where they are.
LabelBox add_contact_table(const Element& svg, const MechanismScene& scene, const MotionAtLoad* motion,
                           const std::vector<std::size_t>& contacts, const NumberWords& numbers, Point corner);

/// Adds rows of equally many texts, the first of each in the colour of names, in smaller letters where they would be
/// wider than `most`; returns where they are.
LabelBox add_text_table(const Element& svg, const std::vector<std::vector<std::string>>& rows, Point corner,
                        double most = std::numeric_limits<double>::max());

/// How high a table of so many rows is.
double contact_table_height(std::size_t contacts);

}  // namespace slipproof
