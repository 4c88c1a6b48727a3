// Which planes of a paper are worth a picture: data beside its claims, figures.toml.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "claims/paper/claims_file.hpp"

namespace slipproof {

/// A plane of one parameter of a setting and its force variable, all other parameters fixed.
struct Figure {
  std::string id;  ///< letters, digits and -
  std::string title;
  std::string note;         ///< what there is to see
  std::size_t setting = 0;  ///< index
  std::size_t x = 0;        ///< index of the parameter
  Rational x_from, x_to, y_from, y_to;
  std::string y_label;           ///< what the force variable is called at these values; its symbol if not given
  std::vector<Rational> values;  ///< of the setting's parameters; that of x does not count
};

/// Reads `slipproof/figures/1`. Throws InputError with every mistake of the file.
std::vector<Figure> read_figures(const std::filesystem::path& path, const ClaimsFile& claims);
std::vector<Figure> parse_figures(std::string_view text, const std::string& file, const ClaimsFile& claims);

}  // namespace slipproof
