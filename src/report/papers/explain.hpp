// What went wrong with a claim, in sentences that stand for themselves: the same in every form of output.
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
/// The same of one counterexample.
std::string explain(const ClaimsFile& file, const ClaimResult& result, const Counterexample& example);

/// Whether the counterexample can be built, and if not, which conditions of [setting.realisable] it breaks and that no
/// other was found. Empty where the setting does not say what can be built. Without a full stop.
std::string realisability(const ClaimsFile& file, const ClaimResult& result);

/// `wheels-apart (b > R), ...`: the conditions that a counterexample breaks.
std::string broken_conditions(const Setting& setting, const Counterexample& example);

/// That so many statements or certificates that the claims file asks for are not there.
std::string missing_text(std::size_t missing);

/// Whether a claim is about motions, so that those at a counterexample show something.
bool is_about_motions(const Claim& claim);

/// `R = 1, h = 2, F = 2/9`: where the counterexample is, with the force if the claim depends on it. By the paper's
/// symbols.
std::vector<std::pair<std::string, Rational>> place_of(const ClaimsFile& file, const ClaimResult& result,
                                                       const Counterexample& example);

/// The paper's parameters there, cosines and sines of its angles among them.
std::vector<std::pair<std::string, Rational>> parameters_of(const Setting& setting, const Counterexample& example);

/// The counterexample as a scene file; where the mechanism is a file, to be read from beside the claims file.
std::string scene_text(const Setting& setting, const Counterexample& example);

/// What there is at the counterexample in place of motions, where there are none.
std::string no_motions(const Counterexample& example);

/// With a capital, if it begins with a word and not with a formula, and with a full stop.
std::string sentence(std::string text);

/// What a sample of a setting, or of all settings of a file, is called: by the mechanism's name where that is a word,
/// as of a bicycle.
std::string_view noun(const Setting& setting, std::string_view otherwise = "point");
std::string_view noun(const ClaimsFile& file);

}  // namespace slipproof
