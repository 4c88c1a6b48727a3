#include "faces/cli/load_option.hpp"

#include <stdexcept>

#include "base/number/parse.hpp"

namespace slipproof::cli {

void add_load_option(CLI::App& command, std::string& load) {
  command.add_option("--load", load, "The value of the load, in place of the scene's, such as 7/4");
}

void add_range_option(CLI::App& command, const std::string& name, std::vector<std::string>& texts,
                      const std::string& help) {
  const auto complaint = [](const std::string& text) {
    try {
      parse_rational(text);
      return std::string();
    } catch (const NumberError& error) {
      return std::string(error.what());
    }
  };
  command.add_option(name, texts, help)->expected(2)->check(complaint);
}

void set_range(const std::vector<std::string>& texts, std::optional<Rational>& from, std::optional<Rational>& to) {
  if (texts.empty()) return;
  from = parse_rational(texts[0]);
  to = parse_rational(texts[1]);
}

MechanismScene at_load(const MechanismScene& scene, const std::string& load) {
  if (load.empty()) return scene;
  if (!scene.mechanism.load) {
    throw CLI::ValidationError("--load", "found a value, but the mechanism has no load, expected no --load");
  }
  try {
    return with_values(scene, {{scene.mechanism.load->symbol, parse_rational(load)}});
  } catch (const NumberError& error) {
    throw CLI::ValidationError("--load", error.what());
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--load", error.what());
  }
}

}  // namespace slipproof::cli
