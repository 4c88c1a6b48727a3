// Converts the LaTeX in the statements of claims files to MathML.
#pragma once

#include <string_view>

#include "report/markup/element.hpp"

namespace slipproof {

/// Adds a sentence with formulas between dollar signs. A formula with a command that latex.cpp does not support stays
/// as written, in a <code>.
void add_sentence(const Element& parent, std::string_view text);

}  // namespace slipproof
