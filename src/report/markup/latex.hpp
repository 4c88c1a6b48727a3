// The LaTeX that stands in the statements of claims files, as MathML.
#pragma once

#include <string_view>

#include "report/markup/element.hpp"

namespace slipproof {

/// A sentence with formulas between dollar signs. What is beyond the commands of latex.cpp stays as it was written, in
/// a <code>.
void add_sentence(const Element& parent, std::string_view text);

}  // namespace slipproof
