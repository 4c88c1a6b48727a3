// Symbols of claims files and scenes as in print: `xi1` is a Greek letter with an index.
#pragma once

#include <string>
#include <string_view>

#include "report/markup/element.hpp"

namespace slipproof {

struct Symbol {
  std::string letter;       ///< UTF-8; several letters for a word such as `gap`
  std::string subscript;    ///< may be empty
  std::string superscript;  ///< the number of the assertion that `N2_1` belongs to; may be empty
};

/// `xi1`, `b0`, `M2`, `eps2`, `a_y`, `F_sigma`, `N2_1`, `sigma`; `ay` and `muf` are `a_y` and `mu_f`.
Symbol typeset_symbol(std::string_view name);

/// The Greek letter with this name, such as `xi`, `eps`, `varepsilon`; empty if there is none.
std::string_view greek(std::string_view name);

/// The symbol as plain text: `ξ1`.
std::string plain_symbol(std::string_view name);

/// Adds the symbol to an SVG <text>, with the subscript lowered; `F sigma` is a product.
void svg_symbol(const Element& text, std::string_view name);

}  // namespace slipproof
