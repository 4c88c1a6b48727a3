// A small claims file, and the mistakes in a changed one.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "support/replaced.hpp"

namespace slipproof::test {

// A small paper, one line a key, so that places are easy to count.
inline const std::string small = R"(schema = "slipproof/claims/1"
[paper]
title = "A paper"
authors = ["A. Uthor"]
source = "paper.tex"
[[setting]]
id = "plain"
motions = "strict"
boundaries = ["b = b1"]
[setting.parameters]
b = { domain = "b > 0", meaning = "half the distance of the axles" }
f = { domain = "f >= 0", meaning = "friction" }
[setting.force]
symbol = "P"
kind = "internal"
domain = "P > 0"
[setting.scene]
M = "1"
R = "1"
h = "1"
b2 = "b"
b3 = "b"
I1 = "0"
I2 = "1"
I3 = "1"
r1 = "1"
r2 = "1"
L = "1"
f = "f"
g = "10"
F = "P"
[[setting.definition]]
symbol = "b1"
line = 10
printed = "f*2"
repaired = "f/2"
why = "a fraction bar is lost"
[[setting.definition]]
symbol = "xi"
line = 11
printed = "b/b1"
[[claim]]
id = "A1"
line = 12
statement = "what is said"
kind = "interval"
mode = "stick/slip+"
region = "b > b1"
forces = "0 < P < xi"
[[claim]]
id = "A2"
line = 13
statement = "what is said"
kind = "motions"
modes = ["stick/stick", "*/lift"]
forces = "P < 3"
[[claim]]
id = "A3"
line = 14
statement = "what is said"
kind = "unique"
claims = ["A1"]
except = ["A2"]
[[claim]]
id = "A4"
line = 15
statement = "what is said"
kind = "formula"
mode = "slip-/stick"
holds = "a = P/2"
)";

inline std::vector<std::string> mistakes(const std::string& text) {
  try {
    parse_claims(text, "claims.toml");
  } catch (const InputError& error) {
    std::vector<std::string> found;
    for (const Diagnostic& diagnostic : error.diagnostics()) found.push_back(to_string(diagnostic));
    return found;
  }
  return {};
}

}  // namespace slipproof::test
