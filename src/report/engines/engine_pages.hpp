// The table of engines as pages: which scenes each engine answers rightly, and each scene with its exact motions.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "report/engines/engine_table.hpp"

namespace slipproof {

/// Receives the name of a page below the folder, and its HTML.
using PageSink = std::function<void(const std::string& name, const std::string& html)>;

/// `index.html`, a page `CLASS.html` for each class of scenes, and `CLASS/NAME.html` for each scene, in space with its
/// picture `CLASS/NAME.svg`.
/// `folder` is what the user calls the folder of the engines, for the commands on the pages. `explorer` is the name of
/// the explorer's page (src/faces/explorer) in the folder of the pages; empty: there is none. The same input gives the
/// same bytes.
void write_engine_pages(const EngineResults& results, const std::string& folder, const std::string& version,
                        const std::string& explorer, const PageSink& write);

}  // namespace slipproof
