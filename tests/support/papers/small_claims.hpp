// A claims file with one setting, as small as can be.
#pragma once

#include <string>

namespace slipproof::test {

/// A bicycle of ones, but for its parameters: a subset of b, f and h.
struct SmallClaims {
  std::string parameters = {};  ///< a line each, as `b = { domain = "b > 0", meaning = "b" }`
  std::string force = "F";
  std::string in_setting = {};  ///< further keys of the setting, a line each
  bool detachment = false;
  std::string claims = {};  ///< the [[claim]] tables

  std::string text() const {
    const auto value = [this](const std::string& name) {
      return parameters.starts_with(name + " =") || parameters.find("\n" + name + " =") != std::string::npos ? name
                                                                                                             : "1";
    };
    std::string scene;
    const auto set = [&scene](const std::string& name, const std::string& expression) {
      scene += name + " = \"" + expression + "\"\n";
    };
    for (const char* one : {"M", "R", "I1", "I2", "I3", "r1", "r2", "L", "g"}) set(one, "1");
    set("b2", value("b"));
    set("b3", value("b"));
    set("h", value("h"));
    set("f", value("f"));
    if (detachment) set("J", "1");
    set("F", force);
    return "schema = \"slipproof/claims/1\"\n"
           "[paper]\ntitle = \"small\"\nauthors = [\"nobody\"]\nsource = \"none.tex\"\n"
           "[[setting]]\nid = \"all\"\nline = 1\nstatement = \"all\"\nmotions = \"strict\"\n" +
           in_setting + "[setting.parameters]\n" + parameters + "[setting.force]\nsymbol = \"" + force +
           "\"\nkind = \"internal\"\ndomain = \"" + force + " > 0\"\n[setting.scene]\n" + scene + claims;
  }
};

/// A claim of the kind `formula`, as a table.
inline std::string formula_claim(const std::string& id, const std::string& holds, const std::string& more = "") {
  return "[[claim]]\nid = \"" + id + "\"\nline = 7\nstatement = \"s\"\nkind = \"formula\"\nholds = \"" + holds +
         "\"\n" + more;
}

}  // namespace slipproof::test
