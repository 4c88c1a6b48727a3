// The module with the formats' parsers: loaded at first use, and then kept.
#pragma once

#include "contact/imported/scene.hpp"
#include "contact/imported/tags.hpp"

/// The function that the module exports: reads a file in the format of its first tag. Does not throw.
extern "C" void slipproof_parse_scene(slipproof::imported::TaggedFile* file,
                                      const slipproof::imported::ReadOptions* options,
                                      slipproof::imported::Scene* scene, slipproof::Mistakes* mistakes);

namespace slipproof::imported {

using ParseScene = decltype(&slipproof_parse_scene);

/// Null, with a sentence that says why, where it is not installed. It is looked for beside the program, in the folder
/// of libraries to which it belongs, and where it was built.
ParseScene find_parsers(std::string& why);

}  // namespace slipproof::imported
