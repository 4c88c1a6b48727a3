// The page, its style and its scripts, as text.
#pragma once

#include <string_view>

namespace slipproof::assets {

extern const std::string_view page_html, page_js, turn_js;

}  // namespace slipproof::assets
