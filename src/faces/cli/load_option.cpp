#include "faces/cli/load_option.hpp"

#include <stdexcept>

#include "base/number/parse.hpp"
#include "faces/cli/command.hpp"
#include "report/picture/space/space_view.hpp"

namespace slipproof::cli {

Rational number_of(const std::string& option, const std::string& text) {
  try {
    return parse_rational(text);
  } catch (const NumberError& error) {
    throw CLI::ValidationError(option, error.what());
  }
}

void add_range_option(CLI::App& command, const std::string& name, std::vector<std::string>& texts,
                      const std::string& description) {
  command.add_option(name, texts, description)->expected(2)->type_name("FROM TO")->check([](const std::string& text) {
    try {
      parse_rational(text);
      return std::string();
    } catch (const NumberError& error) {
      return std::string(error.what());
    }
  });
}

std::array<std::optional<Rational>, 2> range_of(const std::vector<std::string>& texts) {
  if (texts.empty()) return {};
  return {parse_rational(texts[0]), parse_rational(texts[1])};
}

void add_load_option(CLI::App& command, std::string& load) {
  command.add_option("--load", load, "The value of the load, in place of the scene's, such as 7/4");
}

void add_view_option(CLI::App& command, std::string& from) {
  const auto check = [](const std::string& text) {
    try {
      view_direction(text);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  command
      .add_option("--from", from,
                  "Where to look at a scene in space from: a direction in its axes, such as 1,-2,1, or azimuth and "
                  "elevation in degrees, such as -60,20; default: " +
                      std::string(usual_view))
      ->check(CLI::Validator(check, "X,Y,Z|DEGREES,DEGREES"));
}

void add_place_effort_option(CLI::App& command, std::uint64_t& effort) {
  command.add_option("--effort", effort, "In space: operations on words that each place may take")
      ->check(whole_number(1))
      ->capture_default_str();
}

void add_law_option(CLI::App& command, std::string& law, const std::string& otherwise) {
  command
      .add_option("--law", law,
                  "newton: opening after is e times approach before; moreau: the same at all closed contacts; poisson: "
                  "the impulse of restitution is e times that of compression; default: " +
                      otherwise)
      ->check(CLI::IsMember({"newton", "moreau", "poisson"}));
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
