// The planes of a paper that are worth a picture, from figures.toml in the folder of its claims.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "claims/paper/claims_file.hpp"

namespace slipproof {

/// A plane of one parameter of a setting and its force variable, with all other parameters fixed.
struct Figure {
  std::string id;  ///< letters, digits and -
  std::string title;
  std::string note;         ///< what the figure shows
  std::size_t setting = 0;  ///< index
  std::size_t x = 0;        ///< index of the parameter
  Rational x_from, x_to, y_from, y_to;
  std::string y_label;           ///< the name of the force variable at these values; its symbol if not given
  std::vector<Rational> values;  ///< of the setting's parameters; the value of x is not used
};

/// Reads `slipproof/figures/1`. Throws InputError with all mistakes in the file.
std::vector<Figure> read_figures(const std::filesystem::path& path, const ClaimsFile& claims);
std::vector<Figure> parse_figures(std::string_view text, const std::string& file, const ClaimsFile& claims);

}  // namespace slipproof
