#include "faces/cli/load_option.hpp"

#include <stdexcept>

#include "base/number/parse.hpp"

namespace slipproof::cli {

Rational number_of(const std::string& option, const std::string& text) {
  try {
    return parse_rational(text);
  } catch (const NumberError& error) {
    throw CLI::ValidationError(option, error.what());
  }
}

void add_load_option(CLI::App& command, std::string& load) {
  command.add_option("--load", load, "The value of the load, in place of the scene's, such as 7/4");
}

MechanismScene at_load(const MechanismScene& scene, const std::string& load) {
  if (load.empty()) return scene;
  if (!scene.mechanism.load) {
    throw CLI::ValidationError("--load", "found a value, but the mechanism has no load, expected no --load");
  }
  try {
    return with_values(scene, {{scene.mechanism.load->symbol, number_of("--load", load)}});
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--load", error.what());
  }
}

}  // namespace slipproof::cli
