// Explains what is wrong with a claim in complete sentences, the same in every form of output.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "claims/verify/verify.hpp"

namespace slipproof {

/// Why a claim has its verdict: what the counterexample shows, or why there is none. Empty for a claim that holds.
/// Without a full stop.
std::string explain(const ClaimsFile& file, const ClaimResult& result);
/// The same for a given counterexample.
std::string explain(const ClaimsFile& file, const ClaimResult& result, const Counterexample& example);

/// Whether the counterexample can be built. If not: which conditions of [setting.realisable] it breaks, and that no
/// other counterexample was found. Empty if the setting does not say what can be built. Without a full stop.
std::string realisability(const ClaimsFile& file, const ClaimResult& result);

/// `wheels-apart (b > R), ...`: the conditions that a counterexample breaks.
std::string broken_conditions(const Setting& setting, const Counterexample& example);

/// Says how many statements or certificates that the claims file asks for are missing.
std::string missing_text(std::size_t missing);

/// Whether a claim is about motions; only then do the motions at a counterexample show something.
bool is_about_motions(const Claim& claim);

/// `R = 1, h = 2, F = 2/9`: the place of the counterexample in the paper's symbols, with the force if the claim depends
/// on it.
std::vector<std::pair<std::string, Rational>> place_of(const ClaimsFile& file, const ClaimResult& result,
                                                       const Counterexample& example);

/// The paper's parameters at the counterexample, and the cosines and sines of its angles.
std::vector<std::pair<std::string, Rational>> parameters_of(const Setting& setting, const Counterexample& example);

/// The counterexample as a scene file. If its mechanism is a file, the scene must be saved in the folder of the claims
/// file.
std::string scene_text(const Setting& setting, const Counterexample& example);

/// If there are no motions at the counterexample: what there is instead.
std::string no_motions(const Counterexample& example);

/// The text with a full stop; with a capital if it begins with a word and not with a formula.
std::string sentence(std::string text);

/// The word for a sample of a setting, or of all settings of a file: the mechanism's name if that is a word, such as
/// bicycle.
std::string_view noun(const Setting& setting, std::string_view otherwise = "point");
std::string_view noun(const ClaimsFile& file);

}  // namespace slipproof
