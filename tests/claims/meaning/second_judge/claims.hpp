// A claims file with one setting, as the second judge has it: what it judges is what text() writes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "claims/meaning/second_judge/mechanics.hpp"

namespace slipproof::meaning {

struct Setting {
  bool strict = true;
  bool external = false;                    ///< of the bicycle
  std::optional<Mechanics> mechanics = {};  ///< nothing: the bicycle
  Tree angle;                               ///< domain of the paper's angle `beta`, with cb and sb; null: it has none
  std::vector<Parameter> parameters;
  std::string force;  ///< the variable; empty: there is no load
  Tree force_domain;
  std::map<std::string, Tree> scene;  ///< of the mechanism's angle: its cosine `c` and sine `s`
  std::vector<std::pair<std::string, Tree>> definitions;
  std::vector<std::string> boundaries;
};

/// Of a kind that has no such key, a member is empty; a condition that is not given is null, and so true.
struct Claim {
  std::string id, kind;
  Tree region, forces, holds;
  std::vector<Mode> modes;
  std::vector<std::size_t> claims, except, given;
  std::vector<Tree> equations, assume;  ///< `=` of two numbers
  std::string parameter;
  Tree from;
};

struct File {
  Setting setting;
  std::vector<Claim> claims;

  std::string text() const;
};

}  // namespace slipproof::meaning
