// Names that a statement needs beside those of the file: of assumptions, of formulas, of further motions.
#pragma once

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "claims/paper/setting_names.hpp"

namespace slipproof {

/// Keeps made-up names apart from the names of the setting, which people chose, and from each other. Each statement
/// makes up names in a copy of its own.
class MadeUpNames {
 public:
  /// The unknowns are those of the mechanism.
  MadeUpNames(const SettingNames& names, std::vector<std::string> unknowns) : unknowns_(std::move(unknowns)) {
    for (const auto& [name, entry] : names.all()) taken_.insert(name);
    if (std::ranges::any_of(taken_, [&](const std::string& name) { return is_of_motion(name); })) mark_ = '\'';
  }

  /// Whether words of statements contain the character.
  static bool is_in_word(char c) {
    return is_letter(c) || digits.find(c) != digits.npos || c == '_' || c == '\'' || c == '.';
  }

  /// The name, which is taken from then on: a letter, then what words contain, in place of anything else underscores;
  /// and if it was taken, underscores behind it.
  std::string take(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return !is_in_word(c); }, '_');
    if (name.empty() || !is_letter(name.front())) name.insert(0, "n");
    while (is_taken(name)) name += '_';
    taken_.insert(name);
    return name;
  }

  /// What the names of a motion end in, by its number from 1: nothing, `_2`, `_3`. If a name of the setting is that of
  /// an unknown with such an ending, as in a scene of the bodies A and A_2, the endings are `'2`, `'3`: no name in a
  /// file has a prime. The judge that is proved in Coq chooses them in the same way (proofs/coq/claim/Obligations.v).
  std::string ending(std::size_t motion) const { return motion == 1 ? std::string() : mark_ + std::to_string(motion); }

 private:
  static constexpr std::string_view digits = "0123456789";

  static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

  bool is_taken(const std::string& name) const {
    return name == "and" || name == "or" || name == "false" || taken_.contains(name) || is_of_motion(name) ||
           std::ranges::any_of(taken_,
                               [&](const std::string& other) { return is_part(name, other) || is_part(other, name); });
  }

  /// Whether the name is that of an unknown of a further motion, of which there are fewer than ten: `a_22` is none.
  bool is_of_motion(std::string_view name) const {
    const std::size_t ending = 2;
    return name.size() > ending && digits.find(name.back()) != digits.npos && name[name.size() - ending] == mark_ &&
           std::ranges::find(unknowns_, name.substr(0, name.size() - ending)) != unknowns_.end();
  }

  /// Whether an assumption of this name would be called like a part of another: `a.1` and `a.1.2` are parts of `a`
  /// (proofs/FORMAT.md).
  static bool is_part(std::string_view name, std::string_view whole) {
    if (!name.starts_with(whole)) return false;
    const std::string_view rest = name.substr(whole.size());
    return rest.starts_with('.') && rest.find_first_not_of("0123456789.") == rest.npos;
  }

  std::vector<std::string> unknowns_;
  std::set<std::string, std::less<>> taken_;
  char mark_ = '_';
};

}  // namespace slipproof
