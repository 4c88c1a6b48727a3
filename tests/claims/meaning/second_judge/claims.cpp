#include "claims/meaning/second_judge/claims.hpp"

namespace slipproof::meaning {

namespace {

std::string line(const std::string& key, const std::string& value) {
  return key + " = \"" + value + "\"\n";
}

std::string line(const std::string& key, const Tree& value) {
  return value ? line(key, text(value)) : "";
}

std::string list(const std::string& key, const std::vector<std::string>& values) {
  if (values.empty()) return "";
  std::string result;
  for (const std::string& value : values) result += (result.empty() ? "\"" : ", \"") + value + "\"";
  return key + " = [" + result + "]\n";
}

std::vector<std::string> texts(const std::vector<Tree>& trees) {
  std::vector<std::string> result;
  for (const Tree& tree : trees) result.push_back(text(tree));
  return result;
}

bool of_angle(const Setting& setting, const std::string& symbol) {
  return setting.mechanics && setting.mechanics->angle && (symbol == "c" || symbol == "s");
}

std::string setting_text(const Setting& setting) {
  std::string result = "[[setting]]\nid = \"all\"\nline = 1\nstatement = \"all\"\n";
  if (setting.mechanics) result += line("mechanism", "mechanism.toml");
  result += line("motions", setting.strict ? "strict" : "closed") + list("boundaries", setting.boundaries);
  result += "[setting.parameters]\n";
  for (const Parameter& parameter : setting.parameters) {
    result += parameter.symbol + " = { domain = \"" + text(parameter.domain) + "\", meaning = \"any\" }\n";
  }
  if (setting.angle) {
    result += "[setting.angles]\nbeta = { cos = \"cb\", sin = \"sb\", domain = \"" + text(setting.angle) + "\" }\n";
  }
  if (!setting.force.empty()) {
    result += "[setting.force]\n" + line("symbol", setting.force);
    if (!setting.mechanics) result += line("kind", setting.external ? "external" : "internal");
    result += line("domain", setting.force_domain);
  }
  result += "[setting.scene]\n";
  for (const auto& [symbol, value] : setting.scene) {
    if (!of_angle(setting, symbol)) result += line(symbol, value);
  }
  if (setting.mechanics && setting.mechanics->angle) {
    result +=
        "theta = { cos = \"" + text(setting.scene.at("c")) + "\", sin = \"" + text(setting.scene.at("s")) + "\" }\n";
  }
  for (const auto& [symbol, value] : setting.definitions) {
    result += "[[setting.definition]]\nline = 1\n" + line("symbol", symbol) + line("printed", value);
  }
  return result;
}

std::string claim_text(const File& file, const Claim& claim) {
  const auto ids = [&](const std::vector<std::size_t>& claims) {
    std::vector<std::string> result;
    for (const std::size_t i : claims) result.push_back(file.claims[i].id);
    return result;
  };
  std::vector<std::string> modes;
  for (const Mode& mode : claim.modes) modes.push_back(text(mode));
  const bool one_mode = claim.kind == "interval" || claim.kind == "consequence" || claim.kind == "system";
  std::string result = "[[claim]]\n" + line("id", claim.id) + line("kind", claim.kind);
  result += "line = 1\nstatement = \"random\"\n";
  result += one_mode && !modes.empty() ? line("mode", modes.front()) : list("modes", modes);
  result += line("region", claim.region) + line("forces", claim.forces) + line("holds", claim.holds);
  result += list("claims", ids(claim.claims)) + list("except", ids(claim.except)) + list("given", ids(claim.given));
  result += list("equations", texts(claim.equations)) + list("assume", texts(claim.assume));
  if (!claim.parameter.empty()) result += line("parameter", claim.parameter);
  return result + line("from", claim.from);
}

}  // namespace

std::string File::text() const {
  std::string result = "schema = \"slipproof/claims/1\"\n[paper]\ntitle = \"random\"\nauthors = [\"nobody\"]\n";
  result += "source = \"none.tex\"\n" + setting_text(setting);
  for (const Claim& claim : claims) result += claim_text(*this, claim);
  return result;
}

}  // namespace slipproof::meaning
