#include "mechanics/rest_on_slope/shipped.hpp"

#include <map>
#include <stdexcept>

#include "base/input/text_file.hpp"
#include "base/input/toml.hpp"
#include "base/number/binary64.hpp"
#include "base/number/parse.hpp"

namespace slipproof::test::rest_on_slope {

namespace {

const TomlValue& at(const TomlValue& table, const std::string& key) {
  const TomlEntry* entry = table.find(key);
  if (entry == nullptr) throw std::runtime_error("claims.toml: no " + key);
  return entry->value;
}

using Values = std::map<std::string, double>;

/// The parameters of each setting whose domain is one number: `K1 = { domain = "K1 = 12" }`.
std::map<std::string, Values> read_settings() {
  const std::string file = SLIPPROOF_SOURCE_DIR "/proofs/rest-on-slope/claims.toml";
  Mistakes mistakes(file);
  const auto root = parse_toml(read_text_file(file), mistakes);
  mistakes.refuse_if_any();
  std::map<std::string, Values> result;
  for (const TomlValue& setting : at(*root, "setting").items) {
    const TomlEntry* parameters = setting.find("parameters");
    if (parameters == nullptr) continue;
    Values& values = result[at(setting, "id").text.text()];
    for (const TomlEntry& parameter : parameters->value.entries) {
      const std::string& domain = at(parameter.value, "domain").text.text();
      const std::string start = parameter.key + " = ";
      if (domain.starts_with(start))
        values[parameter.key] = nearest_binary64(parse_rational(domain.substr(start.size())));
    }
  }
  return result;
}

Numbers numbers_of(const Values& values) {
  return {values.at("K1"), values.at("K2"), values.at("K3"), values.at("B1"), values.at("B2"), values.at("E")};
}

}  // namespace

std::vector<Point> shipped_points() {
  std::vector<Point> result;
  for (const auto& [id, values] : read_settings()) {
    if (!id.starts_with("point ")) continue;
    const double mu = values.at("mu");
    result.push_back({id, {values.at("u"), values.at("g") / mu, values.at("J"), mu, 0}, numbers_of(values)});
  }
  return result;
}

Numbers shipped_numbers() {
  return numbers_of(read_settings().at("low, kappa"));
}

}  // namespace slipproof::test::rest_on_slope
